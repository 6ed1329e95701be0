//! The data files that the program carries in itself: name and text of each. `build.rs` lists them.

include!(concat!(env!("OUT_DIR"), "/data_files.rs"));
