"""Pop-up cards through the commands: python3 test_cards.py KATAGAMI"""

import json
import os
import pathlib
import re
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


def card(**changes):
    """A small house as a file, with members of its card changed or (None) left out."""
    oa = {"size": [5, 4, 5], "cell_mm": 10,
          "depth": [[0] * 5, [2, 2, 2, 0, 0], [2, 2, 2, 0, 0], [2, 2, 2, 0, 0], [0] * 5]}
    oa.update(changes)
    oa = {key: value for key, value in oa.items() if value is not None}
    path = HERE / "card.katagami"
    path.write_text(json.dumps({"katagami": 1, "kind": "oa", "oa": oa}, indent=1))
    return path


def lines_of(svg, layer):
    """Unit lines of a layer as pairs of points in cells of 10 mm."""
    text = pathlib.Path(svg).read_text(encoding="utf-8")
    group = re.search(rf'<g [^>]*id="{layer}">(.*?)</g>', text, re.DOTALL)
    lines = set()
    for x0, y0, x1, y1 in re.findall(r'd="M ([\d.]+),([\d.]+) L ([\d.]+),([\d.]+)"',
                                     group[1] if group else ""):
        x, y, x1, y1 = (round(float(v) / 10) for v in (x0, y0, x1, y1))
        while (x, y) != (x1, y1):
            to = (x + (x1 > x) - (x1 < x), y + (y1 > y) - (y1 < y))
            assert ((x, y), to) not in lines
            lines.add(((x, y), to))
            x, y = to
    return lines


def test_net_of_a_box_is_its_lines():
    run("net", card(), "-o", "net.svg", "--paper", "none")
    text = (HERE / "net.svg").read_text(encoding="utf-8")
    assert 'viewBox="0 0 50 90"' in text
    assert "M 0,0 L 50,0 L 50,90 L 0,90 Z" in text
    # t = z - y is 5 at the top: the roof from t = 3 to 1, the front from 1 to -2
    across = lambda row: {((x, row), (x + 1, row)) for x in range(1, 4)}
    assert lines_of(HERE / "net.svg", "mountain") == across(4)
    ground = {((0, 5), (1, 5)), ((4, 5), (5, 5))}
    assert lines_of(HERE / "net.svg", "valley") == across(2) | across(7) | ground
    sides = {((x, y), (x, y + 1)) for x in (1, 4) for y in range(2, 7)}
    assert lines_of(HERE / "net.svg", "cut") == sides


def test_window_lies_back_on_its_sill():
    run("net", card(windows=[[2, 1]]), "-o", "net.svg", "--paper", "none")
    # the cell of level 1 is in row 5; its lower edge is a fold, the other three are cuts
    assert ((2, 6), (3, 6)) in lines_of(HERE / "net.svg", "mountain")
    cuts = lines_of(HERE / "net.svg", "cut")
    assert {((2, 5), (3, 5)), ((2, 5), (2, 6)), ((3, 5), (3, 6))} <= cuts


def test_margin_cells_widen_the_sheet():
    run("net", card(margin_cells=2), "-o", "net.svg", "--paper", "none")
    assert 'viewBox="0 0 90 130"' in (HERE / "net.svg").read_text(encoding="utf-8")


def test_all_commands_take_cards():
    path = card()
    info = json.loads(run("info", path, "--json").stdout)
    assert info["card"]["degrees_of_freedom"] == 1 and info["card"]["valid"]
    assert info["parts"][0]["area_mm2"] == 4500
    assert abs(info["parts"][0]["surface_mm2"] - 4500) < 1e-6
    run("check", path)
    for name in ("a.pdf", "a.dxf"):
        run("net", path, "-o", name)
    for name in ("a.obj", "a.ply", "a.stl", "a.off", "a.gltf", "a.glb", "a.fold"):
        run("export", path, "-o", name, "--open", "45")
    fold = json.loads((HERE / "a.fold").read_text(encoding="utf-8"))
    assert set(fold["edges_assignment"]) == {"B", "C", "M", "V"}


