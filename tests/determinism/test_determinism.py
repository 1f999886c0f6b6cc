"""The same model gives the same bytes on every run and from every compiler.

usage: test_determinism.py KATAGAMI SAMPLES

The second compiler's program is named by the environment variable KATAGAMI_OTHER_BUILD, which
`./dev test` sets.
"""

import json
import os
import pathlib
import random
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import script  # noqa: E402

PROGRAM, SAMPLES = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
RANDOM_CARDS = 20


def written(program, model):
    """Everything that `net` and `export` write of a model: {file name: bytes}."""
    with tempfile.TemporaryDirectory() as folder:
        for words in (["net", model, "-o", "net.svg", "--json", "net.json"],
                      ["export", model, "-o", "model.obj"]):
            subprocess.run([program, *words], cwd=folder, check=True)
        return {f.name: f.read_bytes() for f in sorted(pathlib.Path(folder).iterdir())}


def wobbly_card(seed):
    """A card of random columns and windows, most of whose patches are loose."""
    r = random.Random(seed)
    w, d, h = r.randint(6, 24), r.randint(5, 12), r.randint(5, 12)
    depth = [[0] * h for _ in range(w)]
    for x in range(1, w - 1):
        if x == 1 or r.random() < 0.6:
            column = sorted((r.randint(0, d - 1) for _ in range(h - 1)), reverse=True)
        depth[x] = [*column, 0]
    windows = [[x, z] for x in range(w) for z in range(h) if depth[x][z] and r.random() < 0.1]
    return {"katagami": 1, "kind": "oa",
            "oa": {"size": [w, d, h], "cell_mm": 5, "depth": depth, "windows": windows}}


def standing(program):
    """Cards made to stand, of a mesh in three sizes and of random ones: {file name: bytes}."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for size in ("40x20x30", "80x40x40", "64x64x96"):
            for words in ([], ["--stable"], ["--stable", "--thin-top", "2", "--stretch"]):
                subprocess.run([program, "oa", SAMPLES / "castle.obj", "--size", size, *words, "-o",
                                f"{size}{''.join(words)}.katagami"], cwd=folder, check=True,
                               capture_output=True)
        (folder / "edits.json").write_text('[{"command": "card.stabilize"}]')
        for seed in range(RANDOM_CARDS):
            (folder / "wobbly.katagami").write_text(json.dumps(wobbly_card(seed)))
            subprocess.run([program, "apply", "wobbly.katagami", "edits.json", "-o",
                            f"random-{seed}.katagami"], cwd=folder, check=True)
        return {f.name: f.read_bytes() for f in sorted(folder.iterdir())}


def compare_standing(one, other):
    left, right = standing(one), standing(other)
    assert left.keys() == right.keys()
    for name, data in left.items():
        assert data == right[name], f"{name} differs"


def compare(one, other):
    models = sorted(SAMPLES.glob("*.katagami"))
    if not models:
        raise script.Skip("there are no sample models")
    for model in models:
        left, right = written(one, model), written(other, model)
        assert left.keys() == right.keys() and left, (model.name, left.keys(), right.keys())
        for name, data in left.items():
            assert data == right[name], f"{model.name}: {name} differs"


def other_build():
    other = os.environ.get("KATAGAMI_OTHER_BUILD")
    if not other or other == PROGRAM:
        raise script.Skip("only one build to look at")
    return other


def test_two_runs_write_the_same_bytes():
    compare(PROGRAM, PROGRAM)


def test_two_compilers_write_the_same_bytes():
    compare(PROGRAM, other_build())


def test_two_runs_make_cards_stand_alike():
    compare_standing(PROGRAM, PROGRAM)


def test_two_compilers_make_cards_stand_alike():
    compare_standing(PROGRAM, other_build())


if __name__ == "__main__":
    sys.exit(script.run(globals()))
