//! `npm/src/quantities.ts` is generated from the catalogue of summary quantities. After a change:
//! `FENDERLINE_BLESS=1 cargo test -p fenderline-wasm --test all quantities::`.

use core::fmt::Write as _;
use std::path::Path;

use fenderline_results::{
    ANCHORS, CHAINS, Catalogue, DOLPHINS, FENDERS, LINES, PAIRS, TUGS, Taken, VESSELS,
};

#[test]
fn the_types_of_the_package_are_up_to_date() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("npm/src/quantities.ts");
    let mut made = "/**\n * The quantities of `summary.json`, generated from the catalogue in `crates/results`:\n \
                    * `FENDERLINE_BLESS=1 cargo test -p fenderline-wasm --test all quantities::`.\n */\n"
        .to_owned();
    add(&mut made, &ANCHORS);
    add(&mut made, &CHAINS);
    add(&mut made, &DOLPHINS);
    add(&mut made, &FENDERS);
    add(&mut made, &LINES);
    add(&mut made, &PAIRS);
    add(&mut made, &TUGS);
    add(&mut made, &VESSELS);
    if std::env::var_os("FENDERLINE_BLESS").is_some() {
        std::fs::write(&file, &made).expect("it can be written");
    }
    let committed = std::fs::read_to_string(&file).unwrap_or_default();
    assert!(
        committed == made,
        "npm/src/quantities.ts is out of date: FENDERLINE_BLESS=1 cargo test -p fenderline-wasm \
         --test all quantities::"
    );
}

/// The interface of one kind of part. A key that not every part has is optional.
fn add<S, T>(made: &mut String, catalogue: &Catalogue<S, T>) {
    let (first, rest) = catalogue.subject.split_at(1);
    let _ = writeln!(made, "\n/** Of one {first}{rest}. */");
    let _ = writeln!(made, "export interface {}{rest}Quantities {{", first.to_uppercase());
    for of in catalogue.quantities.iter().filter(|of| of.is_in_summary) {
        let (mark, kind) = match of.value {
            Taken::Number(_) => ("", "number"),
            Taken::Known(_) | Taken::Given(_) => ("?", "number"),
            Taken::Flag(_) => ("", "boolean"),
            Taken::Word(_) => ("?", "string"),
        };
        let unit = if of.unit == "-" { String::new() } else { format!(" [{}]", of.unit) };
        let _ = writeln!(made, "  /** {}{unit} */\n  {}{mark}: {kind};", of.meaning, of.name);
    }
    made.push_str("}\n");
}
