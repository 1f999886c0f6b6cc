"""What the commands write and what they refuse. usage: test_commands.py KATAGAMI"""

import contextlib
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import script  # noqa: E402

PROGRAM = str(pathlib.Path(sys.argv[1]).resolve())


def straight(a, b):
    return [[a[k] + (b[k] - a[k]) * i / 3 for k in range(3)] for i in range(4)]


def ground_and_wall(**changes):
    """A wall on the ground, and a construction plane that cuts the wall's top off."""
    wall = {"id": 2, "name": "壁 wall", "points": straight([50, 0, -20], [50, 0, 60]),
            "extent": [-30, 30], "ruling": [0, 1, 0],
            "trims": [{"by": [1], "keep": [[50, 0, 40]]}, {"by": [3], "keep": [[50, 0, 20]]}]}
    wall.update(changes)
    return {"katagami": 1, "kind": "patches", "title": "部屋", "patches": [
        {"id": 1, "points": straight([0, 0, 0], [100, 0, 0]), "extent": [-50, 50],
         "ruling": [0, 1, 0]},
        wall,
        {"id": 3, "points": straight([0, 0, 50], [100, 0, 50]), "extent": [-50, 50],
         "ruling": [0, 1, 0], "construction": True}]}


def katagami(*words, **options):
    return subprocess.run([PROGRAM, *words], capture_output=True, text=True, check=False,
                          **options)


@contextlib.contextmanager
def folder(model=None):
    """A folder to work in, with the model as m.katagami."""
    with tempfile.TemporaryDirectory() as name:
        before = os.getcwd()
        os.chdir(name)
        try:
            text = json.dumps(ground_and_wall() if model is None else model, ensure_ascii=False)
            pathlib.Path("m.katagami").write_text(text, encoding="utf-8")
            yield pathlib.Path(name)
        finally:
            os.chdir(before)


def succeed(*words, **options):
    done = katagami(*words, **options)
    assert done.returncode == 0, done
    return done


def refuse(code, *words, **options):
    """The command fails, says why, prints no results and leaves no file behind."""
    before = sorted(os.listdir())
    done = katagami(*words, **options)
    assert done.returncode == code and done.stderr and not done.stdout, (words, done)
    assert sorted(os.listdir()) == before, (words, os.listdir())
    return done.stderr


REPORT = {"parts", "seams", "totals", "warnings"}
PART = {"part", "patch", "name", "area_mm2", "surface_mm2", "perimeter_mm", "isometry_error",
        "page"}
TOTALS = {"parts", "pages", "page_fill", "tabs", "tab_overlaps"}


def check_report(report):
    assert REPORT <= report.keys(), report.keys()
    assert [p["patch"] for p in report["parts"]] == [1, 2]
    for part in report["parts"]:
        assert part.keys() == PART, part.keys()
    wall = report["parts"][1]
    assert wall["name"] == "壁 wall" and abs(wall["area_mm2"] - 60 * 50) < 1e-6
    assert abs(wall["surface_mm2"] - 60 * 50) < 1e-6 and abs(wall["perimeter_mm"] - 220) < 1e-6
    assert report["seams"] == [{"kind": "contact", "patches": [2, 1],
                                "length_mm": report["seams"][0]["length_mm"]}]
    assert all(abs(x - 60) < 1e-6 for x in report["seams"][0]["length_mm"])
    assert report["totals"].keys() == TOTALS and report["totals"]["parts"] == 2


def test_net_reports_with_the_keys_of_the_format():
    with folder():
        succeed("net", "m.katagami", "-o", "n.svg", "--json", "n.json")
        report = json.loads(pathlib.Path("n.json").read_text(encoding="utf-8"))
        check_report(report)
        totals = report["totals"]
        assert totals["pages"] == 1 and totals["tabs"] >= 1 and totals["tab_overlaps"] == 0
        assert 0 < totals["page_fill"] < 1 and {p["page"] for p in report["parts"]} == {1}
        assert sorted(os.listdir()) == ["m.katagami", "n.json", "n.svg"]


