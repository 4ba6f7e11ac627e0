#!/usr/bin/env bash
# meshio 5.3.5 (Python) and obj-file-parser 0.6.2 (npm).
#
# The guess: `f -3 -2 -1` is the face of the last three vertices before that line.
# Observed: meshio subtracts one from the negative numbers as from the others, and
# counts from the end of the whole file, without an error: -1 -2 -3 below five
# vertices become -2 -3 -4, which numpy takes for the vertices 4, 3 and 2.
# obj-file-parser counts negative numbers within the object and positive ones in the
# file: in a second object `f 4 5 6` and `f -3 -2 -1` are the same face to the
# format and the vertices 4 5 6 and 1 2 3 to it. Negative numbers of normals and
# texture coordinates it leaves negative.
#
# Why the input is valid: Wavefront, Advanced Visualizer manual, appendix B1,
# referencing vertex data: negative numbers count back from the position of the
# statement in the file, for vertices, texture coordinates and normals.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
python_packages meshio==5.3.5 numpy==2.4.6
node_packages obj-file-parser@0.6.2

python - <<'PY'
import sys

import meshio

with open("scene.obj", "w") as file:
    file.write("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf -4 -3 -2\nv 5 5 5\nf -1 -2 -3\n")
mesh = meshio.read("scene.obj")
faces = mesh.cells[0].data.tolist()
last = mesh.points[mesh.cells[0].data[2]].tolist()
print(f"meshio: faces {faces}; the last, by its points: {last}")
if faces != [[0, 1, 2], [-5, -4, -3], [-2, -3, -4]] or last[0] != [0.0, 1.0, 0.0]:
    sys.exit("changed: the faces that meshio gives")
PY
cat > check.mjs <<'JS'
import Parser from 'obj-file-parser';

const text = 'o a\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n'
    + 'o b\nv 0 0 5\nv 1 0 5\nv 1 1 5\nvn 0 0 1\nf 4 5 6\nf -3//-1 -2//-1 -1//-1\n';
const faces = new Parser(text).parse().models[1].faces.map(
    ({ vertices }) => vertices.map((corner) => `${corner.vertexIndex}//${corner.vertexNormalIndex}`).join(' '));
console.log(`obj-file-parser, second object: ${faces.join(', ')}`);
if (faces.join(', ') !== '4//0 5//0 6//0, 1//-1 2//-1 3//-1') {
    console.error('changed: the faces that obj-file-parser gives');
    process.exit(1);
}
JS
node check.mjs
