#!/usr/bin/env bash
# mitsuba 3.9.1 (Python).
#
# The guess: `flip_normals` may differ from shape to shape, also of shapes with one
# material.
# Observed: a scene in which two `rectangle`s, or two `cube`s, have the same material and
# only one of them flips its normals is refused: loading it merges shapes to be faster,
# and `Mesh::merge()` says that "the two meshes are incompatible". Each of the two alone
# is loaded, as are both with materials that differ, both flipped or none, disks and
# spheres, and the same scene without merging (`optimize=False`).
#
# Why the input is valid: Mitsuba's plugin reference, shapes: rectangle and cube take
# `flip_normals`, and any number of shapes may refer to one material.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
python_packages mitsuba==3.9.1 numpy==2.4.6

python - <<'PY'
import sys

import mitsuba

mitsuba.set_variant("scalar_rgb")
mitsuba.set_log_level(mitsuba.LogLevel.Error)


def scene(kind, flips, shared=True):
    materials = "".join(f'<bsdf type="diffuse" id="m{i}"><float name="reflectance" value="0.{i + 1}"/></bsdf>' for i in range(2))
    shape = lambda i, flip: (
        f'<shape type="{kind}"><boolean name="flip_normals" value="{flip}"/><ref id="m{0 if shared else i}"/></shape>'
    )
    return f'<scene version="3.0.0">{materials}{"".join(shape(i, flip) for i, flip in enumerate(flips))}</scene>'


def loads(text, **options):
    try:
        mitsuba.load_string(text, **options)
        return True
    except RuntimeError as error:
        print("  ", " ".join(str(error).split())[:150])
        return False


both = ("true", "false")
found = {}
for kind in ("rectangle", "cube", "disk", "sphere"):
    found[kind] = loads(scene(kind, both))
    print(f"two of {kind}, one flipped: {'loaded' if found[kind] else 'refused'}")
    assert loads(scene(kind, ("true", "true"))) and loads(scene(kind, ("false", "false")))
    assert loads(scene(kind, both, shared=False)) and loads(scene(kind, both), optimize=False)
observed = found == {"rectangle": False, "cube": False, "disk": True, "sphere": True}
if not observed:
    print("shapes that flip their normals are merged otherwise")
sys.exit(not observed)
PY
