//! Writes the chunks that tests read.

/// A chunk around some bytes.
pub(in crate::three_ds) fn chunk(id: u16, parts: &[&[u8]]) -> Vec<u8> {
    let body = parts.concat();
    let length = u32::try_from(body.len() + 6).unwrap();
    [&id.to_le_bytes()[..], &length.to_le_bytes(), &body].concat()
}

/// Entries after their number.
pub(in crate::three_ds) fn list<T, const N: usize>(
    values: &[T],
    bytes: impl Fn(&T) -> [u8; N],
) -> Vec<u8> {
    let count = u16::try_from(values.len()).unwrap().to_le_bytes();
    count.into_iter().chain(values.iter().flat_map(bytes)).collect()
}

pub(in crate::three_ds) fn vertices(positions: &[[f32; 3]]) -> Vec<u8> {
    let numbers: Vec<u8> = positions.iter().flatten().flat_map(|x| x.to_le_bytes()).collect();
    let count = u16::try_from(positions.len()).unwrap().to_le_bytes();
    chunk(0x4110, &[&count, &numbers])
}

pub(in crate::three_ds) fn faces(corners: &[[u16; 3]], inside: &[&[u8]]) -> Vec<u8> {
    let entry = |&[a, b, c]: &[u16; 3]| -> [u8; 8] {
        let mut bytes = [0; 8];
        for (place, value) in bytes.chunks_mut(2).zip([a, b, c, 7]) {
            place.copy_from_slice(&value.to_le_bytes());
        }
        bytes
    };
    chunk(0x4120, &[&list(corners, entry), &inside.concat()])
}

pub(in crate::three_ds) fn group(name: &[u8], members: &[u16]) -> Vec<u8> {
    chunk(0x4130, &[name, &[0], &list(members, |m| m.to_le_bytes())])
}

pub(in crate::three_ds) fn material(name: &[u8]) -> Vec<u8> {
    chunk(0xafff, &[&chunk(0xa000, &[name, &[0]])])
}

/// A file with one object of these triangle chunks, and other chunks after it.
pub(in crate::three_ds) fn file(triangles: &[&[u8]], after: &[&[u8]]) -> Vec<u8> {
    let object = chunk(0x4000, &[b"plate\0", &chunk(0x4100, triangles)]);
    chunk(0x4d4d, &[&chunk(0x3d3d, &[&object, &after.concat()])])
}

pub(in crate::three_ds) const SQUARE: [[f32; 3]; 4] =
    [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];

pub(in crate::three_ds) fn floats(values: &[f32]) -> Vec<u8> {
    values.iter().flat_map(|value| value.to_le_bytes()).collect()
}

/// A named object of some chunks.
pub(in crate::three_ds) fn object(name: &[u8], chunks: &[&[u8]]) -> Vec<u8> {
    chunk(0x4000, &[name, &[0], &chunks.concat()])
}

/// Returns the bytes of a track that says it has so many keys.
pub(in crate::three_ds) fn track(count: u32, keys: &[Vec<u8>]) -> Vec<u8> {
    [&[0; 10][..], &count.to_le_bytes(), &keys.concat()].concat()
}

/// A node of an object, with its number, its parent's, and more chunks.
pub(in crate::three_ds) fn node(name: &[u8], id: u16, parent: u16, chunks: &[&[u8]]) -> Vec<u8> {
    let header = [name, &[0; 5], &parent.to_le_bytes()].concat();
    let (id, header) = (chunk(0xb030, &[&id.to_le_bytes()]), chunk(0xb010, &[&header]));
    chunk(0xb002, &[&id, &header, &chunks.concat()])
}

/// A track of one key at frame 0.
pub(in crate::three_ds) fn still(id: u16, value: &[f32]) -> Vec<u8> {
    chunk(id, &[&track(1, &[[&[0; 6][..], &floats(value)].concat()])])
}
