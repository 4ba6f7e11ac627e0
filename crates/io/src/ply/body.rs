//! Numbers after the header.

use super::declaration::Element;
use super::kind::{Kind, Number};
use super::{Cause, Place};
use crate::suggest::shown;

/// The coding of numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Coding {
    Text,
    LittleEndian,
    BigEndian,
}

impl Coding {
    pub(super) fn of(name: &str) -> Option<Self> {
        Some(match name {
            "ascii" => Self::Text,
            "binary_little_endian" => Self::LittleEndian,
            "binary_big_endian" => Self::BigEndian,
            _ => return None,
        })
    }
}

/// Numbers one after the other.
#[derive(Debug)]
pub(super) struct Body<'a> {
    coding: Coding,
    bytes: &'a [u8],
    at: usize,
    /// The line of text, from 1.
    line: u32,
}

impl<'a> Body<'a> {
    pub(super) fn new(coding: Coding, bytes: &'a [u8], at: usize, line: u32) -> Self {
        Self { coding, bytes, at, line: line.saturating_add(1) }
    }

    /// Tells where the next number is.
    pub(super) fn place(&self) -> Place {
        match self.coding {
            Coding::Text => Place::Line(self.line),
            Coding::LittleEndian | Coding::BigEndian => Place::Byte(self.at),
        }
    }

    /// Refuses more items than the bytes that are left can hold.
    pub(super) fn check_count(&self, element: &Element) -> Result<usize, Cause> {
        let least = |kind| match (self.coding, kind) {
            (Coding::Text, _) => 1,
            (_, Kind::One(number) | Kind::List(number, _)) => number.size() as u64,
        };
        let least: u64 = element.properties.iter().map(|property| least(property.kind)).sum();
        let left = self.bytes.len() - self.at;
        let Element { count, .. } = *element;
        let fits = count.checked_mul(least).is_some_and(|bytes| bytes <= left as u64);
        let few = || Cause::TooFewBytes { count, left };
        if fits { usize::try_from(count).map_err(|_| few()) } else { Err(few()) }
    }

    /// Reads the next number.
    #[inline]
    pub(super) fn number(&mut self, kind: Number) -> Result<f64, Cause> {
        if self.coding == Coding::Text {
            return self.word(kind);
        }
        Ok(match kind {
            Number::I8 => f64::from(i8::from_le_bytes(self.take()?)),
            Number::U8 => f64::from(u8::from_le_bytes(self.take()?)),
            Number::I16 => f64::from(i16::from_le_bytes(self.take()?)),
            Number::U16 => f64::from(u16::from_le_bytes(self.take()?)),
            Number::I32 => f64::from(i32::from_le_bytes(self.take()?)),
            Number::U32 => f64::from(u32::from_le_bytes(self.take()?)),
            Number::F32 => f64::from(f32::from_le_bytes(self.take()?)),
            Number::F64 => f64::from_le_bytes(self.take()?),
        })
    }

    /// Takes the next bytes, the least first.
    #[inline]
    fn take<const N: usize>(&mut self) -> Result<[u8; N], Cause> {
        let mut bytes: [u8; N] = *self.bytes[self.at..].first_chunk().ok_or(Cause::Ended)?;
        self.at += N;
        if self.coding == Coding::BigEndian {
            bytes.reverse();
        }
        Ok(bytes)
    }

    fn word(&mut self, kind: Number) -> Result<f64, Cause> {
        let rest = &self.bytes[self.at..];
        let blanks = rest.iter().take_while(|byte| byte.is_ascii_whitespace());
        let (mut skipped, mut lines) = (0, 0);
        for &byte in blanks {
            skipped += 1;
            lines += u32::from(byte == b'\n');
        }
        self.line = self.line.saturating_add(lines);
        let rest = &rest[skipped..];
        let length = rest.iter().position(u8::is_ascii_whitespace).unwrap_or(rest.len());
        self.at += skipped + length;
        if length == 0 {
            return Err(Cause::Ended);
        }
        let word = std::str::from_utf8(&rest[..length]).ok();
        let value = word.and_then(|word| match kind {
            // Rounded once.
            Number::F32 => word.parse::<f32>().ok().map(f64::from),
            Number::I8
            | Number::U8
            | Number::I16
            | Number::U16
            | Number::I32
            | Number::U32
            | Number::F64 => word.parse::<f64>().ok(),
        });
        value.ok_or_else(|| Cause::NotANumber(shown(&String::from_utf8_lossy(&rest[..length]))))
    }

    /// Reads the length of a list, no more than there are bytes.
    pub(super) fn length(&mut self, kind: Number) -> Result<usize, Cause> {
        let value = self.number(kind)?;
        let left = (self.bytes.len() - self.at) as f64;
        let is_length = value >= 0.0 && value <= left && value.fract() == 0.0;
        if is_length { Ok(value as usize) } else { Err(Cause::Length(value.to_string())) }
    }

    /// Passes a property.
    pub(super) fn skip(&mut self, kind: Kind) -> Result<(), Cause> {
        match kind {
            Kind::One(number) => _ = self.number(number)?,
            Kind::List(length, number) => {
                for _ in 0..self.length(length)? {
                    self.number(number)?;
                }
            }
        }
        Ok(())
    }
}
