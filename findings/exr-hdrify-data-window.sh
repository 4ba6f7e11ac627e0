#!/usr/bin/env bash
# hdrify 1.2.1 (npm) and OpenEXR 3.5.3 (Python).
#
# The guess: hdrify's readExr gives the rows of the data window, as it gives the
# width and the height of that window.
# Observed: rows are placed by their absolute y in a picture that begins at y 0,
# without an error. With a data window of rows 10 to 13 all four rows are black,
# and with rows -2 to 1 the first two are lost and the last two stand on top. Rows
# 0 to 3 are right.
#
# Why the input is valid: "Technical Introduction to OpenEXR", Display Window and
# Data Window: the data window may lie anywhere in the pixel space. A renderer that
# crops its film or renders overscan writes such files.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
python_packages OpenEXR==3.5.3 numpy==2.4.6
node_packages hdrify@1.2.1

python - <<'PY'
import numpy
import OpenEXR

rows = numpy.arange(1, 5, dtype="float32").reshape(4, 1)
for name, first in (("origin", 0), ("below", 10), ("above", -2)):
    window = (numpy.array([0, first], "int32"), numpy.array([0, first + 3], "int32"))
    header = {
        "compression": OpenEXR.NO_COMPRESSION,
        "type": OpenEXR.scanlineimage,
        "dataWindow": window,
        "displayWindow": (numpy.array([0, 0], "int32"), numpy.array([0, 19], "int32")),
    }
    OpenEXR.File(header, {key: rows for key in "RGB"}).write(name + ".exr")
    with OpenEXR.File(name + ".exr") as file:
        read = file.channels()["RGB"].pixels[:, 0, 0]
        print(f"OpenEXR, first row {first}: {read.tolist()}")
        assert (read == rows[:, 0]).all()
PY
cat > check.mjs <<'JS'
import { readFileSync } from 'node:fs';
import { readExr } from 'hdrify';

for (const [name, expected] of [['origin', '1 2 3 4'], ['below', '0 0 0 0'], ['above', '3 4 0 0']]) {
    const { width, height, data } = readExr(new Uint8Array(readFileSync(`${name}.exr`)));
    const red = data.filter((_, place) => place % 4 === 0).join(' ');
    console.log(`hdrify, ${name}: ${width} x ${height}, rows ${red}`);
    if (red !== expected) {
        console.error(`changed: rows of the data window "${name}"`);
        process.exit(1);
    }
}
JS
node check.mjs
