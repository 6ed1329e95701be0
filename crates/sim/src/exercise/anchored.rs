//! The part of a goal that is about anchors: how many anchors hold.

use fenderline_contact::Vec2;

use super::words::metres;
use fenderline_ship::anchor::{AnchorPosition, SHACKLE_M, WindlassOrder};
use fenderline_world::setup::Setup;
use fenderline_world::world::AnchorAtWork;

/// By this much (m) the chain may be shorter than the goal asks: an order in shackles and a condition in metres differ
/// by rounding.
const CHAIN_SLACK_M: f64 = 1e-3;

/// The place where an anchor must lie to fulfil a goal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AnchorPlace {
    /// North and east (m).
    pub at_m: Vec2,
    /// Largest distance of the anchor from the place (m).
    pub within_m: f64,
}

/// What an anchor must fulfil to be counted in a goal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Holding<'a> {
    /// Least chain out (m).
    pub chain_m: f64,
    /// The place where the anchor must lie.
    pub place: &'a Option<AnchorPlace>,
}

impl Holding<'_> {
    /// Returns true if the anchor is on the bottom at its place, with enough chain out and the brake on, and does not
    /// drag.
    pub(super) fn is_met_by(&self, anchor: &AnchorAtWork) -> bool {
        let AnchorPosition::OnBottom(at_m) = anchor.state.position else { return false };
        anchor.state.order == WindlassOrder::Hold
            && !anchor.state.dragging
            && anchor.state.chain_m >= self.chain_m - CHAIN_SLACK_M
            && self.place.is_none_or(|place| (at_m - place.at_m).length() <= place.within_m)
    }

    /// The condition for an anchor in words that follow the word "holds".
    pub(super) fn words(&self) -> String {
        let chain = match self.chain_m > 0.0 {
            true => format!(", at least {} out", shackles(self.chain_m)),
            false => String::new(),
        };
        let place = self.place.map_or_else(String::new, |AnchorPlace { at_m, within_m }| {
            let [north, east] = [at_m.x, at_m.y].map(metres);
            format!(", on the bottom within {} of north {north}, east {east}", metres(within_m))
        });
        format!("{chain}{place}")
    }

    /// Describes in a few words the state of each anchor that is not home in its hawse pipe.
    pub(super) fn now(&self, anchors: &[usize], all: &[AnchorAtWork], setup: &Setup) -> String {
        let out = anchors.iter().filter(|&&anchor| {
            let state = &all[anchor].state;
            state.position != AnchorPosition::Housed
        });
        let of = |&anchor: &usize| {
            let name = &setup.world.anchors[anchor].gear.name;
            format!("{name} {}", self.state_words(&all[anchor]))
        };
        let words: Vec<String> = out.map(of).collect();
        match words.is_empty() {
            true => "no anchor down".to_owned(),
            false => words.join("; "),
        }
    }

    fn state_words(&self, anchor: &AnchorAtWork) -> String {
        let state = &anchor.state;
        let out = shackles(state.chain_m);
        let at_m = match state.position {
            AnchorPosition::Housed => return "home".to_owned(),
            AnchorPosition::Lost(_) => return "lost".to_owned(),
            AnchorPosition::Hanging => return format!("not on the bottom, {out} of chain out"),
            AnchorPosition::OnBottom(at_m) => at_m,
        };
        let off = self.place.map_or_else(String::new, |place| {
            format!(", {} from the place", metres((at_m - place.at_m).length()))
        });
        let moves = match state.order {
            WindlassOrder::Hold => "",
            WindlassOrder::LetGo(_) | WindlassOrder::Veer(_) => ", chain runs out",
            WindlassOrder::Heave(_) => ", chain comes in",
        };
        let drags = if state.dragging { ", drags" } else { "" };
        format!("{out} out{off}{moves}{drags}")
    }
}

fn shackles(length_m: f64) -> String {
    format!("{:.1} shackles", length_m / SHACKLE_M)
}
