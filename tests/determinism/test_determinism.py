"""The same model gives the same bytes on every run and from every compiler.

usage: test_determinism.py KATAGAMI SAMPLES

The second compiler's program is named by the environment variable KATAGAMI_OTHER_BUILD, which
`./dev test` sets.
"""

import os
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import script  # noqa: E402

PROGRAM, SAMPLES = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()


def written(program, model):
    """Everything that `net` and `export` write of a model: {file name: bytes}."""
    with tempfile.TemporaryDirectory() as folder:
        for words in (["net", model, "-o", "net.svg", "--json", "net.json"],
                      ["export", model, "-o", "model.obj"]):
            subprocess.run([program, *words], cwd=folder, check=True)
        return {f.name: f.read_bytes() for f in sorted(pathlib.Path(folder).iterdir())}


def compare(one, other):
    models = sorted(SAMPLES.glob("*.katagami"))
    if not models:
        raise script.Skip("there are no sample models")
    for model in models:
        left, right = written(one, model), written(other, model)
        assert left.keys() == right.keys() and left, (model.name, left.keys(), right.keys())
        for name, data in left.items():
            assert data == right[name], f"{model.name}: {name} differs"


def test_two_runs_write_the_same_bytes():
    compare(PROGRAM, PROGRAM)


def test_two_compilers_write_the_same_bytes():
    other = os.environ.get("KATAGAMI_OTHER_BUILD")
    if not other or other == PROGRAM:
        raise script.Skip("only one build to look at")
    compare(PROGRAM, other)


if __name__ == "__main__":
    sys.exit(script.run(globals()))
