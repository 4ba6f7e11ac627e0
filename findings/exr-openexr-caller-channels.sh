#!/usr/bin/env bash
# OpenEXR 3.5.3 (Python).
#
# The guess: OpenEXR.File takes the dictionary of channels it is given as input
# and leaves it as it was.
# Observed: it replaces the arrays in the caller's dictionary by its own Channel
# objects, so code that goes on with the dictionary (a second picture scaled
# from the first, say) fails with an AttributeError or TypeError. A copy given
# instead, dict(channels), keeps it whole.
#
# Why the input is valid: the OpenEXR documentation, "The OpenEXR Python Module",
# passes a dictionary from channel names to arrays in its first example.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
python_packages OpenEXR==3.5.3 numpy==2.4.6

python - <<'PY'
import sys

import numpy
import OpenEXR

header = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
channels = {key: numpy.ones((2, 2), "float32") for key in "RGB"}

OpenEXR.File(dict(header), dict(channels))
copied = type(channels["R"]).__name__
OpenEXR.File(dict(header), channels)
given = type(channels["R"]).__name__
print("after a copy was given:", copied)
print("after the dictionary itself was given:", given)
if copied != "ndarray":
    sys.exit("changed: a copy does not protect the arrays")
if given != "Channel":
    sys.exit("changed: the caller's dictionary keeps its arrays")
PY
