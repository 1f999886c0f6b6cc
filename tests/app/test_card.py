"""Pop-up cards by edits from a file, and their net from the app and from the command line.
usage: test_card.py KATAGAMI
"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import script  # noqa: E402

PROGRAM = os.path.abspath(sys.argv[1])
CARD = pathlib.Path(__file__).resolve().parent / "card.katagami"
HOUSE = [{"command": "card.box", "from": [3, 0, 0], "to": [8, 3, 5]},
         {"command": "card.pull", "x": 4, "z": 5, "by": 1},
         {"command": "card.window", "x": 5, "z": 2, "on": True},
         {"command": "card.window", "x": 6, "z": 2, "on": True},
         {"command": "card.top", "x": 3, "z": 6, "on": True},
         {"command": "card.set", "title": "house", "cell_mm": 5, "margin_cells": 1}]


def apply(edits, folder):
    """The card after the edits, or None, and what was said."""
    file, out = pathlib.Path(folder) / "e.json", pathlib.Path(folder) / "out.katagami"
    file.write_text(json.dumps(edits), encoding="utf-8")
    done = subprocess.run([PROGRAM, "apply", CARD, file, "-o", out], check=False,
                          capture_output=True, text=True)
    return (json.loads(out.read_text(encoding="utf-8")) if out.exists() else None), done.stderr


def test_edits_build_a_card():
    with tempfile.TemporaryDirectory() as folder:
        card, said = apply(HOUSE, folder)
        assert card, said
        depth = card["oa"]["depth"]
        assert depth[2] == [0] * 8 and depth[3] == [5] * 6 + [0] * 2, depth
        assert card["title"] == "house" and card["oa"]["cell_mm"] == 5


def test_the_other_side_and_all_over_again():
    with tempfile.TemporaryDirectory() as folder:
        card, said = apply([{"command": "card.add", "x": 1, "y": 2, "z": 3},
                            {"command": "card.mirror_now", "from": "left"},
                            {"command": "card.resize", "width": 13}], folder)
        assert card, said
        depth = card["oa"]["depth"]
        assert depth[1] == depth[10] == [3] * 4 + [0] * 4 and len(depth) == 13
        card, said = apply(HOUSE + [{"command": "card.clear"}], folder)
        assert card and not any(sum(card["oa"]["depth"], [])), said


def test_what_is_outside_is_refused_by_its_number():
    with tempfile.TemporaryDirectory() as folder:
        for wrong in ({"command": "card.add", "x": 12, "y": 0, "z": 0},
                      {"command": "card.add", "x": 1, "y": 0},
                      {"command": "card.window", "x": 0, "z": 0},
                      {"command": "card.pull", "x": 0, "z": 0, "by": 1},
                      {"command": "card.resize", "width": 0},
                      {"command": "card.set", "margin_cells": -1}):
            card, said = apply(HOUSE[:1] + [wrong], folder)
            assert card is None and "edit 2" in said, (wrong, said)


def test_the_net_of_the_app_is_that_of_the_command():
    with tempfile.TemporaryDirectory() as folder:
        lines = [f'open "{CARD}"']
        for edit in HOUSE:
            arguments = {k: v for k, v in edit.items() if k != "command"}
            lines.append(f"command {edit['command']} {json.dumps(arguments)}")
        lines += ["command card.open {\"degrees\": 30}", f"save {folder}/house.katagami",
                  "key Ctrl+E", "click \"svg\"", "click \"Choose file…\"", "key Ctrl+A",
                  f"text {folder}/app.svg", "key Enter", "wait", f"expect file {folder}/app.svg"]
        path = pathlib.Path(folder) / "s.txt"
        path.write_text("\n".join(lines), encoding="utf-8")
        done = subprocess.run([PROGRAM, "edit", "--headless", "--script", path], check=False,
                              capture_output=True, text=True,
                              env=script.environment(folder))
        if done.returncode == 1 and ("EGL" in done.stderr or "OpenGL" in done.stderr):
            sys.exit(77)
        assert done.returncode == 0, done.stderr
        subprocess.run([PROGRAM, "net", f"{folder}/house.katagami", "-o", f"{folder}/cli.svg"],
                       check=True)
        one, other = (pathlib.Path(folder, n).read_bytes() for n in ("app.svg", "cli.svg"))
        assert one == other


sys.exit(script.run(globals()))
