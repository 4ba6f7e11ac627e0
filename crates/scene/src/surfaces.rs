//! All that rays can meet, by number.

use crate::LightId;
use traylib_geometry::{
    Aabb, Hit, Mesh, Primitive, Ray, ShapeHit, ShapeKind, ShapeList, Sides, SurfaceSite, Triangle,
    Vec2, Vec3,
};
use traylib_materials::Site;
use traylib_math::warp;

/// The shapes of a scene in the order in which they were added; every triangle of a
/// mesh has a number of its own.
#[derive(Debug, Default)]
pub(crate) struct Surfaces {
    parts: Vec<Part>,
    /// For each number, where it is in the list of parts.
    part_of: Vec<u32>,
}

/// One shape, or a mesh, and what all of it has in common.
#[derive(Debug)]
struct Part {
    form: Form,
    sides: Sides,
    material: u32,
    /// The lamp that its first shape is, if it shines; others follow.
    first_light: Option<LightId>,
    /// The number of its first shape.
    first: u32,
}

/// What a part looks like.
#[derive(Debug)]
pub(crate) enum Form {
    /// One shape.
    Primitive(Primitive),
    /// Triangles, all of which have an area.
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
        form: Form,
        sides: Sides,
        material: u32,
        first_light: Option<LightId>,
    ) {
        let (part, first) = (self.parts.len() as u32, self.part_of.len() as u32);
        let count = match &form {
            Form::Primitive(_) => 1,
            Form::Mesh(mesh) => mesh.triangle_count(),
        };
        self.part_of.extend(std::iter::repeat_n(part, count));
        self.parts.push(Part { form, sides, material, first_light, first });
    }

    /// The shape of this number.
    #[inline]
    pub(crate) fn get(&self, number: u32) -> Surface<'_> {
        let part = &self.parts[self.part_of[number as usize] as usize];
        Surface { part, index: (number - part.first) as usize }
    }

    /// All shapes in the order of their numbers.
    pub(crate) fn all(&self) -> impl Iterator<Item = Surface<'_>> {
        (0..self.part_of.len() as u32).map(|number| self.get(number))
    }

    /// Puts another in the place of a shape: of a triangle another triangle.
    pub(crate) fn replace(&mut self, number: u32, by: Primitive) {
        let part = &mut self.parts[self.part_of[number as usize] as usize];
        match (&mut part.form, by) {
            (Form::Primitive(primitive), by) => *primitive = by,
            (Form::Mesh(mesh), by) => {
                if let Primitive::Triangle(triangle) = by {
                    mesh.move_triangle((number - part.first) as usize, triangle.corners());
                }
            }
        }
    }
}

impl ShapeList for Surfaces {
    fn count(&self) -> usize {
        self.part_of.len()
    }

    fn bounds(&self, index: usize) -> Aabb {
        let Surface { part, index } = self.get(index as u32);
        match &part.form {
            Form::Primitive(primitive) => primitive.bounds(),
            Form::Mesh(mesh) => Aabb::around(mesh.sided_triangle(index, part.sides).corners),
        }
    }

    #[inline]
    fn intersect(&self, index: usize, ray: &Ray) -> Option<ShapeHit> {
        let part = &self.parts[self.part_of[index] as usize];
        match &part.form {
            Form::Primitive(primitive) => primitive.intersect(ray, part.sides),
            Form::Mesh(_) => None,
        }
    }

    fn kind(&self, index: usize) -> ShapeKind {
        let Surface { part, index } = self.get(index as u32);
        match &part.form {
            Form::Primitive(primitive) => primitive.kind(part.sides),
            Form::Mesh(mesh) => ShapeKind::Triangle(mesh.sided_triangle(index, part.sides)),
        }
    }
}

impl Surface<'_> {
    /// The number of its material.
    #[inline]
    pub(crate) fn material(&self) -> usize {
        self.part.material as usize
    }

    /// Where rays meet it.
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
        match &self.part.form {
            Form::Primitive(primitive) => Some(*primitive),
            Form::Mesh(mesh) => mesh.triangle(self.index).map(Primitive::Triangle),
        }
    }

    /// The point that a ray met; `None` as for [`primitive`](Self::primitive).
    #[inline]
    pub(crate) fn site(&self, ray: &Ray, hit: &Hit) -> Option<SurfaceSite> {
        match &self.part.form {
            Form::Primitive(primitive) => Some(primitive.site(ray, hit)),
            Form::Mesh(mesh) => mesh.site(self.index, hit.u, hit.v),
        }
    }

    /// Tells whether a hit lies on an edge, as
    /// [`Primitive::is_on_edge`](traylib_geometry::Primitive::is_on_edge) has it.
    #[inline]
    pub(crate) fn is_on_edge(&self, hit: &Hit) -> bool {
        match &self.part.form {
            Form::Primitive(primitive) => primitive.is_on_edge(hit.u, hit.v),
            Form::Mesh(_) => Triangle::is_on_edge(hit.u, hit.v),
        }
    }

    /// Tells whether it has interpolated normals.
    pub(crate) fn is_smooth(&self) -> bool {
        match &self.part.form {
            Form::Primitive(_) => false,
            Form::Mesh(mesh) => mesh.shading_normal(self.index, 0.5, 0.25).is_some(),
        }
    }

    /// The interpolated normal of a mesh that has some.
    #[inline]
    pub(crate) fn smooth_normal(&self, hit: &Hit) -> Option<Vec3> {
        match &self.part.form {
            Form::Primitive(_) => None,
            Form::Mesh(mesh) => mesh.shading_normal(self.index, hit.u, hit.v),
        }
    }

    /// The surface coordinates of the point that
    /// [`Primitive::sample_area`](traylib_geometry::Primitive::sample_area) makes of `u`.
    pub(crate) fn sample_coordinates(&self, u: Vec2) -> Vec2 {
        match &self.part.form {
            Form::Primitive(primitive) => primitive.sample_coordinates(u),
            Form::Mesh(_) => warp::uniform_triangle(u),
        }
    }

    /// Where on its textures it is at these surface coordinates; `None` on shapes without
    /// texture coordinates.
    pub(crate) fn site_of_textures(&self, at: Vec2) -> Option<Site> {
        match &self.part.form {
            Form::Mesh(mesh) => {
                let uv = mesh.uv(self.index, at.x, at.y)?;
                Some(Site { uv, tangents: mesh.tangents(self.index) })
            }
            Form::Primitive(primitive) => {
                primitive.tangents().map(|edges| Site { uv: at, tangents: Some(edges) })
            }
        }
    }
}
