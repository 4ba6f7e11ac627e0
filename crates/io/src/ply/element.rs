//! Vertices and faces.

use super::body::Body;
use super::declaration::{Element, Property};
use super::header::Header;
use super::kind::Kind;
use super::{Cause, Document, Error, Limits, WarningKind};
use traylib_math::{Vec2, Vec3};

/// Polygons of no more corners are cut in no time.
const SMALL: usize = 16;

pub(super) fn read(header: Header, body: Body<'_>, limits: Limits) -> Result<Document, Error> {
    let Header { elements, textures, warnings } = header;
    let document = Document { textures, warnings, ..Document::default() };
    let mut reader = Reader { document, body, limits, cutting: limits.cutting };
    for element in &elements {
        let mut number = 0;
        reader.element(element, &mut number).map_err(|cause| {
            let (place, name) = (reader.body.place(), element.name.clone());
            Error::Data { place, element: name, number, cause }
        })?;
    }
    check_vertices(&reader.document)?;
    Ok(reader.document)
}

fn check_vertices(document: &Document) -> Result<(), Error> {
    let count = document.positions.len();
    for (face, (_, corners)) in document.faces().enumerate() {
        if let Some(&vertex) = corners.iter().find(|&&corner| corner as usize >= count) {
            return Err(Error::NoVertex { face, vertex, count });
        }
    }
    Ok(())
}

/// What a property of a vertex is, by its place among the values that are kept.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Slot {
    Kept(usize),
    Skipped,
}

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

struct Reader<'a> {
    document: Document,
    body: Body<'a>,
    limits: Limits,
    /// Squares of corners that are left.
    cutting: u64,
}

