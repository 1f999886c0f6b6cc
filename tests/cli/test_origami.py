"""Folded sheets through the commands: python3 test_origami.py KATAGAMI"""

import json
import math
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests"))
import script  # noqa: E402

KATAGAMI = os.path.abspath(sys.argv[1])
DATA = ROOT / "data"
FOLDER = tempfile.TemporaryDirectory()
HERE = pathlib.Path(FOLDER.name)


run = script.program(KATAGAMI, HERE)


def sheet(folds=(), **more):
    """A square of 100 mm with folds as a file."""
    path = HERE / "sheet.katagami"
    path.write_text(json.dumps({
        "katagami": 1, "kind": "origami", "title": "test", **more, "origami": {
            "sheets": [{"polygon": [[0, 0], [100, 0], [100, 100], [0, 100]]}],
            "folds": list(folds)}}, indent=1))
    return path


HALF = {"from": [0, 0, 0], "to": [100, 100, 0], "angle_deg": 180}


def at(angle):
    """Where the folded corner of HALF is after so many degrees."""
    turn, middle = math.radians(angle), 50
    way = middle * (1 - math.cos(turn))
    return [way, way, middle * 2 ** 0.5 * math.sin(turn)]


def test_info_counts_folds_and_creases():
    text = run("info", DATA / "cup.katagami").stdout
    assert text.startswith("cup: 1 sheet, 5 folds, 8 faces"), text
    origami = json.loads(run("info", sheet([HALF]), "--json").stdout)["origami"]
    assert (origami["sheets"], origami["folds"], origami["faces"]) == (1, 1, 2), origami
    assert abs(origami["valley_mm"] - 2 ** 0.5 * 100) < 1e-6 and origami["mountain_mm"] == 0
    assert "states" not in origami


def test_info_counts_the_orders_of_a_pattern_that_holds_its_own():
    before = run("info", DATA / "crane.fold").stdout
    run("export", DATA / "crane.fold", "-o", "again.fold")
    frames = json.loads((HERE / "again.fold").read_text())["file_frames"]
    assert any(frame.get("faceOrders") for frame in frames)
    after = run("info", "again.fold").stdout
    assert "can lie in 4 ways" in before and "can lie in 4 ways" in after, (before, after)
    assert json.loads(run("info", "again.fold", "--json").stdout)["origami"]["states"] == 4


def test_check_finds_nothing_wrong():
    for name in ["cup.katagami", "boat.katagami", "unit.katagami", "crane.fold"]:
        assert "nothing to complain of" in run("check", DATA / name).stdout


def test_a_fold_that_is_impossible_is_named_with_its_line():
    bad = sheet([HALF, {"from": [0, 0, 0], "to": [5, 5, 0]}])
    for words in [["info"], ["check"], ["net", "-o", "x.svg"], ["export", "-o", "x.obj"]]:
        done = run(words[0], bad, *words[1:], expect=1)
        assert "sheet.katagami:" in done.stderr and "fold 2:" in done.stderr, done.stderr
    assert not (HERE / "x.svg").exists() and not (HERE / "x.obj").exists()


def test_broken_files_are_refused_with_line_or_vertex():
    for name, text, message in [
            ("a.fold", '{"vertices_coords": [[0,0],', "a.fold:1:"),
            ("b.cp", "1 0 0 10 0\n9 0 0 1 1\n", "b.cp:2:"),
            ("c.katagami", '{"katagami": 1, "kind": "origami", "origami": {"sheets": []}}',
             "1 to"),
            # three creases at one vertex inside never fold flat
            ("d.cp", "1 0 0 10 0\n1 10 0 10 10\n1 10 10 0 10\n1 0 10 0 0\n3 0 0 5 5\n"
             "3 10 0 5 5\n2 10 10 5 5\n", "Kawasaki")]:
        (HERE / name).write_text(text)
        done = run("info", name, expect=1)
        assert message in done.stderr, done.stderr


def test_the_net_object_of_the_file_is_kept_to():
    run("net", sheet([HALF], net={"paper": "A3", "margin": 30, "scale": 0.5}), "-o", "a.svg")
    text = (HERE / "a.svg").read_text(encoding="utf-8")
    assert 'width="297mm" height="420mm"' in text, text[:300]
    run("net", sheet([HALF], net={"paper": "A3"}), "-o", "b.svg", "--paper", "none")
    assert 'viewBox="0 0 100 100"' in (HERE / "b.svg").read_text(encoding="utf-8")
    run("net", sheet([HALF], net={"paper": "none", "scale": 0.5}), "-o", "c.svg")
    assert 'viewBox="0 0 50 50"' in (HERE / "c.svg").read_text(encoding="utf-8")
    for wrong, word in [({"margin": -1}, "margin"), ({"scale": "big"}, "scale"),
                        ({"paper": "A99"}, "A99"), ({"paper": 4}, "net"), (7, "net")]:
        assert word in run("net", sheet(net=wrong), "-o", "d.svg", expect=1).stderr
    assert not (HERE / "d.svg").exists()


