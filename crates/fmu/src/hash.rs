//! The GUID by which a library recognises its own FMU. It protects no secret.

/// The 128-bit FNV-1a hash of some bytes, written as a GUID.
pub(crate) fn guid(bytes: &[u8]) -> String {
    const PRIME: u128 = 0x0000_0000_0100_0000_0000_0000_0000_013b;
    let step = |sum: u128, &byte: &u8| (sum ^ u128::from(byte)).wrapping_mul(PRIME);
    let sum = bytes.iter().fold(0x6c62_272e_07bb_0142_62b8_2175_6295_c58d, step);
    let digits = format!("{sum:032x}");
    let parts = [&digits[..8], &digits[8..12], &digits[12..16], &digits[16..20], &digits[20..]];
    format!("{{{}}}", parts.join("-"))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The published hashes of "" and "a".
    #[test]
    fn known_hashes() {
        assert_eq!(guid(b""), "{6c62272e-07bb-0142-62b8-21756295c58d}");
        assert_eq!(guid(b"a"), "{d228cb69-6f1a-8caf-7891-2b704e4a8964}");
    }
}
