"""Undo and redo of every command that edits patches, sheets or cards: of random ones, each state
comes back byte by byte. usage: test_undo.py KATAGAMI"""

import json
import os
import pathlib
import random
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import script  # noqa: E402

PROGRAM = os.path.abspath(sys.argv[1])
HERE = pathlib.Path(__file__).resolve().parent
STEPS = 60
SKIPPED = 77


class Patches:
    """Random edits: most of them are possible in a model that grows from three patches."""
    start = "two.katagami"
    least = STEPS // 3

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.patches = 3

    def patch(self):
        return self.random.randint(1, self.patches)

    def number(self, reach=20):
        return round(self.random.uniform(-reach, reach), 3)

    def place(self):
        return [self.number(), self.number(), self.number()]

    def some(self):
        return self.random.sample(range(1, self.patches + 1), self.random.randint(1, 2))

    def on(self):
        return self.random.random() < 0.5

    def contour(self):
        u, v, w, h = (self.random.uniform(*r) for r in ((-20, 5), (0.1, 0.6), (2, 15), (0.1, 0.3)))
        return [[u, v], [u + w, v], [u + w, v + h], [u, v + h]]

    def all(self):
        patch, some, place, number = self.patch(), self.some(), self.place, self.number
        several = {"patches": some}
        one = {"patch": patch}
        trim = {"patch": patch, "trim": self.random.randint(0, 1)}
        return [
            ("patch.add", {"points": [[-30, 0, number()], [-10, number(), 10],
                                      [10, number(), 10], [30, 0, number()]],
                           "extent": [-15, 25], "name": "新しい \"n\""}),
            ("patch.set", one | {"extent": [-abs(number()) - 1, abs(number()) + 1]}),
            ("patch.set", one | {"ruling": [0, 1, number(0.3)], "flip": self.on()}),
            ("patch.delete", one),
            ("patch.duplicate", several),
            ("patch.mirror", several | {"normal": [1, number(1), 0], "point": place()}),
            ("patch.move", several | {"by": place()}),
            ("patch.rotate", several | {"angle_deg": number(180), "axis": [0, 1, number(1)]}),
            ("patch.scale", several | {"factor": self.random.uniform(0.5, 1.5)}),
            ("patch.flip", several), ("patch.hide", several),
            ("patch.construction", several | {"on": self.on()}),
            ("patch.show_all", {}), ("patch.isolate", several),
            ("patch.rename", several | {"name": self.random.choice(["", "鰭", "a"])}),
            ("patch.color", several | {"color": f"#{self.random.randrange(1 << 24):06x}"}),
            ("patch.refit", one), ("patch.planarize", one), ("patch.narrow", one),
            ("patch.equalise", one), ("patch.split", one),
            ("point.move", one | {"point": self.random.randint(0, 3), "by": place()}),
            ("point.move", one | {"point": self.random.randint(0, 3), "to": place()}),
            ("trim.by", one | {"by": self.patch(), "bounded": self.on(), "keep": [place()]}),
            ("trim.inside", one | {"by": [self.patch(), self.patch()],
                                   "trim_cutters": self.on()}),
            ("trim.contour", one | {"contour": self.contour(),
                                    "keep": self.random.choice(["inside", "outside"])}),
            ("trim.set", trim | {"off": self.on()}),
            ("trim.set", trim | {"bounded": self.on()}),
            ("trim.move", trim | {"to": self.random.randint(0, 1)}),
            ("trim.remove", trim),
            ("reference.set", {"opacity": self.random.random(), "visible": self.on()}),
            ("reference.toggle", {}),
            ("net.set", {"margin": abs(number()), "tab_width": abs(number(9)),
                         "landscape": self.on(), "paper": self.random.choice(["a4", "a3"])}),
            ("net.pin", one | {"piece": 0, "page": 0, "x": 50 + number(), "y": 60 + number(),
                               "angle_deg": number(90)}),
            ("net.unpin", {}),
            ("net.join", {"patches": [1, 2], "tab": self.random.choice(["this", "none", "both"])}),
        ]

    def next(self):
        edit = self.random.choice(self.all())
        if edit[0] in ("patch.add", "patch.duplicate"):
            self.patches = min(self.patches + 1, 12)
        return edit


