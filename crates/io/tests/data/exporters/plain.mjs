// A glTF file as a plain one, by gltf-transform 4.5.1: node plain.mjs FILE OUT
//
//     npm install @gltf-transform/core@4.5.1 @gltf-transform/extensions@4.5.1 @gltf-transform/functions@4.5.1
import { NodeIO, Primitive } from '@gltf-transform/core';
import { ALL_EXTENSIONS } from '@gltf-transform/extensions';
import { convertPrimitiveToTriangles, dequantize, uninstance } from '@gltf-transform/functions';

const [file, out] = process.argv.slice(2);
const io = new NodeIO().registerExtensions(ALL_EXTENSIONS);
const document = await io.read(file);
await document.transform(dequantize(), uninstance());
for (const mesh of document.getRoot().listMeshes()) {
  for (const primitive of mesh.listPrimitives()) {
    const mode = primitive.getMode();
    if (mode === Primitive.Mode.TRIANGLE_STRIP || mode === Primitive.Mode.TRIANGLE_FAN) convertPrimitiveToTriangles(primitive);
    for (const name of primitive.listSemantics()) primitive.getAttribute(name).setSparse(false);
  }
}
await io.write(out, document);