def test_scale_does_not_change_the_report():
    with folder():
        for scale in ("0.5", "1.5"):
            succeed("net", "m.katagami", "-o", "n.svg", "--scale", scale, "--json", "n.json")
            check_report(json.loads(pathlib.Path("n.json").read_text(encoding="utf-8")))


def test_info_adds_what_patches_measure():
    with folder():
        report = json.loads(succeed("info", "m.katagami", "--json").stdout)
        check_report(report)
        assert [p["id"] for p in report["patches"]] == [1, 2, 3]
        for patch, length in zip(report["patches"], (100, 80, 100)):
            assert abs(patch["geodesic_mm"] - length) < 1e-9, patch
            assert all(abs(x - 90) < 1e-9 for x in patch["theta_deg"]), patch
            assert patch["regression_margin_mm"] is None, patch
        assert "60.000" in succeed("info", "m.katagami").stdout


def test_the_net_goes_to_stdout_and_the_model_comes_from_stdin():
    with folder():
        text = pathlib.Path("m.katagami").read_text(encoding="utf-8")
        one = succeed("net", "-", "-o", "-", input=text).stdout
        succeed("net", "m.katagami", "-o", "n.svg")
        assert one == pathlib.Path("n.svg").read_text(encoding="utf-8")
        report = succeed("net", "-", "-o", "n.svg", "--json", "-", input=text).stdout
        check_report(json.loads(report))
        refuse(2, "net", "m.katagami", "-o", "-", "--json", "-")


def test_every_kind_of_net_is_written():
    with folder():
        for name, start in (("n.svg", b"<?xml"), ("n.pdf", b"%PDF"), ("n.dxf", b"  0\n")):
            succeed("net", "m.katagami", "-o", name)
            data = pathlib.Path(name).read_bytes()
            assert data.startswith(start) or data.lstrip().startswith(start.strip()), data[:20]
        for words in (["--paper", "none"], ["--paper", "300x200"], ["--landscape"],
                      ["--margin", "20"], ["--tabs", "none"], ["--tab-width", "3"],
                      ["--labels", "outside"], ["--preset", "laser"], ["--perforate", "2,0.5"],
                      ["--tolerance", "0.1"], ["--paper=letter"], ["--preset", "silhouette"],
                      ["--preset", "cricut", "--scale", "0.5"], ["--gap", "4"]):
            succeed("net", "m.katagami", "-o", "n.svg", *words)
            assert "<svg" in pathlib.Path("n.svg").read_text(encoding="utf-8")


def test_tabs_follow_the_wishes_of_the_model():
    model = ground_and_wall()
    model["net"] = {"joins": [{"patches": [1, 2], "tab": "none"}]}
    with folder(model):
        report = json.loads(succeed("net", "m.katagami", "-o", "n.svg", "--json", "-").stdout)
        assert report["totals"]["tabs"] == 0, report


def test_wrong_usage_is_2():
    with folder():
        for words in (["net"], ["net", "m.katagami"], ["net", "m.katagami", "m.katagami", "-o", "x"],
                      ["net", "m.katagami", "-o", "n.svg", "--nonsense"],
                      ["net", "m.katagami", "-o", "n.svg", "--paper", "A9x"],
                      ["net", "m.katagami", "-o", "n.svg", "--labels", "up"],
                      ["net", "m.katagami", "-o", "n.svg", "--tabs", "many"],
                      ["net", "m.katagami", "-o", "n.svg", "--scale", "0"],
                      ["net", "m.katagami", "-o", "n.svg", "--scale", "nan"],
                      ["net", "m.katagami", "-o", "n.svg", "--margin"],
                      ["net", "m.katagami", "-o", "n.svg", "--perforate", "1"],
                      ["net", "m.katagami", "-o", "n.svg", "--preset", "fax"],
                      ["net", "m.katagami", "-o", "n.svg", "--landscape=1"],
                      ["info"], ["check"], ["export", "m.katagami"], ["render", "m.katagami"],
                      ["render", "m.katagami", "-o", "x.png", "--size", "0x5"],
                      ["render", "m.katagami", "-o", "x.png", "--view", "inside"],
                      ["new", "-o", "x.katagami"]):
            refuse(2, *words)