impl Reader<'_> {
    /// Reads all of an element; `number` is that of the item that is read.
    fn element(&mut self, element: &Element, number: &mut usize) -> Result<(), Cause> {
        let count = self.body.check_count(element)?;
        if element.properties.is_empty() && element.name != "vertex" {
            // They take no bytes, so that nothing bounds how many there are.
            let kind = WarningKind::Element(shown(&element.name));
            self.document.warnings.add_many(kind, count);
            return Ok(());
        }
        match element.name.as_str() {
            "vertex" => self.vertices(element, count, number),
            "face" => self.faces(element, count, number),
            "tristrips" => self.strips(element, count, number),
            name => {
                self.document.warnings.add_many(WarningKind::Element(shown(name)), count);
                for item in 0..count {
                    *number = item;
                    self.skip_all(&element.properties)?;
                }
                Ok(())
            }
        }
    }

    fn skip_all(&mut self, properties: &[Property]) -> Result<(), Cause> {
        properties.iter().try_for_each(|property| self.body.skip(property.kind))
    }

    fn vertices(
        &mut self,
        element: &Element,
        count: usize,
        number: &mut usize,
    ) -> Result<(), Cause> {
        if u32::try_from(self.document.positions.len() + count).is_err() {
            return Err(Cause::TooMany("vertices"));
        }
        let slots = self.slots(&element.properties, count);
        let has = |slot| slots.contains(&Slot::Kept(slot));
        for (slot, name) in [(0, "x"), (1, "y"), (2, "z")] {
            if !has(slot) {
                return Err(Cause::NoCoordinate(name));
            }
        }
        let (has_normals, has_uvs) = ((3..6).all(has), (6..8).all(has));
        self.document.positions.reserve(count);
        for item in 0..count {
            *number = item;
            let mut values = [0.0; KEPT.len()];
            for (property, slot) in element.properties.iter().zip(&slots) {
                match (slot, property.kind) {
                    (Slot::Kept(slot), Kind::One(kind)) => {
                        values[*slot] = self.body.number(kind)? as f32;
                    }
                    (_, kind) => self.body.skip(kind)?,
                }
            }
            self.vertex(values, has_normals, has_uvs)?;
        }
        Ok(())
    }

    /// What the properties of vertices are; those that are skipped are told of.
    fn slots(&mut self, properties: &[Property], count: usize) -> Vec<Slot> {
        let mut is_coloured = false;
        let mut slots = Vec::new();
        for Property { name, kind } in properties {
            let found = KEPT.iter().position(|names| names.contains(&name.as_str()));
            let slot = match (found, kind) {
                (Some(slot), Kind::One(_)) if !slots.contains(&Slot::Kept(slot)) => {
                    Slot::Kept(slot)
                }
                _ if is_colour(name) => {
                    is_coloured = true;
                    Slot::Skipped
                }
                _ => {
                    self.document.warnings.add(WarningKind::VertexProperty(shown(name)));
                    Slot::Skipped
                }
            };
            slots.push(slot);
        }
        let coloured = if is_coloured { count } else { 0 };
        self.document.warnings.add_many(WarningKind::VertexColour, coloured);
        slots
    }

    fn vertex(
        &mut self,
        [x, y, z, nx, ny, nz, u, v]: [f32; 8],
        has_normals: bool,
        has_uvs: bool,
    ) -> Result<(), Cause> {
        let (position, normal, uv) = (Vec3::new(x, y, z), Vec3::new(nx, ny, nz), Vec2::new(u, v));
        if !position.is_finite() {
            return Err(Cause::NotFinite);
        }
        let document = &mut self.document;
        document.positions.push(position);
        if has_normals {
            if !normal.is_finite() {
                document.warnings.add(WarningKind::NormalNotFinite);
            }
            document.normals.push(if normal.is_finite() { normal } else { Vec3::ZERO });
        }
        if has_uvs {
            if !uv.is_finite() {
                document.warnings.add(WarningKind::UvNotFinite);
            }
            document.uvs.push(if uv.is_finite() { uv } else { Vec2::ZERO });
        }
        Ok(())
    }

    fn faces(&mut self, element: &Element, count: usize, number: &mut usize) -> Result<(), Cause> {
        let mut is_coloured = false;
        let has_uvs = element.properties.iter().any(is_texcoord);
        for property in &element.properties {
            let name = property.name.as_str();
            match name {
                _ if is_corners(property) || is_texcoord(property) || name == "texnumber" => {}
                _ if is_colour(name) => is_coloured = true,
                _ => self.document.warnings.add(WarningKind::FaceProperty(shown(name))),
            }
        }
        let coloured = if is_coloured { count } else { 0 };
        self.document.warnings.add_many(WarningKind::FaceColour, coloured);
        for item in 0..count {
            *number = item;
            self.face(&element.properties, has_uvs)?;
        }
        Ok(())
    }

    fn face(&mut self, properties: &[Property], has_uvs: bool) -> Result<(), Cause> {
        let first = self.document.corners.len();
        let mut uvs = Vec::new();
        for property in properties {
            match property.kind {
                Kind::List(length, kind) if is_corners(property) => {
                    self.document.corners.truncate(first);
                    let length = self.body.length(length)?;
                    for _ in 0..length {
                        let corner = self.body.number(kind)?;
                        self.document.corners.push(index(corner)?);
                    }
                }
                Kind::List(length, kind) if is_texcoord(property) => {
                    uvs.clear();
                    for _ in 0..self.body.length(length)? {
                        uvs.push(self.body.number(kind)? as f32);
                    }
                }
                Kind::One(kind) if property.name == "texnumber" => {
                    if self.body.number(kind)? > 0.0 {
                        self.document.warnings.add(WarningKind::OtherPicture);
                    }
                }
                kind @ (Kind::One(_) | Kind::List(..)) => self.body.skip(kind)?,
            }
        }
        self.keep(first, has_uvs.then_some(&uvs))
    }

    /// Keeps the corners from `first` on as a polygon, or none of them.
    fn keep(&mut self, first: usize, uvs: Option<&Vec<f32>>) -> Result<(), Cause> {
        let document = &mut self.document;
        let count = document.corners.len() - first;
        if count < 3 {
            document.corners.truncate(first);
            document.warnings.add(WarningKind::TooFewCorners);
            return Ok(());
        }
        if count > self.limits.corners {
            return Err(Cause::TooManyCorners(self.limits.corners));
        }
        if count > SMALL {
            let left = self.cutting.checked_sub((count * count) as u64);
            self.cutting = left.ok_or(Cause::TooMuchCutting(self.limits.cutting))?;
        }
        if u32::try_from(document.corners.len()).is_err() {
            return Err(Cause::TooMany("corners"));
        }
        if let Some(uvs) = uvs {
            let fits = uvs.len() == 2 * count;
            if !fits {
                document.warnings.add(WarningKind::UvCount);
            }
            for corner in 0..count {
                let at = |axis: usize| uvs.get(2 * corner + axis).copied().unwrap_or(0.0);
                let uv = Vec2::new(at(0), at(1));
                let is_sound = fits && uv.is_finite();
                if fits && !is_sound {
                    document.warnings.add(WarningKind::UvNotFinite);
                }
                document.corner_uvs.push(if is_sound { uv } else { Vec2::ZERO });
            }
        }
        document.counts.push(count as u32);
        Ok(())
    }

    /// Strips: each corner makes a triangle with the two before it, turned every other time;
    /// −1 begins a new one.
    fn strips(&mut self, element: &Element, count: usize, number: &mut usize) -> Result<(), Cause> {
        for item in 0..count {
            *number = item;
            for property in &element.properties {
                match property.kind {
                    Kind::List(length, kind) if is_corners(property) => {
                        let mut strip = Vec::new();
                        for _ in 0..self.body.length(length)? {
                            let corner = self.body.number(kind)?;
                            if corner == -1.0 {
                                strip.clear();
                                continue;
                            }
                            strip.push(index(corner)?);
                            self.of_strip(&strip)?;
                        }
                    }
                    kind @ (Kind::One(_) | Kind::List(..)) => self.body.skip(kind)?,
                }
            }
        }
        Ok(())
    }

    fn of_strip(&mut self, strip: &[u32]) -> Result<(), Cause> {
        let [.., a, b, c] = *strip else { return Ok(()) };
        let first = self.document.corners.len();
        let is_turned = strip.len().is_multiple_of(2);
        self.document.corners.extend(if is_turned { [b, a, c] } else { [a, b, c] });
        self.keep(first, None)
    }
}

fn index(value: f64) -> Result<u32, Cause> {
    let is_index = value >= 0.0 && value < f64::from(u32::MAX) && value.fract() == 0.0;
    if is_index { Ok(value as u32) } else { Err(Cause::Index(value.to_string())) }
}

fn is_corners(property: &Property) -> bool {
    let is_list = matches!(property.kind, Kind::List(..));
    is_list && matches!(property.name.as_str(), "vertex_indices" | "vertex_index")
}

fn is_texcoord(property: &Property) -> bool {
    matches!(property.kind, Kind::List(..)) && property.name == "texcoord"
}

fn is_colour(name: &str) -> bool {
    let band = ["diffuse_", "ambient_", "specular_"]
        .into_iter()
        .find_map(|prefix| name.strip_prefix(prefix))
        .unwrap_or(name);
    matches!(band, "red" | "green" | "blue" | "alpha" | "r" | "g" | "b" | "a")
}

fn shown(name: &str) -> String {
    crate::suggest::shown(name)
}
