//! The roles of a scenario's vessels, which are the pilot's own ship, other ships and tugs, and the helm from which a
//! command is given.

use fenderline_sim::order::{TargetKind, towline};
use fenderline_sim::{LineEnd, Setup, VesselSetup};

use crate::action::{Action, OtherAction};
use crate::named_order::NamedOrder;
use crate::request::Control;

/// A vessel counts as a tug if only azimuth units propel her and her length is at most this number (m). The longest
/// harbour and escort tugs are about 50 m long (a number from memory). The greatest length of a tug is our choice.
const LONGEST_TUG_M: f64 = 60.0;

/// The vessels, tugs and lines of a scenario by name, with their roles.
#[derive(Clone, Debug, PartialEq)]
pub struct Cast {
    /// Index of the pilot's own ship among the vessels: the first vessel that is not a tug, or the first vessel if all
    /// are tugs. `None` without vessels.
    pub own: Option<usize>,
    /// Names of the vessels, in the order of the set-up.
    pub vessels: Vec<String>,
    /// For each vessel, whether she is a tug.
    pub is_tug: Vec<bool>,
    /// Names of the vector tugs, which are only forces on vessels and have no hull, in the order of the set-up.
    pub tugs: Vec<String>,
    /// For each vector tug, the index of the vessel that the tug serves.
    pub tug_serves: Vec<usize>,
    /// For each vessel that is a tug, the index of the ship that the tug serves. A tug serves the first ship to which
    /// she has a towline, otherwise the first ship that she may touch, otherwise the pilot's own ship. The search for
    /// the ship that a tug serves begins with the own ship and goes on with the other ships in their order.
    pub serves: Vec<Option<usize>>,
    /// Name of each line, and the vessels at its ends.
    lines: Vec<(String, Vec<usize>)>,
    /// Name of each anchor, and the vessel that carries the anchor.
    anchors: Vec<(String, usize)>,
}

/// The helm, or other place of control, from which a command is given. The helm decides who may give the command.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Helm {
    /// The helm of a vessel or of a vector tug.
    Of(Control),
    /// The helms of the vessels at a line's ends, or of the vessel that carries an anchor; holds the vessels' names.
    Line(Vec<String>),
    /// The place from which weather, faults, and the places of ships before the start are controlled.
    World,
    /// The place from which the speed limit of the docking board and of an approach's alarms is set.
    Board,
    /// An alarm in the list of alarms. The alarm book decides who may acknowledge an alarm.
    Alarm,
    /// The place from which people write notes for the debriefing.
    Notes,
}

/// The ship that a vessel serves, if the vessel is a tug.
fn serves(setup: &Setup, own: Option<usize>, is_tug: &[bool], tug: usize) -> Option<usize> {
    if !is_tug[tug] {
        return None;
    }
    let vessels = &setup.world.vessels;
    let others = (0..vessels.len()).filter(|ship| !is_tug[*ship] && own != Some(*ship));
    let ships: Vec<usize> = own.into_iter().chain(others).collect();
    let body = vessels[tug].body;
    let is_held = |ship: &usize| towline(setup, body, vessels[*ship].body).is_some();
    let is_touched = |ship: &usize| setup.may_touch([body, vessels[*ship].body]);
    let held = ships.iter().copied().find(is_held);
    held.or_else(|| ships.iter().copied().find(is_touched)).or(own)
}

impl Cast {
    /// Finds the roles of the vessels in a scenario's set-up.
    #[must_use]
    pub fn of(setup: &Setup) -> Cast {
        let vessels = &setup.world.vessels;
        let looks_like_a_tug = |vessel: &VesselSetup| {
            vessel.steers_with_azimuths() && vessel.ship.particulars.length_m <= LONGEST_TUG_M
        };
        let first = vessels.iter().position(|vessel| !looks_like_a_tug(vessel));
        let own = first.or((!vessels.is_empty()).then_some(0));
        let is_tug = |(index, vessel)| own != Some(index) && looks_like_a_tug(vessel);
        let name = |vessel: &VesselSetup| setup.bodies[vessel.body].name.clone();
        let on = |body: usize| vessels.iter().position(|vessel| vessel.body == body);
        let lines = setup.world.lines.iter().map(|line| {
            let far = match line.end {
                Some(LineEnd::OnBody { body, .. }) => on(body),
                Some(LineEnd::Fixed(_)) | None => None,
            };
            (line.line.name.clone(), on(line.ship).into_iter().chain(far).collect())
        });
        let anchors = setup.world.anchors.iter();
        let anchors = anchors.map(|anchor| (anchor.gear.name.clone(), anchor.vessel));
        let is_tug: Vec<bool> = vessels.iter().enumerate().map(is_tug).collect();
        let serves = (0..vessels.len()).map(|tug| serves(setup, own, &is_tug, tug)).collect();
        Cast {
            own,
            vessels: vessels.iter().map(name).collect(),
            is_tug,
            serves,
            tugs: setup.world.tugs.iter().map(|tug| tug.tug.name.clone()).collect(),
            tug_serves: setup.world.tugs.iter().map(|tug| tug.vessel).collect(),
            lines: lines.collect(),
            anchors: anchors.collect(),
        }
    }