def test_the_crease_pattern_has_one_line_a_fold():
    for ending in ["svg", "pdf", "dxf"]:
        run("net", sheet([HALF]), "-o", f"p.{ending}")
        assert (HERE / f"p.{ending}").stat().st_size > 0
    text = (HERE / "p.svg").read_text(encoding="utf-8")
    assert 'id="valley"' in text and 'id="mark"' not in text
    for angle in [180, 90, 30]:  # unfolded again, a crease is a mark
        run("net", sheet([HALF | {"angle_deg": angle},
                          {"axis": [[100, 0, 0], [0, 100, 0]], "vertex": at(angle),
                           "angle_deg": -angle}]), "-o", "p.svg")
        text = (HERE / "p.svg").read_text(encoding="utf-8")
        assert 'id="valley"' not in text and 'id="mark"' in text, angle


def corners(obj):
    return [[float(x) for x in line.split()[1:4]]
            for line in (HERE / obj).read_text().splitlines() if line.startswith("v ")]


def test_every_mesh_format_holds_the_folded_sheet():
    for ending in ["obj", "ply", "stl", "off", "gltf", "glb", "fold", "cp"]:
        run("export", sheet([HALF]), "-o", f"m.{ending}")
        assert (HERE / f"m.{ending}").stat().st_size > 0
    assert all(x + y > 99.99 for x, y, _ in corners("m.obj"))
    run("export", sheet([HALF]), "-o", "flat.obj", "--step", "0")
    assert sorted(corners("flat.obj"))[0][:2] == [0, 0]
    assert "no step 2" in run("export", sheet([HALF]), "-o", "x.obj", "--step", "2",
                              expect=1).stderr


def test_gltf_moves_from_the_flat_sheet_to_the_model():
    run("export", sheet([HALF]), "-o", "m.gltf")
    model = json.loads((HERE / "m.gltf").read_text())
    [animation] = model["animations"]
    channel = animation["channels"][0]
    assert channel["target"]["path"] == "weights"
    targets = len(model["meshes"][0]["primitives"][0]["targets"])
    times = model["accessors"][animation["samplers"][0]["input"]]
    assert targets == 3 and times["count"] == 2 + 180 // 5 + 1
    weights = model["accessors"][animation["samplers"][0]["output"]]
    assert weights["count"] == targets * times["count"]
    run("export", sheet(), "-o", "m.gltf")
    assert "animations" not in json.loads((HERE / "m.gltf").read_text())


def test_render_shows_any_step_and_the_way_to_the_next():
    def picture(*words):
        done = subprocess.run([KATAGAMI, "render", str(sheet([HALF])), "-o", "p.png", "--size",
                               "120x90", *words], capture_output=True, text=True, cwd=HERE,
                              check=False)
        if done.returncode == 1 and "EGL" in done.stderr:
            raise script.Skip("this machine cannot draw")
        assert done.returncode == 0, done
        return (HERE / "p.png").read_bytes()

    flat, half, folded = picture("--step", "0"), picture("--step", "0", "--fraction", "0.5"), \
        picture()
    assert len({flat, half, folded}) == 3
    assert picture("--step", "1") == folded
    run("render", sheet([HALF]), "-o", "x.png", "--step", "2", expect=1)
    run("render", sheet([HALF]), "-o", "x.png", "--fraction", "2", expect=2)


def test_the_guide_says_every_step_in_words():
    if not shutil.which("pdftotext"):
        raise script.Skip("pdftotext is not installed")

    def words(path):
        run("net", path, "-o", "n.svg", "--guide", "g.pdf")
        done = subprocess.run(["pdftotext", "-layout", HERE / "g.pdf", "-"], capture_output=True,
                              text=True, check=True)
        return " ".join(done.stdout.split())

    cup = words(DATA / "cup.katagami")
    for text in ["Fold the corner behind, to the other corner.", "to the circled point on the",
                 "62.1 mm", "Fold the edge to the line that it meets.", "only, of 2.",
                 "The finished model.", "Crease pattern",
                 "Sheet 1: 150 × 150 mm", "cup · folding steps"]:
        assert text in cup, (text, cup)
    unit = words(DATA / "unit.katagami")
    for text in ["Tuck it between two", "Turn it by 90° only.", "Seen from an angle.",
                 "Fold the edge to the other edge."]:
        assert text in unit, (text, unit)
    assert "Folded along all its creases." in words(DATA / "crane.fold")


def test_patterns_without_a_unit_get_a_size_and_say_so():
    pattern = {"vertices_coords": [[0, 0], [1, 0], [1, 1], [0, 1]],
               "edges_vertices": [[0, 1], [1, 2], [2, 3], [3, 0], [0, 2]],
               "edges_assignment": ["B", "B", "B", "B", "V"]}
    (HERE / "unit.fold").write_text(json.dumps(pattern))
    for words in (["info"], ["net", "-o", "unit.svg"], ["export", "-o", "unit.obj"]):
        told = run(words[0], "unit.fold", *words[1:]).stderr
        assert "unit.fold: it names no unit" in told and "1 became 150 mm" in told, told
    assert "valley folds 212.1 mm" in run("info", "unit.fold").stdout
    (HERE / "mm.fold").write_text(json.dumps({"frame_unit": "mm", **pattern}))
    assert "unit" not in run("info", "mm.fold").stderr
    assert "valley folds 1.4 mm" in run("info", "mm.fold").stdout


def test_a_model_is_no_mesh_for_a_card():
    assert run("oa", DATA / "cup.katagami", "-o", "x.katagami", expect=1).stderr
    assert not (HERE / "x.katagami").exists()


sys.exit(script.run(globals()))
