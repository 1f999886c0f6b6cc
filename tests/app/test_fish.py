"""A fish made by fish.txt is the one it was. usage: test_fish.py KATAGAMI [--renew]

expected/ holds the model that the script saved, the net that it exported and the report of that
net. With --renew they are written anew: do so only after a look at the pictures the script makes,
which --renew names, and at what `git diff` says of the files.
"""

import json
import math
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import script  # noqa: E402

PROGRAM = pathlib.Path(sys.argv[1]).resolve()
RENEW = "--renew" in sys.argv[2:]
EXPECTED = HERE / "expected"
MODEL_SLACK = 1e-6  # of numbers in the model and in the report: what is typed is exact in neither
PAGE_SLACK = 0.01  # mm on paper, a tenth of what a blade can do
NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[-+]?\d+)?")
FILES = ["fish.katagami", "fish.svg", "fish.json"]


def made(folder):
    """The texts of the files that the script and `katagami net` write."""
    shutil.copy(HERE.parents[1] / "data" / "dolphin.obj", folder)
    done = subprocess.run([PROGRAM, "edit", "--headless", "--script", HERE / "fish.txt"],
                          check=False, capture_output=True, text=True, cwd=folder,
                          env=script.environment(folder, TMP=folder))
    if "EGL" in done.stderr or "OpenGL" in done.stderr:
        raise script.Skip("nothing can be drawn here")
    assert done.returncode == 0, done.stderr
    subprocess.run([PROGRAM, "net", "fish.katagami", "-o", "other.svg", "--json", "fish.json"],
                   check=True, cwd=folder)
    texts = {name: pathlib.Path(folder, name).read_text(encoding="utf-8") for name in FILES}
    assert texts["fish.svg"] == pathlib.Path(folder, "other.svg").read_text(encoding="utf-8"), \
        "the app exports another net than `katagami net`"
    return {name: text.replace(folder, "$TMP") for name, text in texts.items()}


def compare(is_, was, at=""):
    """Two trees of JSON, but for roundings."""
    if isinstance(was, (int, float)) and not isinstance(was, bool):
        assert math.isclose(is_, was, rel_tol=1e-9, abs_tol=MODEL_SLACK), f"{at}: {is_}, not {was}"
    elif isinstance(was, dict):
        assert is_.keys() == was.keys(), f"{at}: {sorted(is_)}, not {sorted(was)}"
        for key, value in was.items():
            compare(is_[key], value, f"{at}.{key}")
    elif isinstance(was, list):
        assert len(is_) == len(was), f"{at}: {len(is_)} things, not {len(was)}"
        for i, value in enumerate(was):
            compare(is_[i], value, f"{at}[{i}]")
    else:
        assert is_ == was, f"{at}: {is_}, not {was}"


def test_the_fish_is_the_expected_one():
    with tempfile.TemporaryDirectory() as folder:
        texts = made(folder)
        if RENEW:
            keep = pathlib.Path(tempfile.mkdtemp(prefix="fish-"))
            for picture in pathlib.Path(folder).glob("*.png"):
                shutil.copy(picture, keep)
            print(f"# look at {keep}/*.png", file=sys.stderr)
    if RENEW:
        for name, text in texts.items():
            (EXPECTED / name).write_text(text, encoding="utf-8")
    was = {name: (EXPECTED / name).read_text(encoding="utf-8") for name in FILES}
    compare(json.loads(texts["fish.katagami"]), json.loads(was["fish.katagami"]), "model")
    compare(json.loads(texts["fish.json"]), json.loads(was["fish.json"]), "report")
    assert NUMBER.split(texts["fish.svg"]) == NUMBER.split(was["fish.svg"]), "other lines on pages"
    for i, (a, b) in enumerate(zip(NUMBER.findall(texts["fish.svg"]),
                                   NUMBER.findall(was["fish.svg"]))):
        assert abs(float(a) - float(b)) <= PAGE_SLACK, f"number {i} of the pages: {a}, not {b}"


def test_another_fish_is_told_from_it():
    model = json.loads((EXPECTED / "fish.katagami").read_text(encoding="utf-8"))
    other = json.loads(json.dumps(model))
    other["patches"][1]["points"][2][0] += 1e-5
    compare(model, model)
    try:
        compare(other, model)
    except AssertionError:
        return
    raise AssertionError("a point moved by 10 nm is not seen")


sys.exit(script.run(globals()))
