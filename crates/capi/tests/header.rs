//! `include/fenderline.h` is generated from this crate by cbindgen. After a change:
//! `FENDERLINE_BLESS=1 cargo test -p fenderline-capi --test all header::`.

use std::path::Path;

/// In the order of the header.
const SOURCES: [&str; 9] = [
    "library.rs",
    "failure.rs",
    "types.rs",
    "table.rs",
    "outline.rs",
    "builder.rs",
    "engine.rs",
    "drawing.rs",
    "dump.rs",
];

#[test]
fn the_header_is_up_to_date() {
    let own = Path::new(env!("CARGO_MANIFEST_DIR"));
    let file = own.join("../../include/fenderline.h");
    let mut config =
        cbindgen::Config::from_file(own.join("cbindgen.toml")).expect("a good configuration");
    let preamble = std::fs::read_to_string(own.join("preamble.h")).expect("it is there");
    config.header = Some(preamble.trim_end().to_owned());
    let builder = SOURCES
        .into_iter()
        .fold(cbindgen::Builder::new().with_config(config), |builder, source| {
            builder.with_src(own.join("src").join(source))
        });
    let mut made = Vec::new();
    builder.generate().expect("a header").write(&mut made);
    let made = String::from_utf8(made).expect("UTF-8");
    if std::env::var_os("FENDERLINE_BLESS").is_some() {
        std::fs::write(&file, &made).expect("it can be written");
    }
    let committed = std::fs::read_to_string(&file).unwrap_or_default();
    assert!(
        committed == made,
        "include/fenderline.h is out of date: FENDERLINE_BLESS=1 cargo test -p fenderline-capi \
         --test all header::"
    );
}
