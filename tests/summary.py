"""Counts single tests over the logs of several `meson test` runs and prints the sum last.

usage: summary.py SETUP=TESTLOG.json …

Test programs print one TAP line per test ("ok 1 - name", "not ok 2 - name"); one that prints none
counts as a single test. A program that ends badly without a failed test (a crash, a sanitizer's
report, a timeout) counts as one failure.
"""

import json
import re
import sys

TAP_LINE = re.compile(r"^(not ok|ok) \d+(.*)$", re.MULTILINE)


def count(entry):
    """(passed, failed, skipped) of one test program."""
    passed = failed = skipped = 0
    for verdict, rest in TAP_LINE.findall(entry.get("stdout") or ""):
        if re.search(r"# skip", rest, re.IGNORECASE):
            skipped += 1
        elif verdict == "ok":
            passed += 1
        else:
            failed += 1
    result = entry["result"]
    if result not in ("OK", "SKIP", "EXPECTEDFAIL") and failed == 0:
        failed = 1
    elif passed + failed + skipped == 0:
        passed, skipped = (0, 1) if result == "SKIP" else (1, 0)
    return passed, failed, skipped


def sentence(counts):
    passed, failed, skipped = counts
    text = f"{passed} passed, {failed} failed"
    return text + f", {skipped} skipped" if skipped else text


def main(arguments):
    total = [0, 0, 0]
    for argument in arguments:
        setup, path = argument.split("=", 1)
        here = [0, 0, 0]
        try:
            with open(path, encoding="utf-8") as log:
                for line in log:
                    here = [a + b for a, b in zip(here, count(json.loads(line)))]
        except FileNotFoundError:
            here[1] = 1
            print(f"{setup}: the tests did not run", file=sys.stderr)
        print(f"{setup}: {sentence(here)}")
        total = [a + b for a, b in zip(total, here)]
    print(sentence(total))
    return 0 if total[0] > 0 and total[1] == 0 else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
