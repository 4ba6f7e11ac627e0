//! Arrays of numbers in buffers.

use super::json::{Accessor, Root, Sparse};
use super::{Cause, Error};
use std::borrow::Cow;

/// Buffers, and what lies in them.
pub(super) struct Arrays<'a> {
    root: &'a Root,
    buffers: Vec<Cow<'a, [u8]>>,
}

/// The type of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Component {
    I8,
    U8,
    I16,
    U16,
    U32,
    F32,
}

impl Component {
    fn of(number: u64) -> Result<Self, Cause> {
        Ok(match number {
            5120 => Self::I8,
            5121 => Self::U8,
            5122 => Self::I16,
            5123 => Self::U16,
            5125 => Self::U32,
            5126 => Self::F32,
            _ => return Err(Cause::Kind("a `componentType` from 5120 to 5126")),
        })
    }

    fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::U32 | Self::F32 => 4,
        }
    }

    /// A whole number; none of any other type.
    fn index(self, bytes: &[u8]) -> Option<u32> {
        match self {
            Self::U8 => bytes.first().map(|&byte| u32::from(byte)),
            Self::U16 => bytes.first_chunk().map(|two| u32::from(u16::from_le_bytes(*two))),
            Self::U32 => bytes.first_chunk().map(|four| u32::from_le_bytes(*four)),
            Self::I8 | Self::I16 | Self::F32 => None,
        }
    }

    /// A number, of which whole ones may stand for parts of one.
    #[inline]
    fn number(self, bytes: &[u8], normalized: bool) -> f32 {
        let (value, most) = match self {
            Self::F32 => return bytes.first_chunk().map_or(0.0, |four| f32::from_le_bytes(*four)),
            Self::I8 => (f32::from(bytes.first().copied().unwrap_or(0).cast_signed()), 127.0),
            Self::U8 => (f32::from(bytes.first().copied().unwrap_or(0)), 255.0),
            Self::I16 => (
                bytes.first_chunk().map_or(0.0, |two| f32::from(i16::from_le_bytes(*two))),
                32767.0,
            ),
            Self::U16 => (
                bytes.first_chunk().map_or(0.0, |two| f32::from(u16::from_le_bytes(*two))),
                65535.0,
            ),
            Self::U32 => {
                let value = bytes.first_chunk().map_or(0, |four| u32::from_le_bytes(*four));
                (value as f32, u32::MAX as f32)
            }
        };
        if normalized { (value / most).max(-1.0) } else { value }
    }
}

/// Elements at equal distances.
struct Strided<'a> {
    bytes: &'a [u8],
    stride: usize,
    size: usize,
}

impl<'a> Strided<'a> {
    fn elements(&self, count: usize) -> impl Iterator<Item = &'a [u8]> {
        let (bytes, stride, size) = (self.bytes, self.stride, self.size);
        (0..count).map(move |index| &bytes[index * stride..][..size])
    }
}

/// The layout of an element in bytes.
struct Layout<R> {
    /// The number of its bytes.
    size: usize,
    /// Makes it of these.
    read: R,
}

impl<'a> Arrays<'a> {
    pub(super) fn new(root: &'a Root, buffers: Vec<Cow<'a, [u8]>>) -> Self {
        Self { root, buffers }
    }

    /// Returns the bytes of a view.
    pub(super) fn view(&self, index: u64) -> Result<&[u8], Error> {
        let view = item(&self.root.buffer_views, index, "buffer view");
        let place = || format!("bufferViews[{index}]");
        let view = view.map_err(|cause| Error::at(place(), cause))?;
        let buffer = item(&self.buffers, view.buffer, "buffer");
        let buffer = buffer.map_err(|cause| Error::at(place(), cause))?;
        part(buffer, view.byte_offset, view.byte_length).map_err(|cause| Error::at(place(), cause))
    }

