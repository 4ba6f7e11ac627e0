//! The surfaces that rays can meet, by number.

use crate::LightId;
use traylib_geometry::{
    Aabb, Error, Hit, Mesh, Primitive, Ray, ShapeHit, ShapeKind, ShapeList, Sides, SurfaceSite,
    Triangle, Vec2, Vec3,
};
use traylib_materials::Site;
use traylib_math::warp;

/// The shapes of a scene in the order in which they were added; every triangle of a
/// mesh has a number of its own.
#[derive(Clone, Debug, Default)]
pub(crate) struct Surfaces {
    parts: Vec<Part>,
    /// The part that the first number of each stretch of 2^`stretch_bits` numbers belongs to.
    part_of: Vec<u32>,
    stretch_bits: u32,
    count: u32,
}

/// The most entries of the list of stretches, or every hit of a large mesh would wait for memory
/// once more.
const MOST_STRETCHES: usize = 1 << 16;

/// One shape, or a mesh, and what all of it has in common.
#[derive(Clone, Debug)]
struct Part {
    /// A mesh has no triangle without area.
    shape: ObjectShape,
    sides: Sides,
    material: u32,
    /// The lamp that its first shape is, if it shines; others follow.
    first_light: Option<LightId>,
    /// The number of its first shape.
    first: u32,
}

/// The least cosine between two normals that are the same but for rounding.
const FLAT: f32 = 1.0 - 1e-6;

/// The shape of an object: one, or a mesh of triangles.
#[derive(Clone, Debug)]
pub enum ObjectShape {
    /// One shape.
    Primitive(Primitive),
    /// Triangles; those without area are left out.
    Mesh(Mesh),
}

/// One shape among all.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Surface<'a> {
    part: &'a Part,
    /// Its number within the part.
    index: usize,
}

impl Surfaces {
    /// Adds a shape, or the triangles of a mesh. If they shine, `first_light` is the lamp
    /// that the first of them is.
    pub(crate) fn add(
        &mut self,
        shape: ObjectShape,
        sides: Sides,
        material: u32,
        first_light: Option<LightId>,
    ) {
        let (part, first) = (self.parts.len() as u32, self.count);
        let count = match &shape {
            ObjectShape::Primitive(_) => 1,
            ObjectShape::Mesh(mesh) => mesh.triangle_count(),
        };
        self.count += count as u32;
        let stretches = |bits: u32| self.count.div_ceil(1 << bits) as usize;
        while stretches(self.stretch_bits) > MOST_STRETCHES {
            self.stretch_bits += 1;
            self.part_of = self.part_of.iter().copied().step_by(2).collect();
        }
        self.part_of.resize(stretches(self.stretch_bits), part);
        self.parts.push(Part { shape, sides, material, first_light, first });
    }

    /// The shape of this number.
    #[inline]
    pub(crate) fn get(&self, number: u32) -> Surface<'_> {
        let part = &self.parts[self.part_at(number)];
        Surface { part, index: (number - part.first) as usize }
    }

    /// The part that a shape belongs to.
    #[inline]
    fn part_at(&self, number: u32) -> usize {
        let stretch = (number >> self.stretch_bits) as usize;
        let first = self.part_of[stretch] as usize;
        if self.stretch_bits == 0 {
            return first;
        }
        // Most stretches are within one part.
        let last =
            self.part_of.get(stretch + 1).map_or(self.parts.len() - 1, |&next| next as usize);
        let later = &self.parts[first + 1..=last];
        first + later.partition_point(|part| part.first <= number)
    }

    /// All shapes in the order of their numbers.
    pub(crate) fn all(&self) -> impl Iterator<Item = Surface<'_>> {
        (0..self.count).map(|number| self.get(number))
    }

    /// The same shapes with the normals of their geometry alone.
    ///
    /// # Errors
    /// None of shapes that are in a scene already.
    pub(crate) fn without_smooth_normals(mut self) -> Result<Self, Error> {
        for part in &mut self.parts {
            match &mut part.shape {
                ObjectShape::Primitive(_) => {}
                ObjectShape::Mesh(mesh) => *mesh = without_normals(mesh)?,
            }
        }
        Ok(self)
    }

    /// Puts another in the place of a shape: of a triangle another triangle.
    pub(crate) fn replace(&mut self, number: u32, by: Primitive) {
        let part = self.part_at(number);
        let part = &mut self.parts[part];
        match (&mut part.shape, by) {
            (ObjectShape::Primitive(primitive), by) => *primitive = by,
            (ObjectShape::Mesh(mesh), by) => {
                if let Primitive::Triangle(triangle) = by {
                    mesh.move_triangle((number - part.first) as usize, triangle.corners());
                }
            }
        }
    }
}

fn without_normals(mesh: &Mesh) -> Result<Mesh, Error> {
    let bare = Mesh::new(mesh.positions().to_vec(), mesh.triangles().to_vec())?;
    if mesh.uvs().is_empty() { Ok(bare) } else { bare.with_uvs(mesh.uvs().to_vec()) }
}

impl ShapeList for Surfaces {
    fn count(&self) -> usize {
        self.count as usize
    }

