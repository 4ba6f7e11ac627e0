//! Facts of a scene that relations depend on.

use super::{Base, DrawnScene, Material, Object, Shape};
use traylib_geometry::Sides;
use traylib_math::Vec3;

/// A flat piece: its plane and a box around it.
struct PlanarPiece {
    normal: Vec3,
    offset: f64,
    bounds: traylib_geometry::Aabb,
}

impl DrawnScene {
    /// Tells whether a surface reflects or refracts ideally.
    pub fn has_mirrors(&self) -> bool {
        self.objects.iter().any(|object| match object.material.base {
            Base::Mirror(..) | Base::Glass(_) => true,
            Base::Pane(reflectance, _) => reflectance != Vec3::ZERO,
            Base::Lambert(_) | Base::Phong(_) | Base::MaxPhong(..) | Base::Sheet(..) => false,
        })
    }

    /// The greatest exponent of a lobe.
    pub fn sharpest(&self) -> f32 {
        let sharpness = |object: &Object| match object.material.base {
            Base::Phong(lobes) => lobes.exponent,
            Base::MaxPhong(_, exponent) => exponent,
            Base::Sheet(a, b) => a.exponent.max(b.exponent),
            Base::Lambert(_) | Base::Mirror(..) | Base::Glass(_) | Base::Pane(..) => 0.0,
        };
        self.objects.iter().map(sharpness).fold(0.0, f32::max)
    }

    /// Tells whether walks from lamps and from the camera see the same surfaces: no back
    /// that is not there can be looked through or lit. Solids that hold neither
    /// camera nor light are so, and the room around all.
    pub fn fronts_are_alike(&self) -> bool {
        let one_sided = |object: &&Object| object.sides == Sides::Front;
        self.objects.iter().filter(one_sided).all(|object| {
            let bounds = object.shape.bounds();
            let inside = |point: Vec3| bounds.contains(point);
            if let Shape::Sphere { inward: true, .. } = object.shape {
                return self.objects.iter().all(|other| {
                    let inner = other.shape.bounds();
                    inside(inner.min) && inside(inner.max)
                });
            }
            let lights = self.lights.iter().map(|light| light.position);
            let others = self.objects.iter().filter(|other| !std::ptr::eq(*other, object));
            let apart = |other: &Object| {
                let o = other.shape.bounds();
                let overlap = o.min.cmple(bounds.max).all() && bounds.min.cmple(o.max).all();
                // A room around it overlaps, and is no matter.
                !overlap || o.min.cmplt(bounds.min).all() && o.max.cmpgt(bounds.max).all()
            };
            object.shape.is_solid() && !lights.chain([self.camera.position]).any(inside) && {
                others
            }
            .all(apart)
        })
    }

    /// Tells whether two flat surfaces lie in one plane and may overlap: which of them is
    /// met is decided by their order or by rounding.
    pub fn has_coplanar(&self) -> bool {
        let planar_pieces: Vec<Vec<PlanarPiece>> =
            self.objects.iter().map(|object| planar_pieces(&object.shape)).collect();
        planar_pieces.iter().enumerate().any(|(index, first)| {
            planar_pieces[index + 1..]
                .iter()
                .any(|second| first.iter().any(|a| second.iter().any(|b| are_coplanar(a, b))))
        })
    }

    /// Tells whether the camera or a light without extent lies on a surface, or nearly: on
    /// which side of it is decided by rounding.
    pub fn has_point_on_surface(&self) -> bool {
        let lights = self.lights.iter().map(|light| light.position);
        lights.chain([self.camera.position]).any(|point| self.surface_at(point, 1e-3).is_some())
    }

    /// The normal of a surface that a point lies on, or off by this part of its size
    /// at most; as long as the surface is large.
    pub fn surface_at(&self, point: Vec3, off: f32) -> Option<Vec3> {
        self.objects.iter().find_map(|object| surface_at(point, &object.shape, off))
    }

    /// Finds the surface of a solid, whose two sides are never lit at once for the same picture. A
    /// light that lies on a sheet shines on both.
    pub fn solid_surface_at(&self, point: Vec3, off: f32) -> Option<Vec3> {
        let solids = self.objects.iter().filter(|object| object.shape.is_solid());
        let sheets = self.objects.iter().filter(|object| !object.shape.is_solid());
        let on = |object: &Object| surface_at(point, &object.shape, off);
        if sheets.into_iter().any(|object| on(object).is_some()) {
            return None;
        }
        solids.into_iter().find_map(on)
    }

