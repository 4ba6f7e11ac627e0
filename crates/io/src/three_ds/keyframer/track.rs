//! Tracks: the keys of one property that changes over time.

use super::super::chunk::Reader;
use super::super::{WarningKind, Warnings};
use traylib_math::Vec3;

/// The property that a track changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum TrackKind {
    /// The position, in its parent's coordinates.
    Position,
    /// The orientation.
    Rotation,
    /// The factors by which it is stretched.
    Scale,
    /// Field of view of a camera, in degrees.
    FieldOfView,
    /// Roll of a camera or spot light, in degrees.
    Roll,
    /// Colour of a light.
    Colour,
    /// The mesh whose form it takes.
    Morph,
    /// Hotspot of a spot light, in degrees.
    Hotspot,
    /// Falloff of a spot light, in degrees.
    Falloff,
    /// Changes between shown and hidden, one a key.
    Hide,
}

/// In the order of their chunks, from B020.
const KINDS: [TrackKind; 10] = [
    TrackKind::Position,
    TrackKind::Rotation,
    TrackKind::Scale,
    TrackKind::FieldOfView,
    TrackKind::Roll,
    TrackKind::Colour,
    TrackKind::Morph,
    TrackKind::Hotspot,
    TrackKind::Falloff,
    TrackKind::Hide,
];
const FIRST: u16 = 0xb020;

impl TrackKind {
    /// Number of its chunk.
    pub fn id(self) -> u16 {
        FIRST + self as u16
    }

    pub(super) fn of(chunk: u16) -> Option<Self> {
        KINDS.get(usize::from(chunk.checked_sub(FIRST)?)).copied()
    }

    fn value(self, reader: &mut Reader<'_>) -> Option<Value> {
        match self {
            Self::Position | Self::Scale | Self::Colour => reader.vec3().map(Value::Vector),
            Self::Rotation => Some(Value::Turn { angle: reader.f32()?, axis: reader.vec3()? }),
            Self::FieldOfView | Self::Roll | Self::Hotspot | Self::Falloff => {
                reader.f32().map(Value::Number)
            }
            Self::Morph => Some(Value::Name(reader.string())),
            Self::Hide => Some(Value::Change),
        }
    }
}

/// The keys of one property of a node, in the order of time.
#[derive(Clone, Debug, PartialEq)]
pub struct Track {
    /// The property that changes.
    pub kind: TrackKind,
    /// Marks as stored: how it repeats, and which axes are locked.
    pub flags: u16,
    /// Its keys in file order.
    pub keys: Vec<Key>,
}

/// A value at a frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Key {
    /// The frame.
    pub frame: u32,
    /// The spline by which values before and after are led here.
    pub spline: Spline,
    /// The value, of the kind that belongs to the track.
    pub value: Value,
}

/// The shape of the curve through a key; 0 where the file does not say.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Spline {
    /// Tension.
    pub tension: f32,
    /// Continuity.
    pub continuity: f32,
    /// Bias.
    pub bias: f32,
    /// Slowing down towards the key.
    pub ease_to: f32,
    /// Starting slowly from it.
    pub ease_from: f32,
}

/// The value of a key.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A place, a scale, or a colour in 0..1.
    Vector(Vec3),
    /// A turn from the key before, **clockwise** seen against the axis.
    Turn {
        /// In radians.
        angle: f32,
        /// Need not have length one; without direction there is no turn.
        axis: Vec3,
    },
    /// An angle in degrees.
    Number(f32),
    /// The name of a mesh.
    Name(String),
    /// The key has no value: that it is there is all.
    Change,
}

impl Value {
    fn is_finite(&self) -> bool {
        match self {
            Self::Vector(vector) => vector.is_finite(),
            Self::Turn { angle, axis } => angle.is_finite() && axis.is_finite(),
            Self::Number(number) => number.is_finite(),
            Self::Name(_) | Self::Change => true,
        }
    }
}

/// Bytes of a track's header that nothing is known of.
const UNUSED: usize = 8;

/// Reads a track. Keys that are not there, or not numbers, are left out.
pub(super) fn decode(kind: TrackKind, mut reader: Reader<'_>, warnings: &mut Warnings) -> Track {
    let mut track = Track { kind, flags: reader.u16().unwrap_or(0), keys: Vec::new() };
    let count = reader.skip(UNUSED).and_then(|()| reader.u32());
    for _ in 0..count.unwrap_or(0) {
        let Some(key) = key(kind, &mut reader) else {
            warnings.add(WarningKind::ListCut);
            break;
        };
        if key.value.is_finite() {
            track.keys.push(key);
        } else {
            warnings.add(WarningKind::NumberNotFinite);
        }
    }
    track
}

