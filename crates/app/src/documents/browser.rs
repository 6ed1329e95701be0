//! The browser that prints the PDF.

use std::env;
use std::path::{Path, PathBuf};

/// Environment variable that names the browser; it takes precedence over all other places where browsers are looked
/// for.
pub(super) const VARIABLE: &str = "FENDERLINE_BROWSER";

/// Names of browser programs that are looked for in the folders of PATH, in this order.
const PROGRAMS: [&str; 9] = [
    "chromium",
    "chromium-browser",
    "google-chrome",
    "google-chrome-stable",
    "chrome",
    "microsoft-edge",
    "microsoft-edge-stable",
    "msedge",
    "brave-browser",
];

/// Paths where macOS and Windows keep browsers; on these systems browsers are not in PATH.
const PLACES: [&str; 7] = [
    "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
    "/Applications/Chromium.app/Contents/MacOS/Chromium",
    "/Applications/Microsoft Edge.app/Contents/MacOS/Microsoft Edge",
    r"C:\Program Files\Google\Chrome\Application\chrome.exe",
    r"C:\Program Files (x86)\Google\Chrome\Application\chrome.exe",
    r"C:\Program Files (x86)\Microsoft\Edge\Application\msedge.exe",
    r"C:\Program Files\Microsoft\Edge\Application\msedge.exe",
];

/// A browser of the Chromium family, which prints the PDF report.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Browser {
    pub(super) program: PathBuf,
}

impl Browser {
    /// The browser that `FENDERLINE_BROWSER` names, or the first that is installed.
    ///
    /// # Errors
    /// Fails if there is no browser; the text names what was looked for and how to get a browser.
    pub(super) fn find() -> Result<Browser, String> {
        find(env::var_os(VARIABLE).map(PathBuf::from), env::var_os("PATH").as_deref(), &PLACES)
    }
}

fn find(
    named: Option<PathBuf>,
    path: Option<&std::ffi::OsStr>,
    places: &[&str],
) -> Result<Browser, String> {
    if let Some(program) = named {
        let has_folder = program.components().count() > 1;
        let found = if has_folder {
            program.is_file().then(|| program.clone())
        } else {
            in_path(path, &program)
        };
        return found.map(|program| Browser { program }).ok_or_else(|| {
            format!("error: {VARIABLE} names {}, which is not a program", program.display())
        });
    }
    let named = PROGRAMS.iter().find_map(|name| in_path(path, Path::new(name)));
    let placed = || places.iter().map(PathBuf::from).find(|place| place.is_file());
    let found = named.or_else(placed);
    found.map(|program| Browser { program }).ok_or_else(|| {
        format!(
            "error: no browser to print the PDF: looked for {} in PATH, and for Chrome, Chromium \
             and Edge in the usual folders of macOS and Windows\n  = help: install one (Debian and \
             Ubuntu: apt-get install chromium), or name one by {VARIABLE}=/path/to/browser; \
             without one, open report.html in any browser and print it",
            PROGRAMS.join(", ")
        )
    })
}

/// Looks for a program in the folders of PATH.
fn in_path(path: Option<&std::ffi::OsStr>, name: &Path) -> Option<PathBuf> {
    let name = name.with_added_extension(env::consts::EXE_EXTENSION);
    env::split_paths(path?).map(|folder| folder.join(&name)).find(|program| program.is_file())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_missing_browser_is_reported_with_what_was_looked_for() {
        let error = find(None, Some("/nowhere".as_ref()), &[]).expect_err("there is none");
        for word in ["chromium", "google-chrome", "msedge", "apt-get install chromium", VARIABLE] {
            assert!(error.contains(word), "{error}");
        }
        let error = find(Some("/nowhere/browser".into()), None, &[]).expect_err("no such file");
        assert!(error.contains("/nowhere/browser"), "{error}");
    }

    #[test]
    fn a_named_browser_comes_first() {
        let own = env::current_exe().expect("the test has a program");
        let found = find(Some(own.clone()), None, &[]).expect("it is there");
        assert_eq!(found.program, own);
        let folder = own.parent().expect("a folder");
        let name = PathBuf::from(own.file_stem().expect("a name"));
        let found = find(Some(name), Some(folder.as_os_str()), &[]).expect("it is in PATH");
        assert_eq!(found.program, own);
    }
}