def test_what_cannot_be_read_is_named_by_every_command():
    with folder():
        pathlib.Path("bad.katagami").write_text('{"katagami": 1, "kind": "patches",\n"patches": 5}',
                                                encoding="utf-8")
        for words in (["net", "-o", "n.svg", "--json", "n.json"], ["info"], ["check"],
                      ["export", "-o", "m.obj"], ["render", "-o", "m.png"]):
            assert "none.katagami" in refuse(1, words[0], "none.katagami", *words[1:])
            assert "bad.katagami:2" in refuse(1, words[0], "bad.katagami", *words[1:])


def test_net_settings_that_cannot_be_followed_are_named_with_their_file():
    with folder({**ground_and_wall(), "net": {"paper": "A9"}}):
        message = refuse(1, "net", "m.katagami", "-o", "n.svg")
        assert "m.katagami: paper 'A9' is unknown" in message, message
        assert not os.path.exists("n.svg")
    for settings, said in (({"tab_width": 5e5}, "tabs 500000 mm wide"),
                           ({"paper": "30x30"}, "part ")):
        with folder({**ground_and_wall(), "net": settings}):
            message = refuse(1, "net", "m.katagami", "-o", "n.svg", "--no-split")
            assert f"katagami net: m.katagami: {said}" in message, message


def test_numbers_out_of_range_are_told_where_help_is():
    with folder():
        message = refuse(2, "net", "m.katagami", "-o", "n.svg", "--margin", "-1")
        assert "--margin wants a number from 0 to 10000" in message, message
        assert "katagami help net" in message, message


def test_a_faulty_model_is_no_net():
    with folder(ground_and_wall(trims=[{"by": [3], "keep": [[50, 0, 20]]},
                                       {"contour": [[0, 0], [9, 1], [9, 0], [0, 1]]}])):
        pathlib.Path("n.svg").write_text("old", encoding="utf-8")
        for words in (["net", "m.katagami", "-o", "n.svg", "--json", "n.json"],
                      ["export", "m.katagami", "-o", "m.obj"], ["info", "m.katagami"]):
            message = refuse(1, *words)
            assert "m.katagami" in message and "patch 2" in message, message
        assert pathlib.Path("n.svg").read_text(encoding="utf-8") == "old"


def test_nothing_stays_when_one_of_the_files_cannot_be_written():
    with folder():
        refuse(1, "net", "m.katagami", "-o", "none/n.svg", "--json", "n.json")
        refuse(1, "net", "m.katagami", "-o", "n.svg", "--json", "none/n.json")
        refuse(1, "net", "m.katagami", "-o", "n.xyz", "--json", "n.json")
        refuse(1, "export", "m.katagami", "-o", "none/m.obj")
        refuse(1, "export", "m.katagami", "-o", "m.xyz")


def test_parts_pinned_on_others_or_off_the_page_are_told_of():
    def placements(*pins):
        model = ground_and_wall()
        model["net"] = {"placements": [
            {"patch": patch, "page": 0, "x": x, "y": y} for patch, x, y in pins]}
        return model

    def codes(model):
        with folder(model):
            said = succeed("net", "m.katagami", "-o", "n.svg", "--json", "n.json").stderr
            found = json.loads(pathlib.Path("n.json").read_text(encoding="utf-8"))["warnings"]
            assert said.count("is pinned") == len(found), said
            for warning in found:
                assert f"patch {warning['patch']}: {warning['message']}" in said, said
            return [(w["patch"], w["code"]) for w in found]

    assert codes(placements((1, 70, 20), (2, 60, 200))) == []
    assert codes(placements((1, 70, 20), (2, 60, 90))) == [(1, "part-overlap"),
                                                             (2, "part-overlap")]
    assert codes(placements((1, 180, 20))) == [(1, "part-off-page")]


