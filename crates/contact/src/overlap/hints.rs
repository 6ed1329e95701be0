//! Hints for the overlap of polygons: each hint tells where the search of a clip begins.

use alloc::vec::Vec;

use crate::geometry::clip::Hint;
use crate::state::memory::HintMemory;

/// Reads the hints of the last step and writes the hints of the next step. A hint tells where the search of a clip of
/// two polygons begins.
///
/// Most hints stay unchanged from step to step, and are copied in runs. If all hints stay unchanged, nothing is copied:
/// this saves 4 % of the instructions of a step in which all contacts continue.
pub(crate) struct Hints<'h> {
    /// Old hints that were neither written nor dropped yet, sorted by key.
    old: &'h [HintMemory],
    /// The part of `old` that was not yet read.
    unread: &'h [HintMemory],
    next: &'h mut Vec<HintMemory>,
    /// True if no hint has been written or dropped so far.
    all_stay: bool,
}

/// Key of a hint: the ranks of the bodies, the face and the pieces, as in [`HintMemory::key`].
pub(crate) type HintKey = (u32, u32, u32, u32, u32);

impl<'h> Hints<'h> {
    /// Makes a reader of the hints in `old` that adds the new hints to `next`. The function reserves room for all
    /// hints, so that a later step does not allocate memory.
    pub(crate) fn new(old: &'h [HintMemory], next: &'h mut Vec<HintMemory>) -> Hints<'h> {
        next.reserve(old.len());
        Hints { old, unread: old, next, all_stay: true }
    }

    /// Returns the hint that the last step left for these pieces. The hint that was read is kept unless
    /// [`Hints::replace`] follows. Both lists of hints are sorted, so one pass finds all hints.
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

    /// Does the same as [`Hints::read`] if other hints come before the wanted hint, or if there is no wanted hint.
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

    /// Copies all hints that were read to the new list.
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

    /// Writes the remaining hints. If all hints stay unchanged, the function writes nothing and returns true.
    pub(crate) fn finish(mut self) -> bool {
        let all_stay = self.all_stay && self.unread.is_empty();
        if !all_stay {
            self.write();
        }
        all_stay
    }
}
