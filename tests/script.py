"""Runs the test_… functions of a script in the order they are written and prints TAP.

A test fails by raising (assert does), and skips by raising Skip with the reason.
"""

import os
import subprocess
import sys
import traceback


class Skip(Exception):
    pass


def environment(home, **more):
    """What programs are started with: a user who reads English, has no preferences, and lives in the
    folder `home`, whoever runs the tests."""
    folders = {f"XDG_{name.upper()}_HOME": f"{home}/{name}"
               for name in ("cache", "config", "data", "state")}
    return {**os.environ, "HOME": str(home), "LANGUAGE": "C", **folders, **more}


def program(path, folder):
    """A function that runs the program in a folder and asserts with which code it ends."""
    def run_it(*words, expect=0):
        done = subprocess.run([path, *map(str, words)], capture_output=True, text=True, cwd=folder,
                              check=False, env=environment(folder))
        assert done.returncode == expect, (words, done.returncode, done.stdout, done.stderr)
        return done
    return run_it


def run(namespace):
    tests = [(n, f) for n, f in namespace.items() if n.startswith("test_") and callable(f)]
    failed = 0
    print(f"1..{len(tests)}")
    for number, (name, function) in enumerate(tests, 1):
        name = name[len("test_"):]
        try:
            function()
            print(f"ok {number} - {name}")
        except Skip as reason:
            print(f"ok {number} - {name} # SKIP {reason}")
        except Exception:  # pylint: disable=broad-except
            failed += 1
            traceback.print_exc()
            print(f"not ok {number} - {name}")
        sys.stdout.flush()
    return 1 if failed else 0
