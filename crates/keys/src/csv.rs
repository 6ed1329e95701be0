//! Reads comma-separated files of numbers with one header line of column names. The reader of these files skips empty
//! lines and lines that begin with `#`. Every mistake in a file is an error that names the line of the mistake.

use crate::error::{Place, ScenarioError};
use crate::printable::printable_number;
use crate::sources::{Sources, Span, quoted};
use crate::suggest::nearest;

type Read<T> = Result<T, ScenarioError>;

/// A file of numbers in columns, after it was read.
pub struct Csv<'a> {
    sources: Sources<'a>,
    /// The key of the scenario under which the file is named.
    key: &'a str,
    header: Span,
    columns: Vec<&'a str>,
    rows: Vec<Row>,
}

/// How a file of another program is laid out.
#[derive(Clone, Copy, Debug, Default)]
pub struct Layout<'a> {
    /// Number of lines at the top of the file that are not read.
    pub skip_lines: usize,
    /// Names of the columns, for a file without a line of column names; [`NOT_READ`] for a column to skip.
    pub columns: Option<&'a [String]>,
}

/// The name that marks a column of a file as a column to skip.
pub const NOT_READ: &str = "-";

/// What separates the cells of a line: a character or blanks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Separator {
    Char(char),
    Blanks,
}

impl Separator {
    /// The separator of the cells in a line of a file from another program.
    fn of(line: &str) -> Separator {
        let found = [';', '\t', ','].into_iter().find(|c| line.contains(*c));
        found.map_or(Separator::Blanks, Separator::Char)
    }
}

/// One row of numbers of a file.
struct Row {
    numbers: Vec<f64>,
    cells: Vec<Span>,
}

/// The rows of a file as a full grid: each combination of the values on the axes has one row.
#[derive(Debug)]
pub struct Grid {
    /// The values on each axis of the grid, in rising order.
    pub axes: Vec<Vec<f64>>,
    /// Indices of the file's rows in the order of the grid, in which the value on the last axis changes fastest.
    pub rows: Vec<usize>,
}

impl<'a> Csv<'a> {
    /// Reads a file's text. `known` lists the columns that the file may have.
    ///
    /// # Errors
    /// Fails if the file has no header, an unknown or repeated column, or no rows, if a row has too many or too few
    /// numbers, or if a cell is not a finite number.
    pub fn parse(text: &'a str, file_name: &'a str, key: &'a str, known: &[&str]) -> Read<Csv<'a>> {
        let sources = Sources::new(file_name, text, &[]);
        let mut lines = lines(text, 0, Separator::Char(','));
        let Some((header, cells)) = lines.next() else {
            return Err(no_header(&sources, known));
        };
        Csv::read(sources, (key, known, false), (header, cells), lines)
    }

    /// Reads the text of a file of another program as [`Csv::parse`] does, but the cells may be separated by
    /// semicolons, tabs, commas or blanks. The numbers may have a decimal comma if commas do not separate the cells.
    ///
    /// # Errors
    /// Fails like [`Csv::parse`].
    pub fn parse_laid_out(
        text: &'a str,
        file_name: &'a str,
        key: &'a str,
        known: &[&str],
        layout: Layout<'a>,
    ) -> Read<Csv<'a>> {
        let sources = Sources::new(file_name, text, &[]);
        let whole = lines(text, layout.skip_lines, Separator::Char('\n')).next();
        let Some((first, _)) = whole else {
            return Err(no_header(&sources, known));
        };
        let separator = Separator::of(&text[first.clone()]);
        let mut lines = lines(text, layout.skip_lines, separator);
        let header = match layout.columns {
            Some(names) => names.iter().map(|name| (name.as_str(), first.clone())).collect(),
            None => lines.next().map_or(Vec::new(), |(_, cells)| cells),
        };
        Csv::read(sources, (key, known, layout.columns.is_some()), (first, header), lines)
    }