    fn bounds(&self, index: usize) -> Aabb {
        let Surface { part, index } = self.get(index as u32);
        match &part.shape {
            ObjectShape::Primitive(primitive) => primitive.bounds(),
            ObjectShape::Mesh(mesh) => Aabb::around(mesh.sided_triangle(index, part.sides).corners),
        }
    }

    #[inline]
    fn intersect(&self, index: usize, ray: &Ray) -> Option<ShapeHit> {
        let part = &self.parts[self.part_at(index as u32)];
        match &part.shape {
            ObjectShape::Primitive(primitive) => primitive.intersect(ray, part.sides),
            ObjectShape::Mesh(_) => None,
        }
    }

    fn kind(&self, index: usize) -> ShapeKind {
        let Surface { part, index } = self.get(index as u32);
        match &part.shape {
            ObjectShape::Primitive(primitive) => primitive.kind(part.sides),
            ObjectShape::Mesh(mesh) => ShapeKind::Triangle(mesh.sided_triangle(index, part.sides)),
        }
    }
}

impl Surface<'_> {
    /// The number of its material.
    #[inline]
    pub(crate) fn material(&self) -> usize {
        self.part.material as usize
    }

    /// Returns the sides on which rays meet it.
    pub(crate) fn sides(&self) -> Sides {
        self.part.sides
    }

    /// The lamp that it is.
    #[inline]
    pub(crate) fn light(&self) -> Option<LightId> {
        self.part.first_light.map(|first| LightId(first.0 + self.index as u32))
    }

    /// Its shape; `None` of a triangle without area, which is in no scene.
    pub(crate) fn primitive(&self) -> Option<Primitive> {
        match &self.part.shape {
            ObjectShape::Primitive(primitive) => Some(*primitive),
            ObjectShape::Mesh(mesh) => mesh.triangle(self.index).map(Primitive::Triangle),
        }
    }

    /// Its area in square metres.
    pub(crate) fn area(&self) -> f32 {
        match &self.part.shape {
            ObjectShape::Primitive(primitive) => primitive.area(),
            ObjectShape::Mesh(mesh) => mesh.triangle_area(self.index),
        }
    }

    /// The point that a ray met; `None` as for [`primitive`](Self::primitive).
    #[inline]
    pub(crate) fn site(&self, ray: &Ray, hit: &Hit) -> Option<SurfaceSite> {
        match &self.part.shape {
            ObjectShape::Primitive(primitive) => Some(primitive.site(ray, hit)),
            ObjectShape::Mesh(mesh) => mesh.site(self.index, hit.u, hit.v),
        }
    }

    /// Tells whether a hit lies on an edge, as
    /// [`Primitive::is_on_edge`](traylib_geometry::Primitive::is_on_edge) has it.
    #[inline]
    pub(crate) fn is_on_edge(&self, hit: &Hit) -> bool {
        match &self.part.shape {
            ObjectShape::Primitive(primitive) => primitive.is_on_edge(hit.u, hit.v),
            ObjectShape::Mesh(_) => Triangle::is_on_edge(hit.u, hit.v),
        }
    }

    /// Tells whether it has interpolated normals.
    pub(crate) fn is_smooth(&self) -> bool {
        match &self.part.shape {
            ObjectShape::Primitive(_) => false,
            ObjectShape::Mesh(mesh) => mesh.shading_normal(self.index, 0.5, 0.25).is_some(),
        }
    }

    /// Tells whether its interpolated normals are others than that of its geometry.
    pub(crate) fn is_bent(&self) -> bool {
        let corners = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)];
        match &self.part.shape {
            ObjectShape::Primitive(_) => false,
            ObjectShape::Mesh(mesh) => mesh.site(self.index, 0.0, 0.0).is_some_and(|site| {
                let normals =
                    corners.into_iter().filter_map(|(u, v)| mesh.shading_normal(self.index, u, v));
                normals.into_iter().any(|normal| normal.dot(site.normal) < FLAT)
            }),
        }
    }

    /// The interpolated normal of a mesh that has some.
    #[inline]
    pub(crate) fn smooth_normal(&self, hit: &Hit) -> Option<Vec3> {
        match &self.part.shape {
            ObjectShape::Primitive(_) => None,
            ObjectShape::Mesh(mesh) => mesh.shading_normal(self.index, hit.u, hit.v),
        }
    }

    /// The surface coordinates of the point that
    /// [`Primitive::sample_area`](traylib_geometry::Primitive::sample_area) makes of `u`.
    pub(crate) fn sample_coordinates(&self, u: Vec2) -> Vec2 {
        match &self.part.shape {
            ObjectShape::Primitive(primitive) => primitive.sample_coordinates(u),
            ObjectShape::Mesh(_) => warp::uniform_triangle(u),
        }
    }

    /// Returns its place on its textures at these surface coordinates; `None` on shapes without
    /// texture coordinates.
    pub(crate) fn site_of_textures(&self, at: Vec2) -> Option<Site> {
        match &self.part.shape {
            ObjectShape::Mesh(mesh) => {
                let uv = mesh.uv(self.index, at.x, at.y)?;
                Some(Site { uv, tangents: mesh.tangents(self.index) })
            }
            ObjectShape::Primitive(primitive) => {
                primitive.tangents().map(|edges| Site { uv: at, tangents: Some(edges) })
            }
        }
    }
}

#[cfg(test)]
mod tests;
