//! Writes rows as records to a growing file (the journal), and to messages between processes. Each record has its
//! length and a check sum.

use std::fs::{File, OpenOptions};
use std::io::{BufReader, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use super::places::Places;
use crate::error::CampaignError;
use crate::row::{Cell, Row};

const EMPTY: u8 = 0;
const NUMBER: u8 = 1;
const TEXT: u8 = 2;
/// Longest record that is read (bytes): more than any row has.
const LONGEST: u32 = 1 << 24;

/// Writes the record of a row.
#[must_use]
pub fn encode(row: &Row) -> Vec<u8> {
    let mut body = Vec::with_capacity(8 + 9 * row.cells.len());
    body.extend(row.run.to_le_bytes());
    for cell in &row.cells {
        match cell {
            Cell::Empty => body.push(EMPTY),
            Cell::Number(value) => {
                body.push(NUMBER);
                body.extend(value.to_bits().to_le_bytes());
            }
            Cell::Text(text) => {
                body.push(TEXT);
                body.extend((text.len() as u32).to_le_bytes());
                body.extend(text.as_bytes());
            }
        }
    }
    let mut record = Vec::with_capacity(8 + body.len());
    record.extend((body.len() as u32).to_le_bytes());
    record.extend(crc32fast::hash(&body).to_le_bytes());
    record.extend(body);
    record
}

/// Reads a row from the body of its record.
fn decode(body: &[u8]) -> Option<Row> {
    fn take<'b, const N: usize>(rest: &mut &'b [u8]) -> Option<&'b [u8; N]> {
        let (first, others) = rest.split_first_chunk()?;
        *rest = others;
        Some(first)
    }
    let mut rest = body;
    let run = u64::from_le_bytes(*take(&mut rest)?);
    let mut cells = Vec::new();
    while !rest.is_empty() {
        let [kind] = *take(&mut rest)?;
        cells.push(match kind {
            EMPTY => Cell::Empty,
            NUMBER => Cell::Number(f64::from_bits(u64::from_le_bytes(*take(&mut rest)?))),
            TEXT => {
                let length = u32::from_le_bytes(*take(&mut rest)?) as usize;
                let (text, others) = rest.split_at_checked(length)?;
                rest = others;
                Cell::Text(str::from_utf8(text).ok()?.to_owned())
            }
            _ => return None,
        });
    }
    Some(Row { run, cells })
}

/// Reads the next record of a stream; `None` at the end of the stream, or if the record is torn or damaged.
fn next(stream: &mut impl Read) -> std::io::Result<Option<(Row, u64)>> {
    let mut head = [0; 8];
    if !filled(stream, &mut head)? {
        return Ok(None);
    }
    let length = u32::from_le_bytes([head[0], head[1], head[2], head[3]]);
    let sum = u32::from_le_bytes([head[4], head[5], head[6], head[7]]);
    if length > LONGEST {
        return Ok(None);
    }
    let mut body = vec![0; length as usize];
    if !filled(stream, &mut body)? || crc32fast::hash(&body) != sum {
        return Ok(None);
    }
    Ok(decode(&body).map(|row| (row, 8 + u64::from(length))))
}

/// Fills the buffer from the stream; returns false if the stream ends before the buffer is full.
fn filled(stream: &mut impl Read, buffer: &mut [u8]) -> std::io::Result<bool> {
    match stream.read_exact(buffer) {
        Ok(()) => Ok(true),
        Err(error) if error.kind() == std::io::ErrorKind::UnexpectedEof => Ok(false),
        Err(error) => Err(error),
    }
}

/// Reads the rows of a message.
///
/// # Errors
/// Fails if the message is torn or damaged.
pub fn decode_all(message: &[u8]) -> Result<Vec<Row>, CampaignError> {
    let mut rest = message;
    let mut rows = Vec::new();
    while !rest.is_empty() {
        match next(&mut rest) {
            Ok(Some((row, _))) => rows.push(row),
            _ => return Err(CampaignError::part("rows", "the message is damaged")),
        }
    }
    Ok(rows)
}

/// A journal: the place of each run's record, and the file to append to.
pub(super) struct Journal {
    path: PathBuf,
    file: File,
    places: Places,
    end: u64,
    done: u64,
}

impl Journal {
    /// Opens a journal, or makes a new journal. A torn record at the end of the journal is cut off; a run with two
    /// records counts once.
    pub(super) fn open(
        path: &Path,
        runs: u64,
        columns: usize,
        visit: &mut dyn FnMut(&Row),
    ) -> Result<Journal, CampaignError> {
        let failed = |error: std::io::Error| CampaignError::disk(path, &error);
        let options = || {
            let mut options = OpenOptions::new();
            options.read(true).write(true).create(true).truncate(false);
            options
        };
        let file = options().open(path).map_err(failed)?;
        let mut journal =
            Journal { path: path.to_owned(), places: Places::of(runs), end: 0, done: 0, file };
        let mut reader =
            BufReader::with_capacity(1 << 20, journal.file.try_clone().map_err(failed)?);
        while let Some((row, length)) = next(&mut reader).map_err(failed)? {
            if row.run >= runs || row.cells.len() != columns {
                let why = "the journal has rows of another campaign";
                return Err(CampaignError::folder(path, why));
            }
            if !journal.has(row.run) {
                journal.places.set(row.run, journal.end);
                journal.done += 1;
                visit(&row);
            }
            journal.end += length;
        }
        journal.file.set_len(journal.end).map_err(failed)?;
        journal.file.seek(SeekFrom::Start(journal.end)).map_err(failed)?;
        Ok(journal)
    }

