//! FNV-1a, a hash for checksums and fingerprints (Fowler, Noll and Vo). The hash finds accidental changes, but gives no
//! protection against deliberate changes.

/// The state of a 64-bit FNV-1a hash of the bytes added so far.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fnv1a(u64);

impl Default for Fnv1a {
    fn default() -> Fnv1a {
        Fnv1a(0xcbf2_9ce4_8422_2325)
    }
}

impl Fnv1a {
    /// Returns the hash of these bytes.
    #[must_use]
    pub fn of(bytes: &[u8]) -> u64 {
        let mut hash = Fnv1a::default();
        hash.bytes(bytes);
        hash.finish()
    }

    /// Adds a 64-bit word to the hash, least significant byte first.
    pub fn word(&mut self, word: u64) {
        self.bytes(&word.to_le_bytes());
    }

    /// Adds the bits of floating-point numbers to the hash.
    pub(crate) fn numbers<'a>(&mut self, numbers: impl IntoIterator<Item = &'a f64>) {
        numbers.into_iter().for_each(|number| self.word(number.to_bits()));
    }

    /// Adds bytes.
    pub fn bytes(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }

    /// Returns the hash of all bytes added so far.
    #[must_use]
    pub fn finish(self) -> u64 {
        self.0
    }
}

#[cfg(test)]
mod tests {
    use super::Fnv1a;

    /// The expected sums of "" and "a" are from the Python package fnvhash.
    #[test]
    fn known_hashes() {
        assert_eq!(Fnv1a::of(b""), 0xcbf2_9ce4_8422_2325);
        assert_eq!(Fnv1a::of(b"a"), 0xaf63_dc4c_8601_ec8c);
        let mut hash = Fnv1a::default();
        hash.word(u64::from(b'a'));
        assert_eq!(hash.finish(), Fnv1a::of(b"a\0\0\0\0\0\0\0"));
    }
}
