//! Keeps the links of a session and the holders of controls in a file beside the recording. A server that starts again
//! with the recording reads links and holders from this file. Links and holders are not in the recording itself,
//! because a person who may read a recording must not get the links of its session.

use std::fs::{self, OpenOptions};
use std::io::{self, Read as _, Write as _};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{self, Receiver, Sender};
use std::thread::JoinHandle;

use fenderline_live::Control;
use fenderline_live::message::Role;
use fenderline_scenario::open_regular;
use serde::{Deserialize, Serialize};

use super::log::Notify;
use super::saved::ENDING;

/// Number of the format. A file of links whose format has another number is refused.
const FORMAT: u32 = 1;
/// The ending of the name of a file of links. The ending for links stands in place of the ending of the recording's
/// name.
const LINKS_ENDING: &str = ".links.json";
/// Largest size of a file of links (bytes). A scenario has about ten roles, each of which takes two hundred bytes of
/// the file.
const LARGEST_BYTES: u64 = 1 << 20;
/// Number of hexadecimal digits of a secret.
pub(crate) const SECRET_DIGITS: usize = 32;
/// Longest label (characters). A label of a holder is a name and a role.
const LONGEST_LABEL: usize = 200;

/// The secret that opens a role.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct KeptLink {
    pub(crate) role: Role,
    /// The secret of the role: 128 bits in hexadecimal.
    pub(crate) secret: String,
}

/// The holder of a control, whether connected or not.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct KeptHolder {
    pub(crate) control: Control,
    /// Label of the holder: name and role of the person.
    pub(crate) label: String,
}

/// What a server needs besides the recording to continue with the same people.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct KeptSeats {
    fenderline_links: u32,
    pub(crate) links: Vec<KeptLink>,
    pub(crate) holders: Vec<KeptHolder>,
}

impl KeptSeats {
    pub(crate) fn of(links: Vec<KeptLink>, holders: Vec<KeptHolder>) -> KeptSeats {
        KeptSeats { fenderline_links: FORMAT, links, holders }
    }

    /// What is wrong with the file of links, in words; `None` if it is good.
    fn mistake(&self) -> Option<String> {
        if self.fenderline_links != FORMAT {
            let other = self.fenderline_links;
            return Some(format!(
                "the file has format {other}, but this program reads format {FORMAT}"
            ));
        }
        let digit = |c: char| c.is_ascii_digit() || ('a'..='f').contains(&c);
        let is_secret = |text: &str| text.len() == SECRET_DIGITS && text.chars().all(digit);
        if !self.links.iter().all(|link| is_secret(&link.secret)) {
            return Some(format!("a secret has {SECRET_DIGITS} hexadecimal digits"));
        }
        let twice = self.links.iter().enumerate().any(|(index, link)| {
            self.links[..index].iter().any(|other| other.secret == link.secret)
        });
        if twice {
            return Some("one secret opens two roles, but must open only one".to_owned());
        }
        let is_label = |text: &str| {
            text.chars().count() <= LONGEST_LABEL && !text.chars().any(char::is_control)
        };
        if !self.holders.iter().all(|holder| is_label(&holder.label)) {
            return Some(format!(
                "a holder's name has at most {LONGEST_LABEL} characters, in one line"
            ));
        }
        None
    }
}

/// Path of the file of links that lies beside a recording.
pub(crate) fn beside(recording: &Path) -> PathBuf {
    let name = recording.file_name().unwrap_or_default().to_string_lossy();
    let stem = name.strip_suffix(ENDING).unwrap_or(&name);
    recording.with_file_name(format!("{stem}{LINKS_ENDING}"))
}

/// Reads a file of links; `None` if the file does not exist.
///
/// # Errors
/// Fails if the file of links cannot be read or used. The error text has the name of the file and the reason.
pub(crate) fn read(path: &Path) -> Result<Option<KeptSeats>, String> {
    if path.symlink_metadata().is_err() {
        return Ok(None);
    }
    let file = open_regular(path, LARGEST_BYTES).map_err(|e| e.to_string())?;
    let mut text = String::new();
    let wrong = |why: &dyn std::fmt::Display| format!("{}: {why}", path.display());
    file.take(LARGEST_BYTES).read_to_string(&mut text).map_err(|e| wrong(&e))?;
    let seats: KeptSeats = serde_json::from_str(&text)
        .map_err(|e| wrong(&format_args!("the file holds no links of a session: {e}")))?;
    match seats.mistake() {
        None => Ok(Some(seats)),
        Some(mistake) => Err(wrong(&mistake)),
    }
}

