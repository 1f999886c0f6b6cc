"""Pictures off-screen. usage: test_pictures.py KATAGAMI"""

import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import script  # noqa: E402

PROGRAM = pathlib.Path(sys.argv[1]).resolve()
MODEL = pathlib.Path(__file__).resolve().parent / "two.katagami"
LINES = ["click @20,-20,22.5", "drag @0,-40,0 @5,-40,3", "key G", "move 300 300"]


def picture(lines, *words):
    with tempfile.TemporaryDirectory() as folder:
        text, shot = pathlib.Path(folder, "s.txt"), pathlib.Path(folder, "s.png")
        text.write_text("\n".join(lines) + "\n", encoding="utf-8")
        done = subprocess.run([PROGRAM, "edit", MODEL, "--headless", "--script", text, "--shot",
                               shot, *words], check=False, capture_output=True, text=True,
                              env=script.environment(folder))
        if "EGL" in done.stderr or "OpenGL" in done.stderr:
            raise script.Skip("nothing can be drawn here")
        assert done.returncode == 0, done.stderr
        return shot.read_bytes()


def size(png):
    return int.from_bytes(png[16:20], "big"), int.from_bytes(png[20:24], "big")


def test_two_runs_make_the_same_picture():
    assert picture(LINES) == picture(LINES)


def test_what_is_done_shows():
    assert picture(LINES) != picture(LINES[:1])


def test_a_hidpi_picture_has_twice_the_pixels():
    assert size(picture([])) == (1280, 800)
    assert size(picture([], "--scale", "2")) == (2560, 1600)


sys.exit(script.run(globals()))
