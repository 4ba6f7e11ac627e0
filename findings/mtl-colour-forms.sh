#!/usr/bin/env bash
# three 0.187.0 (npm), assimp-py 1.1.0 (Python, with its bundled Assimp) and
# trimesh 5.2.0 (Python).
#
# The guess: `Kd 0.5` is a grey, as `Kd 0.5 0.5 0.5` is.
# Observed: Assimp gives 0.5 0 0, a red; three gives a colour whose green and blue
# are not numbers; trimesh replaces the material by its own, of 0.4. There is no
# error in any of them. With `Kd xyz 0.2 0.2 0.2` red is not a number in three,
# trimesh gives 0.4 again and Assimp refuses the file. The long form is a grey in all.
#
# Why the input is valid: Wavefront, MTL Material Format, Kd r g b: green and blue
# are optional and equal to red if left out; Kd xyz x y z gives CIE XYZ.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
python_packages trimesh==5.2.0 assimp-py==1.1.0 Pillow==13.0.0 numpy==2.4.6
node_packages three@0.187.0

for form in '0.5 0.5 0.5' '0.5' 'xyz 0.2 0.2 0.2'; do
    name=${form// /_}
    printf 'newmtl paint\nKd %s\n' "$form" > "$name.mtl"
    printf 'mtllib %s.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl paint\nf 1/1 2/2 3/3\n' \
        "$name" > "$name.obj"
done
cat > check.py <<'PY'
import sys

import assimp_py
import numpy
import trimesh


def assimp(name):
    try:
        scene = assimp_py.import_file(name, assimp_py.Process_Triangulate)
    except RuntimeError:
        return "refused"
    return scene.materials[scene.meshes[0].material_index]["COLOR_DIFFUSE"]


def from_trimesh(name):
    colour = trimesh.load(name, process=False).visual.material.diffuse
    return (numpy.asarray(colour)[:3] / 255).round(2).tolist()


for name, first, second in (
    ("0.5_0.5_0.5.obj", [0.5, 0.5, 0.5], [0.5, 0.5, 0.5]),
    ("0.5.obj", [0.5, 0.0, 0.0], [0.4, 0.4, 0.4]),
    ("xyz_0.2_0.2_0.2.obj", "refused", [0.4, 0.4, 0.4]),
):
    found = assimp(name), from_trimesh(name)
    print(f"{name}: Assimp {found[0]}, trimesh {found[1]}")
    if found != (first, second):
        sys.exit(f"changed: the colour of {name}")
PY
cat > check.mjs <<'JS'
import { readFileSync } from 'node:fs';
import { MTLLoader } from 'three/examples/jsm/loaders/MTLLoader.js';

const colours = {
    '0.5_0.5_0.5': '0.214 0.214 0.214',
    '0.5': '0.214 NaN NaN',
    'xyz_0.2_0.2_0.2': 'NaN 0.033 0.033',
};
for (const [name, expected] of Object.entries(colours)) {
    const { color } = new MTLLoader().parse(readFileSync(`${name}.mtl`, 'utf8'), '').create('paint');
    const found = color.toArray().map((value) => value.toFixed(3)).join(' ');
    console.log(`${name}: three ${found}`);
    if (found !== expected) {
        console.error(`changed: the colour of ${name} in three`);
        process.exit(1);
    }
}
JS
python check.py
node check.mjs
