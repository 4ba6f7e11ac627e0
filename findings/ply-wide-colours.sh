#!/usr/bin/env bash
# trimesh 5.2.0 (Python), @loaders.gl/ply 4.4.5 with @loaders.gl/core 4.4.5 (npm)
# and assimp-py 1.1.0 (Python, with its bundled Assimp).
#
# The guess: a vertex colour that a PLY stores in 16 bits or as a float is scaled to
# the range of the reader's colours, as Assimp does it.
# Observed: trimesh and loaders.gl keep the lowest byte of a 16-bit colour, without
# an error: 65535 32768 256 (full red, half of green, hardly any blue) becomes
# 255 0 0, a pure red. loaders.gl also cuts floats to whole numbers of 255ths:
# 0.9 0.5 0.25 becomes 0 0 0, and white the darkest grey. trimesh scales floats
# rightly.
#
# Why the input is valid: "The PLY Polygon File Format" by Turk lets a property be
# of any of its scalar types, ushort and float among them.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
python_packages trimesh==5.2.0 assimp-py==1.1.0 numpy==2.4.6
node_packages @loaders.gl/core@4.4.5 @loaders.gl/ply@4.4.5

cat > check.py <<'PY'
import sys

import assimp_py
import numpy
import trimesh


def write(name, kind, colours):
    colour = "".join(f"property {kind} {key}\n" for key in ("red", "green", "blue"))
    with open(name, "w") as file:
        file.write(
            "ply\nformat ascii 1.0\nelement vertex 3\n"
            "property float x\nproperty float y\nproperty float z\n" + colour +
            "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
            + "".join(f"{place} {colours}\n" for place in ("0 0 0", "1 0 0", "0 1 0"))
            + "3 0 1 2\n"
        )


def check(name, trimesh_colour, assimp_colour):
    first = trimesh.load(name, process=False).visual.vertex_colors[0, :3].tolist()
    mesh = assimp_py.import_file(name, assimp_py.Process_Triangulate).meshes[0]
    second = numpy.array(mesh.colors[0], "float64").ravel()[:3].round(4).tolist()
    print(f"{name}: trimesh {first}, Assimp {second}")
    if first != trimesh_colour or second != assimp_colour:
        sys.exit(f"changed: colours of {name}")


write("bytes.ply", "uchar", "255 128 1")
write("words.ply", "ushort", "65535 32768 256")
write("floats.ply", "float", "0.9 0.5 0.25")
write("white.ply", "float", "1 1 1")
check("bytes.ply", [255, 128, 1], [1.0, 0.502, 0.0039])
check("words.ply", [255, 0, 0], [1.0, 0.5, 0.0039])
check("floats.ply", [230, 128, 64], [0.9, 0.5, 0.25])
PY
cat > check.mjs <<'JS'
import { readFileSync } from 'node:fs';
import { parse } from '@loaders.gl/core';
import { PLYLoader } from '@loaders.gl/ply';

const expected = { bytes: '255 128 1', words: '255 0 0', floats: '0 0 0', white: '1 1 1' };
for (const [name, colour] of Object.entries(expected)) {
    const file = new Uint8Array(readFileSync(`${name}.ply`)).buffer;
    const { value, normalized } = (await parse(file, PLYLoader, { worker: false })).attributes.COLOR_0;
    const found = value.slice(0, 3).join(' ');
    console.log(`${name}.ply: loaders.gl ${found}, normalized ${normalized}`);
    if (found !== colour || !normalized) {
        console.error(`changed: colours of ${name}.ply in loaders.gl`);
        process.exit(1);
    }
}
JS
python check.py
node check.mjs
