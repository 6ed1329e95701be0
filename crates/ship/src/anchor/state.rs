//! The state of an anchor, the orders to its windlass, and its events.

use fenderline_contact::Vec2;

/// Where an anchor is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AnchorPosition {
    /// The anchor is in the hawse pipe.
    Housed,
    /// The anchor hangs on its chain, in the water or above it.
    Hanging,
    /// The anchor lies on the bottom, at the given position north and east (m).
    OnBottom(Vec2),
    /// The anchor is lost, with its chain.
    Lost(LostBy),
}

impl AnchorPosition {
    /// The word for the anchor's position in results and messages.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            AnchorPosition::Housed => "housed",
            AnchorPosition::Hanging => "hanging",
            AnchorPosition::OnBottom(_) => "on_bottom",
            AnchorPosition::Lost(_) => "lost",
        }
    }
}

/// How an anchor was lost.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LostBy {
    /// The chain was slipped by order, so that the anchor was lost with it.
    Slipped,
    /// The chain parted.
    Parted,
    /// All chain ran out, and its inboard end (bitter end) gave way.
    RanOut,
}

/// An order to a windlass.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum WindlassOrder {
    /// The brake is on.
    #[default]
    Hold,
    /// Chain runs out until the given length is out (m); then the brake is put on.
    LetGo(f64),
    /// Chain is paid out under power until the given length is out (m); then the brake is put on.
    Veer(f64),
    /// Chain is hove in until only the given length is out (m); 0 means until the anchor is home. After the chain has
    /// been hove in, the brake is put on.
    Heave(f64),
}

/// Faults of anchor and windlass.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct AnchorFaults {
    /// The windlass has no power: it neither heaves nor veers. While the windlass has no power, the anchor can still be
    /// let go, and the brake holds.
    pub windlass_failed: bool,
    /// The anchor does not bite: it only holds as much as a dragging anchor.
    pub does_not_bite: bool,
}

/// The state of an anchor: plain data.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AnchorState {
    /// Where the anchor is.
    pub position: AnchorPosition,
    /// Length of chain that is out, from the hawse pipe (m).
    pub chain_m: f64,
    /// The present order to the windlass.
    pub order: WindlassOrder,
    /// Whether the anchor drags: it moved in the last step.
    pub dragging: bool,
    /// Whether the brake rendered (slipped under load) in the last step.
    pub rendering: bool,
    /// How far the anchor has dragged since it came to the bottom (m).
    pub dragged_m: f64,
    /// Energy that the dragging of the anchor has taken from the ship in the run (J).
    pub dragged_j: f64,
    /// Faults of anchor and windlass.
    pub faults: AnchorFaults,
}

impl AnchorState {
    /// The state of an anchor in the hawse pipe.
    #[must_use]
    pub fn housed() -> AnchorState {
        AnchorState {
            position: AnchorPosition::Housed,
            chain_m: 0.0,
            order: WindlassOrder::Hold,
            dragging: false,
            rendering: false,
            dragged_m: 0.0,
            dragged_j: 0.0,
            faults: AnchorFaults::default(),
        }
    }

    /// The state of an anchor on the bottom, with the given length of chain out (m).
    #[must_use]
    pub fn on_bottom(at_m: Vec2, chain_m: f64) -> AnchorState {
        AnchorState { position: AnchorPosition::OnBottom(at_m), chain_m, ..AnchorState::housed() }
    }

    /// True if the anchor is lost.
    #[must_use]
    pub fn is_lost(&self) -> bool {
        matches!(self.position, AnchorPosition::Lost(_))
    }

    /// Loses the anchor with its chain.
    pub fn lose(&mut self, by: LostBy) {
        let AnchorState { dragged_m, dragged_j, faults, .. } = *self;
        let position = AnchorPosition::Lost(by);
        *self = AnchorState { position, dragged_m, dragged_j, faults, ..AnchorState::housed() };
    }
}

/// Position of the hawse pipe.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hawse {
    /// North and east (m).
    pub at_m: Vec2,
    /// Height of the hawse pipe above the bottom (m); `None` in deep water.
    pub above_bottom_m: Option<f64>,
}

/// Forces and motions of an anchor and its chain in a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AnchorLoad {
    /// Tension of the chain at the hawse pipe (N).
    pub tension_n: f64,
    /// Force of the chain on the ship at the hawse pipe: north, east, up (N).
    pub on_ship_n: [f64; 3],
    /// Horizontal pull that anchor and chain can hold (N). While the anchor drags, the pull that it holds is its
    /// dragging resistance. The pull that anchor and chain can hold is 0 if the anchor is not on the bottom.
    pub holding_n: f64,
    /// Length of chain that lies on the bottom (m).
    pub on_bottom_m: f64,
    /// How far the anchor dragged in the step (m).
    pub moved_m: f64,
    /// Length of chain that ran out in the step because the brake rendered (slipped under load) (m).
    pub rendered_m: f64,
    /// Whether the windlass stalls because the tension of the chain is too high for it to heave.
    pub stalled: bool,
    /// The tension at which the chain was lost in this step (N).
    pub lost_at_n: Option<f64>,
}