/// Writes a file of links in place of a former file. Where the operating system has user
/// accounts, other accounts cannot read the file with the links to the pages.
fn write(path: &Path, seats: &KeptSeats) -> Result<(), String> {
    let failed = |e: io::Error| format!("{}: {e}", path.display());
    let text = serde_json::to_string(seats).map_err(|e| failed(e.into()))?;
    // Writes under another name first. If the program is killed meanwhile, the former file is still whole.
    let new = path.with_extension("json.new");
    let _ = fs::remove_file(&new);
    let mut options = OpenOptions::new();
    options.write(true).create_new(true);
    #[cfg(unix)]
    {
        use std::os::unix::fs::OpenOptionsExt as _;
        options.mode(0o600);
    }
    let mut file = options.open(&new).map_err(failed)?;
    file.write_all(text.as_bytes()).and_then(|()| fs::rename(&new, path)).map_err(failed)
}

/// Writes links and holders to their file whenever they change. The keeper uses another thread, because the
/// simulation's thread must not wait for a disk.
#[derive(Debug)]
pub(crate) struct Keeper {
    /// The channel to the keeper's thread; `None` only while the keeper is dropped.
    to: Option<Sender<(PathBuf, KeptSeats)>>,
    thread: Option<JoinHandle<()>>,
}

impl Keeper {
    /// Starts the thread. If a file of links cannot be written, `notify` gets one line about it.
    ///
    /// # Errors
    /// Fails if the operating system gives no thread.
    pub(crate) fn start(notify: Notify) -> io::Result<Keeper> {
        let (to, seats) = mpsc::channel();
        let thread = std::thread::Builder::new().name("links".into());
        let thread = thread.spawn(move || work(&seats, notify))?;
        Ok(Keeper { to: Some(to), thread: Some(thread) })
    }

    /// Lets the keeper's thread write links and holders to a file soon. Earlier links and holders that the
    /// thread has not yet written to the same file are replaced, and never written.
    pub(crate) fn keep(&self, path: PathBuf, seats: KeptSeats) {
        if let Some(to) = &self.to {
            let _ = to.send((path, seats));
        }
    }
}

impl Drop for Keeper {
    fn drop(&mut self) {
        self.to = None;
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}

/// Writes, on the keeper's thread, the latest links and holders that wait, until the server ends.
fn work(waiting: &Receiver<(PathBuf, KeptSeats)>, notify: Notify) {
    let mut written: Option<(PathBuf, KeptSeats)> = None;
    let mut has_failed = false;
    while let Ok(first) = waiting.recv() {
        // If several wait for one file, only the last is written.
        let mut all = vec![first];
        for next in waiting.try_iter() {
            all.retain(|(path, _)| *path != next.0);
            all.push(next);
        }
        for (path, seats) in all {
            if written.as_ref().is_some_and(|(at, of)| *at == path && *of == seats) {
                continue;
            }
            if let Err(why) = write(&path, &seats)
                && !has_failed
            {
                has_failed = true;
                notify(&format!("links cannot be kept for a server that starts again: {why}"));
            }
            written = Some((path, seats));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn silent(_: &str) {}

    #[test]
    fn what_was_kept_last_is_read_and_a_wrong_file_is_answered_with_the_reason() {
        let folder = std::env::temp_dir().join(format!("fenderline-links-{}", std::process::id()));
        fs::create_dir_all(&folder).expect("a folder");
        let path = beside(&folder.join("harbour-001.session.jsonl"));
        assert_eq!(path, folder.join("harbour-001.links.json"));
        assert_eq!(read(&path), Ok(None));
        let link = |digit: char| KeptLink {
            role: Role::Tugmaster { tug: format!("tug {digit}") },
            secret: digit.to_string().repeat(SECRET_DIGITS),
        };
        let holder = |label: &str| KeptHolder {
            control: Control::Vessel("ship".into()),
            label: label.to_owned(),
        };
        let seats = |label: &str| KeptSeats::of(vec![link('a'), link('7')], vec![holder(label)]);
        let keeper = Keeper::start(silent).expect("a thread");
        for label in ["Anna (pilot)", "Berta (pilot)"] {
            keeper.keep(path.clone(), seats(label));
        }
        drop(keeper);
        assert_eq!(read(&path), Ok(Some(seats("Berta (pilot)"))));
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt as _;
            let mode = fs::metadata(&path).expect("a file").permissions().mode();
            assert_eq!(mode & 0o077, 0, "{mode:o}");
        }
        let good = fs::read_to_string(&path).expect("a file");
        for (text, reason) in [
            (String::new(), "no links"),
            (good[..good.len() - 9].to_owned(), "no links"),
            (good.replace("\"fenderline_links\":1", "\"fenderline_links\":9"), "format 9"),
            (good.replace('7', "a"), "two roles"),
            (good.replace('7', "g"), "hexadecimal"),
            (good.replace("Berta", "Be\\nta"), "one line"),
            (good.replace("\"links\"", "\"lynx\""), "unknown field"),
        ] {
            fs::write(&path, &text).expect("written");
            let why = read(&path).expect_err(reason);
            assert!(why.contains(reason) && why.contains("harbour-001"), "{why}");
        }
        fs::remove_dir_all(&folder).expect("it is ours");
    }
}
