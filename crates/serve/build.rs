//! Embeds the pages of `web` in the program. If the built pages are missing or older than their sources, npm builds
//! them first. The program has the pages compressed with gzip, as `web/scripts/pack.mjs` writes them. Without Node or its packages, the program is built without pages, and says so when it serves.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::SystemTime;

/// Folders in `web` that hold no sources of the live server's pages.
const NOT_SOURCES: [&str; 8] =
    ["node_modules", "dist", "packed", "e2e", "e2e-page", "run", "test", "screenshots"];

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let out = PathBuf::from(std::env::var_os("OUT_DIR").expect("cargo sets OUT_DIR"));
    let web = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../web");
    let list = match built(&web).and_then(|packed| embed(&packed, &out)) {
        Ok(list) => list,
        Err(why) => {
            println!("cargo::warning=no pages in this program: {why}");
            // Node may be installed later, or somebody may build the pages by hand.
            println!("cargo::rerun-if-env-changed=PATH");
            watch(&web.join("dist/index.html"));
            format!(
                "const NO_PAGES: Option<&str> = Some({why:?});\nstatic PAGES: &[(&str, &[u8])] = &[];\n"
            )
        }
    };
    fs::write(out.join("pages.rs"), list).expect("OUT_DIR can be written");
}

fn watch(path: &Path) {
    println!("cargo::rerun-if-changed={}", path.display());
}

/// Builds the pages if they are old, and returns the folder of built and compressed pages.
fn built(web: &Path) -> Result<PathBuf, String> {
    if !web.join("package.json").is_file() {
        return Err("the sources of the pages, the folder `web`, are not beside the crates".into());
    }
    let Ok(entries) = fs::read_dir(web) else { return Err("`web` cannot be read".into()) };
    for entry in entries.flatten() {
        let name = entry.file_name();
        if !NOT_SOURCES.iter().any(|other| name == *other) {
            watch(&entry.path());
        }
    }
    // Builds of two profiles at the same time must not write to the same folders.
    let lock = std::env::temp_dir().join("fenderline-pages.lock");
    let lock = fs::File::create(&lock).map_err(|e| format!("{}: {e}", lock.display()))?;
    lock.lock().map_err(|e| format!("cannot wait for another build of the pages: {e}"))?;
    let (dist, packed) = (web.join("dist"), web.join("packed"));
    if is_up_to_date(web, &dist)
        && is_newer(&packed.join("index.html.gz"), &dist.join("index.html"))
    {
        // Builds again if somebody builds the pages by hand.
        watch(&packed.join("index.html.gz"));
        return Ok(packed);
    }
    if !is_newer(&web.join("node_modules/.package-lock.json"), &web.join("package-lock.json")) {
        // Without a network, npm gives up soon and the build goes on without pages.
        npm(web, &["ci", "--no-audit", "--no-fund", "--fetch-retries=1", "--fetch-timeout=20000"])?;
    }
    npm(web, &["run", "build"])?;
    Ok(packed)
}

/// Copies the built pages and lists them. With the copy, the program keeps the pages with which it was built.
fn embed(packed: &Path, out: &Path) -> Result<String, String> {
    let copy = out.join("pages");
    if copy.exists() {
        fs::remove_dir_all(&copy).map_err(|e| format!("{}: {e}", copy.display()))?;
    }
    let mut list =
        String::from("const NO_PAGES: Option<&str> = None;\nstatic PAGES: &[(&str, &[u8])] = &[\n");
    let mut files = Vec::new();
    copy_folder(packed, &copy, "", &mut files)?;
    files.sort();
    for (path, file) in files {
        let file = file.to_str().expect("the path of the target folder must be Unicode");
        let path = path.strip_suffix(".gz").ok_or(format!("{path} is not compressed"))?;
        writeln!(list, "    ({path:?}, include_bytes!({file:?})),").expect("a string");
    }
    list += "];\n";
    Ok(list)
}

fn copy_folder(
    from: &Path,
    to: &Path,
    under: &str,
    files: &mut Vec<(String, PathBuf)>,
) -> Result<(), String> {
    let failed = |e: std::io::Error| format!("{}: {e}", from.display());
    fs::create_dir_all(to).map_err(failed)?;
    for entry in fs::read_dir(from).map_err(failed)? {
        let entry = entry.map_err(failed)?;
        let name = entry
            .file_name()
            .into_string()
            .map_err(|_| "the name of a page's file is not Unicode")?;
        let (path, copy) = (format!("{under}/{name}"), to.join(&name));
        if entry.file_type().map_err(failed)?.is_dir() {
            copy_folder(&entry.path(), &copy, &path, files)?;
        } else {
            fs::copy(entry.path(), &copy).map_err(failed)?;
            files.push((path, copy));
        }
    }
    Ok(())
}

/// True if no source is newer than the built pages.
fn is_up_to_date(web: &Path, dist: &Path) -> bool {
    let Some(built) = changed(&dist.join("index.html")) else { return false };
    newest(web).is_some_and(|source| source <= built)
}

fn is_newer(file: &Path, than: &Path) -> bool {
    match (changed(file), changed(than)) {
        (Some(file), Some(than)) => file >= than,
        (Some(_), None) => true,
        (None, _) => false,
    }
}

fn changed(path: &Path) -> Option<SystemTime> {
    fs::metadata(path).and_then(|of| of.modified()).ok()
}

/// The time of the last change to a file in a folder of sources.
fn newest(folder: &Path) -> Option<SystemTime> {
    let mut newest_yet = None;
    for entry in fs::read_dir(folder).ok()?.flatten() {
        let name = entry.file_name();
        if NOT_SOURCES.iter().any(|other| name == *other) || name.to_string_lossy().starts_with('.')
        {
            continue;
        }
        let path = entry.path();
        let time = if path.is_dir() { newest(&path) } else { changed(&path) };
        newest_yet = newest_yet.max(time);
    }
    newest_yet
}

fn npm(web: &Path, arguments: &[&str]) -> Result<(), String> {
    let program = if cfg!(windows) { "npm.cmd" } else { "npm" };
    let called = format!("npm {}", arguments[..arguments.len().min(2)].join(" "));
    let mut command = Command::new(program);
    command.args(arguments).current_dir(web).stdin(Stdio::null());
    let output = command.output().map_err(|e| match e.kind() {
        std::io::ErrorKind::NotFound => "npm, which builds the pages, was not found".to_owned(),
        _ => format!("{called}: {e}"),
    })?;
    if output.status.success() {
        return Ok(());
    }
    let text = [output.stdout, output.stderr].concat();
    let text = String::from_utf8_lossy(&text);
    let last: Vec<&str> =
        text.lines().rev().filter(|line| !line.trim().is_empty()).take(3).collect();
    let last: Vec<&str> = last.into_iter().rev().map(str::trim).collect();
    Err(format!("`{called}` failed in the folder `web`: {}", last.join(" / ")))
}
