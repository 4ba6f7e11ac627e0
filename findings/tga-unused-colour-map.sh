#!/usr/bin/env bash
# @lunapaint/tga-codec 0.2.0 and three 0.187.0 (npm).
#
# The guess: a true-colour TGA that also carries a colour map is read, the map
# skipped, since nothing in the picture refers to it.
# Observed: @lunapaint/tga-codec takes the bytes of the true-colour pixels, one
# after the other, for indices into that map, without an error: pixels whose
# bytes begin with 1 0 1 0 come back as the second, first, second and first
# colour of the map. three's TGALoader refuses the file.
#
# Why the input is valid: the Truevision TGA File Format Specification 2.0,
# field 2 (Color Map Type), says that a true-colour picture may have a colour
# map, used by some programs for a palette of their own, and that readers of
# true-colour pictures pass over it.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
node_packages @lunapaint/tga-codec@0.2.0 three@0.187.0

cat > check.mjs <<'JS'
import tga from '@lunapaint/tga-codec';
import { TGALoader } from 'three/examples/jsm/loaders/TGALoader.js';

const colourMap = [9, 9, 200, 9, 200, 9]; // two entries: blue, green, red
const pixels = [1, 0, 1, 0, 50, 60, 70, 80, 90, 100, 110, 120];
const file = (entries) => new Uint8Array([
    0, entries ? 1 : 0, 2, 0, 0, entries, 0, entries ? 24 : 0,
    0, 0, 0, 0, 2, 0, 2, 0, 24, 0x20,
    ...(entries ? colourMap : []), ...pixels,
]);
const rgb = (data) => [0, 4, 8, 12].map((i) => Array.from(data.slice(i, i + 3)).join(' ')).join(', ');
const three = (bytes) => {
    try {
        return rgb(new TGALoader().parse(bytes.buffer).data);
    } catch (error) {
        return `refused: ${error.message}`;
    }
};
const changed = (what) => { console.error(`changed: ${what}`); process.exit(1); };

const plain = rgb((await tga.decodeTga(file(0))).image.data);
const mapped = rgb((await tga.decodeTga(file(2))).image.data);
console.log('tga-codec, no map:', plain);
console.log('tga-codec, unused map:', mapped);
console.log('three, no map:', three(file(0)));
console.log('three, unused map:', three(file(2)));
if (plain !== '1 0 1, 60 50 0, 90 80 70, 120 110 100') changed('tga-codec reads the plain file otherwise');
if (mapped !== '9 200 9, 200 9 9, 9 200 9, 200 9 9') changed('tga-codec reads the unused map otherwise');
if (three(file(0)) !== plain) changed('three reads the plain file otherwise');
if (!three(file(2)).startsWith('refused: ')) changed('three reads the file with an unused map');
JS
node check.mjs