    /// Tells whether all glass is the boundary of something, and the camera outside.
    pub fn glass_is_solid(&self) -> bool {
        let is_glass = |object: &&Object| matches!(object.material.base, Base::Glass(_));
        self.objects.iter().filter(is_glass).all(|object| {
            let around = object.shape.bounds().contains(self.camera.position);
            object.shape.is_solid() && object.sides == Sides::Both && !around
        })
    }

    /// Tells whether rounding decides nowhere what is met.
    pub fn is_clear(&self) -> bool {
        !self.has_coplanar() && !self.has_point_on_surface()
    }

    /// Makes its first object shine if nothing does.
    pub fn light_up(&mut self) {
        if self.lights.is_empty()
            && self.sky.is_none()
            && !self.objects.iter().any(Object::is_light)
        {
            self.objects[0].emission = Vec3::ONE;
        }
    }

    /// Tells whether a lamp that is small to the camera lights something at once beside it, or
    /// itself: a bright spot on the film that few rays find.
    pub fn has_bright_spots(&self) -> bool {
        self.objects.iter().filter(|object| object.is_light()).any(|lamp| {
            let bounds = lamp.shape.bounds();
            let size = bounds.extent().length();
            let away = (bounds.centre() - self.camera.position).length();
            let near = bounds.grown(Vec3::splat(3.0 * size));
            let is_beside = |other: &Object| {
                let o = other.shape.bounds();
                let overlaps = o.min.cmple(near.max).all() && near.min.cmple(o.max).all();
                overlaps && !std::ptr::eq(other, lamp)
            };
            let lights_itself = lamp.material != Material::grey(0.0);
            size < 0.1 * away && (lights_itself || self.objects.iter().any(is_beside))
        })
    }

    /// The size of the smallest object.
    pub fn finest(&self) -> f32 {
        let size = |object: &Object| object.shape.bounds().extent().max_element();
        self.objects.iter().map(size).fold(f32::INFINITY, f32::min)
    }

    /// A distance from the origin beyond which there is nothing.
    pub fn reach(&self) -> f32 {
        let reach = |object: &Object| {
            let bounds = object.shape.bounds();
            bounds.min.abs().max(bounds.max.abs()).max_element()
        };
        let camera = self.camera.position.abs().max_element();
        1.75 * self.objects.iter().map(reach).fold(camera, f32::max)
    }
}

fn surface_at(point: Vec3, shape: &Shape, off: f32) -> Option<Vec3> {
    if let &Shape::Sphere { centre, radius, .. } = shape {
        let away = point - centre;
        return ((away.length() / radius - 1.0).abs() < off).then_some(away);
    }
    planar_pieces(shape).iter().find_map(|flat| {
        let size = flat.bounds.extent().length();
        let away = flat.normal.as_dvec3().dot(point.as_dvec3()) - flat.offset;
        let is_near = away.abs() < f64::from(off * size);
        let bounds = flat.bounds.grown(Vec3::splat(off * size));
        (is_near && bounds.contains(point)).then_some(flat.normal * size)
    })
}

fn planar_pieces(shape: &Shape) -> Vec<PlanarPiece> {
    let flat = |corner: Vec3, u: Vec3, v: Vec3, piece: Shape| {
        let normal = u.as_dvec3().cross(v.as_dvec3()).normalize_or_zero();
        PlanarPiece {
            normal: normal.as_vec3(),
            offset: normal.dot(corner.as_dvec3()),
            bounds: piece.bounds(),
        }
    };
    match shape {
        &Shape::Triangle([a, b, c]) => vec![flat(a, b - a, c - a, shape.clone())],
        &Shape::Quad([corner, u, v]) => vec![flat(corner, u, v, shape.clone())],
        &Shape::Disk { centre, normal, .. } => {
            let u = normal.any_orthogonal_vector();
            vec![flat(centre, u, normal.cross(u), shape.clone())]
        }
        Shape::Box(_) => super::sides_of_box(shape).iter().flat_map(planar_pieces).collect(),
        Shape::Mesh(mesh) => {
            mesh.corners().flat_map(|corners| planar_pieces(&Shape::Triangle(corners))).collect()
        }
        Shape::Cone { .. } | Shape::Sphere { .. } => Vec::new(),
    }
}

fn are_coplanar(a: &PlanarPiece, b: &PlanarPiece) -> bool {
    let along = a.normal.dot(b.normal);
    if along.abs() < 0.999_99 {
        return false;
    }
    let size = a.bounds.extent().length() + b.bounds.extent().length();
    let offset = b.offset * f64::from(along.signum());
    let margin = Vec3::splat(1e-5 * size);
    let (near, other) = (a.bounds.grown(margin), &b.bounds);
    (a.offset - offset).abs() < 1e-4 * f64::from(size)
        && other.min.cmple(near.max).all()
        && near.min.cmple(other.max).all()
}
