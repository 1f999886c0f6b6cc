"""The layer lint must find what it is there to find: each test plants one fault in a tiny tree."""

import pathlib
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import script  # noqa: E402
from lint import layers  # noqa: E402

HEADER = '#include "katagami/base.h"\n#ifdef __cplusplus\nextern "C" {\n#endif\n' \
         '#ifdef __cplusplus\n}\n#endif\n'


def complaints(**planted):
    """What the lint says of a correct tree with these files (path with __ for /, dots as _o_)."""
    files = {
        "meson.build": "", "include/meson.build": "'katagami/base.h' 'katagami/net.h'",
        "include/katagami/base.h": "int a;\n", "include/katagami/net.h": HEADER,
        "src/net/page.c": '#include "katagami/net.h"\n#include "base/file.h"\n#include <stdio.h>\n',
        "src/unroll/strip.c": "int a;\n" * 100,
    }
    files.update({name.replace("__", "/").replace("_o_", "."): text
                  for name, text in planted.items()})
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name, text in files.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text, encoding="utf-8")
        return layers.check_tree(root)


def expect(words, **planted):
    said = complaints(**planted)
    assert len(said) == 1 and words in said[0], said


def test_a_correct_tree_is_accepted():
    assert complaints() == []


def test_net_may_not_include_patch():
    expect("net may not include katagami/patch.h",
           src__net__page_o_c='#include "katagami/patch.h"\n')


def test_curve_may_not_include_a_private_header_of_net():
    expect("curve may not include net/page.h", src__curve__arc_o_c='#include "net/page.h"\n')


def test_public_header_may_not_include_a_higher_one():
    expect("base may not include katagami/net.h",
           include__katagami__base_o_h='#include "katagami/net.h"\n')


def test_a_commented_include_is_no_include():
    assert complaints(src__curve__arc_o_c='/* #include "net/page.h" */\n') == []


def test_kernel_may_not_print_or_exit():
    expect("prints", src__net__page_o_c='void f(void) { printf("x"); }\n')
    expect("prints", src__net__page_o_c='void f(void) { fprintf(stderr, "x"); }\n')
    expect("prints", src__net__page_o_c="void f(void) { exit(1); }\n")
    assert complaints(src__cli__main_o_c='void f(void) { printf("x"); }\n') == []
    assert complaints(src__net__page_o_c='const char *s = "printf(x)"; int n = snprintf(0, 0);\n') \
        == []


def test_public_header_with_a_cpp_type():
    expect("extern \"C\"", include__katagami__net_o_h='#ifdef __cplusplus\nstd::string s;\n#endif\n')


def test_public_header_that_is_not_installed():
    expect("not listed", include__katagami__trim_o_h="int a;\n")


def test_public_header_without_a_module():
    expect("no module", include__katagami__other_o_h="int a;\n")


def test_unknown_module():
    expect("not in the list of modules", src__misc__page_o_c="int a;\n")


def test_a_long_file():
    expect("601 lines", src__net__page_o_c="int a;\n" * 601)


def test_too_much_cpp():
    expect("of the code lines are C", src__net__page_o_cpp="int a;\n" * 200)


def test_stray_top_level_file():
    expect("does not belong", notes_o_txt="")


def test_unfinished_work():
    expect("unfinished", src__net__page_o_c="/* TO" + "DO later */\n")


if __name__ == "__main__":
    sys.exit(script.run(globals()))
