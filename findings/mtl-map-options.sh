#!/usr/bin/env bash
# trimesh 5.2.0, assimp-py 1.1.0 (Python, with its bundled Assimp) and three 0.187.0
# (npm).
#
# The guess: a texture is found whatever options stand before its file name.
# Observed: trimesh loads the picture of `map_Kd wood.png`, and none with any option
# before the name, without an error: the surface has the plain Kd. three knows -s and
# -o, and looks for a file called "-clamp on wood.png" with -clamp. Assimp finds the
# name in all of them.
#
# Why the input is valid: Wavefront, MTL Material Format, map_Kd -options args
# filename: -clamp on | off, -s u v w and -o u v w are three of them.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
python_packages trimesh==5.2.0 assimp-py==1.1.0 Pillow==13.0.0 numpy==2.4.6
node_packages three@0.187.0

cat > check.py <<'PY'
import sys

import assimp_py
import trimesh
from PIL import Image

Image.new("RGB", (2, 2), (200, 100, 50)).save("wood.png")
with open("table.obj", "w") as file:
    file.write("mtllib table.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl top\nf 1/1 2/2 3/3\n")
for options in ("", "-clamp on ", "-s 2 2 1 "):
    with open("table.mtl", "w") as file:
        file.write(f"newmtl top\nKd 1 1 1\nmap_Kd {options}wood.png\n")
    loaded = trimesh.load("table.obj", process=False).visual.material.image is not None
    scene = assimp_py.import_file("table.obj", assimp_py.Process_Triangulate)
    name = scene.materials[scene.meshes[0].material_index]["TEXTURE_BASE"]
    print(f"map_Kd {options}wood.png: picture in trimesh {loaded}, name in Assimp {name}")
    if loaded != (options == "") or name != "wood.png":
        sys.exit(f"changed: the texture with {options or 'no option'}")
PY
cat > check.mjs <<'JS'
import { Texture } from 'three';
import { MTLLoader } from 'three/examples/jsm/loaders/MTLLoader.js';

for (const [options, expected] of [['', 'wood.png'], ['-clamp on ', '-clamp on wood.png'], ['-s 2 2 1 ', 'wood.png']]) {
    const materials = new MTLLoader().parse(`newmtl top\nmap_Kd ${options}wood.png\n`, '');
    let asked = '';
    materials.loadTexture = (name) => {
        asked = name;
        return new Texture();
    };
    materials.create('top');
    console.log(`map_Kd ${options}wood.png: file asked for by three "${asked}"`);
    if (asked !== expected) {
        console.error(`changed: the texture with ${options || 'no option'} in three`);
        process.exit(1);
    }
}
JS
python check.py
node check.mjs
