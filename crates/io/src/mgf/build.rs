//! From an entity to a shape in the world.

use super::budget::limit;
use super::keyword::Keyword;
use super::names::Names;
use super::shape::newell;
use super::transform::Transform;
use super::words::{exactly, number, within};
use super::{Cause, Shape, Vertex};
use crate::Limit;
use traylib_math::glam::DVec3;

/// The data that a shape is made with.
pub(super) struct Builder<'a> {
    pub(super) vertices: &'a Names<Vertex>,
    pub(super) transform: Transform,
    /// The most vertices of one polygon.
    pub(super) max_corners: usize,
}

impl Builder<'_> {
    /// The shape; `None` if it has no area.
    #[expect(clippy::wildcard_enum_match_arm, reason = "the reader asks for none but shapes")]
    pub(super) fn build(&self, keyword: Keyword, words: &[&str]) -> Result<Option<Shape>, Cause> {
        match keyword {
            Keyword::Face => self.face(words),
            Keyword::FaceWithHoles => self.face_with_holes(words),
            Keyword::Sphere => self.sphere(words),
            Keyword::Cylinder => self.cylinder(words),
            Keyword::Cone => self.cone(words),
            Keyword::Ring => self.ring(words),
            Keyword::Torus => self.torus(words),
            Keyword::Prism => self.prism(words),
            _ => Ok(None),
        }
    }

    fn vertex(&self, name: &str) -> Result<Vertex, Cause> {
        let vertex = self.vertices.get(name)?;
        Ok(Vertex {
            position: self.transform.point(vertex.position),
            normal: vertex.normal.map(|normal| self.transform.direction(normal)),
        })
    }

    fn point(&self, name: &str) -> Result<DVec3, Cause> {
        self.vertex(name).map(|vertex| vertex.position)
    }

    /// A point with its normal.
    fn axis(&self, name: &str) -> Result<(DVec3, DVec3), Cause> {
        let Vertex { position, normal } = self.vertex(name)?;
        let missing = Cause::Illegal("the vertex needs a normal, which gives the axis");
        Ok((position, normal.ok_or(missing)?))
    }

    fn length(&self, word: &str) -> Result<f64, Cause> {
        Ok(number(word)? * self.transform.scale)
    }

    /// A closed line, fronts staying fronts under mirrors.
    fn outline(&self, words: &[&str]) -> Result<Vec<Vertex>, Cause> {
        if words.len() < 3 {
            return Err(Cause::Arguments { expected: "3 vertices or more", found: words.len() });
        }
        limit(
            "vertices in a polygon",
            words.len() as u64,
            self.max_corners as u64,
            Limit::Corners,
        )?;
        let mut outline: Vec<Vertex> =
            words.iter().map(|name| self.vertex(name)).collect::<Result<_, _>>()?;
        if self.transform.mirrored {
            outline.reverse();
        }
        Ok(outline)
    }

    fn face(&self, words: &[&str]) -> Result<Option<Shape>, Cause> {
        let outline = self.outline(words)?;
        let has_area = newell(&outline) != DVec3::ZERO;
        Ok(has_area.then_some(Shape::Face { outline, holes: Vec::new() }))
    }

    fn face_with_holes(&self, words: &[&str]) -> Result<Option<Shape>, Cause> {
        // Seams count twice, so this bounds the polygon that is cut up.
        let corners = words.len() as u64 + words.iter().filter(|&&word| word == "-").count() as u64;
        limit("vertices in a polygon", corners, self.max_corners as u64, Limit::Corners)?;
        let mut loops = words.split(|&word| word == "-");
        let outline = self.outline(loops.next().unwrap_or_default())?;
        let holes = loops.map(|hole| self.outline(hole)).collect::<Result<_, _>>()?;
        let has_area = newell(&outline) != DVec3::ZERO;
        Ok(has_area.then_some(Shape::Face { outline, holes }))
    }

    fn sphere(&self, words: &[&str]) -> Result<Option<Shape>, Cause> {
        let [centre, radius] = exactly(words, "a vertex and a radius")?;
        let (centre, (radius, inward)) = (self.point(centre)?, self.signed(radius, "the radius")?);
        Ok(Some(Shape::Sphere { centre, radius, inward }))
    }

    /// A length other than 0 whose sign tells the side.
    fn signed(&self, word: &str, what: &'static str) -> Result<(f64, bool), Cause> {
        let length = self.length(word)?;
        within(length != 0.0, length, what, "other than 0")?;
        Ok((length.abs(), length < 0.0))
    }

    fn cylinder(&self, words: &[&str]) -> Result<Option<Shape>, Cause> {
        let [a, radius, b] = exactly(words, "a vertex, a radius and a vertex")?;
        let ends = [self.point(a)?, self.point(b)?];
        let (radius, inward) = self.signed(radius, "the radius")?;
        Ok((ends[0] != ends[1]).then_some(Shape::Cylinder { ends, radius, inward }))
    }

    fn cone(&self, words: &[&str]) -> Result<Option<Shape>, Cause> {
        let [a, r, b, s] = exactly(words, "a vertex and a radius, twice")?;
        let ends = [self.point(a)?, self.point(b)?];
        let radii = [self.length(r)?, self.length(s)?];
        if radii == [0.0; 2] || radii[0] * radii[1] < 0.0 {
            return Err(Cause::Illegal("the radii must have one sign, and only one may be 0"));
        }
        let (inward, radii) = (radii[0] + radii[1] < 0.0, radii.map(f64::abs));
        Ok((ends[0] != ends[1]).then_some(Shape::Cone { ends, radii, inward }))
    }

    fn ring(&self, words: &[&str]) -> Result<Option<Shape>, Cause> {
        let [centre, inner, outer] = exactly(words, "a vertex and two radii")?;
        let (centre, normal) = self.axis(centre)?;
        let radii = [self.length(inner)?, self.length(outer)?];
        if radii[0] < 0.0 || radii[0] >= radii[1] {
            return Err(Cause::Illegal("the radii must be 0 <= r0 < r1"));
        }
        Ok(Some(Shape::Ring { centre, normal, radii }))
    }

    fn torus(&self, words: &[&str]) -> Result<Option<Shape>, Cause> {
        let [centre, inner, outer] = exactly(words, "a vertex and two radii")?;
        let (centre, normal) = self.axis(centre)?;
        let [inner, outer] = [self.length(inner)?, self.length(outer)?];
        let inward = outer < 0.0;
        if inner * outer < 0.0 || inner.abs() >= outer.abs() {
            return Err(Cause::Illegal("the radii must be 0 <= r0 < r1 or r1 < r0 <= 0"));
        }
        let [inner, outer] = [inner.abs(), outer.abs()];
        let (radius, tube_radius) = (f64::midpoint(inner, outer), (outer - inner) / 2.0);
        Ok(Some(Shape::Torus { centre, normal, radius, tube_radius, inward }))
    }

    fn prism(&self, words: &[&str]) -> Result<Option<Shape>, Cause> {
        let Some((length, words)) = words.split_last() else {
            return Err(Cause::Arguments { expected: "3 vertices or more and a length", found: 0 });
        };
        let outline = self.outline(words)?;
        let (length, inward) = self.signed(length, "the length")?;
        let Some(normal) = newell(&outline).try_normalize() else { return Ok(None) };
        let offset = if inward { normal * length } else { -normal * length };
        Ok(Some(Shape::Prism { outline, offset, inward }))
    }
}
