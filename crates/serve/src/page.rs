//! The page of the live server, in memory. It is built from the repository's `web` folder if it is missing or old.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::SystemTime;

use fenderline_scenario::{FileFault, read_bytes};
use maud::{DOCTYPE, html};

use super::log::Notify;

/// The `web` folder of the sources that this program was built from.
const WEB: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../web");
/// Largest size of all files of a page together (bytes).
const LARGEST: u64 = 64 << 20;
/// Folders of `web` that hold no sources of the page.
const NOT_SOURCES: [&str; 5] = ["node_modules", "dist", "e2e", "test", "screenshots"];

/// A file as it is sent.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct PageFile {
    pub(crate) content_type: &'static str,
    pub(crate) bytes: Vec<u8>,
}

/// All files of the page by their paths, with `/index.html`. Only these are sent: no path leads to any other file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Page(BTreeMap<String, PageFile>);

impl Page {
    /// Reads a built page from its folder.
    ///
    /// # Errors
    /// A folder without `index.html`, or that cannot be read.
    pub(crate) fn read(folder: &Path) -> Result<Page, String> {
        let mut files = BTreeMap::new();
        let mut left = LARGEST;
        read_folder(folder, "", &mut files, &mut left)?;
        if !files.contains_key("/index.html") {
            return Err(format!("{}: no index.html in it", folder.display()));
        }
        Ok(Page(files))
    }

    /// The repository's page. It is built first if it is missing or older than its sources. If that fails, a page that
    /// says why.
    pub(crate) fn of_repository(notify: Notify) -> Page {
        built(Path::new(WEB), notify).and_then(|dist| Page::read(&dist)).unwrap_or_else(|why| {
            notify(&format!("no page: {why}"));
            notify("The server works without it; only the pages are missing.");
            Page::missing(&why)
        })
    }

    /// A page that says why the real one is missing.
    fn missing(why: &str) -> Page {
        let text = html! {
            (DOCTYPE)
            html lang="en" {
                head { meta charset="utf-8"; title { "fenderline: no page" } }
                body {
                    h1 { "There is no page here yet" }
                    p { "The simulation runs and its websocket is open, but the page was not built: " (why) }
                    p { "With Node and npm installed, start " code { "fenderline serve" } " again; it builds the page by \
                        itself. A page that was built elsewhere is served with " code { "--page FOLDER" } "." }
                }
            }
        };
        let file = PageFile {
            content_type: "text/html; charset=utf-8",
            bytes: text.into_string().into_bytes(),
        };
        Page(BTreeMap::from([("/index.html".to_owned(), file)]))
    }

    /// The file at a path of a request.
    pub(crate) fn file(&self, path: &str) -> Option<&PageFile> {
        self.0.get(if path == "/" { "/index.html" } else { path })
    }
}

fn read_folder(
    folder: &Path,
    under: &str,
    files: &mut BTreeMap<String, PageFile>,
    left: &mut u64,
) -> Result<(), String> {
    let with_folder = |e: std::io::Error| format!("{}: {e}", folder.display());
    for entry in fs::read_dir(folder).map_err(with_folder)? {
        let entry = entry.map_err(with_folder)?;
        let name = entry.file_name().to_string_lossy().into_owned();
        let (path, kind) = (format!("{under}/{name}"), entry.file_type().map_err(with_folder)?);
        if kind.is_dir() {
            read_folder(&entry.path(), &path, files, left)?;
        } else if kind.is_file() {
            let bytes = read_bytes(&entry.path(), *left).map_err(|e| match e.fault {
                FileFault::TooLarge { .. } => {
                    format!("{}: the page has more than {} MiB", folder.display(), LARGEST >> 20)
                }
                _ => e.to_string(),
            })?;
            *left -= bytes.len() as u64;
            files.insert(path, PageFile { content_type: content_type(&name), bytes });
        }
    }
    Ok(())
}

fn content_type(name: &str) -> &'static str {
    match name.rsplit('.').next().unwrap_or("") {
        "html" => "text/html; charset=utf-8",
        "js" | "mjs" => "text/javascript; charset=utf-8",
        "css" => "text/css; charset=utf-8",
        "svg" => "image/svg+xml",
        "png" => "image/png",
        "ico" => "image/x-icon",
        "woff2" => "font/woff2",
        "json" | "map" => "application/json",
        "webmanifest" => "application/manifest+json",
        "txt" => "text/plain; charset=utf-8",
        _ => "application/octet-stream",
    }
}

/// Builds the page in `web` if needed, and returns its folder.
fn built(web: &Path, notify: Notify) -> Result<PathBuf, String> {
    if !web.join("package.json").is_file() {
        return Err(format!(
            "{}: the page's sources are not there (the folder that this program was built from)",
            web.display()
        ));
    }
    let dist = web.join("dist");
    if is_up_to_date(web, &dist) {
        return Ok(dist);
    }
    notify("building the page (once; npm may fetch what it needs)...");
    if !is_newer(&web.join("node_modules/.package-lock.json"), &web.join("package-lock.json")) {
        npm(web, &["ci"], notify)?;
    }
    npm(web, &["run", "build"], notify)?;
    Ok(dist)
}

/// Whether no source is newer than the built page.
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

/// The last change of any source.
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

fn npm(web: &Path, arguments: &[&str], notify: Notify) -> Result<(), String> {
    let program = if cfg!(windows) { "npm.cmd" } else { "npm" };
    let called = format!("npm {}", arguments.join(" "));
    // Standard output is for the links, so that npm's output is captured.
    let output = Command::new(program).args(arguments).current_dir(web).output();
    let output = output.map_err(|e| match e.kind() {
        std::io::ErrorKind::NotFound => {
            "npm was not found: install Node (20.19 or newer) to build the page".to_owned()
        }
        _ => format!("{called}: {e}"),
    })?;
    if output.status.success() {
        return Ok(());
    }
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).trim().to_owned();
    notify(&format!("{}\n{}", text(&output.stdout), text(&output.stderr)));
    Err(format!("`{called}` failed in {}: see above", web.display()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_page_sends_its_own_files_only() {
        let folder = std::env::temp_dir().join(format!("fenderline-page-{}", std::process::id()));
        fs::create_dir_all(folder.join("assets")).expect("a folder");
        assert!(Page::read(&folder).expect_err("empty").contains("index.html"));
        fs::write(folder.join("index.html"), "<p>hello").expect("written");
        fs::write(folder.join("assets/a.js"), "1").expect("written");
        let page = Page::read(&folder).expect("a page");
        fs::remove_dir_all(&folder).expect("removed");
        assert_eq!(page.file("/").map(|f| f.bytes.as_slice()), Some(&b"<p>hello"[..]));
        let script = page.file("/assets/a.js").expect("a script");
        assert_eq!(script.content_type, "text/javascript; charset=utf-8");
        for other in
            ["/../Cargo.toml", "/assets/../index.html", "//index.html", "/assets", "", "/%2e%2e/x"]
        {
            assert!(page.file(other).is_none(), "{other}");
        }
        let missing = Page::missing("<npm>");
        let text = String::from_utf8_lossy(&missing.file("/").expect("a page").bytes).into_owned();
        assert!(text.contains("&lt;npm&gt;"));
    }
}