    /// Finds elements in a view, which are so many and so long.
    fn strided(
        &self,
        view: u64,
        offset: u64,
        count: u64,
        size: usize,
    ) -> Result<Strided<'_>, Error> {
        let bytes = self.view(view)?;
        let place = || format!("bufferViews[{view}]");
        let stride = self.root.buffer_views[view as usize].byte_stride.unwrap_or(size as u64);
        if stride < size as u64 {
            return Err(Error::at(place(), Cause::Stride(stride)));
        }
        let needed = match count.checked_sub(1) {
            None => Some(0),
            Some(last) => last.checked_mul(stride).and_then(|at| at.checked_add(size as u64)),
        };
        let bytes = part(bytes, offset, needed.unwrap_or(u64::MAX))
            .map_err(|cause| Error::at(place(), cause))?;
        Ok(Strided { bytes, stride: usize::try_from(stride).unwrap_or(usize::MAX), size })
    }

    fn accessor(&self, index: u64, place: &str) -> Result<&'a Accessor, Error> {
        let found = item(&self.root.accessors, index, "accessor");
        found.map_err(|cause| Error::at(place, cause))
    }

    /// Returns how many elements an accessor has.
    pub(super) fn count(&self, index: u64, place: &str) -> Result<u64, Error> {
        Ok(self.accessor(index, place)?.count)
    }

    /// Reads vectors of this many numbers, of any type. The caller has bounded how many there
    /// are: those that no buffer holds take memory all the same.
    pub(super) fn vectors<const N: usize>(
        &self,
        index: u64,
        place: &str,
    ) -> Result<Vec<[f32; N]>, Error> {
        let accessor = self.accessor(index, place)?;
        let here = |cause| Error::at(format!("accessors[{index}]"), cause);
        const { assert!(2 <= N && N <= 4, "vectors of glTF have two to four numbers") };
        let wanted = match N {
            2 => ("VEC2", "a `VEC2`"),
            3 => ("VEC3", "a `VEC3`"),
            _ => ("VEC4", "a `VEC4`"),
        };
        if accessor.kind != wanted.0 {
            return Err(here(Cause::Kind(wanted.1)));
        }
        let component = Component::of(accessor.component_type).map_err(here)?;
        let number_size = component.size();
        let vector = |bytes: &[u8]| {
            let number = |i| component.number(&bytes[i * number_size..], accessor.normalized);
            std::array::from_fn(number)
        };
        let layout = Layout { size: N * number_size, read: vector };
        self.elements(index, accessor, [0.0; N], &layout)
    }

    /// Reads whole numbers.
    pub(super) fn indices(&self, index: u64, place: &str) -> Result<Vec<u32>, Error> {
        let accessor = self.accessor(index, place)?;
        let here = |cause| Error::at(format!("accessors[{index}]"), cause);
        let component = Component::of(accessor.component_type).map_err(here)?;
        let is_whole = matches!(component, Component::U8 | Component::U16 | Component::U32);
        if accessor.kind != "SCALAR" || !is_whole {
            return Err(here(Cause::Kind("a `SCALAR` of unsigned whole numbers")));
        }
        if accessor.buffer_view.is_none() {
            self.check_zeros(accessor.count).map_err(here)?;
        }
        let number = |bytes: &[u8]| component.index(bytes).unwrap_or(0);
        self.elements(index, accessor, 0, &Layout { size: component.size(), read: number })
    }

    /// Refuses more zeros without a view than there are bytes in all buffers.
    fn check_zeros(&self, count: u64) -> Result<(), Cause> {
        let there = self.buffers.iter().map(|buffer| buffer.len() as u64).sum();
        if count <= there { Ok(()) } else { Err(Cause::TooFewBytes { needed: count, there }) }
    }

    /// Reads all elements, with those that replace some; without a view they are zero.
    fn elements<T: Copy, R: Fn(&[u8]) -> T>(
        &self,
        index: u64,
        accessor: &Accessor,
        zero: T,
        layout: &Layout<R>,
    ) -> Result<Vec<T>, Error> {
        let Accessor { count, byte_offset, .. } = *accessor;
        let mut elements = if let Some(view) = accessor.buffer_view {
            let strided = self.strided(view, byte_offset, count, layout.size)?;
            strided.elements(count as usize).map(&layout.read).collect()
        } else {
            vec![zero; count as usize]
        };
        if let Some(sparse) = &accessor.sparse {
            self.replace(&mut elements, sparse, layout, &format!("accessors[{index}].sparse"))?;
        }
        Ok(elements)
    }

    /// Replaces the elements that a sparse accessor names.
    fn replace<T, R: Fn(&[u8]) -> T>(
        &self,
        elements: &mut [T],
        sparse: &Sparse,
        layout: &Layout<R>,
        place: &str,
    ) -> Result<(), Error> {
        let here = |cause| Error::at(place, cause);
        let Sparse { count, indices, values } = sparse;
        let component = Component::of(indices.component_type).map_err(here)?;
        let size = component.size();
        let indices = self.strided(indices.buffer_view, indices.byte_offset, *count, size)?;
        let values = self.strided(values.buffer_view, values.byte_offset, *count, layout.size)?;
        let (count, known) = (*count as usize, elements.len());
        for (index, value) in indices.elements(count).zip(values.elements(count)) {
            let whole = component.index(index);
            let index = whole.ok_or_else(|| here(Cause::Kind("unsigned whole numbers")))?;
            let missing =
                || Cause::OutOfRange { what: "element", index: index.into(), count: known };
            let element = elements.get_mut(index as usize).ok_or_else(|| here(missing()))?;
            *element = (layout.read)(value);
        }
        Ok(())
    }
}

/// Returns what an index names.
pub(super) fn item<'a, T>(items: &'a [T], index: u64, what: &'static str) -> Result<&'a T, Cause> {
    let found = usize::try_from(index).ok().and_then(|index| items.get(index));
    found.ok_or(Cause::OutOfRange { what, index, count: items.len() })
}

/// Returns so many bytes from an offset on.
fn part(bytes: &[u8], offset: u64, length: u64) -> Result<&[u8], Cause> {
    let there = bytes.len() as u64;
    let end = offset.saturating_add(length);
    if end > there {
        return Err(Cause::TooFewBytes { needed: end, there });
    }
    Ok(&bytes[offset as usize..end as usize])
}
