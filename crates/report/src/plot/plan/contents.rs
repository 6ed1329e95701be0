//! The contents of a plan view.

use fenderline_contact::Vec2;

use super::box2::Box2;
use super::fenders::FenderBox;
use super::harbour::{self, Harbour};
use super::map::{Arrow, Frame, Label, Map};
use super::{arrows, furniture};

/// A plan view to draw.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// Title, printed above the plan view.
    pub title: String,
    /// The part of the plane that the view shows.
    pub frame: Frame,
    /// Outlines of bodies, drawn from the first to the last.
    pub outlines: Vec<Outlined>,
    /// Fenders, drawn over the outlines.
    pub fenders: Vec<FenderBox>,
    /// Mooring lines, tugs, wind and current.
    pub harbour: Harbour,
    /// Paths of bodies.
    pub tracks: Vec<Track>,
    /// Arrows of forces, and the points where the forces act.
    pub arrows: Vec<Arrow>,
    /// Names to write into the view.
    pub labels: Vec<Label>,
    /// Note below the plan view; empty for none.
    pub note: String,
}

/// The moment of the run at which an outline is shown, which sets the style of drawing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// The outline of a body that does not move.
    Fixed,
    /// The outline at the start of the run.
    Start,
    /// The outline at the moment of the largest force.
    Peak,
    /// The outline at the end of the run.
    End,
}

/// The outline of a body, earth-fixed (m).
#[derive(Clone, Debug, PartialEq)]
pub struct Outlined {
    /// Corners of the outline (m).
    pub vertices_m: Vec<Vec2>,
    /// The moment of the run at which the outline is shown.
    pub stage: Stage,
    /// Number of the outline's colour; fixed bodies are grey.
    pub style: usize,
}

/// The path of a body's centre of gravity, earth-fixed (m).
#[derive(Clone, Debug, PartialEq)]
pub struct Track {
    /// Points of the track (m).
    pub points_m: Vec<Vec2>,
    /// Number of the body's colour.
    pub style: usize,
    /// True for a track that is drawn thin and faint, because many tracks lie over each other.
    pub is_one_of_many: bool,
}

impl Plan {
    /// The rectangles of the plan view that no text may cover.
    pub(super) fn obstacles(&self, map: &Map) -> Vec<Box2> {
        let mut all = furniture::boxes(map);
        all.extend(harbour::boxes(&self.harbour, map));
        all.extend(self.arrows.iter().flat_map(|arrow| arrows::boxes(arrow, map)));
        all.extend(self.fenders.iter().map(|fender| Box2::around(&fender.corners(map), 0.0)));
        all
    }

    /// The texts that need a place in the plan view: first those of the tugs, then the names.
    pub(super) fn texts(&self) -> impl Iterator<Item = &str> {
        let tugs = self.harbour.tugs.iter().map(|tug| tug.label.as_str());
        tugs.chain(self.labels.iter().map(|label| label.text.as_str()))
    }
}
