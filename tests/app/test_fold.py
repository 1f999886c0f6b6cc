"""Models folded by hand, by commands, and as the samples hold them. usage: test_fold.py KATAGAMI DATA"""

import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import script  # noqa: E402

PROGRAM, DATA = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])


def run(*arguments, folder=None, environment=None):
    return subprocess.run([PROGRAM, *arguments], check=False, capture_output=True, text=True,
                          cwd=folder, env=environment)


def final_state(model, folder):
    """The last state of a model: faces, where their vertices are, and how they lie on each other."""
    fold = folder / "state.fold"
    done = run("export", model, "-o", fold)
    assert done.returncode == 0, done.stderr
    pattern = json.loads(fold.read_text(encoding="utf-8"))
    state = pattern["file_frames"][0]
    return pattern["faces_vertices"], state["vertices_coords"], state["faceOrders"]


def assert_same_state(made, wanted, folder):
    a, b = final_state(made, folder), final_state(wanted, folder)
    assert a[0] == b[0], "other faces"
    assert len(a[1]) == len(b[1])
    far = max(abs(x - y) for p, q in zip(a[1], b[1]) for x, y in zip(p, q))
    assert far < 1e-6, far
    assert a[2] == b[2], "other orders of layers"


def by_hand(name, sample):
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place)
        for model in HERE.glob("*.katagami"):
            shutil.copy(model, folder)
        done = run("edit", "--headless", "--script", HERE / name, folder=place,
                   environment=script.environment(place, TMP=place, HERE=place))
        if done.returncode == 1 and ("EGL" in done.stderr or "OpenGL" in done.stderr):
            raise script.Skip("nothing can be drawn here")
        assert done.returncode == 0, done.stderr
        assert_same_state(folder / "made.katagami", DATA / sample, folder)


def apply(model, edits):
    """The model after the edits, or None with what was said."""
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place)
        for name, content in (("in.katagami", model), ("e.json", edits)):
            (folder / name).write_text(json.dumps(content), encoding="utf-8")
        done = run("apply", folder / "in.katagami", folder / "e.json", "-o",
                   folder / "out.katagami")
        if done.returncode:
            return None, done.stderr
        return json.loads((folder / "out.katagami").read_text(encoding="utf-8")), ""


def sample(name):
    return json.loads((DATA / name).read_text(encoding="utf-8"))


def unfolded(model):
    return dict(model, origami=dict(model["origami"], folds=[]))


def test_the_cup_is_folded_by_hand():
    by_hand("fold_cup.txt", "cup.katagami")


def test_a_strip_is_put_into_a_pocket_by_hand():
    by_hand("fold_unit.txt", "unit.katagami")


def test_edits_from_a_file_fold_every_sample():
    for name in ("boat.katagami", "cup.katagami", "unit.katagami"):
        wanted = sample(name)
        edits = [dict(fold, command="fold.make") for fold in wanted["origami"]["folds"]]
        made, said = apply(unfolded(wanted), edits)
        assert made is not None, said
        with tempfile.TemporaryDirectory() as place:
            path = pathlib.Path(place) / "made.katagami"
            path.write_text(json.dumps(made), encoding="utf-8")
            assert final_state(path, pathlib.Path(place)) == final_state(DATA / name,
                                                                         pathlib.Path(place))


def test_folds_are_changed_and_taken_out():
    boat = sample("boat.katagami")
    changes = [{"command": "fold.set", "angle_deg": 45},
               {"command": "fold.set", "step": 4, "angle_deg": 60}]
    made, said = apply(boat, changes)
    assert made is not None, said
    assert made["origami"]["folds"][3]["angle_deg"] == 60, made
    made, said = apply(boat, changes + [{"command": "fold.unfold"}])
    assert made is not None, said
    assert len(made["origami"]["folds"]) == 3, made


def test_a_fold_that_others_need_stays():
    boat = sample("boat.katagami")
    made, said = apply(boat, [{"command": "fold.unfold", "step": 3}])
    assert made is None and "edit 1" in said and "without fold 3" in said, said


def test_what_cannot_be_folded_is_refused():
    square = unfolded(sample("cup.katagami"))
    for edit, words in (
            ({"from": [0, 0, 0]}, "from"),
            ({"from": [0, 0, 0], "to": [0, 0, 0]}, "same"),
            ({"from": [7, 0, 0], "to": [50, 50, 0]}, "no vertex"),
            ({"axis": [[0, 0, 0]], "vertex": [0, 0, 0]}, "two points"),
            ({"from": [0, 0, 0], "to": [50, 50, 0], "layers": 2}, "only 1 layers"),
            ({"from": [0, 0, 0], "to": [50, 50, 0], "layers": 0}, "layers"),
            ({"from": [0, 0, 0], "to": [50, 50, 0], "between": [0]}, "between"),
            ({"from": [0, 0, 0], "to": [50, 50, 0], "angle_deg": 200}, "200"),
            ({"from": [0, 0, 0], "to": [50, 50, 0], "face": 9}, "no face 9")):
        made, said = apply(square, [dict(edit, command="fold.make")])
        assert made is None and words in said, (edit, said)


sys.exit(script.run(globals()))
