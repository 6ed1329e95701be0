//! Hints of the overlap: where each clip of a step begins.

use alloc::vec::Vec;

use crate::geometry::clip::Hint;
use crate::memory::HintMemory;

/// Reads the last step's hints and writes the next one's: where each clip begins.
///
/// Most hints stay as they are and are copied in runs. If all of them stay nothing is copied: that saves 4 % of the
/// instructions of a step in which all contacts continue.
pub(crate) struct Hints<'h> {
    /// What is neither written nor dropped yet, sorted.
    old: &'h [HintMemory],
    /// What of it is still to be read.
    unread: &'h [HintMemory],
    next: &'h mut Vec<HintMemory>,
    /// Nothing has been written or dropped yet.
    all_stay: bool,
}

/// Ranks, face and pieces, as of [`HintMemory::key`].
pub(crate) type HintKey = (u32, u32, u32, u32, u32);

impl<'h> Hints<'h> {
    /// Reads `old` and adds to `next`. Reserves room for all hints, so that a later step does not allocate.
    pub(crate) fn new(old: &'h [HintMemory], next: &'h mut Vec<HintMemory>) -> Hints<'h> {
        next.reserve(old.len());
        Hints { old, unread: old, next, all_stay: true }
    }

    /// The last step's hint for these pieces. It is kept unless [`Hints::replace`] follows. Both lists are sorted, so one
    /// pass finds all.
    #[inline(always)]
    pub(crate) fn read(&mut self, wanted: HintKey) -> Option<Hint> {
        match self.unread {
            [first, rest @ ..] if first.key() == wanted => {
                self.unread = rest;
                Some(first.hint)
            }
            _ => self.search(wanted),
        }
    }

    /// As [`Hints::read`], if others come before it or there is none.
    #[inline(never)]
    fn search(&mut self, wanted: HintKey) -> Option<Hint> {
        let skipped = self.unread.iter().take_while(|hint| hint.key() < wanted).count();
        if skipped > 0 {
            self.write();
            self.unread = &self.unread[skipped..];
            self.old = self.unread;
        }
        let (first, rest) = self.unread.split_first()?;
        (first.key() == wanted).then(|| {
            self.unread = rest;
            first.hint
        })
    }

    /// Copies all that was read.
    fn write(&mut self) {
        let (read, unread) = self.old.split_at(self.old.len() - self.unread.len());
        self.next.extend_from_slice(read);
        (self.old, self.all_stay) = (unread, false);
    }

    /// Replaces the hint that was read last. [`Hint::None`] is not stored.
    #[inline]
    pub(crate) fn replace(&mut self, of: HintKey, before: Option<Hint>, hint: Hint) {
        let hint = (hint != Hint::None).then_some(hint);
        if hint != before {
            self.write_other(of, before, hint);
        }
    }

    #[inline(never)]
    fn write_other(&mut self, of: HintKey, before: Option<Hint>, hint: Option<Hint>) {
        let (a, b, face, piece_a, piece_b) = of;
        self.write();
        if before.is_some() {
            self.next.pop();
        }
        self.next.extend(hint.map(|hint| HintMemory { a, b, face, piece_a, piece_b, hint }));
    }

    /// Writes the rest. Returns true, and writes nothing, if all hints stay as they are.
    pub(crate) fn finish(mut self) -> bool {
        let all_stay = self.all_stay && self.unread.is_empty();
        if !all_stay {
            self.write();
        }
        all_stay
    }
}
