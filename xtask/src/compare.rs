//! Compares result files, byte for byte or number by number.

use std::collections::BTreeSet;
use std::ffi::OsString;
use std::path::Path;

/// Tolerance for equal numbers, relative to the largest number of their column. Two correct programs agree to this
/// tolerance (`validation/independent/README.md` has the measurement).
const SAME: f64 = 1e-9;

/// Checks that two folders hold the same files with the same bytes.
///
/// # Errors
/// Fails with the first difference between the folders, or for a folder that is empty or cannot be read.
pub(crate) fn same_bytes(one: &Path, two: &Path) -> Result<(), String> {
    let (names, others) = (names(one)?, names(two)?);
    if names.is_empty() || names != others {
        return Err(format!("{} holds {names:?}, {} {others:?}", one.display(), two.display()));
    }
    for name in names {
        let (first, second) = (one.join(&name), two.join(&name));
        let read =
            |path: &Path| std::fs::read(path).map_err(|e| format!("{}: {e}", path.display()));
        let (bytes, others) = (read(&first)?, read(&second)?);
        if bytes != others {
            let same = bytes.iter().zip(&others).take_while(|(a, b)| a == b).count();
            let line = bytes[..same].iter().filter(|&&b| b == b'\n').count() + 1;
            let (first, second) = (first.display(), second.display());
            return Err(format!("{first} and {second} differ at byte {same}, in line {line}"));
        }
    }
    Ok(())
}

fn names(folder: &Path) -> Result<BTreeSet<OsString>, String> {
    let unreadable = |e: std::io::Error| format!("{}: {e}", folder.display());
    let entries = std::fs::read_dir(folder).map_err(unreadable)?;
    entries.map(|entry| entry.map(|e| e.file_name()).map_err(unreadable)).collect()
}

/// Checks that two tables (CSV without quoted cells) hold the same text, and the same numbers to within [`SAME`].
///
/// # Errors
/// Fails with the first difference between the tables, or for a file that cannot be read.
pub(crate) fn same_numbers(one: &Path, two: &Path) -> Result<(), String> {
    let read =
        |path: &Path| std::fs::read_to_string(path).map_err(|e| format!("{}: {e}", path.display()));
    compare_tables(&read(one)?, &read(two)?)
        .map_err(|e| format!("{} and {}: {e}", one.display(), two.display()))
}

fn compare_tables(one: &str, two: &str) -> Result<(), String> {
    let cells = |text: &str| -> Vec<Vec<String>> {
        text.lines().map(|line| line.split(',').map(str::to_owned).collect()).collect()
    };
    let (first, second) = (cells(one), cells(two));
    if first.len() != second.len() {
        return Err(format!("{} and {} lines", first.len(), second.len()));
    }
    let number = |cell: &String| cell.parse::<f64>().ok();
    let largest_of = |column: usize| {
        let column = first.iter().filter_map(|row| row.get(column).and_then(number));
        column.fold(0.0, |largest, v| if v.abs() > largest { v.abs() } else { largest })
    };
    let columns = first.first().map_or(0, Vec::len);
    let largest: Vec<f64> = (0..columns).map(largest_of).collect();
    for (line, (row, other)) in (1..).zip(first.iter().zip(&second)) {
        if row.len() != columns || other.len() != columns {
            return Err(format!("line {line} has {} and {} cells", row.len(), other.len()));
        }
        for (column, (cell, its)) in row.iter().zip(other).enumerate() {
            let same = match (number(cell), number(its)) {
                (Some(a), Some(b)) => (a - b).abs() <= SAME * largest[column],
                _ => cell == its,
            };
            if !same {
                return Err(format!("line {line}, column {}: {cell} and {its}", column + 1));
            }
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::compare_tables;

    #[test]
    fn numbers_may_differ_by_rounding_and_text_may_not() {
        let table = "t_s,state,force_n\n0.1,slip,2e6\n0.2,stick,0\n";
        assert_eq!(compare_tables(table, table), Ok(()));
        assert_eq!(compare_tables(table, &table.replace("2e6", "2000000.001")), Ok(()));
        assert_eq!(compare_tables(table, &table.replace("stick,0", "stick,1e-4")), Ok(()));
        for (from, to) in
            [("2e6", "2000000.1"), ("stick", "slip"), ("0.2,stick,0\n", ""), (",0\n", "\n")]
        {
            assert!(compare_tables(table, &table.replace(from, to)).is_err(), "{from} {to}");
        }
    }
}
