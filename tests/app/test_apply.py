"""Edits from a file. usage: test_apply.py KATAGAMI"""

import json
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import script  # noqa: E402

PROGRAM = sys.argv[1]
STRIP = [[0, -40, 0], [0, -20, 30], [0, 20, 30], [0, 40, 0]]
FIN = [[-30, 0, 0], [-10, 0, 10], [10, 0, 30], [10, 0, 60]]
EMPTY = {"katagami": 1, "kind": "patches", "patches": []}


def apply(edits, model=None):
    """The model after the edits, or None with what was said."""
    with tempfile.TemporaryDirectory() as folder:
        paths = [pathlib.Path(folder) / name for name in ("in.katagami", "e.json", "out.katagami")]
        paths[0].write_text(json.dumps(model or EMPTY), encoding="utf-8")
        paths[1].write_text(json.dumps(edits), encoding="utf-8")
        done = subprocess.run([PROGRAM, "apply", paths[0], paths[1], "-o", paths[2]], check=False,
                              capture_output=True, text=True)
        if done.returncode:
            assert not paths[2].exists()
            return done.returncode, done.stderr
        return 0, json.loads(paths[2].read_text(encoding="utf-8"))


def test_a_patch_is_added_with_its_fields():
    code, model = apply([{"command": "patch.add", "points": STRIP, "extent": [-60, 60],
                          "name": "back"}])
    assert code == 0, model
    [patch] = model["patches"]
    assert patch["points"] == STRIP and patch["extent"] == [-60, 60] and patch["name"] == "back"


def test_edits_build_a_trimmed_model():
    code, model = apply([
        {"command": "patch.add", "points": STRIP, "extent": [-60, 60]},
        {"command": "patch.add", "points": FIN, "extent": [-40, 30], "ruling": [0, 0, 1]},
        {"command": "trim.by", "patch": 2, "by": 1, "keep": [[0, 0, 50]]},
        {"command": "trim.contour", "patch": 1,
         "contour": [[-10, 0.4], [10, 0.4], [0, 0.6]], "keep": "outside"}])
    assert code == 0, model
    assert model["patches"][1]["trims"] == [{"by": [1], "keep": [[0, 0, 50]]}]
    assert model["patches"][0]["trims"][0]["keep"] == "outside"


def test_the_failing_edit_is_named_and_nothing_is_written():
    code, said = apply([{"command": "patch.add", "points": STRIP},
                        {"command": "patch.delete", "patch": 7}])
    assert code == 1 and "edit 2" in said and "7" in said, said


def test_commands_that_do_not_edit_are_refused():
    code, said = apply([{"command": "file.quit"}])
    assert code == 1 and "file.quit" in said, said


def test_what_is_no_list_is_refused():
    code, said = apply({"command": "patch.add"})
    assert code == 1 and "list" in said, said


def test_hundreds_of_steps_survive_in_the_file():
    step = {"command": "point.move", "patch": 1, "point": 0, "by": [0, 0, 0.01]}
    code, model = apply([{"command": "patch.add", "points": STRIP}] + [step] * 250)
    assert code == 0 and len(model["history"]["undo"]) == 251, model
    code, model = apply([step], model)
    assert code == 0 and len(model["history"]["undo"]) == 252, model


def test_mirroring_twice_gives_the_patch_back():
    code, model = apply([{"command": "patch.add", "points": FIN, "extent": [-40, 30]},
                         {"command": "patch.mirror", "normal": [1, 0, 0]},
                         {"command": "patch.mirror", "normal": [1, 0, 0]}])
    assert code == 0, model
    by_id = {patch["id"]: patch for patch in model["patches"]}
    assert by_id[3]["points"] == by_id[1]["points"] and by_id[3]["extent"] == by_id[1]["extent"]
    assert by_id[2]["extent"] == [-30, 40]


sys.exit(script.run(globals()))
