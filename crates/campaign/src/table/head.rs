//! The head of a column.

/// Name, unit and meaning of a column.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Head {
    /// Name without unit.
    pub name: String,
    /// Unit of the column as printed; empty if it has none.
    pub unit: String,
    /// What the column holds; empty if the file does not say.
    pub meaning: String,
}

impl Head {
    /// Reads a head from the head line of a text file: `energy [kJ]` or `energy (kJ)` means the column `energy` in kJ.
    pub(super) fn of_text(text: &str) -> Head {
        let text = text.trim();
        let within = |open, close| text.strip_suffix(close).and_then(|rest| rest.split_once(open));
        let parts = within('[', ']').or_else(|| within('(', ')'));
        let (name, unit) = parts.map_or((text, ""), |(name, unit)| (name.trim(), unit.trim()));
        Head { name: name.to_owned(), unit: unit.to_owned(), meaning: String::new() }
    }

    /// The name of the column with its unit, as in `energy [kJ]`.
    #[must_use]
    pub fn title(&self) -> String {
        match self.unit.as_str() {
            "" => self.name.clone(),
            unit => format!("{} [{unit}]", self.name),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_unit_in_brackets_is_not_part_of_the_name() {
        let parts = |text: &str| {
            let head = Head::of_text(text);
            (head.name.clone(), head.unit.clone(), head.title())
        };
        assert_eq!(parts("energy [kJ]"), ("energy".into(), "kJ".into(), "energy [kJ]".into()));
        assert_eq!(parts("speed (cm/s)"), ("speed".into(), "cm/s".into(), "speed [cm/s]".into()));
        assert_eq!(parts(" energy "), ("energy".into(), String::new(), "energy".into()));
        assert_eq!(parts("a[b"), ("a[b".into(), String::new(), "a[b".into()));
    }
}
