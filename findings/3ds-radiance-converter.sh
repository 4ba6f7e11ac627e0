#!/usr/bin/env bash
# pyradiance 1.3.1 (Python, with the programs of Radiance; 64-bit Linux).
#
# The guess: 3ds2mgf, the converter of Radiance from 3D Studio to MGF, writes the
# triangle of a file that holds one.
# Observed: all coordinates are read as 0, without an error and with status 0:
# the table of objects gives centre and size 0 for a triangle with sides 3 and 4,
# and no face is written.
#
# Why the input is valid: the 3D Studio File Toolkit of Autodesk: one object
# (0x4000) with a mesh (0x4100) of three vertices as 32-bit floats (0x4110) and
# one face (0x4120).
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
python_packages pyradiance==1.3.1

python - <<'PY'
import os
import struct
import subprocess
import sys

import pyradiance


def chunk(kind, *parts):
    data = b"".join(parts)
    return struct.pack("<HI", kind, 6 + len(data)) + data


vertices = struct.pack("<H9f", 3, 0, 0, 0, 3, 0, 0, 0, 4, 0)
faces = struct.pack("<5H", 1, 0, 1, 2, 7)
mesh = chunk(0x4100, chunk(0x4110, vertices), chunk(0x4120, faces))
with open("tri.3ds", "wb") as file:
    file.write(chunk(0x4D4D, chunk(0x3D3D, chunk(0x4000, b"tri\0", mesh))))

tool = os.path.join(os.path.dirname(pyradiance.__file__), "bin", "3ds2mgf")
subprocess.run([tool, "tri.3ds", "tri.mgf"], check=True, timeout=60, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
with open("tri.mgf") as file:
    row = next(line for line in file if line.startswith("#  tri"))
with open("tri.inc") as file:
    faces = [line for line in file if line.startswith("f ")]
print("centre and size of the object:", row.split()[2:])
print("faces written:", len(faces))
if [float(word) for word in row.split()[2:]] != [0.0] * 6 or faces:
    sys.exit("changed: coordinates are read otherwise")
PY
