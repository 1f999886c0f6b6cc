"""Large files are read in the background; long work can be stopped.

usage: test_loading.py KATAGAMI
"""

import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import script  # noqa: E402

PROGRAM = pathlib.Path(sys.argv[1]).resolve()
SIDE = 200  # of the grid on the sphere: two triangles a cell, 3 MB
PATCHES = 400
ADD = ('command patch.add {"points": [[0,-40,0],[0,-20,30],[0,20,30],[0,40,0]], '
       '"extent": [-60,60]}')


def write_mesh(path):
    lines = []
    for i in range(SIDE):
        for k in range(SIDE):
            a, b = 2 * math.pi * i / SIDE, math.pi * ((k + 0.5) / SIDE - 0.5)
            lines.append(f"v {100 * math.cos(a) * math.cos(b):.5f} "
                         f"{100 * math.sin(a) * math.cos(b):.5f} {100 * math.sin(b):.5f}")
    for i in range(SIDE):
        for k in range(SIDE - 1):
            a, b = i * SIDE + k + 1, (i + 1) % SIDE * SIDE + k + 1
            lines += [f"f {a} {b} {b + 1}", f"f {a} {b + 1} {a + 1}"]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def write_model(path, reference=None):
    patches = []
    for i in range(PATCHES):
        x, y = i % 20 * 50, i // 20 * 90
        patches.append({"id": i + 1, "extent": [-20, 20],
                        "points": [[x, y - 40, 0], [x, y - 20, 30], [x, y + 20, 30],
                                   [x, y + 40, 0]]})
    model = {"katagami": 1, "kind": "patches", "patches": patches}
    if reference:
        model["reference"] = {"file": reference}
    path.write_text(json.dumps(model), encoding="utf-8")


def run(folder, *lines):
    text = folder / "script.txt"
    text.write_text("\n".join(lines) + "\n", encoding="utf-8")
    done = subprocess.run([PROGRAM, "edit", "--headless", "--script", text], cwd=folder, text=True,
                          env=script.environment(folder), capture_output=True, check=False)
    if "EGL" in done.stderr or "OpenGL" in done.stderr:
        raise script.Skip("nothing can be drawn here")
    assert done.returncode == 0, done.stderr


def in_folder(test):
    def inner():
        with tempfile.TemporaryDirectory() as name:
            test(pathlib.Path(name))
    return inner


@in_folder
def test_a_large_reference_comes_after_a_while(folder):
    write_mesh(folder / "ball.obj")
    run(folder, "drop ball.obj", "expect shown Cancel", "expect undo steps 0", "wait",
        "expect reference", "expect undo steps 1", "key A", "expect tool place", "key Esc",
        "key Ctrl+Z", "wait", "expect undo steps 0", "key Ctrl+Y", "expect shown Cancel", "wait",
        "expect reference", "save model.katagami", "key Ctrl+N", "open model.katagami", "wait",
        "expect reference")
    assert json.loads((folder / "model.katagami").read_text())["reference"]["file"] == "ball.obj"


@in_folder
def test_escape_gives_up_what_is_being_read(folder):
    write_mesh(folder / "ball.obj")
    write_model(folder / "many.katagami")
    run(folder, ADD, "save one.katagami",
        "drop ball.obj", "key Esc", "expect message Nothing was loaded", ADD, "expect patches 2",
        "wait", "expect undo steps 2", "save",
        "drop many.katagami", "click \"Cancel\"", "expect message Nothing was loaded", "wait",
        "expect patches 2", "expect title one.katagami — katagami",
        # given up and begun again, while the first thread may still be at work
        "drop many.katagami", "key Esc", "drop many.katagami", "key Esc", "drop ball.obj", "wait",
        "expect reference", "expect patches 2", "drop many.katagami", "click \"Discard\"",
        "key Esc")


@in_folder
def test_a_large_model_comes_with_its_reference(folder):
    write_mesh(folder / "ball.obj")
    write_model(folder / "many.katagami", "ball.obj")
    pictures = []
    for i in range(2):
        run(folder, "drop many.katagami", "expect shown Cancel", "expect patches 0", "wait",
            f"expect patches {PATCHES}", "expect reference", "expect unmodified",
            "expect title many.katagami — katagami", f"shot {i}.png")
        pictures.append((folder / f"{i}.png").read_bytes())
    assert pictures[0] == pictures[1]