    /// Whether the journal has the row of a run.
    pub(super) fn has(&self, run: u64) -> bool {
        self.places.of_run(run).is_some()
    }

    /// The number of rows.
    pub(super) fn done(&self) -> u64 {
        self.done
    }

    /// Appends a row to the journal, in one call of the system, so that the row survives if the program ends.
    pub(super) fn append(&mut self, row: &Row) -> Result<(), CampaignError> {
        if self.has(row.run) {
            return Ok(());
        }
        let record = encode(row);
        if let Err(error) = self.file.write_all(&record) {
            // The written part of the record is cut off, so the journal stays intact.
            let _ = self.file.set_len(self.end);
            let _ = self.file.seek(SeekFrom::Start(self.end));
            return Err(CampaignError::disk(&self.path, &error));
        }
        self.places.set(row.run, self.end);
        self.end += record.len() as u64;
        self.done += 1;
        Ok(())
    }

    /// Starts reading the journal's rows in the order of the runs.
    pub(super) fn reader(&self) -> Result<Reader<'_>, CampaignError> {
        let file =
            File::open(&self.path).map_err(|error| CampaignError::folder(&self.path, error))?;
        Ok(Reader { journal: self, file: BufReader::with_capacity(1 << 18, file), at: 0, run: 0 })
    }

    /// Calls `use_row` for each row in the order of the runs below `most`.
    pub(super) fn each(
        &self,
        most: u64,
        use_row: &mut dyn FnMut(&Row) -> Result<(), CampaignError>,
    ) -> Result<(), CampaignError> {
        let mut reader = self.reader()?;
        while let Some(row) = reader.next()?.filter(|row| row.run < most) {
            use_row(&row)?;
        }
        Ok(())
    }
}

/// Reads a journal's rows in the order of the runs.
pub(super) struct Reader<'j> {
    journal: &'j Journal,
    file: BufReader<File>,
    at: u64,
    run: u64,
}

impl Reader<'_> {
    /// Reads the row of the next run that has a row.
    pub(super) fn next(&mut self) -> Result<Option<Row>, CampaignError> {
        let path = &self.journal.path;
        let failed = |error: std::io::Error| CampaignError::folder(path, error);
        let Some((run, start)) = self.journal.places.next(self.run) else { return Ok(None) };
        self.run = run + 1;
        // Runs end nearly in order: most jumps stay within the buffer.
        self.file.seek_relative(start as i64 - self.at as i64).map_err(failed)?;
        let Some((row, length)) = next(&mut self.file).map_err(failed)? else {
            return Err(CampaignError::folder(
                path,
                "a record of the journal that was intact is now damaged",
            ));
        };
        self.at = start + length;
        Ok(Some(row))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(run: u64) -> Row {
        let cells =
            vec![Cell::Number(run as f64 / 3.0), Cell::Text(format!("run {run}")), Cell::Empty];
        Row { run, cells }
    }

    fn path(name: &str) -> PathBuf {
        let path =
            std::env::temp_dir().join(format!("fenderline_journal_{name}_{}", std::process::id()));
        let _ = std::fs::remove_file(&path);
        path
    }

    #[test]
    fn a_journal_cut_anywhere_keeps_the_whole_records() {
        let path = path("cut");
        let mut journal = Journal::open(&path, 10, 3, &mut |_| {}).expect("a journal");
        for run in [3, 0, 7] {
            journal.append(&row(run)).expect("appended");
        }
        let whole = std::fs::read(&path).expect("the file");
        let length = encode(&row(3)).len();
        for cut in 0..=whole.len() {
            std::fs::write(&path, &whole[..cut]).expect("written");
            let mut seen = Vec::new();
            let journal =
                Journal::open(&path, 10, 3, &mut |row| seen.push(row.clone())).expect("a journal");
            assert_eq!(seen.len(), cut / length, "cut at {cut}");
            assert_eq!(journal.done() as usize, seen.len());
            assert_eq!(
                seen,
                [3, 0, 7][..seen.len()].iter().map(|run| row(*run)).collect::<Vec<_>>()
            );
        }
        let mut ordered = Vec::new();
        let journal = Journal::open(&path, 10, 3, &mut |_| {}).expect("a journal");
        journal
            .each(u64::MAX, &mut |row| {
                ordered.push(row.run);
                Ok(())
            })
            .expect("read");
        assert_eq!(ordered, [0, 3, 7]);
        std::fs::remove_file(&path).expect("removed");
    }

    #[test]
    fn a_run_counts_once() {
        let path = path("twice");
        let mut bytes = encode(&row(1));
        bytes.extend(encode(&row(1)));
        std::fs::write(&path, bytes).expect("written");
        let mut journal = Journal::open(&path, 10, 3, &mut |_| {}).expect("a journal");
        assert_eq!(journal.done(), 1);
        journal.append(&row(1)).expect("appended");
        assert_eq!(journal.done(), 1);
        std::fs::remove_file(&path).expect("removed");
    }

    #[test]
    fn messages_are_whole_or_refused() {
        let mut message = encode(&row(0));
        message.extend(encode(&row(5)));
        assert_eq!(decode_all(&message).expect("rows"), [row(0), row(5)]);
        for cut in 1..message.len() {
            if cut != encode(&row(0)).len() {
                assert!(decode_all(&message[..cut]).is_err(), "cut at {cut}");
            }
        }
        message[12] ^= 1;
        assert!(decode_all(&message).is_err());
    }
}
