//! The surfaces that lamps lie on: their own surface with its opacity, or, of point lights, the
//! surface of something else.

use crate::Light;
use crate::surfaces::Surfaces;
use traylib_geometry::{ShapeList, SurfaceSite};
use traylib_materials::Material;
use traylib_math::Vec3;

/// The seat of a lamp: the surface that it lies on.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Seat {
    /// A place where nothing matters: a surface that is there all over, or free space.
    Plain,
    /// The lamp is this surface of the scene, parts of which may not be there.
    Masked(u32),
    /// A point light that lies in a surface up to rounding. It shines on both sides:
    /// neither hides it.
    Within(SurfaceSite),
}

impl Seat {
    /// The seat of a point light among these surfaces.
    pub(crate) fn of_point(position: Vec3, surfaces: &Surfaces) -> Self {
        touching(position, surfaces).next().map_or(Self::Plain, Self::Within)
    }
}

/// Finds what each lamp lies on; nothing if that matters for none.
pub(crate) fn seats(lights: &[Light], materials: &[Material], surfaces: &Surfaces) -> Vec<Seat> {
    let of_light = |light: &Light| match light {
        Light::Area { .. } => Some(Seat::Plain),
        Light::Point(point) => Some(Seat::of_point(point.position, surfaces)),
        // The last of all, and on nothing.
        Light::Sky(_) => None,
    };
    let mut seats: Vec<Seat> = lights.iter().filter_map(of_light).collect();
    for (index, surface) in (0..).zip(surfaces.all()) {
        if let Some(id) = surface.light()
            && materials[surface.material()].has_opacity()
        {
            seats[id.0 as usize] = Seat::Masked(index);
        }
    }
    if seats.iter().all(|seat| matches!(seat, Seat::Plain)) {
        seats.clear();
    }
    seats
}

/// The surfaces in which a point lies up to rounding.
pub(crate) fn touching(position: Vec3, surfaces: &Surfaces) -> impl Iterator<Item = SurfaceSite> {
    // Most shapes are nowhere near.
    let is_near = move |&index: &usize| {
        let bounds = surfaces.bounds(index);
        let rounding = (position.abs() + bounds.extent()) * (64.0 * f32::EPSILON);
        bounds.grown(rounding).contains(position)
    };
    let site = move |index: usize| surfaces.get(index as u32).primitive()?.touching(position);
    (0..surfaces.count()).filter(is_near).filter_map(site)
}
