#!/usr/bin/env bash
# trimesh 5.2.0 and assimp-py 1.1.0 (Python, with its bundled Assimp).
#
# The guess: a triangle fan of a glTF is read as triangles, as a triangle strip is, or
# refused.
# Observed: trimesh leaves the primitive out, without an error: a file of one fan is a
# scene without faces. The same five vertices as a strip give three triangles in
# trimesh, and both give three in Assimp.
#
# Why the input is valid: glTF 2.0, reference of mesh.primitive, mode: 6 is
# TRIANGLE_FAN, one of the allowed values.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
python_packages trimesh==5.2.0 assimp-py==1.1.0 numpy==2.4.6

python - <<'PY'
import base64
import json
import sys

import assimp_py
import numpy
import trimesh

corners = numpy.array([[0, 0, 0], [2, 0, 0], [2, 1, 0], [1, 2, 0], [0, 1, 0]], "<f4")


def write(name, mode):
    scene = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "mode": mode}]}],
        "accessors": [{
            "bufferView": 0, "componentType": 5126, "count": 5, "type": "VEC3",
            "min": [0, 0, 0], "max": [2, 2, 0],
        }],
        "bufferViews": [{"buffer": 0, "byteLength": corners.nbytes}],
        "buffers": [{
            "byteLength": corners.nbytes,
            "uri": "data:application/octet-stream;base64," + base64.b64encode(corners.tobytes()).decode(),
        }],
    }
    with open(name, "w") as file:
        json.dump(scene, file)


for name, mode, expected in (("strip.gltf", 5, 3), ("fan.gltf", 6, 0)):
    write(name, mode)
    first = len(trimesh.load(name, process=False).to_geometry().faces)
    second = len(assimp_py.import_file(name, assimp_py.Process_Triangulate).meshes[0].indices) // 3
    print(f"{name}: triangles in trimesh {first}, in Assimp {second}")
    if (first, second) != (expected, 3):
        sys.exit(f"changed: triangles of {name}")
PY
