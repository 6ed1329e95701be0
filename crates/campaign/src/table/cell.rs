//! Reads one cell of a text table as a number.

/// The number of a cell; NaN for a missing number. With `decimal_comma` a comma stands for the decimal point.
///
/// # Errors
/// Fails if the cell is neither a finite number nor missing.
pub(super) fn number(cell: &str, decimal_comma: bool) -> Result<f64, ()> {
    let cell = cell.trim();
    match cell {
        "" | "NaN" | "nan" | "NA" | "N/A" | "n/a" => return Ok(f64::NAN),
        "true" | "True" | "TRUE" => return Ok(1.0),
        "false" | "False" | "FALSE" => return Ok(0.0),
        _ => {}
    }
    let swapped = (decimal_comma && !cell.contains('.')).then(|| cell.replace(',', "."));
    let value: f64 = swapped.as_deref().unwrap_or(cell).parse().map_err(|_| ())?;
    if value.is_finite() { Ok(value) } else { Err(()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cell_is_a_number_missing_or_refused() {
        assert_eq!(number(" 7.1 ", false), Ok(7.1));
        assert_eq!(number("7,1", true), Ok(7.1));
        assert_eq!(number("-1e-3", false), Ok(-1e-3));
        assert!(
            number("", false).is_ok_and(f64::is_nan) && number("NaN", false).is_ok_and(f64::is_nan)
        );
        for refused in ["7,1", "seven", "inf", "1e999", "7.1 cm/s", "1.000,5"] {
            assert_eq!(number(refused, false), Err(()), "{refused}");
        }
        assert_eq!(number("1.000,5", true), Err(()));
    }
}