def test_pose_follows_the_angle():
    for angle in (0, 90, 180):
        run("export", card(), "-o", "pose.obj", "--open", angle)
        points = [tuple(map(float, line.split()[1:]))
                  for line in (HERE / "pose.obj").read_text(encoding="utf-8").splitlines()
                  if line.startswith("v ")]
        low, high = ([f(p[i] for p in points) for i in range(3)] for f in (min, max))
        size = [b - a for a, b in zip(low, high)]
        wanted = {0: [50, 50, 0], 90: [50, 40, 50], 180: [50, 90, 0]}[angle]
        assert all(abs(a - b) < 1e-6 for a, b in zip(size, wanted)), (angle, size)
    run("export", card(), "-o", "pose.obj", "--open", "181", expect=2)


def test_what_floats_is_an_error_of_check_and_a_warning_elsewhere():
    path = card(windows=[[1, 0], [2, 0], [3, 0]])
    place, reason = "front at depth 2, columns 1-3, levels 1-2", "stands on nothing below"
    done = run("check", path, expect=1)
    assert f"error: {place}: a front that {reason}" in done.stdout, done.stdout
    errors = json.loads(run("check", path, "--json", expect=1).stdout)["errors"]
    assert [e["code"] for e in errors] == ["not-carried"]
    done = run("net", path, "-o", "net.svg", "--json", "net.json")
    assert "katagami net: warning: " + place in done.stderr and (HERE / "net.svg").exists()
    warnings = json.loads((HERE / "net.json").read_text(encoding="utf-8"))["warnings"]
    assert warnings[0]["code"] == "not-carried" and reason in warnings[0]["message"]
    for command, name in (("export", "a.obj"), ("export", "a.fold"), ("render", "a.png")):
        done = run(command, path, "-o", name)
        assert f"katagami {command}: warning: {place}" in done.stderr, done.stderr
        assert (HERE / name).exists()
    info = json.loads(run("info", path, "--json").stdout)
    assert not info["card"]["valid"]
    assert info["warnings"][0]["code"] == "not-carried"
    for command, name in (("export", "b.obj"), ("render", "b.png")):
        assert run(command, card(), "-o", name).stderr == ""


def test_tiny_features_are_warned_of_below_their_limit():
    codes = lambda *words: [w["code"] for w in
                            json.loads(run("check", *words, "--json").stdout)["warnings"]]
    both = ["tiny-fold", "tiny-neck"]
    assert codes(card()) == [] and codes(card(cell_mm=1)) == both
    assert codes(card(cell_mm=1, tiny_mm=1)) == [] and codes(card(tiny_mm=11)) == both
    assert codes(card(cell_mm=1), "--tiny", "0") == []
    assert codes(card(tiny_mm=1), "--tiny", "11") == both
    assert "10 mm: a fold so short" in run("check", card(), "--tiny", "11").stdout
    run("check", card(), "--tiny", "-1", expect=2)
    run("check", card(), "--tiny", "x", expect=2)
    run("oa", DATA / "castle.obj", "-o", "tiny.katagami", "--size", "20x10x10", "--tiny", "0.5")
    assert json.loads((HERE / "tiny.katagami").read_text(encoding="utf-8"))["oa"]["tiny_mm"] == 0.5
    # what counts is the size on paper
    assert "tiny" not in run("net", card(cell_mm=2), "-o", "net.svg").stderr
    assert "so short" in run("net", card(cell_mm=2), "-o", "net.svg", "--scale", "0.5").stderr


