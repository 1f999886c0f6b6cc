"""Checks that every text of the app is there in every language, and that placeholders agree.
usage: test_translations.py SOURCE_ROOT

Leaves with 77, "skipped", where gettext's tools are missing.
"""

import ast
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

root = pathlib.Path(sys.argv[1])
folder = root / "src/app/po"
STRING = re.compile(r'"(?:[^"\\]|\\.)*"')


def entries(text):
    """(flags, msgid, msgstr) of each entry but the header."""
    for block in text.strip().split("\n\n"):
        lines = block.splitlines()
        body = "\n".join(line for line in lines if not line.startswith("#"))
        if "msgid" not in body:
            continue
        msgid, msgstr = ("".join(ast.literal_eval(s) for s in STRING.findall(half))
                         for half in body.split("\nmsgstr", 1))
        if msgid:
            yield [line for line in lines if line.startswith("#,")], msgid, msgstr


def main():
    if not shutil.which("xgettext") or not shutil.which("msgfmt"):
        sys.exit(77)
    complaints = []
    sources = sorted(str(f.relative_to(root)) for f in (root / "src/app").rglob("*.c")
                     if re.search(r"\bN?_\(\"", f.read_text(encoding="utf-8")))
    listed = (folder / "POTFILES").read_text(encoding="utf-8").split()
    for name in sorted(set(sources) - set(listed)):
        complaints.append(f"src/app/po/POTFILES: {name} is missing")
    for name in listed:
        if not (root / name).exists():
            complaints.append(f"src/app/po/POTFILES: there is no {name}")
    with tempfile.TemporaryDirectory() as temporary:
        template = pathlib.Path(temporary) / "katagami.pot"
        subprocess.run(["xgettext", "-k_", "-kN_", "--from-code=UTF-8", "-o", template, *sources],
                       cwd=root, check=True)
        wanted = {msgid for _, msgid, _ in entries(template.read_text(encoding="utf-8"))}
    if len(wanted) < 100:
        complaints.append(f"only {len(wanted)} texts were found")
    for language in (folder / "LINGUAS").read_text(encoding="utf-8").split():
        file = folder / f"{language}.po"
        done = subprocess.run(["msgfmt", "--check-format", "-o", "/dev/null", file], check=False,
                              capture_output=True, text=True)
        if done.returncode:
            complaints.append(done.stderr.strip())
        there = {}
        for flags, msgid, msgstr in entries(file.read_text(encoding="utf-8")):
            there[msgid] = msgstr
            if any("fuzzy" in flag for flag in flags):
                complaints.append(f"{file.name}: not certain: {msgid!r}")
        complaints += [f"{file.name}: missing: {text!r}" for text in sorted(wanted)
                       if not there.get(text)]
        complaints += [f"{file.name}: no longer used: {text!r}" for text in sorted(set(there) - wanted)]
    print("\n".join(complaints))
    sys.exit(1 if complaints else 0)


main()
