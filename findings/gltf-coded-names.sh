#!/usr/bin/env bash
# trimesh 5.2.0 and assimp-py 1.1.0 (Python, with its bundled Assimp).
#
# The guess: a glTF file whose buffer is called `two words.bin` is read when its URI
# has the blank coded as `%20`.
# Observed: both look for a file called `two%20words.bin` and refuse the scene, while
# one whose URI has a bare blank, which no URI may have, is read by both. Blender's
# exporter writes the coded form whenever the name of the scene has a blank, so that
# its files cannot be read without a new name.
#
# Why the input is valid: glTF 2.0, 2.8 URIs: relative paths are RFC 3986 references,
# reserved characters percent-encoded, and clients decode them.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
python_packages trimesh==5.2.0 assimp-py==1.1.0 numpy==2.4.6

python - <<'PY'
import json
import sys

import assimp_py
import numpy
import trimesh

corners = numpy.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], "<f4")
open("two words.bin", "wb").write(corners.tobytes())


def write(name, uri):
    scene = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                       "min": [0, 0, 0], "max": [1, 1, 0]}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "buffers": [{"byteLength": 36, "uri": uri}],
    }
    with open(name, "w") as file:
        json.dump(scene, file)


def by_trimesh(name):
    return len(trimesh.load(name, process=False).to_geometry().vertices)


def by_assimp(name):
    return assimp_py.import_file(name, assimp_py.Process_Triangulate).meshes[0].num_vertices


def outcome(read, name):
    try:
        return f"{read(name)} corners"
    except Exception as error:
        return "refused" if "two%20words.bin" in str(error) else f"other: {error}"


write("coded.gltf", "two%20words.bin")
write("bare.gltf", "two words.bin")
found = [outcome(read, name) for read in (by_trimesh, by_assimp) for name in ("coded.gltf", "bare.gltf")]
print("trimesh: coded {}, bare {}; Assimp: coded {}, bare {}".format(*found))
if found != ["refused", "3 corners"] * 2:
    sys.exit("changed")
PY
