#!/usr/bin/env bash
# three 0.187.0 (npm) and assimp-py 1.1.0 (Python, with its bundled Assimp).
#
# The guess: a lamp with twice the `Ke` shines twice as bright.
# Observed: three's MTLLoader takes Ke for an sRGB code, above 1 too: 1 stays 1, 2
# becomes 4.95 and 10 becomes 223.8, so that the lamps of a scene change against each
# other and a warm 10 5 2 becomes a deep red 223.8 43.0 4.95. Assimp gives 10 5 2. A
# reflectance `Kd 0.5` is 0.214 in the one and 0.5 in the other.
#
# Why the input is valid: Ke is the emission that exporters of MTL write for lamps and
# both readers take; Wavefront, MTL Material Format, Kd r g b, speaks of reflectivity
# and lets values go above 1, and knows no transfer curve.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
python_packages assimp-py==1.1.0 numpy==2.4.6
node_packages three@0.187.0

printf 'newmtl lamp\nKd 0.5 0.5 0.5\nKe 10 5 2\nnewmtl weak\nKd 0.5 0.5 0.5\nKe 2 1 0\n' > lamps.mtl
printf 'mtllib lamps.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl lamp\nf 1 2 3\n' > lamps.obj
python - <<'PY'
import sys

import assimp_py

scene = assimp_py.import_file("lamps.obj", assimp_py.Process_Triangulate)
material = scene.materials[scene.meshes[0].material_index]
found = material["COLOR_EMISSIVE"], material["COLOR_DIFFUSE"]
print(f"Assimp: emission {found[0]}, reflectance {found[1]}")
if found != ([10, 5, 2], [0.5, 0.5, 0.5]):
    sys.exit("changed: the colours that Assimp gives")
PY
cat > check.mjs <<'JS'
import { readFileSync } from 'node:fs';
import { MTLLoader } from 'three/examples/jsm/loaders/MTLLoader.js';

const materials = new MTLLoader().parse(readFileSync('lamps.mtl', 'utf8'), '');
const expected = 'emission 223.83 42.97 4.95, reflectance 0.21 0.21 0.21; '
    + 'emission 4.95 1.00 0.00, reflectance 0.21 0.21 0.21';
const text = (colour) => colour.toArray().map((value) => value.toFixed(2)).join(' ');
const found = ['lamp', 'weak'].map((name) => {
    const { emissive, color } = materials.create(name);
    return `emission ${text(emissive)}, reflectance ${text(color)}`;
});
console.log(`three: ${found.join('; ')}`);
if (found.join('; ') !== expected) {
    console.error('changed: the colours that three gives');
    process.exit(1);
}
JS
node check.mjs
