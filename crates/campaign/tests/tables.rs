//! Tables from files: text and Parquet, units, empty cells, and what is refused.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use fenderline_campaign::table::{Head, Table, TableFault};
use parquet::data_type::{BoolType, ByteArray, ByteArrayType, DoubleType, Int32Type};
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::parser::parse_message_type;

/// A file that is removed at the end.
struct Place(PathBuf);

impl Place {
    fn with(name: &str, bytes: &[u8]) -> Place {
        let path = std::env::temp_dir().join(format!("fenderline-{}-{name}", std::process::id()));
        std::fs::write(&path, bytes).unwrap();
        Place(path)
    }

    fn table(&self) -> Table {
        Table::open(&self.0).unwrap()
    }
}

impl Drop for Place {
    fn drop(&mut self) {
        let _ = std::fs::remove_file(&self.0);
    }
}

#[test]
fn a_text_has_units_numbers_texts_and_empty_cells() {
    let place = Place::with(
        "a.csv",
        "\u{feff}energy [kJ],verdict\n1.5,ok\n,failed\nNaN,ok\n2,ok\n".as_bytes(),
    );
    let table = place.table();
    let heads: Vec<String> = table.heads().iter().map(Head::title).collect();
    assert_eq!(heads, ["energy [kJ]", "verdict"]);
    let numbers = table.numbers("energy").unwrap();
    assert_eq!((numbers.values.len(), numbers.missing), (4, 2));
    assert_eq!(numbers.present(), [1.5, 2.0]);
    assert_eq!(table.numbers("energy [kJ]").unwrap().present(), [1.5, 2.0]);
    let texts = table.texts("verdict").unwrap();
    assert_eq!(texts.counts(), [("ok", 3), ("failed", 1)]);
    assert_eq!(texts.get(1), Some("failed"));
}

#[test]
fn semicolons_come_with_decimal_commas_and_tabs_without() {
    let place = Place::with("b.csv", b"speed [cm/s];ship\r\n7,1;a\r\n4.5;b\r\n");
    assert_eq!(place.table().numbers("speed").unwrap().present(), [7.1, 4.5]);
    let place = Place::with("c.csv", b"speed\tship\n7.1\ta\n");
    assert_eq!(place.table().numbers("speed").unwrap().present(), [7.1]);
}

#[test]
fn a_table_of_an_older_program_is_read() {
    // Latin-1, a unit in round brackets.
    let place = Place::with("n.csv", b"ship;speed (cm/s)\nBj\xf6rn;4,8\nBora;6,6\n");
    let table = place.table();
    assert_eq!(table.head("speed").unwrap().unit, "cm/s");
    assert_eq!(table.numbers("speed").unwrap().values, [4.8, 6.6]);
    assert_eq!(table.texts("ship").unwrap().get(0), Some("Björn"));
}

#[test]
fn mistakes_name_the_line_the_column_and_the_nearest_name() {
    let place = Place::with("d.csv", b"speed,ship\n7.1,a\nfast,b\n");
    let table = place.table();
    let text = table.numbers("speed").unwrap_err().to_string();
    assert!(text.contains("d.csv:3: column `speed`: `fast` is not a number"), "{text}");
    let text = table.numbers("sped").unwrap_err().to_string();
    assert!(text.contains("no column `sped`; did you mean `speed`?"), "{text}");
    let text = table.numbers("energy").unwrap_err().to_string();
    assert!(text.contains("the columns are speed, ship"), "{text}");
    let place = Place::with("e.csv", b"7.1\n4.5\n");
    let text = Table::open(&place.0).unwrap_err().to_string();
    assert!(
        text.contains("e.csv:1: `7.1` is a number: the first line must name the columns"),
        "{text}"
    );
    let place = Place::with("f.csv", b"");
    assert!(matches!(
        Table::open(&place.0).unwrap_err().fault,
        TableFault::NoHead { number: None }
    ));
    let place = Place::with("g.csv", b"a,a\n1,2\n");
    assert!(matches!(Table::open(&place.0).unwrap_err().fault, TableFault::TwoOfOneName { .. }));
    let place = Place::with("h.csv", b"a,b\n1,2\n3\n");
    let text = place.table().numbers("a").unwrap_err().to_string();
    assert!(text.contains("h.csv:3: the row has 1 cells, but the file has 2 columns"), "{text}");
    let text = Table::open(Path::new("/no/such.csv")).unwrap_err().to_string();
    assert!(text.starts_with("cannot read /no/such.csv"), "{text}");
}

