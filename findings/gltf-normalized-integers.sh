#!/usr/bin/env bash
# trimesh 5.2.0 and assimp-py 1.1.0 (Python, with its bundled Assimp).
#
# The guess: texture coordinates and colours that a glTF stores as normalized
# integers are the fractions that they stand for, or the file is refused.
# Observed: trimesh takes the integers, without an error. For texture coordinates of
# 255 51 in bytes (1 and 0.2) it gives 255 and 206, which is 1 - 51 in a byte since it
# turns v over, so that a picture repeats some 255 times over the mesh. Colours of
# 65535 32768 256 in 16 bits (1, 0.5 and 0.004, as Assimp gives them) become 255 0 0,
# their lowest bytes.
#
# Why the input is valid: glTF 2.0, 3.7.2.1 Overview of meshes, table of attributes:
# TEXCOORD_n and COLOR_n are float, or unsigned byte or short normalized, which the
# property accessor.normalized marks: 255 and 65535 stand for 1.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
python_packages trimesh==5.2.0 assimp-py==1.1.0 numpy==2.4.6 pillow==13.0.0

python - <<'PY'
import base64
import json
import sys

import assimp_py
import numpy
import trimesh

corners = numpy.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], "<f4")


def write(name, attribute, kind, component, values):
    floats = {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}
    integers = {"bufferView": 1, "componentType": component, "normalized": True, "count": 3, "type": kind}
    # Rows of four bytes or a multiple, as the format wants it for vertex attributes.
    rows = b"".join(row.tobytes().ljust(4, b"\0") for row in values)
    stride = len(rows) // 3
    data = corners.tobytes() + rows
    primitive = {"attributes": {"POSITION": 0, attribute: 1}}
    scene = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [primitive]}],
        "accessors": [floats, integers],
        "bufferViews": [
            {"buffer": 0, "byteLength": corners.nbytes},
            {"buffer": 0, "byteOffset": corners.nbytes, "byteLength": len(rows), "byteStride": stride},
        ],
        "buffers": [{
            "byteLength": len(data),
            "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode(),
        }],
    }
    if attribute == "TEXCOORD_0":
        primitive["material"] = 0
        scene["materials"] = [{"pbrMetallicRoughness": {"metallicFactor": 0}}]
    with open(name, "w") as file:
        json.dump(scene, file)


write("coordinates.gltf", "TEXCOORD_0", "VEC2", 5121, numpy.array([[255, 51]] * 3, "u1"))
write("colours.gltf", "COLOR_0", "VEC4", 5123, numpy.array([[65535, 32768, 256, 65535]] * 3, "<u2"))

found = trimesh.load("coordinates.gltf", process=False).to_geometry().visual.uv[0].tolist()
print(f"coordinates 255 51: trimesh {found}")
if found != [255, 206]:
    sys.exit("changed: texture coordinates in bytes")
found = trimesh.load("colours.gltf", process=False).to_geometry().visual.vertex_colors[0, :3].tolist()
mesh = assimp_py.import_file("colours.gltf", assimp_py.Process_Triangulate).meshes[0]
right = numpy.array(mesh.colors[0], "float64").ravel()[:3].round(4).tolist()
print(f"colours 65535 32768 256: trimesh {found}, Assimp {right}")
if found != [255, 0, 0] or right != [1, 0.5, 0.0039]:
    sys.exit("changed: colours in 16 bits")
PY
