//! Models of ships for the view: binary glTF files (`.glb`). Scenarios, recordings and packages keep the files that a
//! scenario names as texts, so that the text of a model is its bytes in base64.

use std::sync::Arc;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;

/// Help in the error for a model that cannot be used.
pub(crate) const HELP: &str = "export the model as a binary glTF 2.0 file with the ending .glb, as Blender and most other programs do";

/// The first bytes of a binary glTF file: its magic, and the version, 2 (glTF 2.0 specification, section 4.4.2).
const MAGIC: &[u8] = b"glTF";
const VERSION: [u8; 4] = 2_u32.to_le_bytes();
/// Bytes of the header: magic, version, and length of the file.
const HEADER: usize = 12;

/// Whether a name is that of a model, by its ending.
pub(crate) fn is_model(name: &str) -> bool {
    name.get(name.len().saturating_sub(4)..).is_some_and(|end| end.eq_ignore_ascii_case(".glb"))
}

/// The text that stands for a model's bytes.
pub(crate) fn text_of(bytes: &[u8]) -> String {
    STANDARD.encode(bytes)
}

/// The bytes of the model `name` from the text that stands for the bytes.
///
/// # Errors
/// Returns the reason why the file is no binary glTF file of version 2.
pub(crate) fn bytes_of(name: &str, text: &str) -> Result<Arc<[u8]>, String> {
    if !is_model(name) {
        return Err("the name of a model ends with .glb".to_owned());
    }
    let bytes = STANDARD
        .decode(text.trim())
        .map_err(|_| "the text of the file is not base64".to_owned())?;
    let (magic, version) = (bytes.get(..4), bytes.get(4..8));
    if magic != Some(MAGIC) {
        return Err("the file is not a binary glTF file: it does not begin with glTF".to_owned());
    }
    if version != Some(&VERSION) {
        return Err("the file is not of version 2 of glTF".to_owned());
    }
    let length = bytes.get(8..HEADER).and_then(|part| part.try_into().ok()).map(u32::from_le_bytes);
    match length {
        Some(length) if length as usize == bytes.len() => Ok(bytes.into()),
        Some(length) => Err(format!(
            "the file is cut or damaged: it has {} bytes, and its header says {length}",
            bytes.len()
        )),
        None => Err("the file is cut: its header is not whole".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::{bytes_of, is_model, text_of};

    fn glb(body: &[u8]) -> Vec<u8> {
        let length = u32::try_from(12 + body.len()).unwrap();
        [b"glTF".as_slice(), &2_u32.to_le_bytes(), &length.to_le_bytes(), body].concat()
    }

    #[test]
    fn a_model_is_kept_as_a_text_and_read_back() {
        let bytes = glb(&[0, 255, 7, 200]);
        assert_eq!(*bytes_of("ship.GLB", &text_of(&bytes)).unwrap(), bytes);
    }

    #[test]
    fn a_broken_model_is_refused_with_the_reason() {
        let why = |name: &str, bytes: &[u8]| bytes_of(name, &text_of(bytes)).unwrap_err();
        assert!(why("ship.gltf", &glb(b"")).contains(".glb"));
        assert!(why("ship.glb", b"PK\x03\x04").contains("does not begin with glTF"));
        assert!(why("ship.glb", b"").contains("does not begin with glTF"));
        let mut old = glb(b"1234");
        old[4] = 1;
        assert!(why("ship.glb", &old).contains("version 2"));
        assert!(why("ship.glb", &glb(b"1234")[..14]).contains("14 bytes, and its header says 16"));
        assert!(why("ship.glb", &glb(b"")[..9]).contains("header is not whole"));
        assert!(bytes_of("ship.glb", "no base64 !").unwrap_err().contains("base64"));
    }

    #[test]
    fn models_are_known_by_their_ending() {
        assert!(is_model("a/ship.glb") && is_model("SHIP.GLB"));
        assert!(!is_model("ship.csv") && !is_model("glb") && !is_model("") && !is_model("ü.gl"));
    }
}
