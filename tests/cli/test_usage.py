"""Exit codes and streams of the program. usage: test_usage.py KATAGAMI"""

import os
import pathlib
import re
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import script  # noqa: E402

PROGRAM = sys.argv[1]


def katagami(*words, **options):
    return subprocess.run([PROGRAM, *words], capture_output=True, text=True, check=False,
                          **options)


def listed_commands():
    return re.findall(r"^  (\w+) ", katagami("--help").stdout, re.MULTILINE)


def test_help_goes_to_stdout():
    done = katagami("--help")
    assert (done.returncode, done.stderr) == (0, "") and "usage:" in done.stdout, done


def test_without_a_display_no_command_is_wrong_usage():
    done = katagami(env={k: v for k, v in os.environ.items() if not k.endswith("DISPLAY")})
    assert (done.returncode, done.stdout) == (2, "") and "usage:" in done.stderr, done


def test_unknown_command_is_named():
    done = katagami("fold")
    assert (done.returncode, done.stdout) == (2, "") and "fold" in done.stderr, done


def test_every_command_has_help_both_ways():
    for name in listed_commands():
        one, other = katagami(name, "--help"), katagami("help", name)
        assert one.returncode == other.returncode == 0, (name, one, other)
        assert one.stdout == other.stdout != "", name


def test_version():
    done = katagami("--version")
    assert done.returncode == 0 and re.fullmatch(r"katagami \d+\.\d+\.\d+\n", done.stdout), done


def test_full_disk_is_a_failure():
    if not os.path.exists("/dev/full"):
        raise script.Skip("this system has no /dev/full")
    with open("/dev/full", "w", encoding="utf-8") as full:
        done = subprocess.run([PROGRAM, "--help"], stdout=full, stderr=subprocess.PIPE, check=False)
    assert done.returncode == 1 and b"standard output" in done.stderr, done


if __name__ == "__main__":
    sys.exit(script.run(globals()))