def test_check_tells_errors_from_warnings():
    with folder():
        done = succeed("check", "m.katagami")
        assert "nothing" in done.stdout, done
        found = json.loads(succeed("check", "m.katagami", "--json").stdout)
        assert found == {"errors": [], "warnings": []}, found
    with folder(ground_and_wall(extent=[-60, 30])):  # wider than its trims reach
        found = json.loads(succeed("check", "m.katagami", "--json").stdout)
        assert found["errors"] == [] and found["warnings"][0]["code"] == "cut-prolonged", found
        assert found["warnings"][0]["patch"] == 2, found
        assert "[cut-prolonged]" in succeed("check", "m.katagami").stdout
    with folder(ground_and_wall(points=straight([500, 0, -20], [500, 0, 60]))):
        done = katagami("check", "m.katagami", "--json")
        found = json.loads(done.stdout)
        assert done.returncode == 1 and found["errors"][0]["patch"] == 2, done
        assert found["errors"][0].keys() == {"patch", "code", "message"}
        done = katagami("check", "m.katagami")
        assert done.returncode == 1 and "error: patch 2" in done.stdout, done
    with folder(ground_and_wall(points=straight([50, 0, -400], [50, 0, 400]))):
        model = json.loads(pathlib.Path("m.katagami").read_text(encoding="utf-8"))
        del model["patches"][1]["trims"]
        pathlib.Path("m.katagami").write_text(json.dumps(model), encoding="utf-8")
        found = json.loads(succeed("check", "m.katagami", "--json").stdout)
        assert [w["code"] for w in found["warnings"]] == ["page"], found


# ---- meshes ---------------------------------------------------------------------------------

def read_obj(text):
    """[(group, [triangle of points])] in the order of the file."""
    points, groups = [], []
    for line in text.splitlines():
        words = line.split()
        assert not words or words[0] != "o", "an o line"
        if words and words[0] == "v":
            points.append([float(x) for x in words[1:4]])
        elif words and words[0] == "g":
            groups.append((line[2:], []))
        elif words and words[0] == "f":
            groups[-1][1].append([points[int(w.split("/")[0]) - 1] for w in words[1:4]])
    return groups


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def area_vector(triangles):
    total = [0, 0, 0]
    for a, b, c in triangles:
        n = cross([b[k] - a[k] for k in range(3)], [c[k] - a[k] for k in range(3)])
        total = [total[k] + n[k] / 2 for k in range(3)]
    return total


def test_obj_has_a_group_per_patch_that_winds_about_its_front():
    for flip in (False, True):
        with folder(ground_and_wall(flip=flip)):
            succeed("export", "m.katagami", "-o", "m.obj")
            groups = read_obj(pathlib.Path("m.obj").read_text(encoding="utf-8"))
            assert [g for g, _ in groups] == ["patch_1", "壁_wall"], groups
            # n = p' x d: along x times along y for the ground, z times y for the wall
            ground, wall = (area_vector(t) for _, t in groups)
            assert max(abs(ground[k] - [0, 0, 1e4][k]) for k in range(3)) < 0.01, ground
            front = 3000 if flip else -3000
            assert max(abs(wall[k] - [front, 0, 0][k]) for k in range(3)) < 0.01, wall


def test_every_mesh_format_is_read_back():
    with folder():
        for ending in ("obj", "ply", "stl", "off", "gltf", "glb"):
            succeed("export", "m.katagami", "-o", "m." + ending)
            words = ["--up", "y"] if ending.startswith("gl") else []
            succeed("new", "-o", "n.katagami", "--reference", "m." + ending, *words)


def test_new_names_the_reference_from_where_the_model_is():
    with folder():
        succeed("export", "m.katagami", "-o", "mesh 形.obj")
        os.mkdir("models")
        succeed("new", "-o", "models/a.katagami", "--reference", "mesh 形.obj", "--size", "250")
        model = json.loads(pathlib.Path("models/a.katagami").read_text(encoding="utf-8"))
        assert (model["katagami"], model["kind"], model["patches"]) == (1, "patches", []), model
        assert model["reference"]["file"] == "../mesh 形.obj", model
        assert model["reference"]["size_mm"] == 250 and model["title"] == "mesh 形", model
        os.rename("models", "elsewhere")
        succeed("check", "elsewhere/a.katagami")
        assert "none.obj" in refuse(1, "new", "-o", "b.katagami", "--reference", "none.obj")
        refuse(1, "new", "-o", "none/b.katagami", "--reference", "mesh 形.obj")
        text = succeed("new", "-o", "-", "--reference", "mesh 形.obj").stdout
        assert json.loads(text)["reference"]["file"] == "mesh 形.obj", text


