#!/usr/bin/env bash
# mitsuba 3.9.1 (Python).
#
# The guess: `<rotate x="0" y="2" z="0" angle="90"/>` turns about the y axis, as with
# y="1": an axis has a direction, and its length says nothing.
# Observed: the axis is taken as it is, and what comes out is no rotation. With y="2" the
# transform has the determinant 16, and a square of area 4 has 32; with y="0.5" they are
# 1/16 and 0.5. The example of the documentation, "0.701, 0.701, 0", is 0.9 % short of
# length one, and what it turns loses 3.4 % of its volume. There is no warning.
#
# Why the input is valid: Mitsuba's documentation of scene files, transformations: rotate
# takes "a given axis" as three numbers, and its own example is not of length one.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
python_packages mitsuba==3.9.1 numpy==2.4.6

python - <<'PY'
import sys

import mitsuba
import numpy

mitsuba.set_variant("scalar_rgb")


# The determinant of a rotation about an axis, and the area that it gives a square of 4.
def turned(axis, angle):
    x, y, z = axis
    shape = mitsuba.load_string(f"""<shape version="3.0.0" type="rectangle"><transform name="to_world">
        <rotate x="{x}" y="{y}" z="{z}" angle="{angle}"/></transform></shape>""")
    matrix = numpy.array(mitsuba.traverse(shape)["to_world"].matrix)[:3, :3]
    return numpy.linalg.det(matrix), float(shape.surface_area())


observed = True
for axis, angle, expected in (
    ((0, 1, 0), 90, (1, 4)),
    ((0, 2, 0), 90, (16, 32)),
    ((0, 0.5, 0), 90, (1 / 16, 0.5)),
    ((0.701, 0.701, 0), 180, (0.9656, 3.8624)),
):
    found = turned(axis, angle)
    print(f"about {axis} by {angle}: determinant {found[0]:.4f}, area {found[1]:.4f}")
    observed &= numpy.allclose(found, expected, rtol=1e-3)
if not observed:
    print("the axis of a rotation is taken otherwise")
sys.exit(not observed)
PY
