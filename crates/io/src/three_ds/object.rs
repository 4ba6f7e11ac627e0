//! The properties that all named objects have in common.

/// Marks of an object.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[allow(clippy::struct_excessive_bools, reason = "each is a chunk that is there or is not")]
pub struct ObjectFlags {
    /// Hidden in the editor, and in its pictures.
    pub hidden: bool,
    /// True if it was not made by lofting.
    pub not_lofted: bool,
    /// Casts no shadow.
    pub casts_no_shadow: bool,
    /// Shows the background where it is.
    pub matte: bool,
    /// True if it is not to be edited.
    pub frozen: bool,
}

impl ObjectFlags {
    /// Takes a chunk of an object in, if it is a mark.
    pub(super) fn read(&mut self, chunk: u16) {
        match chunk {
            0x4010 => self.hidden = true,
            0x4012 => self.not_lofted = true,
            0x4013 => self.casts_no_shadow = true,
            0x4014 => self.matte = true,
            0x4017 => self.frozen = true,
            _ => {}
        }
    }
}
