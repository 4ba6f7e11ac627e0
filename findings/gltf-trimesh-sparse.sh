#!/usr/bin/env bash
# trimesh 5.2.0 and assimp-py 1.1.0 (Python, with its bundled Assimp).
#
# The guess: the sparse values of a glTF accessor replace those of its buffer view,
# or the file is refused.
# Observed: trimesh leaves them out, without an error. A triangle whose third corner
# is moved to (5, 5, 5) by a sparse value stays where the buffer view has it, and one
# whose accessor has sparse values only shrinks to a point. Assimp gives both as the
# file has them.
#
# Why the input is valid: glTF 2.0, 3.6.2.3 Sparse Accessors: the values listed are
# substituted, and without a bufferView the others are zeros.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
python_packages trimesh==5.2.0 assimp-py==1.1.0 numpy==2.4.6

python - <<'PY'
import base64
import json
import sys

import assimp_py
import numpy
import trimesh

base = numpy.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], "<f4")
values = numpy.array([[1, 0, 0], [5, 5, 5]], "<f4")
data = base.tobytes() + values.tobytes() + numpy.array([1, 2], "<u2").tobytes()


def write(name, with_base):
    accessor = {
        "componentType": 5126,
        "count": 3,
        "type": "VEC3",
        "min": [0, 0, 0],
        "max": [5, 5, 5],
        "sparse": {
            "count": 2,
            "values": {"bufferView": 1},
            "indices": {"bufferView": 2, "componentType": 5123},
        },
    }
    if with_base:
        accessor["bufferView"] = 0
    sizes = (base.nbytes, values.nbytes, 4)
    scene = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [accessor],
        "bufferViews": [
            {"buffer": 0, "byteOffset": sum(sizes[:place]), "byteLength": size}
            for place, size in enumerate(sizes)
        ],
        "buffers": [{
            "byteLength": len(data),
            "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode(),
        }],
    }
    with open(name, "w") as file:
        json.dump(scene, file)


def check(name, expected):
    write(name, name == "some.gltf")
    first = trimesh.load(name, process=False).to_geometry().vertices.tolist()
    mesh = assimp_py.import_file(name, assimp_py.Process_Triangulate).meshes[0]
    second = numpy.array(mesh.vertices).reshape(-1, 3).tolist()
    print(f"{name}: trimesh {first}, Assimp {second}")
    if first != expected or second != [[0, 0, 0], [1, 0, 0], [5, 5, 5]]:
        sys.exit(f"changed: corners of {name}")


check("some.gltf", base.tolist())
check("only.gltf", [[0, 0, 0]] * 3)
PY
