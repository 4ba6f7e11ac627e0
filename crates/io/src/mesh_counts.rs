//! The contents of a file of meshes, in figures.

use serde::Serialize;

/// The contents of an OBJ, PLY or glTF file, counted, every place of a mesh anew.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct MeshCounts {
    /// Meshes of one material each.
    pub meshes: usize,
    /// Their triangles, after polygons have been cut.
    pub triangles: usize,
    /// Their vertices: one for each position, normal and texture coordinates that meet.
    pub vertices: usize,
    /// Vertices with a normal.
    pub normals: usize,
    /// Vertices with texture coordinates.
    pub texcoords: usize,
    /// Materials that are on its surfaces; what has none is one of them.
    pub materials: usize,
    /// Lights that are no surfaces.
    pub lights: usize,
    /// 1 if there is a camera.
    pub cameras: usize,
    /// Area of all triangles.
    pub area: f64,
    /// Least and greatest x, y and z of the vertices.
    pub bbox: [f32; 6],
    /// Least and greatest u and v of the vertices that have them, v upward; zeros if none has.
    pub uv_box: [f32; 4],
    /// How much of white light each of these scatters diffusely, in red, green and blue.
    pub colours: Vec<[f32; 3]>,
}
