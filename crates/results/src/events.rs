//! Names of the events in result files.

use fenderline_contact::EventKind;
use fenderline_sim::WorldEventKind;

/// The name of a contact event in result files.
#[must_use]
pub fn event_key(kind: EventKind) -> &'static str {
    match kind {
        EventKind::ContactBegan => "contact_began",
        EventKind::ContactEnded => "contact_ended",
        EventKind::PatchSplit => "patch_split",
        EventKind::PatchesMerged => "patches_merged",
        EventKind::Contained => "contained",
        EventKind::DeepOverlap => "deep_overlap",
        EventKind::Teleported => "teleported",
        EventKind::NotConverged => "not_converged",
        EventKind::PlacedInOverlap => "placed_in_overlap",
        EventKind::MassMismatch => "mass_mismatch",
        EventKind::FenderRatingExceeded(_) => "fender_rating_exceeded",
        EventKind::FenderFailed(_) => "fender_failed",
    }
}

/// The name of an event of a vessel, tug, mooring line or anchor in result files.
#[must_use]
pub fn world_event_key(kind: WorldEventKind) -> &'static str {
    match kind {
        WorldEventKind::OrderClamped => "order_clamped",
        WorldEventKind::Aground => "aground",
        WorldEventKind::ShallowHeld => "shallow_held",
        WorldEventKind::TugLimited => "tug_limited",
        WorldEventKind::TugOrderRefused => "tug_order_refused",
        WorldEventKind::LineNotMadeFast => "line_not_made_fast",
        WorldEventKind::LineMadeFast => "line_made_fast",
        WorldEventKind::LineParted => "line_parted",
        WorldEventKind::LineNotParted => "line_not_parted",
        WorldEventKind::LineRenders => "line_renders",
        WorldEventKind::Anchor(event) => event.key(),
    }
}
