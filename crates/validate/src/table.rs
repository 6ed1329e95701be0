//! Reads a table of a file under `validation/`: its values by their kinds, with errors that name table and key.

use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A table of a file under `validation/`, with a name for messages.
pub(crate) struct Table<'t, 'i> {
    pub(crate) name: String,
    pub(crate) table: &'t DeTable<'i>,
}

impl<'t, 'i> Table<'t, 'i> {
    pub(crate) fn error(&self, what: &str) -> String {
        format!("{}: {what}", self.name)
    }

    pub(crate) fn find(&self, key: &str) -> Option<&'t DeValue<'i>> {
        let entry = self.table.iter().find(|(name, _)| name.get_ref() == key);
        entry.map(|(_, value)| value.get_ref())
    }

    pub(crate) fn has(&self, key: &str) -> bool {
        self.find(key).is_some()
    }

    /// Refuses keys of the table that are not in `known`, so that no key is ignored.
    pub(crate) fn allow(&self, known: &[&str]) -> Result<(), String> {
        let unknown = self.table.keys().find(|key| !known.contains(&key.get_ref().as_ref()));
        unknown.map_or(Ok(()), |key| Err(self.error(&format!("unknown key {}", key.get_ref()))))
    }

    fn get<T>(
        &self,
        key: &str,
        what: &str,
        take: impl FnOnce(&'t DeValue<'i>) -> Option<T>,
    ) -> Result<T, String> {
        let value = self.find(key).ok_or_else(|| self.error(&format!("{key} is missing")))?;
        take(value).ok_or_else(|| self.error(&format!("{key} is no {what}")))
    }

    pub(crate) fn text(&self, key: &str) -> Result<String, String> {
        self.get(key, "text", |value| value.as_str().map(str::to_owned))
    }

    pub(crate) fn text_or_empty(&self, key: &str) -> Result<String, String> {
        if self.has(key) { self.text(key) } else { Ok(String::new()) }
    }

    pub(crate) fn flag(&self, key: &str) -> Result<bool, String> {
        self.get(key, "true or false", DeValue::as_bool)
    }

    pub(crate) fn float(&self, key: &str) -> Result<f64, String> {
        let number = self.get(key, "number", number)?;
        if number.is_finite() {
            Ok(number)
        } else {
            Err(self.error(&format!("{key} is not finite")))
        }
    }

    pub(crate) fn texts(&self, key: &str) -> Result<Vec<String>, String> {
        self.get(key, "list of texts", |value| {
            let items = value.as_array()?.iter();
            items.map(|item| item.get_ref().as_str().map(str::to_owned)).collect()
        })
    }

    /// Reads a list of pairs of numbers.
    pub(crate) fn pairs(&self, key: &str) -> Result<Vec<[f64; 2]>, String> {
        self.get(key, "list of pairs of numbers", |value| {
            let pairs = value.as_array()?.iter().map(|item| {
                let [x, y] = two(item.get_ref())?;
                Some([number(x)?, number(y)?])
            });
            pairs.collect()
        })
    }

    /// Reads a list of pairs of a number and a text.
    pub(crate) fn named_places(&self, key: &str) -> Result<Vec<(f64, String)>, String> {
        self.get(key, "list of pairs of a number and a name", |value| {
            let pairs = value.as_array()?.iter().map(|item| {
                let [x, name] = two(item.get_ref())?;
                Some((number(x)?, name.as_str()?.to_owned()))
            });
            pairs.collect()
        })
    }

    /// Reads the tables of an array of tables, each named by its case; none if the key is missing.
    pub(crate) fn tables(&self, key: &str) -> Result<Vec<Table<'t, 'i>>, String> {
        if !self.has(key) {
            return Ok(Vec::new());
        }
        self.get(key, "array of tables", |value| {
            let tables = value.as_array()?.iter().map(Spanned::get_ref).map(|item| {
                let table = item.as_table()?;
                let unnamed = Table { name: key.to_owned(), table };
                let named = unnamed.text("case").or_else(|_| unnamed.text("name"));
                let name = named.unwrap_or(unnamed.name);
                Some(Table { name, table })
            });
            tables.collect()
        })
    }
}

/// Reads a number, which may be an integer or a float.
fn number(value: &DeValue<'_>) -> Option<f64> {
    match value {
        DeValue::Integer(integer) => integer.as_str().parse::<f64>().ok(),
        DeValue::Float(float) => float.as_str().parse().ok(),
        _ => None,
    }
}

/// Returns the two values of a list that has exactly two.
fn two<'v, 'i>(value: &'v DeValue<'i>) -> Option<[&'v DeValue<'i>; 2]> {
    let values: Vec<&DeValue<'i>> = value.as_array()?.iter().map(Spanned::get_ref).collect();
    values.try_into().ok()
}