class Folds:
    """Random folds between places where corners often are, and all else that is done to sheets."""
    start = "square.katagami"
    least = STEPS // 5

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.count = 0

    def place(self):
        return [self.random.randint(0, 4) * 37.5, self.random.randint(0, 4) * 37.5, 0]

    def corner(self):
        return [self.random.choice([0, 150]), self.random.choice([0, 150]), 0]

    def angle(self):
        return self.random.choice([180, 180, 180, -180, 90, -45])

    def fold(self):
        by_axis = {"axis": [self.place(), self.place()], "vertex": self.corner()}
        by_corner = {"from": self.corner(), "to": self.place()}
        layers = self.random.choice([{}, {}, {"layers": 2}])
        return ("fold.make", self.random.choice([by_axis, by_corner]) | layers
                | {"angle_deg": self.angle()})

    def sheet(self):
        color = f"#{self.random.randrange(1 << 24):06x}"
        by = [self.random.uniform(-20, 20), self.random.uniform(-20, 20)]
        return self.random.choice([
            ("sheet.add", {"shape": "triangle", "size": 80, "at": by, "front": color}),
            ("sheet.add", {"shape": "square", "size": 150}), ("sheet.move", {"sheet": 2, "by": by}),
            ("sheet.color", {"sheet": 1, "back": color}),
            ("sheet.turn", {"sheet": 2, "angle_deg": self.random.uniform(-180, 180)}),
            ("sheet.raise", {"sheet": 1}), ("sheet.lower", {"sheet": 2}),
            ("sheet.duplicate", {"sheet": 1}), ("sheet.remove", {"sheet": 2})])

    def next(self):
        self.count += 1
        if self.count <= 8 or self.random.random() < 0.05:
            return self.sheet()
        step = {"step": self.random.randint(0, 4)}
        return self.random.choice([self.fold()] * 9 + [
            ("fold.set", step | {"angle_deg": self.angle()}), ("fold.unfold", {}),
            ("fold.unfold", step), ("step.from_here", step), ("step.from_here", step),
            ("net.set", {"margin": self.random.uniform(0, 20)})])


class Cards:
    """Random edits of cards, few of which lie outside it."""
    start = "card.katagami"
    least = STEPS // 3

    def __init__(self, seed):
        self.random = random.Random(seed)

    def spot(self):
        return {k: self.random.randint(0, 9 if k == "x" else 7) for k in "xyz"}

    def face(self):
        return {k: self.random.randint(0, 9 if k == "x" else 4) for k in "xz"}

    def on(self):
        return self.random.random() < 0.5

    def box(self):
        ends = list(self.spot().values()), list(self.spot().values())
        return {"from": ends[0], "to": ends[1], "remove": self.random.random() < 0.2}

    def next(self):
        size = {"width": self.random.randint(8, 14), "depth": self.random.randint(6, 9),
                "height": self.random.randint(6, 9)}
        some = dict(self.random.sample(sorted(size.items()), 2))
        by = {"by": self.random.choice([-2, -1, 1, 2])}
        spot, face = self.spot(), self.face()
        return self.random.choice([
            ("card.add", spot), ("card.remove", spot),
            ("card.box", self.box()), ("card.box", self.box()), ("card.box", self.box()),
            ("card.pull", face | by),
            ("card.pull", {"x": spot["x"], "y": spot["y"], "top": True} | by),
            ("card.window", face), ("card.window", face | {"on": self.on()}),
            ("card.top", face), ("card.fill_windows", {}),
            ("card.fill_windows", {"from": [0, 0, 0], "to": list(spot.values())}),
            ("card.omit_thin", {"depth": self.random.randint(0, 3)}),
            ("card.mirror_now", {"from": self.random.choice(["left", "right"])}),
            ("card.diagonals", {"on": self.on()}), ("card.resize", some),
            ("card.symmetry", {"on": self.on()}),
            ("card.clear", {}) if self.on() else ("card.box", self.box()),
            ("card.set", {"title": self.random.choice(["", "家 \"n\"", "a"]),
                          "cell_mm": self.random.uniform(0.5, 20)}),
            ("card.set", {"margin_cells": self.random.randint(0, 3),
                          "tiny_mm": self.random.uniform(0, 5)}),
            ("net.set", {"margin": self.random.uniform(0, 20), "landscape": self.on(),
                         "paper": self.random.choice(["a4", "a3"])}),
        ])


