"""Checks that every text for people is there in every language, and that placeholders agree.
usage: test_translations.py SOURCE_ROOT

The texts are those that xgettext finds by the keywords of src/app/po/meson.build in the files of
POTFILES, which has to name all files with such texts but those of POTFILES.skip. Texts without a
word ("%s: %s") may be translated and need not be. Leaves with 77, "skipped", where gettext's tools
are missing.
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
VALUE = re.compile(r"%(?:\d+\$)?[-+ 0#]*(?:\d+|\*)?(?:\.(?:\d+|\*))?(?:hh|h|ll|l|z|j|t)?[a-zA-Z]|%%")
TALKING = {"base", "curve", "patch", "trim", "model", "net", "unroll", "mesh", "fit", "oa",
           "origami", "document", "render", "guide", "app"}  # not cli, samples: English only


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
            yield " ".join(line for line in lines if line.startswith("#,")), msgid, msgstr


def extract(keywords, names, out):
    """Entries of xgettext, which has to find something; C++ is asked for to read both languages."""
    subprocess.run(["xgettext", "--language=C++", *keywords, "--from-code=UTF-8", "-o", out, *names],
                   cwd=root, check=True)
    return entries(out.read_text(encoding="utf-8")) if out.exists() else ()


def words_of(name):
    return (folder / name).read_text(encoding="utf-8").split()


def check_language(language, wanted):
    """Complaints about a language; `wanted` maps texts to their flags."""
    file = folder / f"{language}.po"
    done = subprocess.run(["msgfmt", "--check-format", "-o", "/dev/null", file], check=False,
                          capture_output=True, text=True)
    if done.returncode:
        yield done.stderr.strip()
    there = {}
    for flags, msgid, msgstr in entries(file.read_text(encoding="utf-8")):
        there[msgid] = msgstr
        if "fuzzy" in flags:
            yield f"{file.name}: not certain: {msgid!r}"
        if "c-format" in wanted.get(msgid, "") and "c-format" not in flags:
            yield f"{file.name}: \"#, c-format\" is missing: {msgid!r}"
    for text in sorted(wanted):
        if not there.get(text) and re.search("[A-Za-z]", VALUE.sub("", text)):
            yield f"{file.name}: missing: {text!r}"
    for text in sorted(set(there) - set(wanted)):
        yield f"{file.name}: no longer used: {text!r}"


def main():
    if not shutil.which("xgettext") or not shutil.which("msgfmt"):
        sys.exit(77)
    complaints = []
    keywords = re.findall(r"--keyword=\S+?(?=')", (folder / "meson.build").read_text("utf-8"))
    marked = re.compile(r"\b(?:%s)\(" % "|".join(k[10:].split(":")[0] for k in keywords))
    skipped, listed = words_of("POTFILES.skip"), words_of("POTFILES")
    for name in (n for n in listed + skipped if not (root / n).exists()):
        complaints.append(f"src/app/po: there is no {name}")
    with tempfile.TemporaryDirectory() as temporary:
        template = pathlib.Path(temporary) / "katagami.pot"
        for file in sorted((root / "src").rglob("*.c*")):
            name = str(file.relative_to(root))
            if (file.relative_to(root / "src").parts[0] in TALKING and name not in listed + skipped
                    and marked.search(file.read_text(encoding="utf-8"))
                    and any(extract(keywords, [name], template))):
                complaints.append(f"src/app/po/POTFILES: {name} is missing")
                listed.append(name)
            template.unlink(missing_ok=True)
        listed = [n for n in listed if (root / n).exists()]
        wanted = {msgid: flags for flags, msgid, _ in extract(keywords, listed, template)}
    if len(wanted) < 500:
        complaints.append(f"only {len(wanted)} texts were found")
    for language in words_of("LINGUAS"):
        complaints += check_language(language, wanted)
    print("\n".join(complaints))
    sys.exit(1 if complaints else 0)


main()
