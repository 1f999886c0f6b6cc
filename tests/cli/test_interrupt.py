"""Ctrl+C leaves files whole or not there. usage: test_interrupt.py KATAGAMI"""

import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests"))
import script  # noqa: E402

PROGRAM = os.path.abspath(sys.argv[1])
DATA = ROOT / "data"
DEADLINE_S = 120


def interrupted(words, moment):
    """The files that a command leaves when it is interrupted: the moment is how many of its files,
    temporary ones as well, have been seen in its folder before."""
    with tempfile.TemporaryDirectory() as folder:
        home = pathlib.Path(folder, "home")
        work = pathlib.Path(folder, "work")
        work.mkdir()
        process = subprocess.Popen([PROGRAM, *map(str, words)], cwd=work, stderr=subprocess.PIPE,
                                   stdout=subprocess.DEVNULL, env=script.environment(home))
        seen, end = set(), time.monotonic() + DEADLINE_S
        while len(seen) < moment and process.poll() is None and time.monotonic() < end:
            seen |= set(os.listdir(work))
        process.send_signal(signal.SIGINT)
        said = process.communicate()[1].decode()
        if process.returncode == 1 and "EGL" in said:
            raise script.Skip("this machine cannot draw")
        assert process.returncode in (0, -signal.SIGINT), (process.returncode, said)
        for report in work.glob("*.json"):
            json.loads(report.read_text())
        return set(os.listdir(work)), process.returncode


def check(words, wanted):
    for moment in range(len(wanted) + 4):
        left, code = interrupted(words, moment)
        assert left in (set(), wanted), (moment, left)
        assert left == wanted or code != 0, (moment, left)


def test_a_net_its_guide_and_report_come_together_or_not_at_all():
    check(["net", DATA / "cup.katagami", "-o", "n.svg", "--guide", "g.pdf", "--json", "r.json"],
          {"n.svg", "g.pdf", "r.json"})


def test_pages_come_together_or_not_at_all():
    check(["net", DATA / "dolphin.katagami", "-o", "n.svg", "--rows"],
          pages(DATA / "dolphin.katagami", "--rows"))


def pages(model, *words):
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([PROGRAM, "net", model, "-o", "n.svg", *words], cwd=folder, check=True,
                       stderr=subprocess.DEVNULL)
        names = set(os.listdir(folder))
        assert len(names) > 1, names
        return names


def test_a_mesh_is_whole_or_not_there():
    check(["export", DATA / "dolphin.katagami", "-o", "m.obj"], {"m.obj"})


def test_a_card_is_whole_or_not_there():
    check(["oa", DATA / "castle.obj", "-o", "c.katagami", "--size", "30x15x20"], {"c.katagami"})


sys.exit(script.run(globals()))
