#!/usr/bin/env bash
# three 0.187.0 (npm) and mitsuba 3.9.1 (Python).
#
# The guess: where an OBJ has no normals, `s 1` gives rounded ones and `s off` facets.
# Observed: neither looks at the statement, and they differ by themselves: of two
# triangles that meet at an edge three's OBJLoader makes facets with both, and Mitsuba
# rounds the edge with both. The same file has an edge in one picture and none in the
# other.
#
# Why the input is valid: Wavefront, Advanced Visualizer manual, appendix B1, s
# group_number: sets the group over whose elements is smoothed, 0 or off for none.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
python_packages mitsuba==3.9.1 numpy==2.4.6
node_packages three@0.187.0

for group in 1 off; do
    printf 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 1\ns %s\nf 1 2 3\nf 1 3 4\n' "$group" > "$group.obj"
done
cat > check.py <<'PY'
import sys

import mitsuba
import numpy

mitsuba.set_variant("scalar_rgb")


for name in ("1.obj", "off.obj"):
    shape = mitsuba.load_dict({"type": "obj", "filename": name})
    found = numpy.array(mitsuba.traverse(shape)["vertex_normals"]).reshape(-1, 3)
    print(f"mitsuba, {name}: normal at the shared corner {found[0].round(3).tolist()}")
    if len(found) != 4 or not 0.8 < found[0][2] < 0.9:
        sys.exit(f"changed: normals of {name} in mitsuba")
PY
cat > check.mjs <<'JS'
import { readFileSync } from 'node:fs';
import { OBJLoader } from 'three/examples/jsm/loaders/OBJLoader.js';

for (const name of ['1.obj', 'off.obj']) {
    const { normal } = new OBJLoader().parse(readFileSync(name, 'utf8')).children[0].geometry.attributes;
    const z = [0, 1, 2, 3, 4, 5].map((corner) => normal.getZ(corner).toFixed(3)).join(' ');
    console.log(`three, ${name}: z of the normals ${z}`);
    if (z !== '1.000 1.000 1.000 0.577 0.577 0.577') {
        console.error(`changed: normals of ${name} in three`);
        process.exit(1);
    }
}
JS
python check.py
node check.mjs
