#!/usr/bin/env python3
"""Turns shader files into a C header: surface.vert becomes the string kg_shader_surface_vert."""
import sys
from pathlib import Path

output, *inputs = map(Path, sys.argv[1:])
lines = ["/* Made from the files in shaders/ by embed.py. */"]
for path in inputs:
    # Numbers, since C limits the length of a string literal.
    codes = [str(code) for code in path.read_text(encoding="ascii").encode("ascii")] + ["0"]
    lines.append(f"static const char kg_shader_{path.name.replace('.', '_')}[] = {{")
    lines += ["    " + ", ".join(codes[i : i + 20]) + "," for i in range(0, len(codes), 20)]
    lines.append("};")
output.write_text("\n".join(lines) + "\n", encoding="ascii")
