#!/usr/bin/env bash
# assimp-py 1.1.0 (Python, with its bundled Assimp).
#
# The guess: the objects of a 3D Studio file keep their names.
# Observed: in a file without a keyframer section the objects "table" and "lamp"
# become nodes 3DSMesh_0 and 3DSMesh_1 with meshes "0" and "1"; the names are
# nowhere in the loaded scene. With a keyframer section that lists both, the
# nodes are called "table" and "lamp".
#
# Why the input is valid: the 3D Studio File Toolkit of Autodesk has the name in
# the NAMED_OBJECT chunk (0x4000) of the mesh section; the keyframer section
# (0xB000) is there for animation and many exporters leave it out.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
python_packages assimp-py==1.1.0

python - <<'PY'
import struct
import sys

import assimp_py


def chunk(kind, *parts):
    data = b"".join(parts)
    return struct.pack("<HI", kind, 6 + len(data)) + data


def triangle(name):
    vertices = struct.pack("<H9f", 3, 0, 0, 0, 1, 0, 0, 0, 1, 0)
    faces = struct.pack("<5H", 1, 0, 1, 2, 7)
    return chunk(0x4000, name, b"\0", chunk(0x4100, chunk(0x4110, vertices), chunk(0x4120, faces)))


def node(name):
    return chunk(0xB002, chunk(0xB010, name, b"\0", struct.pack("<HHh", 0, 0, -1)))


def names(file_name, *sections):
    with open(file_name, "wb") as file:
        file.write(chunk(0x4D4D, *sections))
    scene = assimp_py.import_file(file_name, 0)
    found = []
    waiting = [scene.root_node]
    while waiting:
        here = waiting.pop(0)
        found.append(here.name)
        waiting.extend(here.children)
    return found + [mesh.name for mesh in scene.meshes]


meshes = chunk(0x3D3D, triangle(b"table"), triangle(b"lamp"))
plain = names("plain.3ds", meshes)
keyed = names("keyed.3ds", meshes, chunk(0xB000, node(b"table"), node(b"lamp")))
print("without keyframer:", plain)
print("with keyframer:", keyed)
if {"table", "lamp"} & set(plain) or "3DSMesh_0" not in plain:
    sys.exit("changed: names without a keyframer section")
if not {"table", "lamp"} <= set(keyed):
    sys.exit("changed: names with a keyframer section")
PY
