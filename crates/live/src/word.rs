//! Writes a value of an enum of `fenderline_sim` into JSON as the word that names the value, and reads the value from
//! the word: `#[serde(with = "crate::word")]`.

use fenderline_sim::order::Word;
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serializer};

pub(crate) fn serialize<W: Word, S: Serializer>(word: &W, to: S) -> Result<S::Ok, S::Error> {
    to.serialize_str(word.word())
}

pub(crate) fn deserialize<'de, W: Word, D: Deserializer<'de>>(from: D) -> Result<W, D::Error> {
    let given = String::deserialize(from)?;
    W::of_word(&given).ok_or_else(|| {
        let known: Vec<String> = W::ALL.iter().map(|one| format!("`{}`", one.word())).collect();
        D::Error::custom(format_args!(
            "unknown word `{given}`, expected one of {}",
            known.join(", ")
        ))
    })
}
