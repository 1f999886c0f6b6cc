"""`katagami net --guide`: the files it leaves. usage: test_command.py KATAGAMI"""

import contextlib
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import script  # noqa: E402

PROGRAM = str(pathlib.Path(sys.argv[1]).resolve())

# A wall glued on the ground: cover, a page of parts with the first step, one with the second.
MODEL = {"katagami": 1, "kind": "patches", "title": "部屋", "patches": [
    {"id": 1, "name": "床", "points": [[0, 0, 0], [30, 0, 0], [70, 0, 0], [100, 0, 0]],
     "extent": [-50, 50], "ruling": [0, 1, 0]},
    {"id": 2, "name": "壁 wall", "points": [[50, 0, -20], [50, 0, 0], [50, 0, 30], [50, 0, 60]],
     "extent": [-30, 30], "ruling": [0, 1, 0], "trims": [{"by": [1], "keep": [[50, 0, 40]]}]}]}


@contextlib.contextmanager
def folder():
    with tempfile.TemporaryDirectory() as name:
        before = os.getcwd()
        os.chdir(name)
        try:
            pathlib.Path("m.katagami").write_text(json.dumps(MODEL), encoding="utf-8")
            yield
        finally:
            os.chdir(before)


def net(*words, **environment):
    return subprocess.run([PROGRAM, "net", "m.katagami", *words], capture_output=True, text=True,
                          check=False, env={**os.environ, "LANGUAGE": "C", **environment})


def write_guide(path, *words, **environment):
    done = net("-o", "net.svg", "--guide", path, *words, **environment)
    if done.returncode == 1 and "EGL" in done.stderr:
        raise script.Skip("this machine cannot draw")
    assert done.returncode == 0, done


def words_of(path):
    if not shutil.which("pdftotext"):
        raise script.Skip("pdftotext is not installed")
    done = subprocess.run(["pdftotext", "-layout", path, "-"], capture_output=True, text=True,
                          check=True)
    return " ".join(done.stdout.split())


def test_a_guide_lies_beside_an_unchanged_net():
    with folder():
        write_guide("guide.pdf")
        data = pathlib.Path("guide.pdf").read_bytes()
        assert data.startswith(b"%PDF") and b"CreationDate" not in data
        with_guide = pathlib.Path("net.svg").read_bytes()
        assert net("-o", "net.svg").returncode == 0
        assert pathlib.Path("net.svg").read_bytes() == with_guide


def test_a_guide_names_parts_and_joins_as_the_net_does():
    with folder():
        write_guide("guide.pdf")
        text = words_of("guide.pdf")
        assert "部屋" in text
        assert "Step 1 · Begin with part 1 (床)" in text
        assert "Step 2 · Attach part 2 (壁 wall)" in text
        assert "1 Edge of part 2 (壁 wall) onto the mark on part 1 (床), 60 mm" in text, text


def test_a_guide_without_a_title_bears_the_name_of_its_file():
    with folder():
        pathlib.Path("m.katagami").write_text(
            json.dumps({k: v for k, v in MODEL.items() if k != "title"}), encoding="utf-8")
        os.rename("m.katagami", "Little room.katagami")
        done = subprocess.run([PROGRAM, "net", "Little room.katagami", "-o", "net.svg", "--guide",
                               "guide.pdf"], capture_output=True, text=True, check=False)
        if done.returncode == 1 and "EGL" in done.stderr:
            raise script.Skip("this machine cannot draw")
        text = words_of("guide.pdf")
        assert "Little room" in text and "Little room · assembly guide" in text, text
        assert "Paper model" not in text, text


def test_without_drawing_nothing_is_written():
    with folder():
        done = net("-o", "net.svg", "--guide", "guide.pdf", "--json", "report.json",
                   __EGL_VENDOR_LIBRARY_FILENAMES="/nonexistent")
        assert done.returncode == 1 and "EGL" in done.stderr, done
        assert sorted(os.listdir()) == ["m.katagami"]


def test_a_net_that_cannot_be_written_leaves_no_guide():
    with folder():
        done = net("-o", "missing/net.svg", "--guide", "guide.pdf")
        assert done.returncode == 1, done
        assert sorted(os.listdir()) == ["m.katagami"]


def test_a_guide_that_cannot_be_written_leaves_no_net():
    with folder():
        done = net("-o", "net.svg", "--guide", "missing/guide.pdf")
        assert done.returncode == 1 and "missing/guide.pdf" in done.stderr, done
        assert sorted(os.listdir()) == ["m.katagami"]


def test_standard_output_is_no_place_for_a_guide():
    with folder():
        assert net("-o", "net.svg", "--guide", "-").returncode == 2


def test_a_card_says_how_it_is_cut_and_folded():
    card = {"katagami": 1, "kind": "oa", "title": "box", "oa": {
        "size": [5, 4, 5], "cell_mm": 10,
        "depth": [[0] * 5, [2, 2, 2, 0, 0], [2, 2, 2, 0, 0], [2, 2, 2, 0, 0], [0] * 5]}}
    with folder():
        pathlib.Path("m.katagami").write_text(json.dumps(card), encoding="utf-8")
        write_guide("g.pdf")
        words = words_of("g.pdf")
        for text in ["box", "One sheet of 50 × 90 mm", "cut along all solid lines", "open at 45°",
                     "closed", "The sheet"]:
            assert text in words, (text, words)


def test_a_guide_is_in_the_language_that_is_asked_for():
    with folder():
        write_guide("ja.pdf", "--language", "ja")
        text = words_of("ja.pdf")
        for words in ["組み立て説明書", "手順 1 ・ 部品 1 (床)から始める", "手順 2 ・ 部品 2 (壁 wall)を付ける",
                      "部品 2 (壁 wall)の辺を、部品 1 (床)の印の線に貼ります(60 mm)", "のりしろ", "山折り"]:
            assert words.replace(" ", "") in text.replace(" ", ""), (words, text)
        assert "Step" not in text and "glue" not in text
        write_guide("environment.pdf", LANGUAGE="ja")
        assert words_of("environment.pdf") == text
        write_guide("en.pdf", "--language", "en", LANGUAGE="ja")
        assert "Step 1 · Begin with part 1" in words_of("en.pdf")


def test_cards_and_sheets_are_told_in_japanese():
    sheet = {"katagami": 1, "kind": "origami", "origami": {
        "sheets": [{"polygon": [[0, 0], [100, 0], [100, 100], [0, 100]]}],
        "folds": [{"from": [0, 0, 0], "to": [100, 100, 0]}]}}
    card = {"katagami": 1, "kind": "oa", "oa": {"size": [1, 1, 1], "cell_mm": 10, "depth": [[0]]}}
    for model, wanted in ((sheet, ["折り図", "もう一つの角に合わせて", "完成です"]),
                          (card, ["飛び出すカード", "折り線にすべて筋をつけます", "閉じたところ"])):
        with folder():
            pathlib.Path("m.katagami").write_text(json.dumps(model), encoding="utf-8")
            write_guide("g.pdf", "--language", "ja")
            text = words_of("g.pdf").replace(" ", "")
            for words in wanted:
                assert words in text, (words, text)


def test_the_command_line_speaks_english_beside_a_japanese_guide():
    with folder():
        done = net("-o", "net.xyz", LANGUAGE="ja", LC_ALL="C.UTF-8")
        assert done.returncode == 1 and "a net is written as .svg, .pdf or .dxf" in done.stderr
        done = net("-o", "net.svg", "--guide", "g.pdf", "--language", "fr")
        assert done.returncode == 2 and "--language is ja or en" in done.stderr, done


sys.exit(script.run(dict(globals())))