@in_folder
def test_what_cannot_be_read_changes_nothing(folder):
    (folder / "bad.obj").write_text("v 1 2 x\n" * 200000)
    write_model(folder / "bad.katagami")
    (folder / "bad.katagami").write_text((folder / "bad.katagami").read_text()[:-2])
    write_model(folder / "alone.katagami", "nowhere.obj")
    run(folder, ADD, "drop bad.obj", "wait", "expect shown Close", "key Esc", "expect undo steps 1",
        "save one.katagami", "drop bad.katagami", "wait", "expect shown Close", "key Esc",
        "expect patches 1", "expect title one.katagami — katagami",
        "drop alone.katagami", "wait", f"expect patches {PATCHES}", "expect message nowhere.obj")


@in_folder
def test_faces_of_a_mesh_that_were_skipped_are_told_of(folder):
    cube = [(x, y, z) for x in (0, 9) for y in (0, 9) for z in (0, 9)]
    sides = ["1 2 4 3", "5 7 8 6", "1 5 6 2", "3 4 8 7", "1 3 7 5", "2 6 8 4", "1 2", "1 2 1 3"]
    (folder / "torn.obj").write_text("".join(f"v {x} {y} {z}\n" for x, y, z in cube) +
                                     "".join(f"f {side}\n" for side in sides))
    say = "expect message torn.obj: faces that were skipped: 2"
    run(folder, ADD, "drop torn.obj", "wait", "expect reference", say, "save one.katagami",
        "command file.new_card {}", "open one.katagami", "wait", say, "command file.new_card {}",
        "drop torn.obj", "wait", 'click "Make card"', "wait", say, "save card.katagami",
        'command file.card_from_mesh {"mesh": "torn.obj", "size": [12, 6, 6]}', say)


@in_folder
def test_work_survives_an_opening_that_fails_after_it_was_given_up(folder):
    (folder / "bad.katagami").write_text("{")
    run(folder, ADD, "autosave 2", "wait 121", "drop bad.katagami", 'click "Discard"',
        "expect shown Close", "key Esc", "expect patches 1")
    assert list((folder / "state" / "katagami").glob("autosave-*.katagami"))


def write_parts(path, count):
    """Patches that are far from each other and whose parts are hard to place."""
    chance = random.Random(3)
    patches = []
    for i in range(count):
        x, y = i % 20 * 120, i // 20 * 200
        high, wide, far = map(chance.uniform, (10, 8, 15), (35, 40, 70))
        patches.append({"id": i + 1, "extent": [-wide, wide],
                        "points": [[x, y - far, 0], [x, y - far / 2, high],
                                   [x, y + far / 2, high], [x, y + far, 0]]})
    path.write_text(json.dumps({"katagami": 1, "kind": "patches", "patches": patches}))


def pages(folder, *words):
    subprocess.run([PROGRAM, "net", "parts.katagami", "-o", "n.pdf", "--json", "n.json", *words],
                   cwd=folder, check=True)
    return json.loads((folder / "n.json").read_text())["totals"]["pages"]


@in_folder
def test_placing_parts_and_writing_files_can_be_stopped(folder):
    write_parts(folder / "parts.katagami", 150)
    rows, nested = pages(folder, "--rows"), pages(folder)
    assert rows > nested, (rows, nested)
    run(folder, "open parts.katagami", "command view.net", 'wait "Stop"', 'click "Stop"', "wait",
        f"expect net pages {rows}",  # as they come; the next change makes the search begin anew
        "command patch.flip {\"patch\": 1}", "wait", f"expect net pages {nested}",
        "key F4", "key Ctrl+E", 'click "pdf"', "key Enter", "key Ctrl+A", "text never.pdf",
        "key Enter", 'wait "Cancel"', 'click "Cancel"', "wait",
        "expect message Nothing was written", "expect file never.pdf missing",
        "key Ctrl+E", "key Enter", "key Ctrl+A", "text never.pdf", "key Enter", "wait \"Cancel\"",
        "key Esc", "wait", "expect message Nothing was written", "expect file never.pdf missing",
        "key Ctrl+E", "key Enter", "key Ctrl+A", "text written.pdf", "key Enter", "wait",
        "expect file written.pdf exists")


sys.exit(script.run(globals()))
