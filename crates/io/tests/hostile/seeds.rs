//! Sound files of our own to be damaged, each with a name.

use super::made;

pub(crate) fn all() -> Vec<(String, Vec<u8>)> {
    let files: [(&str, &[u8]); 12] = [
        ("shapes.mgf", include_bytes!("../data/shapes.mgf")),
        ("arrays.mgf", include_bytes!("../data/arrays.mgf")),
        ("trimesh.obj", include_bytes!("../data/models/trimesh.obj")),
        ("trimesh.mtl", include_bytes!("../data/models/trimesh.mtl")),
        ("text.ply", include_bytes!("../data/models/trimesh-text.ply")),
        ("binary.ply", include_bytes!("../data/models/trimesh-binary.ply")),
        ("trimesh.glb", include_bytes!("../data/models/trimesh.glb")),
        ("shapes.xml", include_bytes!("../data/mitsuba/shapes.xml")),
        ("textures.xml", include_bytes!("../data/mitsuba/textures.xml")),
        ("old.xml", include_bytes!("../data/mitsuba/old.xml")),
        ("cube.3ds", include_bytes!("../../../../scenes/models/cube.3ds")),
        ("enemy01.3ds", include_bytes!("../../../../scenes/models/enemy01.3ds")),
    ];
    let files = files.into_iter().map(|(name, bytes)| (name.to_string(), bytes.to_vec()));
    files.chain(textures()).collect()
}

/// Every format and every way to compress, by names as `pcx-of-1-bit.tga`: what is of
/// no format is read as TGA.
pub(crate) fn textures() -> impl Iterator<Item = (String, Vec<u8>)> {
    let named = |(name, bytes): (&str, Vec<u8>)| (format!("{}.tga", name.replace(' ', "-")), bytes);
    made::all(9, 7).into_iter().map(named)
}
