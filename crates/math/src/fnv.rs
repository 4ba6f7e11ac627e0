//! The hash that names what is kept on disk.

use std::fmt;

/// FNV-1a of 64 bits: each byte is put in by exclusive or, then all is multiplied by
/// 2⁴⁰ + 2⁸ + 0xb3, from 14695981039346656037 on. It stays what it is with every compiler
/// and on every machine, as names of files must. It guards against chance, not against
/// anybody: of a million pieces of work two share a key with a probability of 3·10⁻⁸.
///
/// Fowler, Noll, Vo and Eastlake, *The FNV non-cryptographic hash algorithm*, RFC 9923.
#[derive(Clone, Copy, Debug)]
pub struct Fnv(u64);

impl Default for Fnv {
    fn default() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }
}

impl Fnv {
    /// Takes in bytes, as if all had come at once.
    pub fn add(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }

    /// The hash of all bytes so far.
    pub fn finish(self) -> u64 {
        self.0
    }
}

/// Text, byte by byte.
impl fmt::Write for Fnv {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.add(text.as_bytes());
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The test vectors of its authors.
    #[test]
    fn it_is_the_published_hash() {
        let vectors = [
            ("", 0xcbf2_9ce4_8422_2325),
            ("a", 0xaf63_dc4c_8601_ec8c),
            ("foobar", 0x8594_4171_f739_67e8),
        ];
        for (text, known) in vectors {
            let mut hash = Fnv::default();
            hash.add(text.as_bytes());
            assert_eq!(hash.finish(), known, "{text}");
        }
    }

    #[test]
    fn parts_are_as_good_as_the_whole() {
        let (mut parts, mut whole) = (Fnv::default(), Fnv::default());
        parts.add(b"foo");
        parts.add(b"bar");
        whole.add(b"foobar");
        assert_eq!(parts.finish(), whole.finish());
    }
}