    /// All helms of a scenario: the vessels, then the vector tugs.
    #[must_use]
    pub fn controls(&self) -> Vec<Control> {
        let vessels = self.vessels.iter().cloned().map(Control::Vessel);
        vessels.chain(self.tugs.iter().cloned().map(Control::Tug)).collect()
    }

    /// Names of all tugs: the tugs that are vessels, then the vector tugs.
    #[must_use]
    pub fn tug_names(&self) -> Vec<String> {
        let vessels = self.vessels.iter().zip(&self.is_tug);
        let vessels = vessels.filter(|(_, is_tug)| **is_tug).map(|(name, _)| name.clone());
        vessels.chain(self.tugs.iter().cloned()).collect()
    }

    /// Indices of the ships that can be conned: the pilot's own ship, then the others. Tugs are not among the ships
    /// that can be conned.
    #[must_use]
    pub fn ships(&self) -> Vec<usize> {
        let ships = (0..self.vessels.len()).filter(|index| !self.is_tug[*index]);
        let others = ships.filter(|index| self.own != Some(*index));
        self.own.into_iter().chain(others).collect()
    }

    /// Names of the ships besides the pilot's own ship and the tugs. Each ship besides the own ship can have her own
    /// pilot.
    #[must_use]
    pub fn other_ships(&self) -> Vec<String> {
        let others = self.ships().into_iter().filter(|index| self.own != Some(*index));
        others.map(|index| self.vessels[index].clone()).collect()
    }

    /// The name of the ship of a pilot: the own ship, or the ship that `pilot` names.
    #[must_use]
    pub fn ship_of<'a>(&'a self, pilot: &'a Option<String>) -> Option<&'a str> {
        match pilot {
            Some(name) => Some(name),
            None => self.own.map(|own| self.vessels[own].as_str()),
        }
    }

    /// The ship that a tug serves: see [`Cast::tug_serves`] and [`Cast::serves`].
    #[must_use]
    pub fn served_by(&self, tug: &str) -> Option<&str> {
        let vector = self.tugs.iter().position(|name| name == tug);
        let vessel = || self.vessels.iter().position(|name| name == tug);
        let ship = vector.map(|tug| self.tug_serves[tug]);
        let ship = ship.or_else(|| self.serves[vessel()?]).or(self.own);
        ship.map(|ship| self.vessels[ship].as_str())
    }

    /// True if the vessel of this name is a tug.
    #[must_use]
    pub fn is_tug(&self, vessel: &str) -> bool {
        let index = self.vessels.iter().position(|name| name == vessel);
        index.is_some_and(|index| self.is_tug[index])
    }

    /// The helm from which the command `action` is given. This function accepts names of vessels that do not exist;
    /// carrying out a command to such a vessel is refused.
    #[must_use]
    pub fn helm(&self, action: &Action) -> Helm {
        match action {
            Action::Order(NamedOrder { order, to, .. }) => match order.spec().target {
                TargetKind::Vessel => Helm::Of(Control::Vessel(to.clone())),
                TargetKind::Tug => Helm::Of(Control::Tug(to.clone())),
                TargetKind::Line => {
                    let ends = self.lines.iter().find(|(name, _)| name == to);
                    let ends = ends.map(|(_, ends)| ends.as_slice()).unwrap_or_default();
                    Helm::Line(ends.iter().map(|&vessel| self.vessels[vessel].clone()).collect())
                }
                TargetKind::Anchor => {
                    let own = self.anchors.iter().filter(|(name, _)| name == to);
                    Helm::Line(own.map(|&(_, vessel)| self.vessels[vessel].clone()).collect())
                }
            },
            Action::Other(other) => match other {
                OtherAction::Tug { tug, .. } if self.vessels.contains(tug) => {
                    Helm::Of(Control::Vessel(tug.clone()))
                }
                OtherAction::Tug { tug, .. } => Helm::Of(Control::Tug(tug.clone())),
                OtherAction::Wind { .. }
                | OtherAction::Current { .. }
                | OtherAction::Visibility { .. }
                | OtherAction::Fault { .. }
                | OtherAction::ThrusterOut { .. }
                | OtherAction::Place { .. }
                | OtherAction::PartLine { .. }
                | OtherAction::AnchorFault { .. }
                | OtherAction::TugOut { .. }
                | OtherAction::Plan { .. }
                | OtherAction::CancelPlanned { .. } => Helm::World,
                OtherAction::ApproachLimit { .. } => Helm::Board,
                OtherAction::Acknowledge { .. } => Helm::Alarm,
                OtherAction::Note { .. } => Helm::Notes,
            },
        }
    }
}