#[test]
fn a_parquet_file_has_its_units_in_its_metadata() {
    let path = std::env::temp_dir().join(format!("fenderline-{}-i.parquet", std::process::id()));
    let schema = "message t { REQUIRED DOUBLE energy; OPTIONAL DOUBLE load; REQUIRED BYTE_ARRAY verdict (STRING); REQUIRED BOOLEAN met; REQUIRED INT32 touched; }";
    let fact =
        KeyValue::new("fenderline.column.energy".to_owned(), "kJ; largest energy".to_owned());
    let properties = WriterProperties::builder().set_key_value_metadata(Some(vec![fact])).build();
    let file = std::fs::File::create(&path).unwrap();
    let schema = Arc::new(parse_message_type(schema).unwrap());
    let mut writer = SerializedFileWriter::new(file, schema, Arc::new(properties)).unwrap();
    // More rows than are read at once, in two row groups.
    const ROWS: usize = 20_000;
    for group in 0..2 {
        let mut rows = writer.next_row_group().unwrap();
        let value = |row: usize| if row == 7 { f64::NAN } else { (group * ROWS + row) as f64 };
        let energies: Vec<f64> = (0..ROWS).map(value).collect();
        let mut column = rows.next_column().unwrap().unwrap();
        column.typed::<DoubleType>().write_batch(&energies, None, None).unwrap();
        column.close().unwrap();
        let levels: Vec<i16> = (0..ROWS).map(|row| i16::from(row % 2 == 0)).collect();
        let loads: Vec<f64> = (0..ROWS).step_by(2).map(|row| row as f64).collect();
        let mut column = rows.next_column().unwrap().unwrap();
        column.typed::<DoubleType>().write_batch(&loads, Some(&levels), None).unwrap();
        column.close().unwrap();
        let words: Vec<ByteArray> = (0..ROWS)
            .map(|row| ByteArray::from(if row % 4 == 0 { "ok" } else { "over" }))
            .collect();
        let mut column = rows.next_column().unwrap().unwrap();
        column.typed::<ByteArrayType>().write_batch(&words, None, None).unwrap();
        column.close().unwrap();
        let mut column = rows.next_column().unwrap().unwrap();
        column.typed::<BoolType>().write_batch(&vec![true; ROWS], None, None).unwrap();
        column.close().unwrap();
        let mut column = rows.next_column().unwrap().unwrap();
        column.typed::<Int32Type>().write_batch(&vec![3; ROWS], None, None).unwrap();
        column.close().unwrap();
        rows.close().unwrap();
    }
    writer.close().unwrap();
    let table = Table::open(&path).unwrap();
    let head = table.head("energy").unwrap();
    assert_eq!((head.unit.as_str(), head.meaning.as_str()), ("kJ", "largest energy"));
    let energy = table.numbers("energy").unwrap();
    assert_eq!((energy.values.len(), energy.missing), (2 * ROWS, 2));
    assert_eq!(energy.values[ROWS + 8], (ROWS + 8) as f64);
    let load = table.numbers("load").unwrap();
    assert_eq!((load.values.len(), load.missing), (2 * ROWS, ROWS));
    assert_eq!((load.values[4], load.values[5].is_nan()), (4.0, true));
    assert_eq!(
        table.texts("verdict").unwrap().counts(),
        [("over", 3 * ROWS / 2), ("ok", ROWS / 2)]
    );
    assert_eq!(table.numbers("met").unwrap().values[0], 1.0);
    assert_eq!(table.numbers("touched").unwrap().values[1], 3.0);
    assert!(matches!(
        table.numbers("verdict").unwrap_err().fault,
        TableFault::NotANumber { line: 1, .. }
    ));
    std::fs::remove_file(&path).unwrap();
}
