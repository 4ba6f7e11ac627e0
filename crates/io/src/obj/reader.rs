//! Statements of object files.

use super::lines::Lines;
use super::words::{any_number, name, number, shown, words};
use super::{Cause, Corner, Document, Error, Face, Index, Limits, WarningKind};
use crate::polygon_limits::PolygonBudget;
use std::collections::HashMap;
use traylib_math::{Vec2, Vec3};

/// Statements of curves and surfaces of free form.
const FREE_FORM: [&[u8]; 23] = [
    b"vp", b"cstype", b"deg", b"bmat", b"step", b"curv", b"curv2", b"surf", b"parm", b"trim",
    b"hole", b"scrv", b"sp", b"end", b"con", b"mg", b"ctech", b"stech", b"bsp", b"bzp", b"cdc",
    b"cdp", b"res",
];

pub(super) fn read(bytes: &[u8], limits: Limits) -> Result<Document, Error> {
    let mut reader = Reader::new(limits);
    for (line, text) in Lines::new(bytes) {
        reader.statement(&text).map_err(|cause| Error::Line { line, cause })?;
    }
    Ok(reader.document)
}

struct Reader {
    document: Document,
    budget: PolygonBudget,
    /// The number of each material of the document.
    numbers: HashMap<String, u32>,
    material: Option<u32>,
    smoothing: u32,
}

impl Reader {
    fn new(limits: Limits) -> Self {
        Self {
            document: Document::default(),
            budget: PolygonBudget::new(limits),
            numbers: HashMap::new(),
            material: None,
            smoothing: 0,
        }
    }

    fn statement(&mut self, line: &[u8]) -> Result<(), Cause> {
        let mut words = words(line);
        let Some(keyword) = words.next() else { return Ok(()) };
        match keyword {
            b"v" => self.vertex(words)?,
            b"vt" => self.uv(words)?,
            b"vn" => self.normal(words)?,
            b"f" | b"fo" => self.face(words)?,
            b"s" => self.smoothing(words.next()),
            b"usemtl" => self.material = Some(self.material(name(line))),
            b"mtllib" => self.document.libraries.push(name(line)),
            // Names that no material depends on.
            b"g" | b"o" => {}
            b"p" | b"l" => self.warn(WarningKind::PointOrLine),
            other if FREE_FORM.contains(&other) => self.warn(WarningKind::FreeForm),
            other => self.warn(WarningKind::statement(other)),
        }
        Ok(())
    }

    fn warn(&mut self, kind: WarningKind) {
        self.document.warnings.add(kind);
    }

