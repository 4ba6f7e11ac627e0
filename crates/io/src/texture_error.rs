//! The reasons why a file is no picture.

use std::io;

/// The reason why a decoder gives up.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Fault {
    /// The data end too early.
    #[error("is cut off")]
    CutOff,
    /// Sound, but not supported.
    #[error("is of a kind that is not read")]
    Unsupported,
    /// The data contradict the format or themselves.
    #[error("is damaged")]
    Damaged,
}

impl Fault {
    /// Cut off, if that is what an error ends in; else damage.
    pub(crate) fn of(error: &(dyn std::error::Error + 'static)) -> Self {
        let causes = std::iter::successors(Some(error), |error| error.source());
        let is_end = |error: &(dyn std::error::Error + 'static)| {
            let io = error.downcast_ref::<io::Error>();
            io.is_some_and(|io| io.kind() == io::ErrorKind::UnexpectedEof)
        };
        if causes.into_iter().any(is_end) { Self::CutOff } else { Self::Damaged }
    }
}

/// The reason why bytes are not a picture, as the cause in
/// [`Error::ReadPicture`](crate::Error::ReadPicture).
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum TextureError {
    /// The file cannot be read.
    #[error("{}", crate::source::why(.0))]
    File(#[from] io::Error),
    /// The file is larger than [`TextureLimits`](crate::TextureLimits) allows.
    #[error("it has more than {0} bytes")]
    TooLong(u64),
    /// Neither the content nor the name is of a known format.
    #[error(
        "it begins as none of PNG, JPEG, GIF, BMP, PCX, Radiance and EXR does; \
         a TGA file whose header makes no sense must be named .tga"
    )]
    UnknownFormat,
    /// It says it has no pixels.
    #[error("it has no pixels")]
    Empty,
    /// More pixels than [`TextureLimits`](crate::TextureLimits) allows.
    #[error("{width}x{height} pixels are more than the {most} allowed")]
    TooLarge {
        /// Columns.
        width: u32,
        /// Rows.
        height: u32,
        /// [`TextureLimits::pixels`](crate::TextureLimits::pixels).
        most: u64,
    },
    /// All channels and layers of an EXR file together have more values than this.
    #[error("its channels and layers have more than {0} values")]
    TooManyLayers(u64),
    /// So many bytes of memory are not to be had.
    #[error("its pixels need {:.2} GB of memory, which are not free", *.0 as f64 / 1e9)]
    Memory(u64),
    /// A decoder gave up.
    #[error("the {format} picture {fault}")]
    Decoder {
        /// The format.
        format: &'static str,
        /// The fault that the decoder met.
        fault: Fault,
        /// In the decoder's own words, which speak of its inside.
        source: Box<dyn std::error::Error + Send + Sync>,
    },
    /// Something in a Radiance file is not as it must be.
    #[error("Radiance: at byte {at}: {what}")]
    Radiance {
        /// The offset from the start of the file.
        at: usize,
        /// The fault in words.
        what: &'static str,
    },
}

/// Tells whether so much memory is to be had. Decoders take it without asking, which would
/// end the program.
pub(crate) fn check_memory(bytes: u64) -> Result<(), TextureError> {
    let is_there = |bytes| Vec::<u8>::new().try_reserve_exact(bytes).is_ok();
    let is_there = usize::try_from(bytes).is_ok_and(is_there);
    if is_there { Ok(()) } else { Err(TextureError::Memory(bytes)) }
}
