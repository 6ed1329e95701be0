//! Writes the file of an FMU: a zip archive of model description, libraries and scenario.

use core::fmt;
use std::io::{Cursor, Write as _};

use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

use crate::Fmi;
use crate::description;
use crate::library::{self, Platform};
use crate::plan::Plan;

/// File name of the scenario among the FMU's resources.
pub(crate) const BUNDLE_FILE: &str = "scenario.json";

/// The licence of the libraries in an FMU.
pub(crate) const LICENCE: &str = include_str!("license.txt");

/// An FMU, and the description for the Open Simulation Platform, which is a file beside the FMU.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Packed {
    /// The bytes of the FMU, which are the same for the same scenario, program and libraries.
    pub fmu: Vec<u8>,
    /// File name of the description for the Open Simulation Platform. Masters of the Open Simulation Platform look for
    /// the description with this name in the FMU's folder.
    pub osp_name: String,
    /// The text of the description for the Open Simulation Platform.
    pub osp: String,
}

/// The reason why an FMU cannot be written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PackError(String);

impl fmt::Display for PackError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for PackError {}

/// Packs an FMU with a library for each of some platforms. `stem` is the FMU's file name without extension, and also
/// the model's name.
///
/// # Errors
/// Fails if a file is too large for a zip archive.
pub fn pack(
    plan: &Plan,
    fmi: Fmi,
    stem: &str,
    libraries: &[(Platform, &[u8])],
) -> Result<Packed, PackError> {
    let error = |e: &dyn fmt::Display| PackError(e.to_string());
    let identifier = identifier(stem);
    let description = description::model(plan, fmi, stem, &identifier).map_err(|e| error(&e))?;
    let osp = description::osp(&plan.table).map_err(|e| error(&e))?;
    // A fixed file time: the same scenario gives the same bytes.
    let options = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Deflated)
        .last_modified_time(zip::DateTime::default());
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    let bundle = plan.bundle.to_json();
    let mut files: Vec<(String, &[u8])> = vec![
        ("modelDescription.xml".to_owned(), description.as_bytes()),
        (format!("resources/{BUNDLE_FILE}"), bundle.as_bytes()),
        ("documentation/licenses/license.txt".to_owned(), LICENCE.as_bytes()),
    ];
    let platforms: Vec<Platform> = libraries.iter().map(|(platform, _)| *platform).collect();
    for (platform, library) in libraries {
        files.push((library::place(fmi, *platform, &platforms, &identifier), library));
    }
    for (name, content) in files {
        let rights = if name.starts_with("binaries") { 0o755 } else { 0o644 };
        zip.start_file(name, options.unix_permissions(rights)).map_err(|e| error(&e))?;
        zip.write_all(content).map_err(|e| error(&e))?;
    }
    let fmu = zip.finish().map_err(|e| error(&e))?.into_inner();
    Ok(Packed { fmu, osp_name: format!("{stem}_OspModelDescription.xml"), osp })
}

/// A C identifier.
fn identifier(stem: &str) -> String {
    let fit = |c: char| if c.is_ascii_alphanumeric() { c } else { '_' };
    let name: String = stem.chars().map(fit).collect();
    let begins = name.starts_with(|c: char| c.is_ascii_alphabetic());
    if begins { name } else { format!("fmu_{name}") }
}
