//! Numbers that are sets: one bit, or one byte of bits, for each member.

/// The places of the ones in a mask, the lowest first.
#[inline(always)]
pub(crate) fn ones(mut mask: u32) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let place = (mask != 0).then(|| mask.trailing_zeros() as usize)?;
        mask &= mask - 1;
        Some(place)
    })
}

/// The bytes of a number that are not zero, with their places.
#[inline(always)]
pub(crate) fn bytes(mut number: u32) -> impl Iterator<Item = (usize, u32)> {
    std::iter::from_fn(move || {
        let place = (number != 0).then(|| number.trailing_zeros() / u8::BITS)?;
        let byte = number >> (u8::BITS * place) & u32::from(u8::MAX);
        number ^= byte << (u8::BITS * place);
        Some((place as usize, byte))
    })
}