    /// Reads three coordinates; behind them nothing, a weight, or a colour.
    fn vertex<'a>(&mut self, mut words: impl Iterator<Item = &'a [u8]>) -> Result<(), Cause> {
        let position = three("v", &mut words, number)?;
        let fourth = words.next();
        match (fourth, words.next()) {
            (None, _) => {}
            (Some(weight), None) if any_number(weight) == Ok(1.0) => {}
            (Some(_), None) => self.warn(WarningKind::VertexWeight),
            (Some(_), Some(_)) => self.warn(WarningKind::VertexColour),
        }
        self.document.positions.push(position);
        numbered(self.document.positions.len(), "vertices")
    }

    fn uv<'a>(&mut self, mut words: impl Iterator<Item = &'a [u8]>) -> Result<(), Cause> {
        let missing = Cause::Missing { keyword: "vt", wanted: "one to three coordinates" };
        let u = any_number(words.next().ok_or(missing)?)?;
        let v = words.next().map_or(Ok(0.0), any_number)?;
        let uv = Vec2::new(u, v);
        if !uv.is_finite() {
            self.warn(WarningKind::UvNotFinite);
        }
        self.document.uvs.push(if uv.is_finite() { uv } else { Vec2::ZERO });
        numbered(self.document.uvs.len(), "texture coordinates")
    }

    fn normal<'a>(&mut self, mut words: impl Iterator<Item = &'a [u8]>) -> Result<(), Cause> {
        let normal = three("vn", &mut words, any_number)?;
        if !normal.is_finite() {
            self.warn(WarningKind::NormalNotFinite);
        }
        self.document.normals.push(if normal.is_finite() { normal } else { Vec3::ZERO });
        numbered(self.document.normals.len(), "normals")
    }

    fn smoothing(&mut self, group: Option<&[u8]>) {
        let group = group.unwrap_or(b"off");
        let number = match group {
            b"off" => Some(0),
            // What some writers put for the only group there is.
            b"on" => Some(1),
            _ => std::str::from_utf8(group).ok().and_then(|text| text.parse().ok()),
        };
        if number.is_none() {
            self.warn(WarningKind::SmoothingGroup);
        }
        self.smoothing = number.unwrap_or(0);
    }

    fn material(&mut self, name: String) -> u32 {
        let materials = &mut self.document.materials;
        *self.numbers.entry(name).or_insert_with_key(|name| {
            materials.push(name.clone());
            materials.len() as u32 - 1
        })
    }

    fn face<'a>(&mut self, words: impl Iterator<Item = &'a [u8]>) -> Result<(), Cause> {
        let first = self.document.corners.len();
        for word in words {
            let corner = self.corner(word)?;
            self.document.corners.push(corner);
        }
        numbered(self.document.corners.len(), "corners")?;
        let count = self.document.corners.len() - first;
        if count < 3 {
            self.document.corners.truncate(first);
            self.warn(WarningKind::TooFewCorners);
            return Ok(());
        }
        self.budget.take(count)?;
        let (material, smoothing) = (self.material, self.smoothing);
        let face = Face { first: first as u32, count: count as u32, material, smoothing };
        self.document.faces.push(face);
        Ok(())
    }

    /// `v`, `v/vt`, `v//vn` or `v/vt/vn`.
    fn corner(&self, word: &[u8]) -> Result<Corner, Cause> {
        let mut parts = word.split(|&byte| byte == b'/');
        let Document { positions, uvs, normals, .. } = &self.document;
        let mut part = |what, count| match parts.next() {
            None | Some(b"") => Ok(None),
            Some(digits) => {
                let number = integer(digits).ok_or_else(|| Cause::NotACorner(shown(word)))?;
                index(what, number, count).map(Some)
            }
        };
        let position = part("vertex", positions.len())?;
        let uv = part("texture coordinate", uvs.len())?;
        let normal = part("normal", normals.len())?;
        let position = position.filter(|_| parts.next().is_none());
        let position = position.ok_or_else(|| Cause::NotACorner(shown(word)))?;
        Ok(Corner { position, uv: uv.and_then(Index::new), normal: normal.and_then(Index::new) })
    }
}

/// Reads the three coordinates that a statement begins with.
fn three<'a>(
    keyword: &'static str,
    words: &mut impl Iterator<Item = &'a [u8]>,
    number: fn(&[u8]) -> Result<f32, Cause>,
) -> Result<Vec3, Cause> {
    let missing = || Cause::Missing { keyword, wanted: "three coordinates" };
    let mut coordinate = || number(words.next().ok_or_else(missing)?);
    Ok(Vec3::new(coordinate()?, coordinate()?, coordinate()?))
}

/// Reads a whole number of up to 18 digits; longer ones are numbers of nothing.
fn integer(word: &[u8]) -> Option<i64> {
    let digits = word.strip_prefix(b"-").unwrap_or(word);
    if digits.is_empty() || digits.len() > 18 || !digits.iter().all(u8::is_ascii_digit) {
        return None;
    }
    let value = digits.iter().fold(0, |value, digit| 10 * value + i64::from(digit - b'0'));
    Some(if digits.len() < word.len() { -value } else { value })
}

/// Turns a number that counts from 1, or back from the last one, into one that counts from 0.
fn index(what: &'static str, number: i64, count: usize) -> Result<u32, Cause> {
    let known = i64::try_from(count).unwrap_or(i64::MAX);
    let index = if number < 0 { known + number } else { number - 1 };
    let is_there = (0..known).contains(&index);
    if is_there { Ok(index as u32) } else { Err(Cause::OutOfRange { what, number, count }) }
}

/// Refuses more elements than have numbers of 32 bits.
fn numbered(count: usize, what: &'static str) -> Result<(), Cause> {
    if count < u32::MAX as usize { Ok(()) } else { Err(Cause::TooMany(what)) }
}
