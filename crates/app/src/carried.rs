//! The FMU libraries that the build script has put into this program.

include!(concat!(env!("OUT_DIR"), "/fmu_libraries.rs"));

/// Platforms for which this program carries a library, by their names in FMI 3.0.
pub(crate) fn platforms() -> Vec<&'static str> {
    EMBEDDED.iter().map(|(platform, _)| *platform).collect()
}
