//! Recordings as files. A saved recording is checked, then replayed.

use std::fmt;
use std::fs::File;
use std::io::{BufReader, Read, Seek, SeekFrom};
use std::path::Path;

use fenderline_live::{
    Ending, LARGEST_RECORDING_BYTES, Outline, RecordingError, RecordingReader, Replay, ReplayError,
    Session, begins_recording,
};
use fenderline_scenario::open_regular;

/// The ending of a recording's file name.
pub(crate) const ENDING: &str = ".session.jsonl";

/// Number of steps that are replayed between two reports of progress.
const SLICE: u64 = 200;
/// Size of the buffer for reading a recording (bytes).
const BLOCK: usize = 256 << 10;

/// Progress of a replay.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Progress {
    /// Number of bytes of the recording that were read and checked so far, and the number of all its bytes.
    Reading(u64, u64),
    /// Number of ticks of the recording that were replayed so far, and the number of all its ticks.
    Replaying(u64, u64),
}

/// Receives the progress. If the function that receives the progress returns an error, the replay stops with that
/// reason.
pub(crate) type Watch<'w> = &'w mut dyn FnMut(Progress) -> Result<(), String>;

/// A recording that was replayed to its end.
pub(crate) struct Replayed<R> {
    pub(crate) session: Session,
    /// Number of recorded states that the replay reached with the same bits.
    pub(crate) equal_states: u64,
    pub(crate) outline: Outline,
    /// Version of the program that recorded the session.
    pub(crate) version: String,
    /// The file of the recording that was replayed. The position in the file is not at its start.
    pub(crate) file: R,
}

/// Why a recording was not replayed to its end. The text of the error does not contain the recording's name.
#[derive(Debug)]
pub(crate) enum ReplayFailure {
    /// The file is not a recording, or is damaged. A file that is no good recording is found before the replay.
    Bad(RecordingError),
    /// The lines are intact, but the replay differs from the recorded states.
    Differs(ReplayError),
    /// The caller stopped the replay, or the file cannot be read. The text is the reason of the caller or of the
    /// system.
    Stopped(String),
}

impl fmt::Display for ReplayFailure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ReplayFailure::Bad(error) => error.fmt(f),
            ReplayFailure::Differs(error) => error.fmt(f),
            ReplayFailure::Stopped(why) => f.write_str(why),
        }
    }
}

/// Opens a file if it begins as a recording does. The result is `None` for any other regular file.
///
/// # Errors
/// Fails for a file that cannot be read, whose name is in the error.
pub(crate) fn open(path: &Path) -> Result<Option<File>, String> {
    let mut file = open_regular(path, LARGEST_RECORDING_BYTES).map_err(|e| e.to_string())?;
    let mut start = Vec::new();
    let read = file.by_ref().take(64).read_to_end(&mut start).and_then(|_| file.rewind());
    read.map_err(|e| format!("{}: {e}", path.display()))?;
    Ok(begins_recording(&start).then_some(file))
}

/// The title of a recording's scenario. The title is `None` if the first line of the recording is missing or damaged.
pub(crate) fn title(file: &File) -> Option<String> {
    let reader = RecordingReader::open(BufReader::new(file)).ok()?;
    Some(reader.source().scenario().ok()?.title)
}

/// Checks a whole recording, then replays it.
///
/// # Errors
/// [`ReplayFailure`].
pub(crate) fn replay<R: Read + Seek>(
    mut file: R,
    watch: Watch<'_>,
) -> Result<Replayed<R>, ReplayFailure> {
    let unreadable = |e: std::io::Error| ReplayFailure::Stopped(e.to_string());
    let all = file.seek(SeekFrom::End(0)).map_err(unreadable)?;
    file.rewind().map_err(unreadable)?;
    let mut stopped = None;
    let read = |bytes: u64| {
        watch(Progress::Reading(bytes, all)).inspect_err(|why| stopped = Some(why.clone()))
    };
    let outline = Outline::read(BufReader::with_capacity(BLOCK, &mut file), read);
    let outline = match (outline, stopped) {
        (_, Some(why)) => return Err(ReplayFailure::Stopped(why)),
        (Err(error), None) => return Err(ReplayFailure::Bad(error)),
        (Ok(outline), None) => outline,
    };
    file.rewind().map_err(unreadable)?;
    let input = BufReader::with_capacity(BLOCK, &mut file);
    let version = {
        let reader = RecordingReader::open(input).map_err(ReplayFailure::Bad)?;
        reader.version().to_owned()
    };
    file.rewind().map_err(unreadable)?;
    let input = BufReader::with_capacity(BLOCK, &mut file);
    let mut replay = Replay::begin(input, outline.clone()).map_err(ReplayFailure::Differs)?;
    while !replay.play(SLICE).map_err(ReplayFailure::Differs)? {
        watch(Progress::Replaying(replay.done(), outline.ticks)).map_err(ReplayFailure::Stopped)?;
    }
    let replayed = replay.finish().map_err(ReplayFailure::Differs)?;
    let (session, equal_states) = (replayed.session, replayed.same);
    Ok(Replayed { session, equal_states, outline, version, file })
}

/// Says what is missing at the end of a recording. The text is `None` for a complete recording.
pub(crate) fn missing_at_end(ending: Ending) -> Option<String> {
    match ending {
        Ending::Whole => None,
        Ending::Open => Some(
            "its last line is missing: the program was killed or is still recording, or the file was cut off"
                .to_owned(),
        ),
        Ending::Torn { bytes } => Some(format!(
            "its last line is incomplete, and the {bytes} bytes of that line are dropped"
        )),
    }
}
