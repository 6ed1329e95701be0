//! The built-in data files: name and text of each. `build.rs` lists them.

include!(concat!(env!("OUT_DIR"), "/data_files.rs"));
