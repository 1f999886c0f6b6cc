"""The app in a real window, with a real mouse, under Xvfb. usage: test_window.py KATAGAMI"""

import collections
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
TICKS = os.sysconf("SC_CLK_TCK")
DEADLINE_S = 120  # for what takes a moment: a busy machine gets all the time it needs

Display = collections.namedtuple("Display", ["name", "server"])  # of the display; process


def cpu(process):
    """Seconds of work that it has done."""
    fields = pathlib.Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / TICKS


def sleeps(process):
    """Whether none of its threads has anything to do."""
    states = []
    for task in pathlib.Path(f"/proc/{process}/task").iterdir():
        with contextlib.suppress(OSError):  # it ended meanwhile
            states.append((task / "stat").read_text().rsplit(")", 1)[1].split()[0])
    return all(state == "S" for state in states)


@contextlib.contextmanager
def screen():
    """An X server of its own."""
    if not (shutil.which("Xvfb") and shutil.which("xdotool")):
        raise script.Skip("Xvfb or xdotool is missing")
    read, write = os.pipe()
    server = subprocess.Popen(["Xvfb", "-noreset", "-displayfd", str(write), "-screen", "0",
                               "1300x900x24"], pass_fds=[write], stderr=subprocess.DEVNULL)
    os.close(write)
    try:
        number = os.read(read, 16).decode().strip()
        if not number:
            raise script.Skip("Xvfb does not start here")
        yield Display(":" + number, server.pid)
    finally:
        server.terminate()
        server.wait()
        os.close(read)


def wait_for(condition, what):
    """What the condition gives once it holds."""
    end = time.monotonic() + DEADLINE_S
    while time.monotonic() < end:
        found = condition()
        if found:
            return found
        time.sleep(0.02)
    raise AssertionError(f"waited in vain for {what}")


class App:
    def __init__(self, display, folder, *words, **settings):
        self.server = display.server
        self.environment = script.environment(folder, DISPLAY=display.name)
        self.state = pathlib.Path(folder, "state", "katagami")
        self.settings = pathlib.Path(folder, "config", "katagami", "settings.json")
        self.settings.parent.mkdir(parents=True, exist_ok=True)
        # the places below are those of a wide 3D view
        self.settings.write_text(json.dumps({"net_view": False, **settings}))
        self.said = pathlib.Path(folder, "said.txt")
        with self.said.open("w") as said:
            self.process = subprocess.Popen([PROGRAM, "edit", *words], env=self.environment,
                                            cwd=folder, stderr=said)
        try:
            self.window = wait_for(self.find_window, "a window")
        except AssertionError:
            self.kill()
            raise
        self.settle()

    def find_window(self):
        if self.process.poll() is not None:
            said = self.said.read_text()
            if "OpenGL" in said:
                raise script.Skip("no window: " + said.strip())
            raise AssertionError(said)
        return self.xdotool("search", "--onlyvisible", "--pid", str(self.process.pid),
                            "--class", "katagami", check=False).split("\n")[0]

    def xdotool(self, *words, check=True):
        return subprocess.run(["xdotool", *words], env=self.environment, check=check,
                              capture_output=True, text=True).stdout

    def settle(self):
        """Waits until everything sent has been dealt with, and shows: the server, which passes it on,
        and the app have nothing to do."""
        quiet, spent, both = 0, None, (self.server, self.process.pid)
        end = time.monotonic() + DEADLINE_S
        while quiet < 4 and time.monotonic() < end and self.process.poll() is None:
            time.sleep(0.02)
            now = [cpu(process) for process in both]
            quiet = quiet + 1 if now == spent and all(map(sleeps, both)) else 0
            spent = now

    def move(self, x, y):
        self.xdotool("mousemove", "--window", self.window, str(x), str(y))

    def press_and_move(self, x, y, dx, dy):
        self.move(x, y)
        self.settle()
        self.xdotool("mousedown", "1")
        for i in range(1, 6):
            self.move(x + dx * i // 5, y + dy * i // 5)
        self.settle()

    def drag(self, x, y, dx, dy):
        self.press_and_move(x, y, dx, dy)
        self.xdotool("mouseup", "1")
        self.settle()

    def click(self, x, y):
        self.move(x, y)
        self.settle()
        self.xdotool("click", "1")
        self.settle()

    def key(self, *chords):
        for chord in chords:
            self.xdotool("key", chord)
            self.settle()

    def type(self, text):
        self.xdotool("type", "--delay", "20", text)
        self.settle()

    def title(self):
        return self.xdotool("getwindowname", self.window).strip()

    def autosaves(self):
        return list(self.state.glob("autosave-*.katagami"))

    def kill(self):
        self.process.kill()
        self.process.wait()

    def end(self):
        self.xdotool("key", "ctrl+q")
        assert self.process.wait(timeout=DEADLINE_S) == 0, self.said.read_text()


@contextlib.contextmanager
def running(display, folder, *words, **settings):
    app = App(display, folder, *words, **settings)
    try:
        yield app
    finally:
        if app.process.poll() is None:
            app.kill()


def model_at(path):
    return json.loads(path.read_text(encoding="utf-8"))


def first_point(model):
    return model["patches"][0]["points"][0]


def test_a_window_opens_and_closes():
    with screen() as display, tempfile.TemporaryDirectory() as folder:
        with running(display, folder, MODEL) as app:
            app.end()


def test_an_idle_window_costs_nothing():
    with screen() as display, tempfile.TemporaryDirectory() as folder:
        with running(display, folder, MODEL) as app:
            costs = []
            while not costs or (min(costs) >= 0.05 and len(costs) < 20):
                spent = cpu(app.process.pid)
                time.sleep(1.5)
                costs.append(cpu(app.process.pid) - spent)
            assert min(costs) < 0.05, costs  # the server may ask for a picture now and then
            app.end()
            settings = model_at(app.settings)
            assert settings["autosave_minutes"] == 2, "work of two minutes is lost at most"


def test_a_point_is_dragged_by_the_mouse():
    with screen() as display, tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder, "two.katagami")
        shutil.copy(MODEL, path)
        before = model_at(path)
        with running(display, folder, path) as app:
            app.click(350, 480)  # the body
            app.drag(381, 624, -40, 30)  # its first point
            assert app.title() == "● two.katagami — katagami", app.title()
            app.key("ctrl+s")
            wait_for(lambda: app.title() == "two.katagami — katagami", "the model saved")
            after = model_at(path)
            assert after["patches"][0]["points"][0] != before["patches"][0]["points"][0]
            assert after["patches"][0]["points"][1:] == before["patches"][0]["points"][1:]
            assert len(after["history"]["undo"]) == 1
            app.end()


