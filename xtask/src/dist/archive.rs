//! Packs folders into archives with fixed times and owners: the same content gives the same bytes.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::command::run_quietly;
use crate::tools;

/// A Python program that writes a zip file whose files have times of 1980, the earliest that the format knows.
const ZIP: &str = "\
import sys, zipfile
from pathlib import Path
folder, out = Path(sys.argv[1]), sys.argv[2]
with zipfile.ZipFile(out, 'w', zipfile.ZIP_DEFLATED) as archive:
    for file in sorted(path for path in folder.rglob('*') if path.is_file()):
        info = zipfile.ZipInfo(str(file.relative_to(folder.parent).as_posix()), (1980, 1, 1, 0, 0, 0))
        info.compress_type, info.external_attr = zipfile.ZIP_DEFLATED, 0o644 << 16
        archive.writestr(info, file.read_bytes())
";

/// A Python program that writes a tar file whose files have times of 1970 and no owner. Links stay links.
const TAR: &str = "\
import gzip, sys, tarfile
from pathlib import Path
folder, out = Path(sys.argv[1]), sys.argv[2]
def plain(info):
    info.uid = info.gid = info.mtime = 0
    info.uname = info.gname = ''
    return info
with open(out, 'wb') as file, gzip.GzipFile('', 'wb', 9, file, 0) as packed:
    with tarfile.open(fileobj=packed, mode='w', format=tarfile.GNU_FORMAT) as archive:
        archive.add(folder, folder.name, filter=plain)
";

/// Packs a folder into a file beside it, for Windows into `FOLDER.zip`, otherwise into `FOLDER.tar.gz`. Returns the
/// archive.
///
/// # Errors
/// A failure of Python.
pub(super) fn pack(folder: &Path, as_zip: bool) -> Result<PathBuf, String> {
    let name = folder.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let within = folder.parent().unwrap_or(Path::new(""));
    let archive = within.join(format!("{name}.{}", if as_zip { "zip" } else { "tar.gz" }));
    let python = tools::python().map_err(|missing| format!("{} is missing", missing.tool))?;
    let script = if as_zip { ZIP } else { TAR };
    run_quietly(Command::new(python).args(["-c", script]).arg(folder).arg(&archive))?;
    Ok(archive)
}
