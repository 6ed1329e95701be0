//! Hints of the overlap: where the search of each clip begins.

use alloc::vec::Vec;

use crate::geometry::clip::Hint;
use crate::memory::HintMemory;

/// Reads the hints of the last step and writes the hints of the next step. A hint tells where the search of a clip
/// begins.
///
/// Most hints stay unchanged and are copied in runs. If all hints stay, nothing is copied: this saves 4 % of the
/// instructions of a step in which all contacts continue.
pub(crate) struct Hints<'h> {
    /// Hints that are neither written nor dropped yet, sorted.
    old: &'h [HintMemory],
    /// The part of `old` that is still to be read.
    unread: &'h [HintMemory],
    next: &'h mut Vec<HintMemory>,
    /// Whether no hint has been written or dropped so far.
    all_stay: bool,
}

/// Ranks, face and pieces, as in [`HintMemory::key`].
pub(crate) type HintKey = (u32, u32, u32, u32, u32);

impl<'h> Hints<'h> {
    /// Reads `old` and adds to `next`. Reserves room for all hints, so that a later step does not allocate.
    pub(crate) fn new(old: &'h [HintMemory], next: &'h mut Vec<HintMemory>) -> Hints<'h> {
        next.reserve(old.len());
        Hints { old, unread: old, next, all_stay: true }
    }

    /// The last step's hint for these pieces. The hint is kept unless [`Hints::replace`] follows. Both lists are
    /// sorted, so one pass finds all.
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

    /// Does as [`Hints::read`] if other hints come before the wanted one, or if there is none.
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

    /// Copies all hints that were read.
    fn write(&mut self) {
        let (read, unread) = self.old.split_at(self.old.len() - self.unread.len());
        self.next.extend_from_slice(read);
        (self.old, self.all_stay) = (unread, false);
    }

    /// Replaces the hint read last. [`Hint::None`] is not stored.
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

    /// Writes the remaining hints. If all hints stay unchanged, writes nothing and returns true.
    pub(crate) fn finish(mut self) -> bool {
        let all_stay = self.all_stay && self.unread.is_empty();
        if !all_stay {
            self.write();
        }
        all_stay
    }
}
