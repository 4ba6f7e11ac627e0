//! SHA-256 (FIPS 180-4), by which pixels of files and archives are known.

/// In hexadecimal digits.
pub(crate) fn sha256(bytes: &[u8]) -> String {
    let mut message = bytes.to_vec();
    message.push(0x80);
    message.resize((message.len() + 8).next_multiple_of(64) - 8, 0);
    message.extend((8 * bytes.len() as u64).to_be_bytes());
    let primes: Vec<u32> = (2..312).filter(|n| (2..*n).all(|d| n % d != 0)).collect();
    let fraction = |root: f64| (root.fract() * 2.0_f64.powi(32)) as u32;
    let constants: Vec<u32> = primes.iter().map(|&p| fraction(f64::from(p).cbrt())).collect();
    let mut state: [u32; 8] = std::array::from_fn(|i| fraction(f64::from(primes[i]).sqrt()));
    message.as_chunks().0.iter().for_each(|block| step(&mut state, block, &constants));
    state.map(|word| format!("{word:08x}")).concat()
}

fn step(state: &mut [u32; 8], block: &[u8; 64], constants: &[u32]) {
    let mut words: Vec<u32> = block.as_chunks().0.iter().map(|&w| u32::from_be_bytes(w)).collect();
    let mixed = |x: u32, [a, b, c]: [u32; 3], shift| {
        x.rotate_right(a) ^ x.rotate_right(b) ^ if shift { x >> c } else { x.rotate_right(c) }
    };
    for i in 16..64 {
        let (near, far) = (words[i - 2], words[i - 15]);
        let sum = words[i - 16].wrapping_add(mixed(far, [7, 18, 3], true));
        words.push(sum.wrapping_add(words[i - 7]).wrapping_add(mixed(near, [17, 19, 10], true)));
    }
    let [mut a, mut b, mut c, mut d, mut e, mut f, mut g, mut h] = *state;
    for (word, constant) in words.iter().zip(constants) {
        let one = h
            .wrapping_add(mixed(e, [6, 11, 25], false))
            .wrapping_add((e & f) ^ (!e & g))
            .wrapping_add(*constant)
            .wrapping_add(*word);
        let two = mixed(a, [2, 13, 22], false).wrapping_add((a & b) ^ (a & c) ^ (b & c));
        (h, g, f, e, d, c, b, a) = (g, f, e, d.wrapping_add(one), c, b, a, one.wrapping_add(two));
    }
    let added = [a, b, c, d, e, f, g, h];
    *state = std::array::from_fn(|i| state[i].wrapping_add(added[i]));
}

#[cfg(test)]
#[test]
fn it_is_sha256() {
    let empty = "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855";
    assert_eq!(sha256(b""), empty);
    let two_blocks = b"abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq";
    let expected = "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1";
    assert_eq!(sha256(two_blocks), expected);
}