/// How steeply the chain leads downwards, from nearly vertical to nearly level.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stay {
    /// The chain leads within 10° of the vertical.
    UpAndDown,
    /// The chain leads steeper than 60° below the horizontal.
    Short,
    /// The chain leads steeper than 30° below the horizontal, but not steeper than 60°.
    Medium,
    /// Flatter than 30°.
    Long,
}

impl Stay {
    /// The words for it.
    #[must_use]
    pub fn words(self) -> &'static str {
        match self {
            Stay::UpAndDown => "up and down",
            Stay::Short => "short stay",
            Stay::Medium => "medium stay",
            Stay::Long => "long stay",
        }
    }
}

impl AnchorLoad {
    /// The word for how steeply the chain leads below the horizontal. The angles at which the words for the chain's
    /// lead change are our choice. `None` without a pull.
    #[must_use]
    pub fn stay(&self) -> Option<Stay> {
        let [north_n, east_n, up_n] = self.on_ship_n;
        let horizontal_n = libm::hypot(north_n, east_n);
        if self.tension_n <= 0.0 {
            return None;
        }
        let steep_rad = libm::atan2(-up_n, horizontal_n);
        Some(match steep_rad.to_degrees() {
            angle if angle >= 80.0 => Stay::UpAndDown,
            angle if angle >= 60.0 => Stay::Short,
            angle if angle >= 30.0 => Stay::Medium,
            _ => Stay::Long,
        })
    }

    /// Direction of the chain relative to the bow of a ship with the given heading, positive to starboard, −π to π
    /// (rad). The direction is `None` if the chain leads straight down.
    #[must_use]
    pub fn lead_rad(&self, heading_rad: f64) -> Option<f64> {
        let [north_n, east_n, _] = self.on_ship_n;
        // A chain that leads straight down has no direction.
        let leads = libm::hypot(north_n, east_n) > 1e-3 * self.tension_n;
        let direction_rad = libm::atan2(east_n, north_n) - heading_rad;
        leads.then(|| libm::remainder(direction_rad, core::f64::consts::TAU))
    }
}

impl LostBy {
    /// The word in results for the way in which the anchor was lost.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            LostBy::Slipped => "slipped",
            LostBy::Parted => "parted",
            LostBy::RanOut => "ran_out",
        }
    }
}

/// Events of an anchor. An event that lasts, such as dragging, is reported once, when it begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AnchorEvent {
    /// The anchor came to the bottom.
    OnBottom,
    /// The anchor was hove off the bottom.
    Aweigh,
    /// The anchor is home in the hawse pipe.
    Home,
    /// The anchor drags.
    Drags,
    /// The anchor stopped dragging, and holds.
    Holds,
    /// The brake renders: chain slips out under load.
    Renders,
    /// The chain parted.
    Parted,
    /// All chain ran out, and its inboard end (bitter end) gave way.
    RanOut,
    /// An order to the anchor could not be carried out.
    OrderRefused,
}

impl AnchorEvent {
    /// The key of the anchor's event in results.
    #[must_use]
    pub fn key(self) -> &'static str {
        match self {
            AnchorEvent::OnBottom => "anchor_on_bottom",
            AnchorEvent::Aweigh => "anchor_aweigh",
            AnchorEvent::Home => "anchor_home",
            AnchorEvent::Drags => "anchor_drags",
            AnchorEvent::Holds => "anchor_holds",
            AnchorEvent::Renders => "windlass_renders",
            AnchorEvent::Parted => "anchor_chain_parted",
            AnchorEvent::RanOut => "anchor_chain_ran_out",
            AnchorEvent::OrderRefused => "anchor_order_refused",
        }
    }

    /// Text of the event. The text of an event continues a sentence that begins with the anchor's name.
    #[must_use]
    pub fn text(self) -> &'static str {
        match self {
            AnchorEvent::OnBottom => "on the bottom",
            AnchorEvent::Aweigh => "aweigh: off the bottom",
            AnchorEvent::Home => "home in the hawse pipe",
            AnchorEvent::Drags => "DRAGS",
            AnchorEvent::Holds => "holds again",
            AnchorEvent::Renders => "the brake of the windlass renders",
            AnchorEvent::Parted => "its chain PARTED",
            AnchorEvent::RanOut => "all chain RAN OUT, and the bitter end gave way",
            AnchorEvent::OrderRefused => "an order to the anchor could not be carried out",
        }
    }
}