def content(path):
    """The bytes of a model without its history."""
    text = path.read_text(encoding="utf-8")
    model = json.loads(text)
    model.pop("history", None)
    return json.dumps(model, ensure_ascii=False)


def run(lines, folder):
    path = folder / "s.txt"
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    done = subprocess.run([PROGRAM, "edit", "--headless", "--script", path], check=False,
                          capture_output=True, text=True, env=script.environment(folder))
    if done.returncode and re.search(r"EGL|OpenGL", done.stderr):
        print(done.stderr)
        sys.exit(SKIPPED)
    assert done.returncode == 0, done.stderr


def states_of(folder, name):
    return [content(path) for path in sorted(folder.glob(name + "*.katagami"))]


def without_repeats(states):
    return [s for i, s in enumerate(states) if i == 0 or s != states[i - 1]]


def values_of(states):
    """What the states say: a key that the file has once stays in it, though it may be empty."""
    models = [json.loads(s) for s in states]
    return [{key: m[key] for key in m if m[key] != {}} for m in models]


def steps_of(folder, count):
    """Lines that go through the history and save each state."""
    lines = []
    for verb in ("undo", "redo"):
        for i in range(1, count + 1):
            lines += [f"command edit.{verb}", f"save {folder}/{verb}{i:03}.katagami"]
    return lines


def check(edits, seed, folder):
    model = json.loads((HERE / edits.start).read_text(encoding="utf-8"))
    if model["kind"] == "patches":
        model["reference"] = {"file": "mesh.obj"}
    if model["kind"] == "oa":  # all keys, so that none appears on the way
        model["oa"] |= {"margin_cells": 0, "tiny_mm": 2, "diagonals": False,
                        "windows": [], "omitted": []}
    (folder / "mesh.obj").write_text("v 0 0 0\nv 50 0 0\nv 0 50 0\nf 1 2 3\n")
    (folder / "start.katagami").write_text(json.dumps(model), encoding="utf-8")
    lines = [f"open {folder}/start.katagami", "wait", f"save {folder}/done000.katagami"]
    for i in range(1, STEPS + 1):
        name, arguments = edits.next()
        lines += [f"try {name} {json.dumps(arguments, ensure_ascii=False)}", "wait",
                  f"save {folder}/done{i:03}.katagami"]
    run(lines + steps_of(folder, STEPS), folder)
    done = without_repeats(states_of(folder, "done"))
    steps = len(done) - 1
    # more steps back than there are change nothing
    assert states_of(folder, "undo") == done[-2::-1] + [done[0]] * (STEPS - steps), f"seed {seed}"
    assert states_of(folder, "redo") == done[1:] + [done[-1]] * (STEPS - steps), f"seed {seed}"
    # the history is in the file: the same after it was opened again
    run([f"open {folder}/done{STEPS:03}.katagami", "wait", f"expect undo steps {steps}"]
        + steps_of(folder, steps) + ["expect redo steps 0"], folder)
    undone, redone = (values_of(states_of(folder, verb)[:steps]) for verb in ("undo", "redo"))
    assert undone == values_of(done[-2::-1]), f"seed {seed}, opened again"
    assert redone == values_of(done[1:]), f"seed {seed}, opened again"
    return steps


def main():
    for kind in (Patches, Folds, Cards):
        for seed in range(1, 4):
            with tempfile.TemporaryDirectory() as folder:
                steps = check(kind(seed), seed, pathlib.Path(folder))
                print(f"seed {seed}: {steps} of {STEPS} edits changed the model, all came back")
                assert steps > kind.least


if __name__ == "__main__":
    main()
