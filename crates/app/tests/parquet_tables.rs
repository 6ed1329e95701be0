//! The parquet tables hold what the csv tables hold, with units and meanings in their metadata.

use crate::support;

use std::collections::BTreeMap;
use std::fs::File;

use parquet::basic::Type;
use parquet::file::reader::{FileReader as _, SerializedFileReader};
use parquet::record::Field;

use support::Workplace;

struct Table {
    columns: Vec<(String, Type)>,
    rows: Vec<Vec<Field>>,
    metadata: BTreeMap<String, String>,
    groups: usize,
}

fn read(place: &Workplace, name: &str) -> Table {
    let file = File::open(place.path(name)).expect("the file is there");
    let reader = SerializedFileReader::new(file).expect("it is parquet");
    let meta = reader.metadata().file_metadata();
    let columns = meta.schema_descr().columns().iter();
    let columns = columns.map(|c| (c.name().to_owned(), c.physical_type())).collect();
    let metadata = meta.key_value_metadata().into_iter().flatten();
    let metadata = metadata
        .map(|entry| (entry.key.clone(), entry.value.clone().unwrap_or_default()))
        .collect();
    let rows = reader.get_row_iter(None).expect("rows");
    let rows = rows
        .map(|row| row.expect("a row").get_column_iter().map(|(_, f)| f.clone()).collect())
        .collect();
    Table { columns, rows, metadata, groups: reader.num_row_groups() }
}

fn assert_same(field: &Field, text: &str) {
    match field {
        // Not known.
        Field::Double(value) if text.is_empty() => assert!(value.is_nan(), "{value}"),
        Field::Double(value) => {
            let parsed: f64 = text.parse().expect("a number");
            assert_eq!(value.to_bits(), parsed.to_bits(), "{value} against {text}");
        }
        Field::Str(value) => assert_eq!(value, text),
        Field::Bool(value) => assert_eq!(value.to_string(), text),
        Field::Int(value) => assert_eq!(value.to_string(), text),
        other => panic!("a field of an unexpected type: {other:?}"),
    }
}

#[test]
fn both_formats_hold_the_same_values() {
    let place = Workplace::new("both_formats");
    for format in ["csv", "parquet"] {
        let run = place.run(&[
            "run",
            "berth.toml",
            "--allow-failures",
            "--format",
            format,
            "--out",
            format,
        ]);
        assert_eq!(run.code, 0, "{}", run.stderr);
    }
    for name in ["bodies", "contacts", "fenders", "energy"] {
        let table = read(&place, &format!("parquet/{name}.parquet"));
        let mut csv = csv::Reader::from_path(place.path(&format!("csv/{name}.csv"))).expect("csv");
        let header: Vec<String> =
            csv.headers().expect("a header").iter().map(str::to_owned).collect();
        let names: Vec<String> = table.columns.iter().map(|(name, _)| name.clone()).collect();
        assert_eq!(names, header);
        let records: Vec<_> = csv.records().map(|r| r.expect("a record")).collect();
        assert!(!records.is_empty());
        assert_eq!(records.len(), table.rows.len());
        for (record, row) in records.iter().zip(&table.rows) {
            for (text, field) in record.iter().zip(row) {
                assert_same(field, text);
            }
        }
    }
}

#[test]
fn every_column_has_its_unit_and_meaning() {
    let place = Workplace::new("metadata");
    assert_eq!(
        place.run(&["run", "berth.toml", "--allow-failures", "--format", "parquet"]).code,
        0
    );
    for name in ["bodies", "contacts", "fenders", "energy"] {
        let table = read(&place, &format!("out/berth/{name}.parquet"));
        for (column, _) in &table.columns {
            let text = &table.metadata[&format!("fenderline.column.{column}")];
            let (unit, meaning) = text.split_once("; ").expect("unit; meaning");
            assert!(!unit.is_empty() && !meaning.is_empty(), "{column}: {text}");
        }
        assert_eq!(table.metadata["fenderline.title"], "A ship onto two fenders");
        assert_eq!(table.metadata["fenderline.step_s"], "0.1");
    }
    let contacts = read(&place, "out/berth/contacts.parquet");
    assert_eq!(contacts.metadata["fenderline.column.area_m2"], "m²; overlap area S");
    let types: BTreeMap<_, _> = contacts.columns.into_iter().collect();
    assert_eq!(types["t_s"], Type::DOUBLE);
    assert_eq!(types["body_1"], Type::BYTE_ARRAY);
    assert_eq!(types["limited"], Type::BOOLEAN);
    assert_eq!(types["patch"], Type::INT32);
    assert_eq!(types["fender"], Type::BYTE_ARRAY);
}

#[test]
fn a_long_run_is_written_in_groups_of_bounded_size() {
    let place = Workplace::new("groups");
    let args = "run tug.toml --format parquet --step 0.001 --duration 100 --interval 0";
    assert_eq!(place.run(&args.split(' ').collect::<Vec<_>>()).code, 0);
    let bodies = read(&place, "out/tug/bodies.parquet");
    assert_eq!(bodies.rows.len(), 200_000);
    assert_eq!(bodies.groups, 4);
}

#[test]
fn a_run_without_contact_has_an_empty_table_with_all_columns() {
    let place = Workplace::new("no_contact");
    let args = ["run", "tug.toml", "--format", "parquet", "--duration", "0.5"];
    let run = place.run(&args);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert!(run.stdout.contains("no bodies touched"));
    let contacts = read(&place, "out/tug/contacts.parquet");
    assert_eq!((contacts.rows.len(), contacts.columns.len()), (0, 26));
}
