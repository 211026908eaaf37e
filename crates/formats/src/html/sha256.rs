//! The digest SHA-256 (FIPS 180-4, section 6.2), by which the page's policy names its own script
//! and style and no others.

/// The first 32 bits of the fractional parts of the cube roots of the first 64 primes, and of the
/// square roots of the first eight.
fn constants() -> ([u32; 64], [u32; 8]) {
    let primes = (2_u64..).filter(|n| (2..*n).take_while(|d| d * d <= *n).all(|d| n % d != 0));
    let (mut cubes, mut squares) = ([0; 64], [0; 8]);
    for (at, prime) in primes.take(64).enumerate() {
        // The root times 2³², rounded down: whole numbers, since f64 has too few digits.
        cubes[at] = root(u128::from(prime) << 96, 3) as u32;
        if let Some(square) = squares.get_mut(at) {
            *square = root(u128::from(prime) << 64, 2) as u32;
        }
    }
    (cubes, squares)
}

/// The largest whole number whose power is at most `of`.
fn root(of: u128, power: u32) -> u128 {
    (0..40).rev().fold(0, |found, bit| {
        let next = found | 1 << bit;
        match u128::checked_pow(next, power) {
            Some(value) if value <= of => next,
            _ => found,
        }
    })
}

pub(super) fn sha256(message: &[u8]) -> [u8; 32] {
    let (k, mut hash) = constants();
    let mut padded = message.to_vec();
    padded.push(0x80);
    padded.resize((padded.len() + 8).next_multiple_of(64) - 8, 0);
    padded.extend((message.len() as u64 * 8).to_be_bytes());
    for block in padded.as_chunks::<64>().0 {
        let mut w = [0_u32; 64];
        for (word, bytes) in w.iter_mut().zip(block.as_chunks::<4>().0) {
            *word = u32::from_be_bytes(*bytes);
        }
        for t in 16..64 {
            let (a, b) = (w[t - 15], w[t - 2]);
            let small0 = a.rotate_right(7) ^ a.rotate_right(18) ^ a >> 3;
            let small1 = b.rotate_right(17) ^ b.rotate_right(19) ^ b >> 10;
            w[t] = [w[t - 16], small0, w[t - 7], small1]
                .into_iter()
                .fold(0, u32::wrapping_add);
        }
        let mut s = hash;
        for t in 0..64 {
            let [a, b, c, _, e, f, g, h] = s;
            let big1 = e.rotate_right(6) ^ e.rotate_right(11) ^ e.rotate_right(25);
            let choice = e & f ^ !e & g;
            let one = [h, big1, choice, k[t], w[t]]
                .into_iter()
                .fold(0, u32::wrapping_add);
            let big0 = a.rotate_right(2) ^ a.rotate_right(13) ^ a.rotate_right(22);
            let two = big0.wrapping_add(a & b ^ a & c ^ b & c);
            s.rotate_right(1);
            s[0] = one.wrapping_add(two);
            s[4] = s[4].wrapping_add(one);
        }
        for (sum, word) in hash.iter_mut().zip(s) {
            *sum = sum.wrapping_add(word);
        }
    }
    let mut digest = [0; 32];
    for (bytes, word) in digest.as_chunks_mut::<4>().0.iter_mut().zip(hash) {
        *bytes = word.to_be_bytes();
    }
    digest
}

#[cfg(test)]
mod tests {
    use super::*;

    fn hex(message: &str) -> String {
        let digest = sha256(message.as_bytes());
        digest.iter().map(|byte| format!("{byte:02x}")).collect()
    }

    /// The standard's examples, and what Python's hashlib says of lengths about a block's end.
    #[test]
    fn the_standard_s_examples() {
        assert_eq!(
            hex("abc"),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"
        );
        assert_eq!(
            hex("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1"
        );
        assert_eq!(
            hex(""),
            "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"
        );
        assert_eq!(
            hex(&"a".repeat(55)),
            "9f4390f8d30c2dd92ec9f095b65e2b9ae9b0a925a5258e241c9f1e910f734318"
        );
        assert_eq!(
            hex(&"a".repeat(56)),
            "b35439a4ac6f0948b6d6f9e3c6af0f5f590ce20f1bde7090ef7970686ec6738a"
        );
        assert_eq!(
            hex(&"a".repeat(64)),
            "ffe054fe7ae0cb6dc65c3af9b61d5209f439851db43d0ba5997337df154668eb"
        );
        assert_eq!(
            hex(&"a".repeat(1000)),
            "41edece42d63e8d9bf515a9ba6932e1c20cbc9f5a5d134645adb5db1b9737ea3"
        );
    }
}
