//! The names and texts of the data files that are built into the program. `build.rs` lists these files.

include!(concat!(env!("OUT_DIR"), "/data_files.rs"));
