//! Holds the files of the live server's pages in memory. The files of the pages come from the program itself or from a
//! folder.

use std::collections::BTreeMap;
use std::fs;
use std::io::Read;
use std::path::Path;

use fenderline_scenario::{FileFault, read_bytes};
use flate2::read::GzDecoder;
use maud::{DOCTYPE, html};

use super::log::Notify;

include!(concat!(env!("OUT_DIR"), "/pages.rs"));

/// Tells the user how to get pages that are missing.
const GET_PAGES: &str = "Programs of a release have the pages. To build a program with pages: install Node \
                         20.19 or later with npm, run `npm ci` and `npm run build` in the folder `web` of the \
                         sources, and build the program again. Or serve a folder of built pages with the option `--page FOLDER`.";
/// Largest size of all files of the pages together (bytes).
const LARGEST: u64 = 64 << 20;

/// True if this program contains the pages.
pub fn has_pages() -> bool {
    NO_PAGES.is_none()
}

/// A file of the page, ready to be sent.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct PageFile {
    pub(crate) content_type: &'static str,
    pub(crate) bytes: Vec<u8>,
}

/// All files of the pages by their paths, with `/index.html`. The server sends no other file. No path of a request
/// leads to any other file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Page(BTreeMap<String, PageFile>);

impl Page {
    /// Reads built pages from a folder.
    ///
    /// # Errors
    /// Fails if the folder has no `index.html`, or cannot be read.
    pub(crate) fn read(folder: &Path) -> Result<Page, String> {
        let mut files = BTreeMap::new();
        let mut left = LARGEST;
        read_folder(folder, "", &mut files, &mut left)?;
        if !files.contains_key("/index.html") {
            return Err(format!("{}: no index.html in it", folder.display()));
        }
        Ok(Page(files))
    }

    /// The pages that are built into this program. If the program was built without pages, this is a page that says how
    /// to get them.
    pub(crate) fn embedded(notify: Notify) -> Page {
        if let Some(why) = NO_PAGES {
            notify(&format!("notice: this program was built without pages: {why}"));
            notify(&format!("The server works without its pages. {GET_PAGES}"));
            return Page::missing(why);
        }
        let file = |(path, packed): &(&str, &[u8])| {
            let mut bytes = Vec::new();
            let read = GzDecoder::new(*packed).read_to_end(&mut bytes);
            read.expect("the build of the program compressed this file");
            ((*path).to_owned(), PageFile { content_type: content_type(path), bytes })
        };
        Page(PAGES.iter().map(file).collect())
    }

    /// A page that says why the real pages are missing, and how to get them.
    fn missing(why: &str) -> Page {
        let text = html! {
            (DOCTYPE)
            html lang="en" {
                head { meta charset="utf-8"; title { "fenderline: no pages" } }
                body {
                    h1 { "This program was built without pages" }
                    p { "The simulation runs, and its websocket is open. The pages are missing: " (why) "." }
                    p { (GET_PAGES) }
                }
            }
        };
        let file = PageFile {
            content_type: "text/html; charset=utf-8",
            bytes: text.into_string().into_bytes(),
        };
        Page(BTreeMap::from([("/index.html".to_owned(), file)]))
    }

    /// The file that answers a request for a path.
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
        assert!(text.contains("&lt;npm&gt;") && text.contains("npm run build"));
    }
}
