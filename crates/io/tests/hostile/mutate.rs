//! Damage of many kinds.

use traylib_math::Sampler;

/// Numbers and words that ask for much or mean nothing, for text.
const WORDS: [&str; 12] = [
    "99999999999999999999",
    "4000000000",
    "1e308",
    "-1",
    "0",
    "nan",
    "-a 1000000",
    "-i 9999999999",
    "\n",
    "\\\n",
    "xf -a 999\n",
    "i x.mgf\n",
];

/// Values that counts, sizes and lengths break at.
const VALUES: [u32; 8] = [0, 1, 5, 0x7f, 0xff, 0xffff, 0x7fff_ffff, u32::MAX];

/// Copies of a file, each damaged in one to four places, the same in every run.
pub(crate) struct Mutations<'a> {
    sound: &'a [u8],
    sampler: Sampler,
}

impl<'a> Mutations<'a> {
    pub(crate) fn new(sound: &'a [u8], seed: u64) -> Self {
        Self { sound, sampler: Sampler::numbered(seed, 0) }
    }

    fn below(&mut self, count: usize) -> usize {
        (self.sampler.next_1d() * count as f32) as usize
    }

    /// A place in the bytes; every other one is in the first hundred.
    fn place(&mut self, bytes: &[u8]) -> usize {
        let range = if self.below(2) == 0 { bytes.len().min(100) } else { bytes.len() };
        self.below(range.max(1)).min(bytes.len())
    }

    fn damage(&mut self, bytes: &mut Vec<u8>) {
        let at = self.place(bytes);
        let end = (at + 1 + self.below(64)).min(bytes.len());
        match self.below(7) {
            0 => bytes.iter_mut().skip(at).take(1).for_each(|byte| *byte ^= 1 << (at % 8)),
            1 => {
                let value = self.below(256) as u8;
                bytes.iter_mut().skip(at).take(1).for_each(|byte| *byte = value);
            }
            2 => {
                let value = VALUES[self.below(VALUES.len())].to_le_bytes();
                let length = if self.below(2) == 0 { 2 } else { 4 };
                bytes.iter_mut().skip(at).zip(&value[..length]).for_each(|(a, b)| *a = *b);
            }
            3 => _ = bytes.drain(at..end),
            4 => {
                let piece = bytes[at..end].to_vec();
                let to = self.place(bytes);
                bytes.splice(to..to, piece);
            }
            5 => {
                let word = WORDS[self.below(WORDS.len())];
                bytes.splice(at..at, word.bytes());
            }
            _ => self.replace_number(bytes, at),
        }
    }

    /// Another number for the first one from a place on.
    fn replace_number(&mut self, bytes: &mut Vec<u8>, at: usize) {
        let digits = |byte: &u8| byte.is_ascii_digit();
        let Some(start) = bytes[at..].iter().position(digits).map(|skip| at + skip) else { return };
        let length = bytes[start..].iter().take_while(|byte| digits(byte)).count();
        let word = WORDS[self.below(5)];
        bytes.splice(start..start + length, word.bytes());
    }
}

impl Iterator for Mutations<'_> {
    type Item = Vec<u8>;

    fn next(&mut self) -> Option<Vec<u8>> {
        let mut bytes = self.sound.to_vec();
        for _ in 0..=self.below(4) {
            self.damage(&mut bytes);
        }
        Some(bytes)
    }
}

/// Beginnings of a file, so many at most, evenly spaced.
pub(crate) fn beginnings(bytes: &[u8], most: usize) -> impl Iterator<Item = &[u8]> {
    let count = bytes.len().min(most);
    (0..count).map(move |index| &bytes[..index * bytes.len() / count])
}
