//! JSON whose numbers are checked before they are written.
//!
//! JSON has no NaN and no infinity. `serde_json` writes null for both, but null also means that there is no value;
//! these two meanings cannot be distinguished in a `serde_json` value. So [`Json`] keeps each number as a number, and
//! [`Json::checked`] checks all numbers on the way to a [`serde_json::Value`].

use core::fmt;
use core::ops::{Index, IndexMut};
use std::borrow::Cow;

use serde_json::{Map, Value};

/// A JSON document that is not written yet.
#[derive(Clone, Debug, PartialEq)]
pub enum Json {
    /// There is no value.
    Null,
    /// Yes or no.
    Flag(bool),
    /// A count.
    Count(u64),
    /// A number, which may be NaN or infinite until [`Json::checked`] has checked it.
    Number(f64),
    /// A text.
    Text(String),
    /// A list.
    List(Vec<Json>),
    /// Keys and values, in the order in which they are written.
    Object(Vec<(String, Json)>),
}

/// A number that is NaN or infinite, with its place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NumberNotFinite {
    /// Key of the number, with dots between the levels and indices of lists in brackets.
    pub key: String,
}

impl fmt::Display for NumberNotFinite {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the simulation gave a value that is not finite for `{}`", self.key)
    }
}

impl core::error::Error for NumberNotFinite {}

impl Json {
    /// Checks all numbers and gives the document as a value of `serde_json`.
    ///
    /// # Errors
    /// Fails if a number is NaN or infinite.
    pub fn checked(self) -> Result<Value, NumberNotFinite> {
        self.at(&mut String::new())
    }

    /// Checks a value; `path` is the path of this value in the document, and is unchanged afterwards.
    fn at(self, path: &mut String) -> Result<Value, NumberNotFinite> {
        Ok(match self {
            Json::Null => Value::Null,
            Json::Flag(flag) => flag.into(),
            Json::Count(count) => count.into(),
            Json::Number(number) if number.is_finite() => number.into(),
            Json::Number(_) => return Err(NumberNotFinite { key: path.clone() }),
            Json::Text(text) => text.into(),
            Json::List(items) => {
                let items = items.into_iter().enumerate();
                let checked = items.map(|(index, item)| below(path, &format!("[{index}]"), item));
                Value::Array(checked.collect::<Result<_, _>>()?)
            }
            Json::Object(entries) => {
                let entries = entries.into_iter().map(|(key, value)| {
                    let part = if path.is_empty() { key.clone() } else { format!(".{key}") };
                    Ok((key, below(path, &part, value)?))
                });
                Value::Object(entries.collect::<Result<Map<_, _>, _>>()?)
            }
        })
    }

    /// Sets the value of a key of an object; a new key comes last.
    ///
    /// # Panics
    /// This is no object.
    pub fn put(&mut self, key: &str, value: impl ToJson) {
        self[key] = value.to_json();
    }

    /// Sets the value of a key of an object, if there is a value: a missing value gets no key.
    ///
    /// # Panics
    /// This is no object.
    pub fn put_if_any(&mut self, key: &str, value: Option<impl ToJson>) {
        if let Some(value) = value {
            self.put(key, value);
        }
    }

    /// The items of a JSON list; empty for any other value.
    pub fn items_mut(&mut self) -> &mut [Json] {
        match self {
            Json::List(items) => items,
            _ => &mut [],
        }
    }
}

fn below(path: &mut String, part: &str, value: Json) -> Result<Value, NumberNotFinite> {
    let length = path.len();
    path.push_str(part);
    let checked = value.at(path);
    path.truncate(length);
    checked
}

impl Index<&str> for Json {
    type Output = Json;

    /// The value of a key of an object; null if the object lacks the key.
    fn index(&self, key: &str) -> &Json {
        let Json::Object(entries) = self else { return &Json::Null };
        entries.iter().find(|(own, _)| own == key).map_or(&Json::Null, |(_, value)| value)
    }
}