    fn read(
        sources: Sources<'a>,
        (key, known, may_skip): (&'a str, &[&str], bool),
        (header, cells): (Span, Vec<(&'a str, Span)>),
        lines: impl Iterator<Item = (Span, Vec<(&'a str, Span)>)>,
    ) -> Read<Csv<'a>> {
        let mut columns: Vec<&str> = Vec::new();
        for (name, span) in cells {
            if may_skip && name == NOT_READ {
                columns.push(name);
                continue;
            }
            if !known.contains(&name) {
                let message = format!("{} is not a column of this kind of file", quoted(name));
                return Err(sources.error(&span, key, message).with_help(
                    match nearest(name, known.iter().copied()) {
                        Some(near) => format!("did you mean `{near}`?"),
                        None => format!("there are {}", known.join(", ")),
                    },
                ));
            }
            if columns.contains(&name) {
                return Err(sources.error(
                    &span,
                    key,
                    format!("the column `{name}` is given twice"),
                ));
            }
            columns.push(name);
        }
        let mut rows = Vec::new();
        for (line, cells) in lines {
            if cells.len() != columns.len() {
                let message = format!(
                    "the row has {} numbers, but the header has {} columns",
                    cells.len(),
                    columns.len()
                );
                return Err(sources.error(&line, key, message));
            }
            let mut row = Row { numbers: Vec::new(), cells: Vec::new() };
            for ((text, span), column) in cells.into_iter().zip(&columns) {
                if *column == NOT_READ {
                    row.numbers.push(0.0);
                    row.cells.push(span);
                    continue;
                }
                let number = text.parse::<f64>().or_else(|_| text.replacen(',', ".", 1).parse());
                let number = number.ok().filter(|number| number.is_finite());
                let Some(number) = number else {
                    let message = if text.is_empty() {
                        format!("`{column}` is empty here")
                    } else {
                        format!("`{column}` is not a finite number here, but {}", quoted(text))
                    };
                    return Err(sources.error(&span, key, message));
                };
                // Adding 0 turns -0 into 0: the two are the same place, but have different bits.
                row.numbers.push(number + 0.0);
                row.cells.push(span);
            }
            rows.push(row);
        }
        if rows.is_empty() {
            return Err(sources.error(&header, key, "the file has no rows below its header"));
        }
        Ok(Csv { sources, key, header, columns, rows })
    }

    /// Number of rows.
    pub fn row_count(&self) -> usize {
        self.rows.len()
    }

    /// Whether the file has the column `column`.
    pub fn has(&self, column: &str) -> bool {
        self.columns.contains(&column)
    }

    /// An error that points to the header line of the file.
    pub fn header_error(&self, message: impl Into<String>) -> ScenarioError {
        self.sources.error(&self.header, self.key, message)
    }

    /// The index of the column `column`, which the file must have.
    ///
    /// # Errors
    /// Fails if the file does not have the column `column`.
    pub fn column(&self, column: &str) -> Read<usize> {
        self.columns
            .iter()
            .position(|known| *known == column)
            .ok_or_else(|| self.header_error(format!("the column `{column}` is missing")))
    }

    /// The number in a cell, which must lie within bounds; both bounds are allowed.
    ///
    /// # Errors
    /// Fails if the number is outside the bounds.
    pub fn number(&self, row: usize, column: usize, [low, high]: [f64; 2]) -> Read<f64> {
        let number = self.rows[row].numbers[column];
        if number >= low && number <= high {
            return Ok(number);
        }
        let name = self.columns[column];
        Err(self.cell_error(
            row,
            column,
            format!(
                "`{name}` must be between {} and {}, but is {}",
                printable_number(low),
                printable_number(high),
                printable_number(number)
            ),
        ))
    }

    /// The number in a cell, without a check of bounds.
    pub fn plain(&self, row: usize, column: usize) -> f64 {
        self.rows[row].numbers[column]
    }

    /// The place of a cell in the file, to be shown in a warning; the place of the header if `cell` is `None`.
    pub fn place_of(&self, cell: Option<(usize, usize)>) -> Place {
        let span = cell.map_or(&self.header, |(row, column)| &self.rows[row].cells[column]);
        self.sources.place(span)
    }

    /// An error that points to one cell of the file.
    pub fn cell_error(&self, row: usize, column: usize, message: String) -> ScenarioError {
        self.sources.error(&self.rows[row].cells[column], self.key, message)
    }

    /// The rows of the file as a full grid over the columns `columns`: each combination of values in these columns has
    /// one row. The rows may stand in the file in any order.
    ///
    /// # Errors
    /// Fails if the file has two rows or no row for a combination of values.
    pub fn grid(&self, columns: &[usize]) -> Read<Grid> {
        let at = |row: usize, axis: usize| self.rows[row].numbers[columns[axis]];
        let axes: Vec<Vec<f64>> = (0..columns.len())
            .map(|axis| {
                let mut values: Vec<f64> = (0..self.rows.len()).map(|row| at(row, axis)).collect();
                values.sort_by(f64::total_cmp);
                values.dedup();
                values
            })
            .collect();
        let mut rows: Vec<usize> = (0..self.rows.len()).collect();
        let compare = |one: usize, other: usize| {
            let each = (0..columns.len()).map(|axis| at(one, axis).total_cmp(&at(other, axis)));
            each.fold(core::cmp::Ordering::Equal, core::cmp::Ordering::then)
        };
        // The sort is stable: of two equal rows, the later row in the file comes second.
        rows.sort_by(|one, other| compare(*one, *other));
        if let Some(two) = rows.windows(2).find(|two| compare(two[0], two[1]).is_eq()) {
            let place = self.place(columns, |axis| at(two[1], axis));
            return Err(self.cell_error(
                two[1],
                columns.first().copied().unwrap_or(0),
                format!("the file has a second row for {place}"),
            ));
        }
        // Sorted rows must count through the values of the axes like digits; a row that does not fit means a missing
        // one.
        let mut digits = vec![0; columns.len()];
        let mut rest = rows.iter();
        loop {
            let row = rest.next();
            let fits = row.is_some_and(|row| {
                (0..columns.len()).all(|axis| at(*row, axis) == axes[axis][digits[axis]])
            });
            if !fits {
                let place = self.place(columns, |axis| axes[axis][digits[axis]]);
                let error = self.header_error(format!("the file has no row for {place}"));
                return Err(error.with_help(
                    "the file needs one row for each combination of the values in these columns",
                ));
            }
            let turns = (0..columns.len()).rev().find(|axis| digits[*axis] + 1 < axes[*axis].len());
            let Some(axis) = turns else { break };
            digits[axis] += 1;
            digits[axis + 1..].fill(0);
        }
        Ok(Grid { axes, rows })
    }

    fn place(&self, columns: &[usize], value: impl Fn(usize) -> f64) -> String {
        let named = columns.iter().enumerate();
        let named: Vec<String> = named
            .map(|(axis, column)| {
                format!("{} = {}", self.columns[*column], printable_number(value(axis)))
            })
            .collect();
        match named.is_empty() {
            true => "all of it".to_owned(),
            false => named.join(", "),
        }
    }
}

fn no_header(sources: &Sources<'_>, known: &[&str]) -> ScenarioError {
    let error = sources.file_error("the file has no header line");
    error.with_help(format!("the header line names columns, which may be {}", known.join(", ")))
}

/// The lines of a text after its first `skip_lines` lines, without empty lines and comments, each line with its cells.
fn lines(
    text: &str,
    skip_lines: usize,
    separator: Separator,
) -> impl Iterator<Item = (Span, Vec<(&str, Span)>)> {
    let mut start = 0;
    // Lines end with LF, CR LF, or CR alone, as old spreadsheets write them. Splitting at both leaves an empty line
    // between CR and LF, which is skipped.
    let all = text.split_inclusive(['\n', '\r']).map(move |line| {
        let from = start;
        start += line.len();
        (from, line.trim_end_matches(['\n', '\r']))
    });
    // Some programs begin a file with a byte order mark.
    let all = all.map(|(from, line)| match line.strip_prefix('\u{feff}') {
        Some(rest) => (from + '\u{feff}'.len_utf8(), rest),
        None => (from, line),
    });
    let skipped = after_lines(text, skip_lines);
    let rows = all.filter(move |(from, line)| {
        *from >= skipped && !line.trim().is_empty() && !line.starts_with('#')
    });
    rows.map(move |(from, line)| {
        let mut at = from;
        let mut placed = |cell: &'_ str, step: usize| {
            let inner = at + (cell.len() - cell.trim_start().len());
            at += cell.len() + step;
            inner..inner + cell.trim().len()
        };
        let cells: Vec<_> = match separator {
            Separator::Char(c) => {
                line.split(c).map(|cell| (cell.trim(), placed(cell, c.len_utf8()))).collect()
            }
            Separator::Blanks => {
                let words = line.split([' ', '\t']).map(|word| (word, placed(word, 1)));
                words.filter(|(word, _)| !word.is_empty()).collect()
            }
        };
        (from..from + line.len(), cells)
    })
}

/// Index of the byte of the text at which the line after the first `count` lines begins.
fn after_lines(text: &str, count: usize) -> usize {
    let mut rest = text;
    for _ in 0..count {
        let Some(end) = rest.find(['\n', '\r']) else { return text.len() };
        let both = if rest[end..].starts_with("\r\n") { 2 } else { 1 };
        rest = &rest[end + both..];
    }
    text.len() - rest.len()
}

#[cfg(test)]
mod tests {
    use super::Csv;

    fn refused(text: &str) -> String {
        let read = Csv::parse(text, "f.csv", "key", &["a", "b", "c"]);
        read.and_then(|csv| csv.grid(&[0, 1]).map(|_| ())).expect_err(text).to_string()
    }

    #[test]
    fn rows_are_sorted_into_the_order_of_the_grid() {
        let text = "\u{feff}# place\na, b ,c\r\n1,10,5\n\n0,20,2\n1,20,6\n# more\n0,10,1\n";
        let csv = Csv::parse(text, "f.csv", "key", &["a", "b", "c"]).unwrap();
        let grid = csv.grid(&[0, 1]).unwrap();
        assert_eq!(grid.axes, [vec![0.0, 1.0], vec![10.0, 20.0]]);
        assert_eq!(grid.rows, [3, 1, 0, 2]);
        assert_eq!(csv.grid(&[]).unwrap_err().line(), Some(5), "all rows are one place");
    }

    #[test]
    fn lines_may_end_with_a_carriage_return_alone() {
        let csv =
            Csv::parse("# old\ra,b,c\r1,2,3\r4,5,6\r", "f.csv", "key", &["a", "b", "c"]).unwrap();
        assert_eq!(csv.row_count(), 2);
        assert_eq!(csv.number(1, 2, [0.0, 9.0]), Ok(6.0));
        let message = refused("a,b,c\r1,2,3\r4,x,6\r");
        assert!(message.contains("f.csv:3:3") && message.contains("4,x,6"), "{message}");
        assert!(!message.contains("1,2,3"), "{message}");
        let message = refused("a,b,c\r\n1,2,3\r\n4,x,6\r\n");
        assert!(message.contains("f.csv:3:3"), "{message}");
    }

    #[test]
    fn each_mistake_is_reported_at_its_line() {
        for (text, fragments) in [
            ("", ["no header line", "f.csv", "f.csv"]),
            ("a,b,d\n", ["\"d\" is not a column", "f.csv:1:5", "^"]),
            ("a,a,b\n", ["`a` is given twice", "f.csv:1:3", "^"]),
            ("a,b,c\n", ["no rows", "f.csv:1:1", "^"]),
            ("a,b,c\n1,2\n", ["2 numbers", "f.csv:2:1", "^"]),
            ("a,b,c\n1,,3\n", ["`b` is empty", "f.csv:2:3", "^"]),
            ("a,b,c\n1,nan,3\n", ["`b` is not a finite number", "f.csv:2:3", "\"nan\""]),
            ("a,b,c\n1,2,1e999\n", ["`c` is not a finite number", "f.csv:2:5", "^"]),
            ("a,b,c\n1,2,3\n1,2,4\n", ["second row for a = 1, b = 2", "f.csv:3:1", "^"]),
            (
                "a,b,c\n1,2,3\n2,3,4\n2,2,4\n",
                ["no row for a = 1, b = 3", "each combination", "f.csv:1"],
            ),
            (
                "a,b,c\n0,0,1\n-0,1,1\n1,0,1\n",
                ["no row for a = 1, b = 1", "each combination", "f.csv:1"],
            ),
        ] {
            let message = refused(text);
            assert!(fragments.iter().all(|fragment| message.contains(fragment)), "{message}");
        }
    }
}