def test_faces_of_a_mesh_that_were_skipped_are_told_of():
    with folder():
        cube = [(x, y, z) for x in (0, 9) for y in (0, 9) for z in (0, 9)]
        sides = ["1 2 4 3", "5 7 8 6", "1 5 6 2", "3 4 8 7", "1 3 7 5", "2 6 8 4"]
        text = "".join(f"v {x} {y} {z}\n" for x, y, z in cube)
        text += "".join(f"f {side}\n" for side in sides)
        pathlib.Path("whole.obj").write_text(text, encoding="utf-8")
        pathlib.Path("torn.obj").write_text(text + "f 1 2\nf 1 2 1 3\n", encoding="utf-8")
        for words in (["new", "-o", "n.katagami", "--reference"],
                      ["oa", "-o", "o.katagami", "--size", "12x6x6"]):
            assert succeed(*words, "whole.obj").stderr == ""
            said = succeed(*words, "torn.obj").stderr
            assert f"katagami {words[0]}: warning: torn.obj: faces that were skipped: 2;" in said


def test_new_makes_empty_cards_and_sheets():
    with folder():
        succeed("new", "-o", "card.katagami", "--card", "20x10x8", "--cell", "5", "--title", "塔")
        model = json.loads(pathlib.Path("card.katagami").read_text(encoding="utf-8"))
        assert (model["kind"], model["title"], model["oa"]["size"], model["oa"]["cell_mm"]) == (
            "oa", "塔", [20, 10, 8], 5), model
        succeed("check", "card.katagami")
        succeed("new", "-o", "wide.katagami", "--card", "80x40x40")
        cell = json.loads(pathlib.Path("wide.katagami").read_text(encoding="utf-8"))["oa"]["cell_mm"]
        assert cell * 80 <= 194, cell  # within an A4 and its margins
        succeed("new", "-o", "sheet.katagami", "--sheet", "A4")
        model = json.loads(pathlib.Path("sheet.katagami").read_text(encoding="utf-8"))
        corners = model["origami"]["sheets"][0]["polygon"]
        assert max(x for x, _ in corners) - min(x for x, _ in corners) == 210, corners
        succeed("check", "sheet.katagami")
        for words in (["--card", "20x10"], ["--card", "0x1x1"], ["--sheet", "none"],
                      ["--sheet", "A4", "--cell", "2"], ["--card", "3x3x3", "--sheet", "A4"],
                      ["--sheet", "A4", "--size", "10"]):
            refuse(2, "new", "-o", "x.katagami", *words)
        refuse(1, "new", "-o", "x.katagami", "--card", "9999x1x1")
        refuse(1, "new", "-o", "x.katagami", "--sheet", "20000x5")
        assert not os.path.exists("x.katagami")


def test_an_empty_model_is_fine_until_it_is_to_be_cut_out():
    with folder({"katagami": 1, "kind": "patches"}):
        succeed("check", "m.katagami")
        assert json.loads(succeed("info", "m.katagami", "--json").stdout)["parts"] == []
        refuse(1, "net", "m.katagami", "-o", "n.svg")


def test_pages_are_numbered_files():
    model = ground_and_wall()
    model["patches"][2]["construction"] = False
    model["net"] = {"paper": "130x120"}
    with folder(model):
        report = json.loads(succeed("net", "m.katagami", "-o", "n.svg", "--json", "-").stdout)
        pages = report["totals"]["pages"]
        assert pages > 1
        names = sorted(n for n in os.listdir() if n.endswith(".svg"))
        assert names == [f"n-{i + 1}.svg" for i in range(pages)], names
        text = pathlib.Path("n-1.svg").read_text(encoding="utf-8")
        assert re.search(r'width="130mm" height="120mm" viewBox="0 0 130 120"', text), text[:300]


if __name__ == "__main__":
    sys.exit(script.run(globals()))
