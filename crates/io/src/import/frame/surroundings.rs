//! Tells whether what is in a file is a room or an object.
//!
//! Rays from the middle tell. In a room they meet fronts almost everywhere, most of them
//! near the sides of the box around everything; in a closed object (a car, a fish) they
//! meet backs. Without a lamp nothing is a room.

use super::{Vec3, direction};
use crate::import::imported_object::ImportedObject;
use crate::import::model_part::ModelSide;
use traylib_geometry::{Aabb, Bvh, Primitive, Ray, Shapes, SidedPrimitive, Sides, Vec2};
use traylib_scene::PointLight;

/// Directions that are tried, evenly over the sphere.
const DIRECTIONS: u32 = 400;
/// Part of them that meets something in a closed room.
const ENCLOSED: f32 = 0.95;
/// Part of them that meets something in a room with openings, such as a corridor.
const HALF_OPEN: f32 = 0.6;
/// Part of them that meets it at the sides of the box.
const AT_THE_SIDES: f32 = 0.5;
/// From the middle to the sides of the box: from here on is at the sides.
const NEAR_A_SIDE: f32 = 0.9;
/// Part of what is met: where more are backs, it is an object. Of real rooms the most is
/// 0.28, of real objects that enclose their middle the least 0.54.
const MOST_BACKS: f32 = 0.4;

/// Part of the light that must reach the middle for it to be lit from within; of a lamp
/// all around that shines to both sides it is one half.
const MOSTLY: f64 = 0.6;

/// The tree of all that rays can meet, from both sides wherever there is one surface for both.
pub(super) type Tree = Bvh<Shapes<Vec<SidedPrimitive>>>;

/// The tree of all objects; `None` if coordinates are too large for one.
pub(super) fn tree(items: &[ImportedObject]) -> Option<Tree> {
    let seen = |item: &ImportedObject| {
        let sides = if item.side == ModelSide::Whole { Sides::Both } else { item.sides };
        item.primitives().map(move |sided| SidedPrimitive { sides, ..sided }).collect::<Vec<_>>()
    };
    Bvh::of_shapes(items.iter().flat_map(seen).collect::<Vec<_>>()).ok()
}

/// Tells whether there is any light.
pub(super) fn shines(items: &[ImportedObject], lights: &[PointLight]) -> bool {
    items.iter().any(|item| !item.emission.is_black())
        || lights.iter().any(|light| !light.intensity.is_black())
}

/// The numbers of rays from the middle, by the surfaces that they meet.
#[derive(Clone, Copy, Debug, Default)]
struct Hits {
    all: u32,
    at_the_sides: u32,
    backs: u32,
    /// The number of backs of surfaces that reflect on both sides.
    solid_backs: u32,
}

/// Tells whether it is to be seen from inside.
pub(super) fn is_room(
    tree: &Tree,
    items: &[ImportedObject],
    lights: &[PointLight],
    bounds: &Aabb,
    up: Vec3,
) -> bool {
    if !shines(items, lights) {
        return false;
    }
    let hits = hits(tree, items, bounds, up);
    if !is_around(hits) {
        return false;
    }
    let most = MOST_BACKS * hits.all as f32;
    let one_sided_backs = hits.backs - hits.solid_backs;
    hits.backs as f32 <= most
        || (one_sided_backs as f32 <= most && is_lit_from_within(tree, items, lights, bounds))
}

fn is_around(hits: Hits) -> bool {
    let part = |count: u32| count as f32 / DIRECTIONS as f32;
    let all = part(hits.all);
    all >= ENCLOSED || (all >= HALF_OPEN && part(hits.at_the_sides) >= AT_THE_SIDES)
}

fn hits(tree: &Tree, items: &[ImportedObject], bounds: &Aabb, up: Vec3) -> Hits {
    let (centre, half) = (bounds.centre(), 0.5 * bounds.extent());
    let whose = |item| ImportedObject::primitives(item).map(move |_| item);
    let owners: Vec<&ImportedObject> = items.iter().flat_map(whose).collect();
    let mut hits = Hits::default();
    for index in 0..DIRECTIONS {
        let ray = Ray::new(centre, direction(index, DIRECTIONS, up));
        let Some(hit) = tree.nearest(&ray) else { continue };
        let normal = tree.shapes()[hit.primitive as usize].primitive.site(&ray, &hit).normal;
        let owner = owners[hit.primitive as usize];
        // As the file has it, before its back was turned round.
        let is_back = (normal.dot(ray.direction) > 0.0) != (owner.side == ModelSide::Back);
        let is_solid = owner.side == ModelSide::Back || owner.sides == Sides::Both;
        let off = (ray.at(hit.t) - centre).abs();
        hits.all += 1;
        hits.at_the_sides += u32::from(off.cmpgt(NEAR_A_SIDE * half).any());
        hits.backs += u32::from(is_back);
        hits.solid_backs += u32::from(is_back && is_solid);
    }
    hits
}

/// Tells whether most of the light is of lamps that the middle sees: then walls that show
/// their backs are those of a room all the same, drawn with their fronts outward.
fn is_lit_from_within(
    tree: &Tree,
    items: &[ImportedObject],
    lights: &[PointLight],
    bounds: &Aabb,
) -> bool {
    let centre = bounds.centre();
    let (mut seen, mut all) = (0.0, 0.0);
    let mut add = |power: f32, is_seen: bool| {
        all += f64::from(power);
        seen += if is_seen { f64::from(power) } else { 0.0 };
    };
    for lamp in items.iter().filter(|item| !item.emission.is_black()) {
        for SidedPrimitive { primitive, .. } in lamp.primitives() {
            let power = lamp.emission.luminance() * primitive.area();
            add(power, lamp_is_seen(tree, &primitive, centre));
        }
    }
    let scale = 0.25 * bounds.surface_area();
    for light in lights {
        let to_middle = centre - light.position;
        let reach = scale / to_middle.length_squared();
        let falloff = light.cone.map_or(1.0, |cone| cone.falloff(to_middle.normalize_or_zero()));
        let is_seen = falloff > 0.0 && !tree.any_hit(&Ray::segment(light.position, centre));
        // A light far outside may be as strong as it likes.
        add(light.intensity.luminance() * reach.min(1.0), is_seen);
    }
    seen > MOSTLY * all
}

fn lamp_is_seen(tree: &Tree, lamp: &Primitive, from: Vec3) -> bool {
    let (site, _) = lamp.sample_toward(from, Vec2::splat(0.5));
    let way = from - site.position;
    site.normal.dot(way) > 0.0 && !tree.any_hit(&Ray::segment(site.ray_origin(way), from))
}
