//! Totals of an anchor over a run.

use fenderline_contact::Vec2;
use fenderline_contact::number::greater;
use fenderline_sim::anchor::{AnchorPosition, LostBy};
use fenderline_sim::{AnchorAtWork, AnchorSetup};

use super::{Lasting, Peak};

/// Totals of one anchor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AnchorTotals {
    /// Break load of the chain (N).
    pub break_load_n: f64,
    /// Peak tension of the chain at the hawse pipe (N); for a lost chain, the tension at its loss.
    pub tension_n: Peak,
    /// Largest length of chain out (m).
    pub chain_m: Peak,
    /// Time for which the anchor was on the bottom.
    pub on_bottom: Lasting,
    /// Distance by which the anchor dragged (m).
    pub dragged_m: f64,
    /// Time for which the anchor dragged.
    pub dragging: Lasting,
    /// Energy that the bottom absorbed from the anchor (J).
    pub dragged_j: f64,
    /// Length of chain that the windlass brake let run out under load (m).
    pub rendered_m: f64,
    /// Time at which the anchor was lost (s), and the way in which it was lost.
    pub lost: Option<(f64, LostBy)>,
    /// Position of the anchor at the end of the run.
    pub position: AnchorPosition,
    /// Length of chain out at the end of the run (m).
    pub last_chain_m: f64,
    /// Tension of the chain at the end of the run (N).
    pub last_tension_n: f64,
}

impl AnchorTotals {
    pub(super) fn new(setup: &AnchorSetup) -> AnchorTotals {
        AnchorTotals {
            break_load_n: setup.gear.chain().break_load_n(),
            tension_n: Peak::default(),
            chain_m: Peak::default(),
            on_bottom: Lasting::default(),
            dragged_m: 0.0,
            dragging: Lasting::default(),
            dragged_j: 0.0,
            rendered_m: 0.0,
            lost: None,
            position: AnchorPosition::Housed,
            last_chain_m: 0.0,
            last_tension_n: 0.0,
        }
    }

    pub(super) fn add(&mut self, (t_s, step_s): (f64, f64), now: &AnchorAtWork) {
        let AnchorAtWork { state, load, .. } = now;
        self.tension_n.raise(greater(load.tension_n, load.lost_at_n.unwrap_or(0.0)), t_s);
        self.chain_m.raise(state.chain_m, t_s);
        self.on_bottom.count(matches!(state.position, AnchorPosition::OnBottom(_)), step_s);
        self.dragging.count(state.dragging, step_s);
        self.dragged_m += load.moved_m;
        self.dragged_j = state.dragged_j;
        self.rendered_m += load.rendered_m;
        if let AnchorPosition::Lost(by) = state.position {
            self.lost.get_or_insert((t_s, by));
        }
        (self.position, self.last_chain_m) = (state.position, state.chain_m);
        self.last_tension_n = load.tension_n;
    }

    /// Place of the anchor on the bottom at the end of the run: north and east (m).
    #[must_use]
    pub fn place_m(&self) -> Option<Vec2> {
        match self.position {
            AnchorPosition::OnBottom(at_m) => Some(at_m),
            _ => None,
        }
    }

    /// The verdict on the anchor.
    #[must_use]
    pub fn verdict(&self) -> AnchorVerdict {
        match self.lost {
            Some((_, LostBy::Slipped)) => AnchorVerdict::Slipped,
            Some(_) => AnchorVerdict::Lost,
            None if self.dragged_m > 0.0 => AnchorVerdict::Dragged,
            None if self.on_bottom.s() > 0.0 => AnchorVerdict::Held,
            None => AnchorVerdict::NotUsed,
        }
    }
}

/// The verdict on an anchor, from best to worst.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum AnchorVerdict {
    /// The anchor was never on the bottom.
    NotUsed,
    /// The anchor held.
    Held,
    /// The anchor dragged.
    Dragged,
    /// The anchor was slipped by order.
    Slipped,
    /// The anchor was lost because its chain parted or ran out.
    Lost,
}

impl AnchorVerdict {
    /// The verdict in words.
    #[must_use]
    pub fn text(self) -> &'static str {
        match self {
            AnchorVerdict::NotUsed => "not used",
            AnchorVerdict::Held => "held",
            AnchorVerdict::Dragged => "dragged",
            AnchorVerdict::Slipped => "slipped",
            AnchorVerdict::Lost => "LOST",
        }
    }

    /// The verdict in `summary.json`.
    #[must_use]
    pub fn key(self) -> &'static str {
        match self {
            AnchorVerdict::NotUsed => "not_used",
            AnchorVerdict::Held => "held",
            AnchorVerdict::Dragged => "dragged",
            AnchorVerdict::Slipped => "slipped",
            AnchorVerdict::Lost => "lost",
        }
    }
}
