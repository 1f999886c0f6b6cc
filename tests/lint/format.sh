#!/bin/sh
# usage: format.sh CLANG_FORMAT ROOT: complains about sources that are not formatted.
cd "$2" && find src include tests \( -name '*.[ch]' -o -name '*.cpp' \) -print0 |
    xargs -0 "$1" --dry-run -Werror
