//! Cells and heads of a campaign's table.

/// A cell.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    /// Words.
    Text(String),
    /// A finite number.
    Number(f64),
    /// An empty cell: the value is not known, or the run was not made.
    Empty,
}

impl Cell {
    /// The cell of a number; empty if the number is not finite.
    #[must_use]
    pub fn of_number(value: f64) -> Cell {
        if value.is_finite() { Cell::Number(value) } else { Cell::Empty }
    }

    /// The number of a cell, if it holds a number.
    #[must_use]
    pub fn number(&self) -> Option<f64> {
        match self {
            Cell::Number(value) => Some(*value),
            Cell::Text(_) | Cell::Empty => None,
        }
    }

    /// The cell as text; a number has the shortest form that reads back to the same value.
    #[must_use]
    pub fn shown(&self) -> String {
        match self {
            Cell::Text(text) => text.clone(),
            Cell::Number(value) => format!("{value}"),
            Cell::Empty => String::new(),
        }
    }
}

/// Name, unit and meaning of a column.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Head {
    /// Name.
    pub name: String,
    /// Unit of the column; empty if it has none.
    pub unit: String,
    /// Meaning of the column.
    pub meaning: String,
    /// Whether the cells of the column are words.
    pub is_text: bool,
}

impl Head {
    /// The head of a column of numbers.
    #[must_use]
    pub fn new(name: &str, unit: &str, meaning: &str) -> Head {
        Head {
            name: name.to_owned(),
            unit: unit.to_owned(),
            meaning: meaning.to_owned(),
            is_text: false,
        }
    }

    /// The head of a column of words.
    #[must_use]
    pub fn of_text(name: &str, meaning: &str) -> Head {
        Head { is_text: true, ..Head::new(name, "", meaning) }
    }
}

/// A row: one run.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Number of the run, from 0.
    pub run: u64,
    /// The cells of the run, one for each column.
    pub cells: Vec<Cell>,
}
