"""Kernel modules keep no mutable globals: looks for writable data in their object code.

usage: globals.py OBJDUMP LIBRARY.a …

Constant tables with pointers live in .data.rel.ro, which is read-only once loaded. C++ symbols are
left out: the standard library's headers and the compiler's exception tables plant their own.
"""

import re
import subprocess
import sys

SYMBOL = re.compile(r"^[0-9a-f]+ .{6}O (\S+)\s+[0-9a-f]+\s+(?:\.hidden )?(\S+)$")
WRITABLE = re.compile(r"^(\.data|\.bss|\.tdata|\.tbss|\*COM\*)(?!\.rel\.ro)")


def main(objdump, libraries):
    bad = 0
    for library in libraries:
        member = ""
        table = subprocess.run([objdump, "-t", library], check=True, capture_output=True,
                               text=True, env={"LC_ALL": "C"}).stdout
        for line in table.splitlines():
            if "file format" in line:
                member = line.split(":")[0]
            symbol = SYMBOL.match(line)
            if symbol and WRITABLE.match(symbol[1]) and not symbol[2].startswith(("_Z", "DW.ref.")):
                print(f"{library}({member}): {symbol[2]} is a mutable global")
                bad += 1
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2:]))
