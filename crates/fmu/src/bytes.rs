//! Turns numbers into bytes and back: little-endian, bit for bit.

pub(crate) fn word32(out: &mut Vec<u8>, word: u32) {
    out.extend_from_slice(&word.to_le_bytes());
}

pub(crate) fn word64(out: &mut Vec<u8>, word: u64) {
    out.extend_from_slice(&word.to_le_bytes());
}

pub(crate) fn number(out: &mut Vec<u8>, number: f64) {
    word64(out, number.to_bits());
}

/// Reads numbers from the front of some bytes; `None` if there are too few bytes.
pub(crate) struct Reader<'a>(pub(crate) &'a [u8]);

impl<'a> Reader<'a> {
    pub(crate) fn take(&mut self, count: usize) -> Option<&'a [u8]> {
        let (taken, rest) = self.0.split_at_checked(count)?;
        self.0 = rest;
        Some(taken)
    }

    pub(crate) fn word32(&mut self) -> Option<u32> {
        Some(u32::from_le_bytes(self.take(4)?.try_into().ok()?))
    }

    pub(crate) fn word64(&mut self) -> Option<u64> {
        Some(u64::from_le_bytes(self.take(8)?.try_into().ok()?))
    }

    /// A finite number.
    pub(crate) fn number(&mut self) -> Option<f64> {
        Some(f64::from_bits(self.word64()?)).filter(|number| number.is_finite())
    }
}
