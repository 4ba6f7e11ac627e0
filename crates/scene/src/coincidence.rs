//! Lamps that lie in one place with other surfaces.
//!
//! Which of two surfaces in one place is seen would be decided by rounding, and by each
//! program in its own way. So lamps are lifted off their fronts when the scene is built,
//! by a few times what rounding can move a point: a lamp flush with its ceiling shines.
//! Of lamps in one place that face the same way the first is lifted highest and hides
//! the rest. Of other surfaces in one place the one added first is seen.

use crate::Light;
use crate::scene::Surface;
use traylib_geometry::{Bvh, Error, Ray, Shapes, SidedPrimitive, Sides};
use traylib_math::{Defect, Vec2, planted};

/// Points along each side of a lamp at which something else is looked for.
const POINTS: u8 = 3;

/// How parallel the normals of surfaces in one place are.
const PARALLEL: f32 = 1.0 - 1e-4;

/// How many lamps lay in one place with something else, which the builder of the scene
/// told apart.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Coincidences {
    /// Lamps in one place with other surfaces or lamps, which were lifted off their
    /// fronts.
    pub lifted_lamps: usize,
    /// Point lights within a surface, which shine on both its sides.
    pub points_in_surfaces: usize,
}

/// Lifts every lamp that lies in one place with another surface; how many there were.
///
/// # Errors
/// Those of the shapes.
pub(crate) fn lift_lamps(
    shapes: &mut Bvh<Shapes<SidedPrimitive>>,
    surfaces: &[Surface],
    lights: &mut [Light],
) -> Result<usize, Error> {
    if planted(Defect::LampStaysFlush) {
        return Ok(0);
    }
    let lamps = (0..surfaces.len() as u32).filter(|&i| surfaces[i as usize].light.is_some());
    let heights: Vec<(u32, f32)> =
        lamps.filter_map(|lamp| Some((lamp, height(shapes, surfaces, lamp)?))).collect();
    if heights.is_empty() {
        return Ok(0);
    }
    let mut all = shapes.shapes().to_vec();
    for &(index, height) in &heights {
        let shape = &mut all[index as usize].primitive;
        *shape = shape.lifted(height)?;
        let light = surfaces[index as usize].light.map(|id| &mut lights[id.0 as usize]);
        if let Some(Light::Area { primitive, .. }) = light {
            *primitive = *shape;
        }
    }
    *shapes = Bvh::of_shapes(all)?;
    Ok(heights.len())
}

/// How high to lift a lamp, in units of [`Primitive::lifted`](traylib_geometry::Primitive::lifted): one, and one more for each
/// later lamp in its place that faces the same way. `None` if it lies alone.
fn height(shapes: &Bvh<Shapes<SidedPrimitive>>, surfaces: &[Surface], lamp: u32) -> Option<f32> {
    let others = in_one_place(shapes, lamp);
    let hides = |&&(other, same_way): &&(u32, bool)| {
        same_way && other > lamp && surfaces[other as usize].light.is_some()
    };
    let hidden = others.iter().filter(hides).count();
    (!others.is_empty()).then_some(1.0 + hidden as f32)
}

/// The other primitives in one place with this one, and whether they face the same way.
/// Two that face opposite ways and have their fronts alone are never met together.
fn in_one_place(shapes: &Bvh<Shapes<SidedPrimitive>>, index: u32) -> Vec<(u32, bool)> {
    let SidedPrimitive { primitive, sides } = &shapes.shapes()[index as usize];
    let share = |i: u8| (f32::from(i) + 0.5) / f32::from(POINTS);
    let mut found = Vec::new();
    for i in 0..POINTS * POINTS {
        let site = primitive.sample_area(Vec2::new(share(i / POINTS), share(i % POINTS)));
        let forth = site.through();
        // One-sided surfaces are met one way.
        let back = Ray { origin: forth.at(forth.t_max), direction: -forth.direction, ..forth };
        for ray in [forth, back] {
            for hit in shapes.all_hits(&ray) {
                let other = &shapes.shapes()[hit.primitive as usize];
                let cosine = other.primitive.site(&ray, &hit).normal.dot(site.normal);
                let is_parallel = cosine.abs() > PARALLEL;
                let met_together = cosine > 0.0 || [*sides, other.sides].contains(&Sides::Both);
                if hit.primitive != index && is_parallel && met_together {
                    found.push((hit.primitive, cosine > 0.0));
                }
            }
        }
    }
    found.sort_unstable();
    found.dedup();
    found
}
