"""Killed at any moment, the app leaves whole files and work to go on with.

usage: test_kill.py KATAGAMI

A session edits on and on: each edit lifts the only patch by STEP, so that its height tells how many
edits a file holds. A mesh written after each edit tells how far the session got.
"""

import json
import os
import pathlib
import random
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import script  # noqa: E402

PROGRAM = pathlib.Path(sys.argv[1]).resolve()
SANITIZED = "LD_PRELOAD" in os.environ
POINTS = [[0, -40, 0], [0, -20, 30], [0, 20, 30], [0, 40, 0]]
STEP = 0.5  # mm
KILLS = 6 if SANITIZED else 24
KILLS_MOST = 80
DEADLINE_S = 30  # for the edits of a session
EDITS = 3000  # more than are done before the kill
AUTOSAVE_S = 0.4  # by the script's clock, in which an edit takes EDIT_S: itself and the mesh
EDIT_S = 2 / 60
LOST_MOST = AUTOSAVE_S / EDIT_S + 2  # edits: the interval, the one under way, the one of the mesh


def edits_in(model):
    """How many edits a model holds; it has to be the first one, lifted."""
    patches = model["patches"]
    assert len(patches) == 1 and patches[0]["extent"] == [-60, 60], patches
    height = patches[0]["points"][0][2]
    for now, then in zip(patches[0]["points"], POINTS):
        assert max(abs(a - b) for a, b in zip(now, [then[0], then[1], then[2] + height])) < 1e-6
    assert abs(height / STEP - round(height / STEP)) < 1e-6, height
    return round(height / STEP)


def read(path):
    """Of a model file that has to be whole, for us and for the program."""
    model = json.loads(path.read_text(encoding="utf-8"))
    done = subprocess.run([PROGRAM, "check", path], capture_output=True, check=False)
    assert done.returncode == 0, done.stderr
    return edits_in(model)


def edits_seen(mesh, chord=0.2):
    """Of the last mesh: its lowest vertices are the patch's first and last point."""
    if not mesh.exists():
        return 0
    rows = [line.split() for line in mesh.read_text(encoding="utf-8").splitlines()]
    heights = [float(row[3]) for row in rows if row and row[0] == "v"]
    assert heights, "half a mesh"
    assert abs(min(heights) / STEP - round(min(heights) / STEP)) < chord
    return round(min(heights) / STEP)


class Session:
    """A folder in which sessions follow each other, all killed."""

    def __init__(self, folder, chance):
        self.folder, self.chance = pathlib.Path(folder), chance
        self.file, self.mesh = self.folder / "one.katagami", self.folder / "seen.obj"
        self.file.write_text(json.dumps({"katagami": 1, "kind": "patches", "patches": [
            {"id": 1, "points": POINTS, "extent": [-60, 60]}]}), encoding="utf-8")
        self.recovered = 0

    def left_behind(self):
        return list((self.folder / "state" / "katagami").glob("autosave-*.katagami"))

    def lines(self):
        yield f"open {self.file}"
        yield f"autosave {AUTOSAVE_S / 60}"
        if self.left_behind():
            height = STEP * read(self.left_behind()[0])
            yield "recover"
            yield 'click "Recover"'
            yield f"expect point 1 0 0 -40 {height} 1e-6"
            yield "expect modified"
            yield "expect title ● one.katagami — katagami"
            yield "expect faults 0"
            yield "key Ctrl+Z"  # the history came along
            yield f"expect point 1 0 0 -40 {height - STEP} 1e-6"
            yield "key Ctrl+Y"
            self.recovered += 1
        saves = self.chance.randint(5, 60)
        for i in range(1, EDITS):
            yield f'command patch.move {{"patches": [1], "by": [0, 0, {STEP}]}}'
            yield f'command file.export_mesh {{"path": "{self.mesh}"}}'
            if i % saves == 0:
                yield "save"

    def run_and_kill(self):
        text = self.folder / "script.txt"
        text.write_text("\n".join(self.lines()) + "\n", encoding="utf-8")
        before = edits_seen(self.mesh)
        process = subprocess.Popen([PROGRAM, "edit", "--headless", "--script", text],
                                   cwd=self.folder, env=script.environment(self.folder), stderr=subprocess.PIPE,
                                   text=True)
        # So many edits later, not so much time: a slow machine has to reach the autosaves as well.
        edits, began = self.chance.randint(1, 60), time.monotonic()
        while (process.poll() is None and abs(edits_seen(self.mesh) - before) < edits and
               time.monotonic() - began < DEADLINE_S):
            time.sleep(0.002)
        time.sleep(self.chance.uniform(0, 0.05))
        process.kill()
        said = process.communicate()[1]
        if "EGL" in said or "OpenGL" in said:
            raise script.Skip("nothing can be drawn here")
        assert process.returncode in (-9, 0), said  # 0: it was through before the kill came

    def check(self):
        left = self.left_behind()
        assert len(left) <= 1, left
        kept = max([read(self.file)] + [read(path) for path in left])
        seen = edits_seen(self.mesh)
        assert kept <= seen + 1, (kept, seen)
        assert seen - kept <= LOST_MOST, f"{seen - kept} edits of {seen} are lost"
        return bool(left)


def test_killed_at_any_moment_files_are_whole_and_little_is_lost():
    with tempfile.TemporaryDirectory() as folder:
        session, kills, offered = Session(folder, random.Random(7)), 0, 0
        # Where exactly a kill hits is not ours to say: on until work was offered often enough.
        while kills < KILLS or offered < 3 or session.recovered < 2:
            assert kills < KILLS_MOST, f"of {kills} sessions {offered} left work to go on with"
            session.run_and_kill()
            offered += session.check()
            kills += 1


sys.exit(script.run(globals()))
