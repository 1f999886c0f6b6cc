"""The app in a real window, with a real mouse, under Xvfb. usage: test_window.py KATAGAMI"""

import contextlib
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import script  # noqa: E402

PROGRAM = pathlib.Path(sys.argv[1]).resolve()
MODEL = pathlib.Path(__file__).resolve().parent / "two.katagami"
SANITIZED = "LD_PRELOAD" in os.environ
TICKS = os.sysconf("SC_CLK_TCK")


@contextlib.contextmanager
def screen():
    """An X server of its own; the environment of its programs."""
    if not (shutil.which("Xvfb") and shutil.which("xdotool")):
        raise script.Skip("Xvfb or xdotool is missing")
    read, write = os.pipe()
    server = subprocess.Popen(["Xvfb", "-displayfd", str(write), "-screen", "0", "1300x900x24"],
                              pass_fds=[write], stderr=subprocess.DEVNULL)
    os.close(write)
    try:
        number = os.read(read, 16).decode().strip()
        if not number:
            raise script.Skip("Xvfb does not start here")
        yield dict(os.environ, DISPLAY=":" + number)
    finally:
        server.terminate()
        server.wait()
        os.close(read)


class App:
    def __init__(self, environment, folder, *words):
        self.environment = dict(environment, HOME=folder, XDG_CONFIG_HOME=folder,
                                XDG_STATE_HOME=folder, LANGUAGE="C")
        settings = pathlib.Path(folder, "katagami", "settings.json")
        settings.parent.mkdir()
        settings.write_text('{"net_view": false}')  # the places below are those of a wide 3D view
        began = time.monotonic()
        self.process = subprocess.Popen([PROGRAM, "edit", *words], env=self.environment,
                                        cwd=folder, stderr=subprocess.PIPE, text=True)
        self.window = ""
        while not self.window and self.process.poll() is None and time.monotonic() - began < 20:
            self.window = self.xdotool("search", "--onlyvisible", "--pid", str(self.process.pid),
                                       "--class", "katagami", check=False).split("\n")[0]
        self.opened = time.monotonic() - began
        if not self.window:
            self.process.kill()
            said = self.process.communicate()[1]
            raise script.Skip("no window: " + said.strip())
        time.sleep(1)

    def xdotool(self, *words, check=True):
        return subprocess.run(["xdotool", *words], env=self.environment, check=check,
                              capture_output=True, text=True).stdout

    def move(self, x, y):
        self.xdotool("mousemove", "--window", self.window, str(x), str(y))
        time.sleep(0.1)

    def drag(self, x, y, dx, dy):
        self.move(x, y)
        self.xdotool("mousedown", "1")
        for i in range(1, 6):
            self.move(x + dx * i // 5, y + dy * i // 5)
        self.xdotool("mouseup", "1")
        time.sleep(0.2)

    def click(self, x, y):
        self.move(x, y)
        self.xdotool("click", "1")
        time.sleep(0.2)

    def key(self, *chords):
        for chord in chords:
            self.xdotool("key", chord)
            time.sleep(0.3)

    def cpu(self):
        fields = pathlib.Path(f"/proc/{self.process.pid}/stat").read_text().split()
        return (int(fields[13]) + int(fields[14])) / TICKS

    def end(self):
        said = self.process.communicate(timeout=30)[1]
        assert self.process.returncode == 0, said


def test_a_window_opens_at_once_idles_and_edits():
    with screen() as environment, tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder, "two.katagami")
        shutil.copy(MODEL, path)
        before = json.loads(path.read_text())
        app = App(environment, folder, path)
        assert SANITIZED or app.opened < 3, app.opened  # 0.4 s on a machine with nothing else to do
        spent = app.cpu()
        time.sleep(1.5)
        assert app.cpu() - spent < 0.05, "an idle window costs time"
        app.click(350, 480)  # the body
        app.drag(381, 624, -40, 30)  # its first point
        app.key("ctrl+s")
        after = json.loads(path.read_text())
        assert after["patches"][0]["points"][0] != before["patches"][0]["points"][0]
        assert after["patches"][0]["points"][1:] == before["patches"][0]["points"][1:]
        assert len(after["history"]["undo"]) == 1
        app.key("ctrl+q")
        app.end()


def test_a_patch_is_placed_by_four_clicks_and_the_net_exported():
    with screen() as environment, tempfile.TemporaryDirectory() as folder:
        app = App(environment, folder)
        app.key("alt+1", "a")
        for x, y in ((300, 400), (400, 330), (520, 330), (620, 400)):
            app.click(x, y)
        app.key("ctrl+s")
        app.xdotool("type", "--delay", "20", f"{folder}/one.katagami")
        app.key("Return")
        model = json.loads(pathlib.Path(folder, "one.katagami").read_text())
        assert len(model["patches"]) == 1
        app.key("ctrl+p")
        app.xdotool("type", "--delay", "20", "file.export_net")
        app.key("Return")
        time.sleep(0.5)
        app.key("Return")  # what kind of file: SVG
        time.sleep(0.5)
        app.key("Return")
        time.sleep(1)
        assert pathlib.Path(folder, "one.svg").exists()
        app.key("ctrl+q")
        app.end()


sys.exit(script.run(globals()))
