//! Reads a fuzzer's bytes as numbers.

/// Reads bytes from the front of the input, then zeros, so that any input is valid.
#[derive(Clone, Debug)]
pub struct Input<'a>(&'a [u8]);

impl<'a> Input<'a> {
    /// Starts at the first byte of the input.
    #[must_use]
    pub fn new(bytes: &'a [u8]) -> Input<'a> {
        Input(bytes)
    }

    /// True when all bytes of the input are used up.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The next byte.
    pub fn byte(&mut self) -> u8 {
        let Some((&first, rest)) = self.0.split_first() else { return 0 };
        self.0 = rest;
        first
    }

    /// The next two bytes.
    pub fn word(&mut self) -> u16 {
        u16::from_le_bytes([self.byte(), self.byte()])
    }

    /// A coordinate in [−128, 128) on a grid of 1/256. Sums and products of such coordinates are exact, so that
    /// coincident edges and corners on edges are common.
    pub fn coordinate_m(&mut self) -> f64 {
        f64::from(self.word() as i16) / 256.0
    }

    /// A heading: often a multiple of a right angle, otherwise any angle.
    pub fn heading_rad(&mut self) -> f64 {
        let choice = self.byte();
        match choice {
            0..128 => f64::from(choice % 8) * core::f64::consts::FRAC_PI_2,
            _ => f64::from(self.word()) * 1e-4,
        }
    }

    /// The remaining bytes.
    #[must_use]
    pub fn rest(self) -> &'a [u8] {
        self.0
    }
}
