//! Vertices: positions, normals and texture coordinates.

use super::{Reader, is_colour};
use crate::ply::declaration::Property;
use crate::ply::kind::Kind;
use crate::ply::{Cause, WarningKind};
use crate::suggest::shown;
use traylib_math::{Vec2, Vec3};

/// Names of what is kept of a vertex: position, normal, texture coordinates.
const KEPT: [&[&str]; 8] = [
    &["x"],
    &["y"],
    &["z"],
    &["nx", "normal_x"],
    &["ny", "normal_y"],
    &["nz", "normal_z"],
    &["s", "u", "texture_u", "texture_s", "s0", "u0"],
    &["t", "v", "texture_v", "texture_t", "t0", "v0"],
];

/// For each property its place among [`KEPT`]; `None` if it is skipped.
type Slots = Vec<Option<usize>>;

impl Reader<'_> {
    pub(super) fn vertices(&mut self, properties: &[Property], count: usize) -> Result<(), Cause> {
        if u32::try_from(self.document.positions.len() + count).is_err() {
            return Err(Cause::TooMany("vertices"));
        }
        let slots = self.slots(properties, count);
        let has = |slot| slots.contains(&Some(slot));
        if let Some(missing) = (0..3).find(|&axis| !has(axis)) {
            return Err(Cause::NoCoordinate(["x", "y", "z"][missing]));
        }
        let (has_normals, has_uvs) = ((3..6).all(has), (6..8).all(has));
        self.document.positions.reserve(count);
        self.each(count, |reader| {
            let [x, y, z, nx, ny, nz, u, v] = reader.values(properties, &slots)?;
            reader.position(Vec3::new(x, y, z))?;
            if has_normals {
                reader.normal(Vec3::new(nx, ny, nz));
            }
            if has_uvs {
                reader.uv(Vec2::new(u, v));
            }
            Ok(())
        })
    }

    /// Finds what each property of vertices is, and warns of those that are skipped.
    fn slots(&mut self, properties: &[Property], count: usize) -> Slots {
        let mut slots = Slots::new();
        let mut is_coloured = false;
        for property in properties {
            let is_one = matches!(property.kind, Kind::One(_));
            let is_named = |names: &[&str]| names.contains(&property.name.as_str());
            let slot = KEPT.iter().copied().position(is_named).filter(|_| is_one);
            let slot = slot.filter(|slot| !slots.contains(&Some(*slot)));
            if slot.is_none() && is_colour(property) {
                is_coloured = true;
            } else if slot.is_none() {
                self.warn(WarningKind::VertexProperty(shown(&property.name)), 1);
            }
            slots.push(slot);
        }
        self.warn(WarningKind::VertexColour, if is_coloured { count } else { 0 });
        slots
    }

    /// Reads a vertex; what it does not have is 0.
    fn values(
        &mut self,
        properties: &[Property],
        slots: &[Option<usize>],
    ) -> Result<[f32; KEPT.len()], Cause> {
        let mut values = [0.0; KEPT.len()];
        for (property, slot) in properties.iter().zip(slots) {
            match (slot, property.kind) {
                (Some(slot), Kind::One(kind)) => values[*slot] = self.body.number(kind)? as f32,
                (None, kind) | (Some(_), kind @ Kind::List(..)) => self.body.skip(kind)?,
            }
        }
        Ok(values)
    }

    fn position(&mut self, position: Vec3) -> Result<(), Cause> {
        self.document.positions.push(position);
        if position.is_finite() { Ok(()) } else { Err(Cause::NotFinite) }
    }

    fn normal(&mut self, normal: Vec3) {
        let is_sound = normal.is_finite();
        self.warn(WarningKind::NormalNotFinite, usize::from(!is_sound));
        self.document.normals.push(if is_sound { normal } else { Vec3::ZERO });
    }

    fn uv(&mut self, uv: Vec2) {
        let is_sound = uv.is_finite();
        self.warn(WarningKind::UvNotFinite, usize::from(!is_sound));
        self.document.uvs.push(if is_sound { uv } else { Vec2::ZERO });
    }
}
