//! The keyframer: what hangs on what, and moves how.

pub mod hierarchy;
mod track;

pub use track::{Key, Spline, Track, TrackKind, Value};

use super::Warnings;
use super::affine::Affine;
use super::chunk::{Reader, set};
use super::limits::Remaining;
use traylib_math::Vec3;

/// The animation part of a file, as stored.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Keyframer {
    /// Revision of the program that wrote it.
    pub revision: Option<u16>,
    /// Name in its header.
    pub name: String,
    /// Number of frames.
    pub frames: Option<u32>,
    /// First and last frame of the part at work.
    pub segment: Option<[u32; 2]>,
    /// The frame that was shown last.
    pub current_frame: Option<u32>,
    /// The nodes in file order.
    pub nodes: Vec<Node>,
}

/// The kind of object that a node moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum NodeKind {
    /// Ambient light.
    Ambient,
    /// A mesh, or a group without one.
    Object,
    /// A camera.
    Camera,
    /// The point that a camera looks at.
    CameraTarget,
    /// A light to all sides.
    Light,
    /// The point that a spot light points to.
    SpotTarget,
    /// A spot light.
    SpotLight,
}

impl NodeKind {
    fn of(chunk: u16) -> Option<Self> {
        Some(match chunk {
            0xb001 => Self::Ambient,
            0xb002 => Self::Object,
            0xb003 => Self::Camera,
            0xb004 => Self::CameraTarget,
            0xb005 => Self::Light,
            0xb006 => Self::SpotTarget,
            0xb007 => Self::SpotLight,
            _ => return None,
        })
    }
}

/// A node of the animation: what moves an object, a light or a camera.
#[derive(Clone, Debug, PartialEq)]
pub struct Node {
    /// The kind of object that it moves.
    pub kind: NodeKind,
    /// Number by which others call it their parent; its place in the file where
    /// there is none.
    pub id: Option<u16>,
    /// Name of the object it moves.
    pub name: String,
    /// Tells nodes of one object apart; the real name of a group.
    pub instance: String,
    /// Marks as stored.
    pub flags: [u16; 2],
    /// The parent's number as stored.
    pub parent_id: Option<u16>,
    /// Place of the parent among the nodes. Nodes of a decoded file hang on one
    /// another without loops.
    pub parent: Option<usize>,
    /// Point about which an object turns, in its own coordinates.
    pub pivot: Vec3,
    /// Lower and upper corner of the object's box.
    pub bounds: Option<[Vec3; 2]>,
    /// Angle up to which a morphed object is smooth, in radians.
    pub morph_smoothing: Option<f32>,
    /// The tracks by which it moves.
    pub tracks: Vec<Track>,
}

/// Name of nodes that are groups.
const GROUP: &str = "$$$DUMMY";
/// A bit of the first flags, as lib3ds 2.0 has it.
const HIDDEN: u16 = 0x0800;
/// The parent's number where there is none.
const NO_PARENT: u16 = 0xffff;

impl Node {
    fn new(kind: NodeKind) -> Self {
        Self {
            kind,
            id: None,
            name: String::new(),
            instance: String::new(),
            flags: [0; 2],
            parent_id: None,
            parent: None,
            pivot: Vec3::ZERO,
            bounds: None,
            morph_smoothing: None,
            tracks: Vec::new(),
        }
    }

    /// Tells whether it is a group without a mesh.
    pub fn is_group(&self) -> bool {
        self.kind == NodeKind::Object && self.name == GROUP
    }

    /// Tells whether it was hidden.
    pub fn is_hidden(&self) -> bool {
        self.flags[0] & HIDDEN != 0
    }

    /// Its track of a kind.
    pub fn track(&self, kind: TrackKind) -> Option<&Track> {
        self.tracks.iter().find(|track| track.kind == kind)
    }

    /// From the node's to its parent's coordinates at frame 0, where the first
    /// key of each track holds: scale, then turn, then move.
    pub fn local_at_start(&self) -> Affine {
        let vector = |kind, without| match self.first(kind) {
            Some(&Value::Vector(vector)) => vector,
            _ => without,
        };
        let moved = Affine::translation(vector(TrackKind::Position, Vec3::ZERO));
        let scaled = Affine::scaling(vector(TrackKind::Scale, Vec3::ONE));
        let turned = match self.first(TrackKind::Rotation) {
            // Stored angles are clockwise.
            Some(&Value::Turn { angle, axis }) => Affine::rotation(axis, -f64::from(angle)),
            _ => Affine::IDENTITY,
        };
        moved.after(&turned.after(&scaled))
    }

    fn first(&self, kind: TrackKind) -> Option<&Value> {
        self.track(kind)?.keys.first().map(|key| &key.value)
    }
}

impl Keyframer {
    /// Takes in a keyframer section (B000).
    pub(super) fn read(
        &mut self,
        mut reader: Reader<'_>,
        warnings: &mut Warnings,
        remaining: &mut Remaining,
    ) {
        while let Some((id, mut body)) = reader.next_chunk(warnings) {
            match id {
                0xb008 => self.segment = body.u32().zip(body.u32()).map(|(a, b)| [a, b]),
                0xb009 => self.current_frame = body.u32(),
                0xb00a => self.header(body),
                _ => {
                    if let Some(kind) = NodeKind::of(id).filter(|_| remaining.take(warnings)) {
                        self.nodes.push(node(kind, body, warnings));
                    }
                }
            }
        }
    }

    fn header(&mut self, mut body: Reader<'_>) {
        self.revision = body.u16();
        self.name = body.string();
        self.frames = body.u32();
    }
}

fn node(kind: NodeKind, mut reader: Reader<'_>, warnings: &mut Warnings) -> Node {
    let mut node = Node::new(kind);
    while let Some((id, body)) = reader.next_chunk(warnings) {
        node.read(id, body, warnings);
    }
    node
}

impl Node {
    fn read(&mut self, id: u16, mut body: Reader<'_>, warnings: &mut Warnings) {
        match id {
            0xb010 => self.header(body),
            0xb011 => self.instance = body.string(),
            0xb013 => set(&mut self.pivot, body.finite(warnings).map(Vec3::from_array)),
            0xb014 => self.bounds = bounds(body, warnings),
            0xb015 => self.morph_smoothing = body.number(warnings),
            0xb030 => self.id = body.u16(),
            _ => {
                if let Some(kind) = TrackKind::of(id) {
                    self.tracks.push(track::decode(kind, body, warnings));
                }
            }
        }
    }

    fn header(&mut self, mut body: Reader<'_>) {
        self.name = body.string();
        self.flags = [body.u16().unwrap_or(0), body.u16().unwrap_or(0)];
        self.parent_id = body.u16().filter(|&id| id != NO_PARENT);
    }
}

fn bounds(mut body: Reader<'_>, warnings: &mut Warnings) -> Option<[Vec3; 2]> {
    let [a, b, c, d, e, f] = body.finite(warnings)?;
    Some([Vec3::new(a, b, c), Vec3::new(d, e, f)])
}