def test_broken_cards_are_refused_with_the_place():
    columns = [[0] * 5, [2, 3, 2, 0, 0], [0] * 5, [0] * 5, [0] * 5]
    for changes, words in [
            ({"depth": columns}, ("column 1, level 1",)),
            ({"size": [0, 4, 5]}, ("width",)),
            ({"size": [5, 4, 10 ** 9]}, ("height",)),
            ({"size": None}, ("size",)),
            ({"windows": [[5, 0]]}, ("window [5, 0]", "column", "0 to 4")),
            ({"windows": [[1, 0], [2, 7]]}, ("window [2, 7]", "level", "0 to 4")),
            ({"windows": [[0, 0]]}, ("column 0",)),
            ({"omitted": [[1, 2]]}, ("column 1", "height 2")),
            ({"tiny_mm": -1}, ("tiny_mm",)),
            ({"cell_mm": -1}, ("cell_mm",))]:
        path = card(**changes)
        for command in (("check",), ("net", "-o", "no.svg"), ("export", "-o", "no.obj")):
            done = run(command[0], path, *command[1:], expect=1)
            assert re.search(r"card\.katagami:\d+: ", done.stderr), done.stderr
            assert all(word in done.stderr for word in words), (words, done.stderr)
    assert not (HERE / "no.svg").exists() and not (HERE / "no.obj").exists()


def test_mesh_becomes_a_card():
    run("oa", DATA / "castle.obj", "-o", "castle.katagami", "--size", "60x30x40", "--thin-top", "1",
        "--diagonals")
    model = json.loads((HERE / "castle.katagami").read_text(encoding="utf-8"))
    assert model["oa"]["size"] == [60, 30, 40] and len(model["oa"]["windows"]) > 20
    run("check", "castle.katagami")
    run("oa", DATA / "castle.obj", "-o", "closed.katagami", "--size", "60x30x40", "--no-windows")
    assert "windows" not in json.loads((HERE / "closed.katagami").read_text(encoding="utf-8"))["oa"]


def converted(name, *words):
    told = run("oa", DATA / "castle.obj", "-o", f"{name}.katagami", *words).stderr
    stands = "[loose]" not in run("check", f"{name}.katagami").stdout
    assert stands != ("warning: patches that are loose: " in told), told
    return json.loads((HERE / f"{name}.katagami").read_text(encoding="utf-8"))["oa"]


def test_card_of_a_mesh_stands_when_asked():
    wobbly, firm = converted("wobbly"), converted("firm", "--stable")
    assert "[loose]" in run("check", "wobbly.katagami").stdout
    assert "[loose]" not in run("check", "firm.katagami").stdout
    assert "[flap]" not in run("check", "firm.katagami").stdout
    voxels = [v for column in wobbly["depth"] for v in column]
    changed = [abs(a - b) for a, b in zip(voxels, (v for c in firm["depth"] for v in c))]
    assert sum(changed) < sum(voxels) / 50
    assert converted("again", "--stable") == firm


def test_closed_card_covers_its_model_when_asked():
    wide = ("--size", "80x30x30", "--stretch")
    assert "margin_cells" not in converted("bare", *wide)
    assert "[overhang]" in run("check", "bare.katagami").stdout
    assert "sticks out" in run("net", "bare.katagami", "-o", "bare.svg").stderr
    fit = converted("fit", *wide, "--margin", "fit")
    assert "[overhang]" not in run("check", "fit.katagami").stdout
    margin = fit["margin_cells"]
    assert margin > 0 and fit["cell_mm"] * (80 + 2 * margin) <= 194  # an A4 within its margins
    less = converted("less", *wide, "--margin", str(margin - 1))
    assert less["margin_cells"] == margin - 1
    assert "[overhang]" in run("check", "less.katagami").stdout
    chosen = converted("chosen", *wide, "--margin", "fit", "--cell", "5")
    assert chosen["margin_cells"] == margin and chosen["cell_mm"] == 5


def test_wrong_options_are_usage():
    mesh = DATA / "castle.obj"
    for words in (["--size", "4x4"], ["--size", "0x4x4"], ["--size", "9000x4x4"],
                  ["--up", "w"], ["--up", "y", "--front", "-y"], ["--smooth", "2"],
                  ["--thin-top", "-1"], ["--windows", "--no-windows"], ["--cell", "0"],
                  ["--margin", "-1"], ["--margin", "1.5"], ["--margin", "wide"]):
        run("oa", mesh, "-o", "no.katagami", *words, expect=2)
    run("oa", mesh, expect=2)
    run("oa", HERE / "nothing.obj", "-o", "no.katagami", expect=1)
    assert not os.path.exists(HERE / "no.katagami")


sys.exit(script.run(globals()))
