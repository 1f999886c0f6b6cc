"""Checks the rules of the source tree that compilers do not: run with the source root.

Modules include only lower modules and their own files; kernel modules print nothing and end no
process; public headers are C, listed for installation and belong to a module; files stay short; at
least four fifths of the code are C; the top level holds only what belongs there.
"""

import pathlib
import re
import sys

# Every module and the modules right below it; what those include is allowed as well. The order and
# the reasons are in docs/architecture.md.
BELOW = {
    "base": [],
    "curve": ["base"],
    "patch": ["curve"],
    "trim": ["patch"],
    "model": ["trim", "net"],
    "net": ["base"],
    "unroll": ["model", "net"],
    "mesh": ["base"],
    "oa": ["mesh", "net"],
    "origami": ["net"],
    "document": ["model", "unroll", "oa", "origami", "mesh", "net"],
    "render": ["document"],
    "guide": ["document", "render"],
    "app": ["document", "render", "guide"],
    "cli": ["document", "render", "guide", "app"],
    "samples": ["document"],
}
# Public headers named otherwise than their module.
MODULE_OF_HEADER = {"crossing": "trim"}
FRONT_ENDS = {"app", "cli", "samples"}  # the only ones that talk to people

TOP_LEVEL = {"meson.build", "src", "include", "shaders", "data", "tests", "docs", "README.md",
             "LICENSE", "CHANGELOG.md", "dev"}
NOT_OURS = re.compile(r"^(build.*|out)$")  # what `dev` makes here

MAX_LINES = 600
MIN_C_SHARE = 0.8

CODE = {".c", ".h", ".cpp", ".hpp"}
TEXT = CODE | {".py", ".build", ".glsl", ".vert", ".frag", ".sh"}

INCLUDE = re.compile(r'^\s*#\s*include\s*(["<])([^">]+)[">]', re.MULTILINE)
PRINTS_OR_ENDS = re.compile(
    r"\b(?:printf|vprintf|puts|putchar|perror|exit|_exit|quick_exit|abort|setlocale)\s*\("
    r"|\bv?fprintf\s*\(\s*(?:stdout|stderr)\b|\bf?puts\s*\([^;]*\b(?:stdout|stderr)\b"
    r"|\bstd\s*::\s*(?:cout|cerr|clog)\b")
UNFINISHED = re.compile(r"\b(?:TODO|FIXME|XXX)\b")
# What a header may say to C++ compilers alone.
LINKAGE_ONLY = re.compile(r'#\s*ifdef __cplusplus\s*(?:extern "C" \{|\})\s*#\s*endif')


def module_of_header(name):
    return MODULE_OF_HEADER.get(name, name)


def lower_modules(module):
    """All modules that `module` may include, itself among them."""
    allowed = {module}
    for below in BELOW[module]:
        allowed |= lower_modules(below)
    return allowed


def without_comments(text):
    """The text with comments blanked (line breaks kept); strings stay."""
    token = re.compile(r'"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'|/\*.*?\*/|//[^\n]*', re.DOTALL)
    return token.sub(lambda m: m[0] if m[0][0] in "\"'" else re.sub(r"[^\n]", " ", m[0]), text)


def without_strings(text):
    return re.sub(r'"(?:\\.|[^"\\\n])*"', '""', text)


def line_of(text, position):
    return text.count("\n", 0, position) + 1


def check_includes(root, path, module, text, complaints):
    allowed = lower_modules(module)
    for match in INCLUDE.finditer(text):
        place = f"{path.relative_to(root)}:{line_of(text, match.start(2))}"
        quote, name = match.groups()
        folder, _, rest = name.partition("/")
        if quote == "<":
            continue
        target = module_of_header(rest.removesuffix(".h")) if folder == "katagami" else folder
        if not rest or target not in BELOW:
            complaints.append(f'{place}: "{name}" is neither "katagami/module.h" nor "module/…"')
        elif target not in allowed:
            complaints.append(f"{place}: {module} may not include {name}, which is not below it")


def check_public_header(root, path, text, complaints):
    place = path.relative_to(root)
    for match in INCLUDE.finditer(text):
        if match[1] == '"' and not match[2].startswith("katagami/"):
            complaints.append(f"{place}: public headers include no private ones ({match[2]})")
    if "__cplusplus" in LINKAGE_ONLY.sub("", text):
        complaints.append(f'{place}: only extern "C" may depend on __cplusplus')
    listed = root / "include" / "meson.build"
    if f"'katagami/{path.name}'" not in listed.read_text(encoding="utf-8"):
        complaints.append(f"{place}: not listed in include/meson.build")


def check_file(root, path, complaints):
    raw = path.read_text(encoding="utf-8")
    place = path.relative_to(root)
    parts = place.parts
    lines = raw.count("\n")
    if lines > MAX_LINES:
        complaints.append(f"{place}: {lines} lines, more than {MAX_LINES}; split it by algorithm")
    if path.suffix not in CODE:
        return
    text = without_comments(raw)
    for match in UNFINISHED.finditer(raw):
        complaints.append(f"{place}:{line_of(raw, match.start())}: unfinished work ({match[0]})")
    if parts[0] == "include":
        module = module_of_header(path.stem)
        if module not in BELOW:
            complaints.append(f"{place}: no module of this name")
            return
        check_public_header(root, path, text, complaints)
    elif parts[0] == "src":
        module = parts[1]
        if module not in BELOW:
            complaints.append(f"{place}: {module} is not in the list of modules")
            return
    else:
        return
    check_includes(root, path, module, text, complaints)
    if module not in FRONT_ENDS:
        code = without_strings(text)
        for match in PRINTS_OR_ENDS.finditer(code):
            complaints.append(f"{place}:{line_of(code, match.start())}: {module} prints, ends the "
                              f"process or changes the locale ({match[0].strip()}…)")


def code_lines(path):
    text = without_comments(path.read_text(encoding="utf-8"))
    return sum(1 for line in text.splitlines() if line.strip())


def check_c_share(root, files, complaints):
    c = sum(code_lines(f) for f in files if f.suffix in (".c", ".h"))
    cpp = sum(code_lines(f) for f in files if f.suffix in (".cpp", ".hpp"))
    if c + cpp > 0 and c / (c + cpp) < MIN_C_SHARE:
        complaints.append(f"only {100 * c / (c + cpp):.0f} % of the code lines are C, "
                          f"less than {100 * MIN_C_SHARE:.0f} %")


def check_tree(root):
    complaints = []
    for entry in sorted(root.iterdir()):
        if not (entry.name in TOP_LEVEL or entry.name.startswith(".") or
                NOT_OURS.match(entry.name)):
            complaints.append(f"{entry.name}: does not belong at the top level")
    files = [f for folder in ("include", "src", "shaders", "tests")
             for f in sorted((root / folder).rglob("*")) if f.is_file() and f.suffix in TEXT]
    for path in files + [root / "meson.build"]:
        check_file(root, path, complaints)
    check_c_share(root, files, complaints)
    return complaints


if __name__ == "__main__":
    found = check_tree(pathlib.Path(sys.argv[1]).resolve())
    print("\n".join(found))
    sys.exit(1 if found else 0)
