//! Charts and plan views as SVG, and the page that holds them.
//!
//! Pages are plain markup without outside resources. A page is complete without its script, prints on A4, and can be
//! read in black and white, because series differ in dash and mark as well as in colour. The same input gives the same
//! bytes of a page.

mod axis;
mod bars;
mod chart;
mod number;
mod page;
mod plan;
mod rose;
mod series;
mod stacked;
mod stand_alone;
mod system;
mod timeline;
mod tornado;

pub use axis::Axis;
pub use bars::{Bars, Group};
pub use chart::{Chart, Reference};
pub use number::{
    Scaled, counted, decimals_for, fixed, ordinal, plain, shortened, significant, times,
};
pub use page::{page, page_of};
pub use plan::{
    Approached, Arrow, DepthLimits, FenderBox, Frame, Harbour, Label, LineDrawn, Outlined,
    PassingDrawn, Place, Plan, PlannedDrawn, Stage, Track, TugDrawn, Use, Weather,
    approached_legend, chart_labels, chart_note, charted_in, fenders_legend, harbour_legend,
    outlined_legend, planned_legend, waypoint_name,
};
pub use rose::{Ring, Rose};
pub use series::{Decimator, Point, Series};
pub use stacked::Stacked;
pub use system::{
    Chain, ConeDrawn, Face, FaceFender, Hull, Level, LevelKind, PanelPlan, Section, Side,
};
pub use timeline::{Fill, Lane, Span, Timeline};
pub use tornado::{Tornado, Whisker};

/// Colours that the colour-blind can tell apart (Okabe and Ito, 2008), in the order in which the series of a chart take
/// them. Yellow is left out because it does not show on white, and a brown is added.
const COLOURS: [&str; STYLES] =
    ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000", "#7F5F3F"];

/// Largest number of series that can be distinguished in one chart.
pub const STYLES: usize = 8;

/// Dashes of the series, in the order of their colours, so that series can be distinguished in print without colour.
const DASHES: [&str; STYLES] =
    ["", "7 3", "2 2.5", "9 3 2 3", "12 4", "4 2 1 2 1 2", "1 4", "16 3 3 3"];

/// The colour of the series or body number `index`.
fn colour(index: usize) -> &'static str {
    COLOURS[index % COLOURS.len()]
}

/// The dash of the series number `index`.
fn dash(index: usize) -> &'static str {
    DASHES[index % DASHES.len()]
}
