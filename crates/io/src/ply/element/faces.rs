//! Polygons, and strips of triangles.

use super::{Reader, is_colour};
use crate::ply::declaration::Property;
use crate::ply::kind::{Kind, Number};
use crate::ply::{Cause, WarningKind};
use crate::suggest::shown;
use traylib_math::Vec2;

/// The role of a property of a face.
#[derive(Clone, Copy)]
enum Role {
    /// Its corners: a length, and numbers of vertices.
    Corners(Number, Number),
    /// Two texture coordinates for each corner.
    Uvs(Number, Number),
    /// The number of its picture.
    Picture(Number),
    Skipped(Kind),
}

impl Role {
    fn of(property: &Property) -> Self {
        match (property.name.as_str(), property.kind) {
            ("vertex_indices" | "vertex_index", Kind::List(length, index)) => {
                Self::Corners(length, index)
            }
            ("texcoord", Kind::List(length, number)) => Self::Uvs(length, number),
            ("texnumber", Kind::One(number)) => Self::Picture(number),
            (_, kind) => Self::Skipped(kind),
        }
    }
}

impl Reader<'_> {
    pub(super) fn faces(&mut self, properties: &[Property], count: usize) -> Result<(), Cause> {
        let roles: Vec<Role> = properties.iter().map(Role::of).collect();
        self.warn_of_skipped(properties, &roles, count);
        let has_uvs = roles.iter().any(|role| matches!(role, Role::Uvs(..)));
        let mut uvs = Vec::new();
        self.each(count, |reader| {
            let first = reader.document.corners.len();
            uvs.clear();
            for role in &roles {
                reader.property(*role, first, &mut uvs)?;
            }
            if reader.keep(first)? && has_uvs {
                reader.corner_uvs(first, &uvs);
            }
            Ok(())
        })
    }

    fn warn_of_skipped(&mut self, properties: &[Property], roles: &[Role], count: usize) {
        let mut is_coloured = false;
        for (property, role) in properties.iter().zip(roles) {
            match role {
                Role::Corners(..) | Role::Uvs(..) | Role::Picture(_) => {}
                Role::Skipped(_) if is_colour(property) => is_coloured = true,
                Role::Skipped(_) => self.warn(WarningKind::FaceProperty(shown(&property.name)), 1),
            }
        }
        self.warn(WarningKind::FaceColour, if is_coloured { count } else { 0 });
    }

    /// Reads a property of the face whose corners begin at `first`. The last list of a kind
    /// counts.
    fn property(&mut self, role: Role, first: usize, uvs: &mut Vec<f32>) -> Result<(), Cause> {
        match role {
            Role::Corners(length, index) => {
                self.document.corners.truncate(first);
                for _ in 0..self.body.length(length)? {
                    let corner = self.body.number(index)?;
                    self.document.corners.push(vertex(corner)?);
                }
            }
            Role::Uvs(length, number) => {
                uvs.clear();
                for _ in 0..self.body.length(length)? {
                    uvs.push(self.body.number(number)? as f32);
                }
            }
            Role::Picture(number) => {
                let is_other = self.body.number(number)? > 0.0;
                self.warn(WarningKind::OtherPicture, usize::from(is_other));
            }
            Role::Skipped(kind) => self.body.skip(kind)?,
        }
        Ok(())
    }

    /// Keeps the corners from `first` on as a polygon, or none of them; tells whether it did.
    fn keep(&mut self, first: usize) -> Result<bool, Cause> {
        let count = self.document.corners.len() - first;
        if count < 3 {
            self.document.corners.truncate(first);
            self.warn(WarningKind::TooFewCorners, 1);
            return Ok(false);
        }
        self.budget.take(count)?;
        if u32::try_from(self.document.corners.len()).is_err() {
            return Err(Cause::TooMany("corners"));
        }
        self.document.counts.push(count as u32);
        Ok(true)
    }

    /// Keeps texture coordinates of the corners from `first` on; zero for each if they are not
    /// two for every corner.
    fn corner_uvs(&mut self, first: usize, uvs: &[f32]) {
        let count = self.document.corners.len() - first;
        let (pairs, _) = uvs.as_chunks();
        if uvs.len() != 2 * count {
            self.warn(WarningKind::UvCount, 1);
            self.document.corner_uvs.extend(std::iter::repeat_n(Vec2::ZERO, count));
            return;
        }
        for &pair in pairs {
            let uv = Vec2::from_array(pair);
            self.warn(WarningKind::UvNotFinite, usize::from(!uv.is_finite()));
            self.document.corner_uvs.push(if uv.is_finite() { uv } else { Vec2::ZERO });
        }
    }

    /// Reads strips: each corner makes a triangle with the two before it, turned every other
    /// time; −1 begins a new one.
    pub(super) fn strips(&mut self, properties: &[Property], count: usize) -> Result<(), Cause> {
        let roles: Vec<Role> = properties.iter().map(Role::of).collect();
        self.each(count, |reader| {
            for role in &roles {
                match *role {
                    Role::Corners(length, index) => reader.strip(length, index)?,
                    Role::Uvs(length, number) => reader.body.skip(Kind::List(length, number))?,
                    Role::Picture(number) => reader.body.skip(Kind::One(number))?,
                    Role::Skipped(kind) => reader.body.skip(kind)?,
                }
            }
            Ok(())
        })
    }

    fn strip(&mut self, length: Number, index: Number) -> Result<(), Cause> {
        let mut strip = Vec::new();
        for _ in 0..self.body.length(length)? {
            let corner = self.body.number(index)?;
            if corner == -1.0 {
                strip.clear();
                continue;
            }
            strip.push(vertex(corner)?);
            let [.., a, b, c] = strip[..] else { continue };
            let first = self.document.corners.len();
            let is_turned = strip.len().is_multiple_of(2);
            self.document.corners.extend(if is_turned { [b, a, c] } else { [a, b, c] });
            self.keep(first)?;
        }
        Ok(())
    }
}

/// The number of a vertex.
fn vertex(value: f64) -> Result<u32, Cause> {
    let is_index = value >= 0.0 && value < f64::from(u32::MAX) && value.fract() == 0.0;
    if is_index { Ok(value as u32) } else { Err(Cause::Index(value.to_string())) }
}
