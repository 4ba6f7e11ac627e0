#!/usr/bin/env bash
# assimp-py 1.1.0 (Python, with its bundled Assimp).
#
# The guess: `aniso 0.5` in a material library sets the anisotropy, or is skipped, as
# `Pcr 0.03` and words that are not known are.
# Observed: Assimp refuses the whole OBJ file: it takes `a` for the keyword and then
# `niso` for the number. `anisor` fails alike. Blender writes both statements into every
# library when its PBR extensions are asked for, so that none of these files is read.
#
# Why the input is valid: `aniso` and `anisor` belong to the extension of MTL for
# physically-based rendering that exporters have in common, and Wavefront's MTL format
# has statements by whole words.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
python_packages assimp-py==1.1.0

for statement in 'Pcr 0.03' 'unknown 1' 'aniso 0.5' 'anisor 0.25'; do
    name=${statement% *}
    printf 'newmtl paint\nKd 1 0 0\n%s\n' "$statement" > "$name.mtl"
    printf 'mtllib %s.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl paint\nf 1 2 3\n' "$name" > "$name.obj"
done

python - <<'PY'
import sys

import assimp_py


def outcome(name):
    try:
        scene = assimp_py.import_file(name + ".obj", assimp_py.Process_Triangulate)
        return f"{scene.meshes[0].num_vertices} corners"
    except Exception as error:
        return "refused" if "niso" in str(error) else f"other: {error}"


found = {name: outcome(name) for name in ("Pcr", "unknown", "aniso", "anisor")}
print(found)
if list(found.values()) != ["3 corners", "3 corners", "refused", "refused"]:
    sys.exit("changed")
PY
