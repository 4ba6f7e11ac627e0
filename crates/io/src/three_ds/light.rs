//! Lights of a 3DS file.

use super::chunk::{Reader, set};
use super::colour::colour;
use super::{ObjectFlags, WarningKind, Warnings};
use traylib_math::{Rgb, Vec3};

/// A light as stored.
///
/// 3D Studio's light does not weaken with the square of the distance: what
/// arrives is colour · multiplier, whatever the distance, and between the two
/// ranges falls linearly to 0 if `attenuated`.
#[derive(Clone, Debug, PartialEq)]
pub struct Light {
    /// Name of the object.
    pub name: String,
    /// Marks of the object.
    pub flags: ObjectFlags,
    /// The position; finite.
    pub position: Vec3,
    /// Colour, in 0..1 and coded for a screen.
    pub colour: Rgb,
    /// Factor on the colour. Below 0 light is taken away.
    pub multiplier: f32,
    /// True if it shines.
    pub on: bool,
    /// True if the ranges count.
    pub attenuated: bool,
    /// Up to here the light is full.
    pub inner_range: f32,
    /// From here on there is none.
    pub outer_range: f32,
    /// Objects it does not shine on.
    pub excluded: Vec<String>,
    /// The cone that makes it a spot light, if it is one.
    pub spot: Option<Spot>,
}

impl Light {
    /// A white light to all sides.
    pub(crate) fn new(name: String, position: Vec3) -> Self {
        Self {
            name,
            flags: ObjectFlags::default(),
            position,
            colour: Rgb::WHITE,
            multiplier: 1.0,
            on: true,
            attenuated: false,
            inner_range: 0.0,
            outer_range: 0.0,
            excluded: Vec::new(),
            spot: None,
        }
    }

    /// The unit direction a spot light points to; `None` for other lights, and
    /// where the target is where the light is.
    pub fn direction(&self) -> Option<Vec3> {
        (self.spot.as_ref()?.target - self.position).try_normalize()
    }
}

/// The properties that a spot light has beyond other lights.
#[derive(Clone, Debug, PartialEq)]
pub struct Spot {
    /// The place that it points to; finite.
    pub target: Vec3,
    /// Whole angle of the cone of full light, in degrees.
    pub hotspot_degrees: f32,
    /// Whole angle of the cone beyond which there is none, in degrees.
    pub falloff_degrees: f32,
    /// Turn about its direction, in degrees.
    pub roll_degrees: f32,
    /// A rectangle rather than a cone.
    pub rectangular: bool,
    /// Width to height of the rectangle.
    pub aspect: f32,
    /// It shines outside its cone too; only shadows are inside.
    pub overshoot: bool,
    /// The picture it projects.
    pub projector: Option<String>,
    /// Its shadow, if it casts one.
    pub shadow: Option<Shadow>,
}

/// The way a spot light casts its shadow.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Shadow {
    /// True if shadows are cast by rays, not by a map.
    pub ray_traced: bool,
    /// The distance off the surface at which rays start.
    pub ray_bias: Option<f32>,
    /// Bias, filter and size of a map of its own.
    pub map: Option<(f32, f32, u16)>,
}

/// Reads a light chunk (4600). `None` if it stands nowhere.
pub(super) fn decode(
    name: String,
    mut reader: Reader<'_>,
    warnings: &mut Warnings,
) -> Option<Light> {
    let Some(position) = reader.vec3().filter(|position| position.is_finite()) else {
        warnings.add(WarningKind::LightWithoutPlace);
        return None;
    };
    let mut light = Light::new(name, position);
    // The colour is a chunk among the others, which are warned about below.
    let mut seen = Warnings::default();
    set(&mut light.colour, colour(reader, &mut seen));
    let faulty = seen.count(&WarningKind::ColourNotFinite);
    warnings.add_many(WarningKind::ColourNotFinite, faulty as usize);
    while let Some((id, body)) = reader.next_chunk(warnings) {
        light.read(id, body, warnings);
    }
    Some(light)
}

impl Light {
    fn read(&mut self, id: u16, mut body: Reader<'_>, warnings: &mut Warnings) {
        match id {
            0x4610 => self.spot = spot(body, warnings),
            0x4620 => self.on = false,
            0x4625 => self.attenuated = true,
            0x4654 => self.excluded.push(body.string()),
            0x4659 => set(&mut self.inner_range, body.number(warnings)),
            0x465a => set(&mut self.outer_range, body.number(warnings)),
            0x465b => set(&mut self.multiplier, body.number(warnings)),
            _ => {}
        }
    }
}

/// Reads a spot light chunk (4610). Without target and angles the light is one
/// to all sides.
fn spot(mut reader: Reader<'_>, warnings: &mut Warnings) -> Option<Spot> {
    let [x, y, z, hotspot_degrees, falloff_degrees] = reader.finite(warnings)?;
    let mut spot = Spot {
        target: Vec3::new(x, y, z),
        hotspot_degrees,
        falloff_degrees,
        roll_degrees: 0.0,
        rectangular: false,
        aspect: 1.0,
        overshoot: false,
        projector: None,
        shadow: None,
    };
    while let Some((id, body)) = reader.next_chunk(warnings) {
        spot.read(id, body, warnings);
    }
    Some(spot)
}

impl Spot {
    fn read(&mut self, id: u16, mut body: Reader<'_>, warnings: &mut Warnings) {
        match id {
            0x4627 => self.shadow().ray_traced = true,
            0x4630 => _ = self.shadow(),
            0x4641 => self.shadow().map = shadow_map(body, warnings),
            0x4651 => self.rectangular = true,
            0x4652 => self.overshoot = true,
            0x4653 => self.projector = Some(body.string()),
            0x4656 => set(&mut self.roll_degrees, body.number(warnings)),
            0x4657 => set(&mut self.aspect, body.number(warnings)),
            0x4658 => self.shadow().ray_bias = body.number(warnings),
            _ => {}
        }
    }

    fn shadow(&mut self) -> &mut Shadow {
        self.shadow.get_or_insert_default()
    }
}

fn shadow_map(mut body: Reader<'_>, warnings: &mut Warnings) -> Option<(f32, f32, u16)> {
    let [bias, filter] = body.finite(warnings)?;
    Some((bias, filter, body.u16()?))
}

#[cfg(test)]
mod tests;
