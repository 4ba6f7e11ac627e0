//! From bytes of a text to lines and columns.

/// The offsets at which the lines of a text begin.
pub(super) struct Lines<'a> {
    text: &'a str,
    starts: Vec<u32>,
}

impl<'a> Lines<'a> {
    pub(super) fn of(text: &'a str) -> Self {
        let is_end = |&(_, byte): &(usize, u8)| byte == b'\n';
        let ends = || text.bytes().enumerate().filter(is_end);
        let mut starts = Vec::with_capacity(ends().count() + 1);
        starts.push(0);
        starts.extend(ends().map(|(end, _)| end as u32 + 1));
        Self { text, starts }
    }

    /// The line and the character in it, both from 1, of a byte.
    pub(super) fn at(&self, byte: usize) -> (u32, u32) {
        let line = self.starts.partition_point(|&start| start as usize <= byte);
        let start = self.starts[line.saturating_sub(1)] as usize;
        let before = self.text.get(start..byte).map_or(0, |before| before.chars().count());
        (line as u32, before as u32 + 1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_and_columns_count_characters_from_one() {
        let lines = Lines::of("ab\nä<x\n");
        assert_eq!([0, 1, 3, 5].map(|byte| lines.at(byte)), [(1, 1), (1, 2), (2, 1), (2, 2)]);
        assert_eq!(lines.at(99), (3, 1));
    }
}
