//! Builds programs that use the C interface, with all warnings as errors.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::built;
use crate::command::{run, run_quietly};

pub(crate) const WARNINGS: [&str; 4] = ["-Wall", "-Wextra", "-Werror", "-pedantic"];

pub(crate) const SANITIZERS: [&str; 2] =
    ["-fsanitize=address,undefined", "-fno-sanitize-recover=all"];

/// System libraries with which the static library must be linked.
pub(crate) const SYSTEM: [&str; 3] = ["-lpthread", "-ldl", "-lm"];

/// The C library that was built, and a folder for programs.
pub(crate) struct Build {
    pub(crate) folder: PathBuf,
    pub(crate) library: PathBuf,
}

impl Build {
    /// Builds the library, optimised.
    pub(crate) fn new(what: &str) -> Result<Build, String> {
        run(&mut built::build("release", &["--lib"]))?;
        let library = built::folder("release").join("libfenderline.a");
        let name = format!("fenderline-c-{what}-{}", std::process::id());
        let folder = std::env::temp_dir().join(name);
        std::fs::create_dir_all(&folder).map_err(|e| format!("{}: {e}", folder.display()))?;
        Ok(Build { folder, library })
    }

    /// Compiles a C file to a program, with `options`; if none are given, against the shared library.
    pub(crate) fn compile(
        &self,
        name: &str,
        source: &Path,
        options: &[&str],
    ) -> Result<PathBuf, String> {
        let program = self.folder.join(name);
        let mut cc = Command::new("cc");
        cc.args(["-std=c99", "-g"]).args(WARNINGS).args(options).arg("-Iinclude").arg(source);
        if options.is_empty() {
            let folder = self.library.parent().unwrap_or(Path::new(""));
            cc.arg("-L").arg(folder).arg(format!("-Wl,-rpath,{}", folder.display()));
            cc.arg("-lfenderline");
        } else {
            cc.arg(&self.library).args(SYSTEM);
        }
        run_quietly(cc.arg("-o").arg(&program))?;
        Ok(program)
    }

    /// The shared library exports the header's functions and nothing else.
    pub(crate) fn exports(&self) -> Result<(), String> {
        let shared = self.library.with_extension("so");
        let listed = run_quietly(Command::new("nm").args(["-D", "--defined-only"]).arg(&shared))?;
        let mut exported: Vec<&str> =
            listed.lines().filter_map(|line| line.split_whitespace().nth(2)).collect();
        exported.sort_unstable();
        let header = std::fs::read_to_string("include/fenderline.h")
            .map_err(|e| format!("include/fenderline.h: {e}"))?;
        // A declaration begins a line; comments do not.
        let declared = header.lines().filter(|line| {
            line.starts_with(|c: char| c.is_alphabetic()) && !line.starts_with("static inline")
        });
        let name =
            |line: &'_ str| Some(line.split_once('(')?.0.rsplit([' ', '*']).next()?.to_owned());
        let mut declared: Vec<String> =
            declared.filter_map(name).filter(|name| name.starts_with("fl_")).collect();
        declared.sort_unstable();
        if exported != declared {
            return Err(format!("exported: {exported:?}\ndeclared: {declared:?}"));
        }
        println!(
            "the library exports {} functions, which are all of the header, and no other symbol",
            exported.len()
        );
        Ok(())
    }

    pub(crate) fn remove(&self) -> Result<(), String> {
        std::fs::remove_dir_all(&self.folder).map_err(|e| format!("{}: {e}", self.folder.display()))
    }
}
