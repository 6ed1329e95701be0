//! The report as PDF, printed by a browser without a window.

use std::fs::{self, DirBuilder};
use std::io;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use super::browser::{Browser, VARIABLE};

/// Longest time that a browser may take to print a report.
const LONGEST: Duration = Duration::from_secs(180);
/// Number of bytes of the browser's messages that an error shows.
const SHOWN: usize = 600;

/// A temporary folder, which is removed with everything in it.
struct Workplace(PathBuf);

impl Workplace {
    /// Makes a temporary folder beside the PDF, because a browser from a snap package cannot read the system's folder
    /// for temporary files.
    fn beside(pdf: &Path) -> io::Result<Workplace> {
        let folder = pdf.with_added_extension(format!("print-{}", std::process::id()));
        DirBuilder::new().create(&folder)?;
        Ok(Workplace(std::path::absolute(folder)?))
    }

    fn file(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }
}

impl Drop for Workplace {
    fn drop(&mut self) {
        // What is left does no harm.
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// Prints a page to PDF by a browser. The browser works in a temporary folder beside the file `pdf`.
///
/// # Errors
/// Fails if a folder or a file cannot be written, or if the browser does not start, fails or takes too long.
pub(super) fn print(browser: &Browser, page: &str, pdf: &Path) -> Result<Vec<u8>, String> {
    let place = Workplace::beside(pdf).map_err(|e| {
        format!(
            "cannot make a temporary folder beside \
        the PDF: {e}"
        )
    })?;
    let failed = |what: &str, e: io::Error| format!("{what}: {e}");
    fs::write(place.file("report.html"), page).map_err(|e| failed("the page", e))?;
    let log = fs::File::create(place.file("log")).map_err(|e| failed("the log", e))?;
    let mut command = Command::new(&browser.program);
    command.args(arguments(&place)).stdin(Stdio::null()).stdout(Stdio::null()).stderr(log);
    let name = browser.program.display();
    let mut child = command.spawn().map_err(|e| format!("{name} does not start: {e}"))?;
    let ended = wait(&mut child).map_err(|e| format!("{name}: {e}"))?;
    let printed = fs::read(place.file("report.pdf")).unwrap_or_default();
    if ended && printed.starts_with(b"%PDF-") {
        return Ok(printed);
    }
    let said = fs::read(place.file("log")).unwrap_or_default();
    let said = String::from_utf8_lossy(&said[said.len().saturating_sub(SHOWN)..]).into_owned();
    let what = if ended { "printed nothing" } else { "did not end in time" };
    Err(format!(
        "{name} {what}\n  = help: {VARIABLE} names another browser; or print report.html from a browser with a window\n{said}"
    ))
}

/// Waits until the browser has ended; returns `false` if the browser took too long and was killed.
fn wait(child: &mut Child) -> io::Result<bool> {
    let begun = Instant::now();
    loop {
        if child.try_wait()?.is_some() {
            return Ok(true);
        }
        if begun.elapsed() > LONGEST {
            child.kill()?;
            child.wait()?;
            return Ok(false);
        }
        sleep(Duration::from_millis(50));
    }
}

fn arguments(place: &Workplace) -> Vec<String> {
    let mut all: Vec<String> = [
        "--headless",
        "--disable-gpu",
        "--disable-quic",
        "--disable-sync",
        "--disable-extensions",
        "--disable-component-update",
        "--disable-background-networking",
        "--no-first-run",
        "--no-default-browser-check",
        // The page has its own footers.
        "--no-pdf-header-footer",
    ]
    .map(str::to_owned)
    .to_vec();
    if is_root() {
        // Chromium refuses to run as root with its sandbox. The page is our own and loads nothing.
        all.push("--no-sandbox".to_owned());
    }
    all.push(format!("--user-data-dir={}", place.file("profile").display()));
    all.push(format!("--print-to-pdf={}", place.file("report.pdf").display()));
    all.push(file_url(&place.file("report.html")));
    all
}

fn is_root() -> bool {
    #[cfg(unix)]
    {
        rustix::process::geteuid().is_root()
    }
    #[cfg(not(unix))]
    false
}

/// The URL of a file. Characters that have a meaning in URLs are escaped.
fn file_url(path: &Path) -> String {
    let text = path.to_string_lossy().replace('\\', "/");
    let mut url = String::from(if text.starts_with('/') { "file://" } else { "file:///" });
    for byte in text.bytes() {
        match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'/' | b'.' | b'-' | b'_' | b'~' | b':' => {
                url.push(char::from(byte));
            }
            _ => url.push_str(&format!("%{byte:02X}")),
        }
    }
    url
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_with_odd_characters_is_escaped_in_its_url() {
        assert_eq!(file_url(Path::new("/a b/#1?.html")), "file:///a%20b/%231%3F.html");
        assert_eq!(file_url(Path::new(r"C:\x\y.html")), "file:///C:/x/y.html");
    }
}