def test_a_patch_is_placed_pulled_and_its_net_exported():
    with screen() as display, tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder, "one.katagami")
        with running(display, folder) as app:
            app.key("alt+1")
            app.click(20, 122)  # the button of the tool that places patches
            for x, y in ((300, 400), (400, 330), (520, 330), (620, 400)):
                app.click(x, y)
            app.key("ctrl+s")
            app.type(str(path))
            app.key("Return")
            placed = wait_for(lambda: path.exists() and model_at(path), "the model saved")
            assert len(placed["patches"]) == 1
            app.drag(620, 400, 30, 20)  # its last point
            app.key("ctrl+s")
            wait_for(lambda: app.title() == "one.katagami — katagami", "the model saved again")
            pulled = model_at(path)["patches"][0]["points"]
            points = placed["patches"][0]["points"]
            assert pulled[:3] == points[:3] and pulled[3][0] > points[3][0] + 1, pulled
            assert pulled[3][2] < points[3][2] - 1, pulled
            app.key("ctrl+e")
            app.key("Return")  # what kind of file: SVG
            app.key("Return")  # its name: that of the model
            net = pathlib.Path(folder, "one.svg")
            wait_for(net.exists, "the net")
            subprocess.run([PROGRAM, "net", path, "-o", f"{folder}/other.svg"], check=True)
            assert net.read_text() == pathlib.Path(folder, "other.svg").read_text()
            assert 'data-part="1"' in net.read_text()
            app.end()


def test_killed_the_work_is_offered_at_the_next_start():
    with screen() as display, tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder, "two.katagami")
        shutil.copy(MODEL, path)
        before = model_at(path)
        with running(display, folder, path, autosave_minutes=0.01) as app:
            app.click(350, 480)
            app.drag(381, 624, -40, 30)
            wait_for(lambda: any(first_point(model_at(path)) != first_point(before)
                                 for path in app.autosaves()), "an autosave")
            app.kill()
            kept = model_at(app.autosaves()[0])
        assert model_at(path) == before
        assert first_point(kept) != first_point(before)
        with running(display, folder) as app:
            app.key("Return")  # Recover
            wait_for(lambda: app.title() == "● two.katagami — katagami", "the work recovered")
            app.key("ctrl+s")
            wait_for(lambda: app.title() == "two.katagami — katagami", "the model saved")
            assert model_at(path)["patches"] == kept["patches"]
            assert not app.autosaves()
            app.end()


sys.exit(script.run(globals()))
