"""Runs a script of the app off-screen. usage: run_script.py KATAGAMI SCRIPT.txt

The script finds a folder of its own in $TMP, copies of the models of the tests in $HERE and of those
of the project in $DATA. Its user has no preferences. Leaves with 77, "skipped", where the machine cannot draw.
"""

import pathlib
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import script as tests  # noqa: E402

program, script = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()

with tempfile.TemporaryDirectory() as folder:
    for model in [*script.parent.glob("*.katagami"), *script.parent.glob("*.fold")]:
        shutil.copy(model, folder)
    shutil.copytree(script.parents[2] / "data", f"{folder}/data")
    environment = tests.environment(folder, TMP=folder, HERE=folder, DATA=f"{folder}/data")
    done = subprocess.run([program, "edit", "--headless", "--script", script], check=False,
                          capture_output=True, text=True, env=environment, cwd=folder)
    sys.stderr.write(done.stderr)
    cannot_draw = done.returncode == 1 and ("EGL" in done.stderr or "OpenGL" in done.stderr)
    sys.exit(77 if cannot_draw else done.returncode)