impl IndexMut<&str> for Json {
    /// The value of a key of an object; a new key comes last, with null.
    fn index_mut(&mut self, key: &str) -> &mut Json {
        let Json::Object(entries) = self else {
            panic!("the key `{key}` is asked of a value that is no object")
        };
        let place = entries.iter().position(|(own, _)| own == key).unwrap_or_else(|| {
            entries.push((key.to_owned(), Json::Null));
            entries.len() - 1
        });
        &mut entries[place].1
    }
}

/// A value from which [`Json`] can be made.
pub trait ToJson {
    /// The value as JSON.
    fn to_json(&self) -> Json;
}

impl ToJson for Json {
    fn to_json(&self) -> Json {
        self.clone()
    }
}

impl ToJson for bool {
    fn to_json(&self) -> Json {
        Json::Flag(*self)
    }
}

impl ToJson for f64 {
    fn to_json(&self) -> Json {
        Json::Number(*self)
    }
}

impl ToJson for u32 {
    fn to_json(&self) -> Json {
        Json::Count(u64::from(*self))
    }
}

impl ToJson for u64 {
    fn to_json(&self) -> Json {
        Json::Count(*self)
    }
}

impl ToJson for usize {
    fn to_json(&self) -> Json {
        Json::Count(*self as u64)
    }
}

impl ToJson for str {
    fn to_json(&self) -> Json {
        Json::Text(self.to_owned())
    }
}

impl ToJson for String {
    fn to_json(&self) -> Json {
        Json::Text(self.clone())
    }
}

impl ToJson for Cow<'_, str> {
    fn to_json(&self) -> Json {
        Json::Text(self.to_string())
    }
}

impl<T: ToJson + ?Sized> ToJson for &T {
    fn to_json(&self) -> Json {
        (**self).to_json()
    }
}

impl<T: ToJson> ToJson for Option<T> {
    fn to_json(&self) -> Json {
        self.as_ref().map_or(Json::Null, ToJson::to_json)
    }
}

impl<T: ToJson> ToJson for [T] {
    fn to_json(&self) -> Json {
        Json::List(self.iter().map(ToJson::to_json).collect())
    }
}

impl<T: ToJson, const N: usize> ToJson for [T; N] {
    fn to_json(&self) -> Json {
        self.as_slice().to_json()
    }
}

impl<T: ToJson> ToJson for Vec<T> {
    fn to_json(&self) -> Json {
        self.as_slice().to_json()
    }
}

impl<T: ToJson> FromIterator<T> for Json {
    /// A list.
    fn from_iter<I: IntoIterator<Item = T>>(items: I) -> Json {
        Json::List(items.into_iter().map(|item| item.to_json()).collect())
    }
}

impl<T: ToJson> FromIterator<(String, T)> for Json {
    /// An object.
    fn from_iter<I: IntoIterator<Item = (String, T)>>(entries: I) -> Json {
        Json::Object(entries.into_iter().map(|(key, value)| (key, value.to_json())).collect())
    }
}

/// Makes a JSON object from a notation like JSON: `object!({ "key": value })`. Values are anything with [`ToJson`]; a
/// key is a text in quotes or in a variable.
macro_rules! object {
    ({ $($key:tt : $value:expr),* $(,)? }) => {
        $crate::json::Json::Object(vec![
            $(((($key).to_owned()), $crate::json::ToJson::to_json(&$value))),*
        ])
    };
}
pub(crate) use object;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_null_is_no_number_and_a_number_that_is_not_finite_is_found_by_its_key() {
        let sound = object!({ "none": None::<f64>, "list": [1.0, 2.5], "count": 3_usize });
        let text = sound.checked().expect("all numbers are finite").to_string();
        assert_eq!(text, r#"{"none":null,"list":[1.0,2.5],"count":3}"#);
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let inner = object!({ "none": Json::Null, "value": [Some(0.0), Some(bad)] });
            let error = object!({ "ships": [inner] }).checked().expect_err("one is not finite");
            assert_eq!(error.key, "ships[0].value[1]");
        }
    }

    #[test]
    fn a_key_keeps_its_place_when_its_value_changes() {
        let mut of = object!({ "a": 1.0, "b": "x" });
        of.put("a", 2.0);
        of.put_if_any("c", None::<f64>);
        assert_eq!(of.checked().expect("finite").to_string(), r#"{"a":2.0,"b":"x"}"#);
    }
}
