"""How long the app takes to show its window, on an X server of its own. usage: window.py KATAGAMI MODEL

Prints the median in seconds; ends with code 2 where Xvfb, xdotool or OpenGL are missing."""

import os
import pathlib
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import script  # noqa: E402

RUNS = 7
LIMIT_S = 60


def is_visible(app, environment):
    return subprocess.run(["xdotool", "search", "--onlyvisible", "--pid", str(app.pid), "--class",
                           "katagami"], env=environment, check=False,
                          stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode == 0


def seconds_to_window(program, model, environment):
    began = time.monotonic()
    with subprocess.Popen([program, "edit", model], env=environment,
                          stderr=subprocess.DEVNULL) as app:
        try:
            while not is_visible(app, environment):
                if app.poll() is not None or time.monotonic() > began + LIMIT_S:
                    sys.exit(2)  # no OpenGL here
            return time.monotonic() - began
        finally:
            app.kill()


def main():
    if not (shutil.which("Xvfb") and shutil.which("xdotool")):
        sys.exit(2)
    read, write = os.pipe()
    with subprocess.Popen(["Xvfb", "-noreset", "-displayfd", str(write), "-screen", "0",
                           "1300x900x24"], pass_fds=[write], stderr=subprocess.DEVNULL) as server, \
            tempfile.TemporaryDirectory() as folder:
        try:
            os.close(write)
            number = os.read(read, 16).decode().strip()
            if not number:
                sys.exit(2)
            environment = script.environment(folder, DISPLAY=":" + number)
            print(statistics.median(seconds_to_window(sys.argv[1], sys.argv[2], environment)
                                    for _ in range(RUNS)))
        finally:
            server.terminate()


main()