fn key(kind: TrackKind, reader: &mut Reader<'_>) -> Option<Key> {
    let (frame, stored) = (reader.u32()?, reader.u16()?);
    let mut parameters = [0.0; 5];
    for (bit, parameter) in parameters.iter_mut().enumerate() {
        if stored >> bit & 1 == 1 {
            *parameter = reader.f32()?;
        }
    }
    let [tension, continuity, bias, ease_to, ease_from] = parameters;
    let spline = Spline { tension, continuity, bias, ease_to, ease_from };
    Some(Key { frame, spline, value: kind.value(reader)? })
}

#[cfg(test)]
mod tests {
    use super::super::super::tests::writer::{floats, track};
    use super::*;

    fn decoded(kind: TrackKind, body: &[u8]) -> (Track, Warnings) {
        let mut warnings = Warnings::default();
        (decode(kind, Reader::new(body), &mut warnings), warnings)
    }

    /// A key at a frame with these spline parameters.
    fn key(frame: u32, spline: &[(u8, f32)], value: &[u8]) -> Vec<u8> {
        let bits: u16 = spline.iter().map(|(bit, _)| 1 << bit).sum();
        let parameters: Vec<f32> = spline.iter().map(|&(_, parameter)| parameter).collect();
        [&frame.to_le_bytes()[..], &bits.to_le_bytes(), &floats(&parameters), value].concat()
    }

    #[test]
    fn every_kind_has_its_chunk() {
        for (kind, id) in KINDS.into_iter().zip(0xb020..) {
            assert_eq!((kind.id(), TrackKind::of(id)), (id, Some(kind)));
        }
        assert_eq!((TrackKind::of(0xb01f), TrackKind::of(0xb02a)), (None, None));
    }

    #[test]
    fn every_kind_has_its_value() {
        let three = floats(&[1.0, 2.0, 3.0]);
        let vector = Value::Vector(Vec3::new(1.0, 2.0, 3.0));
        let turn = Value::Turn { angle: 0.5, axis: Vec3::new(1.0, 2.0, 3.0) };
        let four = [floats(&[0.5]), three.clone()].concat();
        let cases = [
            (TrackKind::Position, three, vector),
            (TrackKind::Rotation, four, turn),
            (TrackKind::Roll, floats(&[7.0]), Value::Number(7.0)),
            (TrackKind::Morph, b"fist\0".to_vec(), Value::Name("fist".to_string())),
            (TrackKind::Hide, Vec::new(), Value::Change),
        ];
        for (kind, bytes, expected) in cases {
            let keys = [key(3, &[], &bytes), key(9, &[], &bytes)];
            let (found, warnings) = decoded(kind, &track(2, &keys));
            let values: Vec<_> = found.keys.iter().map(|key| (key.frame, &key.value)).collect();
            assert_eq!(values, [(3, &expected), (9, &expected)]);
            assert_eq!(warnings, Warnings::default());
        }
    }

    #[test]
    fn only_the_parameters_that_are_stored_are_read() {
        let keys = [key(0, &[(1, 0.25), (4, 0.75)], &floats(&[30.0]))];
        let (found, _) = decoded(TrackKind::FieldOfView, &track(1, &keys));
        let spline = Spline { continuity: 0.25, ease_from: 0.75, ..Spline::default() };
        assert_eq!(found.keys, [Key { frame: 0, spline, value: Value::Number(30.0) }]);
    }

    #[test]
    fn keys_that_are_not_there_or_not_numbers_are_left_out() {
        let keys = [key(0, &[], &floats(&[f32::NAN])), key(1, &[], &floats(&[2.0]))];
        let (found, warnings) = decoded(TrackKind::Roll, &track(u32::MAX, &keys));
        assert_eq!(found.keys.len(), 1);
        assert_eq!(warnings.count(&WarningKind::ListCut), 1);
        assert_eq!(warnings.count(&WarningKind::NumberNotFinite), 1);
        assert_eq!(decoded(TrackKind::Roll, &[1, 0, 9]).0.keys, []);
    }
}
