//! Passing ships in a plan view.

use fenderline_contact::Vec2;
use maud::{Markup, html};

use super::map::Map;

/// A passing ship in a plan view: her outline where she is nearest to a vessel, and her track.
#[derive(Clone, Debug, PartialEq)]
pub struct PassingDrawn {
    /// Outline of the passing ship where she is nearest, earth-fixed (m).
    pub outline_m: Vec<Vec2>,
    /// Track of the passing ship (m).
    pub track_m: Vec<Vec2>,
}

/// Fill and stroke.
const COLOURS: (&str, &str) = ("#e8d6f0", "#7b3294");

pub(super) fn passing(ship: &PassingDrawn, map: &Map) -> Markup {
    let (fill, stroke) = COLOURS;
    html! {
        path d=(map.path(&ship.track_m)) fill="none" stroke=(stroke) stroke-width="1.2"
            stroke-dasharray="8 3 2 3" {}
        path d={ (map.path(&ship.outline_m)) "Z" } fill=(fill) fill-opacity="0.8" stroke=(stroke)
            stroke-width="1.4" stroke-linejoin="round" {}
    }
}

/// The legend for passing ships.
pub(super) fn legend() -> Markup {
    let (fill, stroke) = COLOURS;
    html! {
        li {
            svg width="30" height="12" viewBox="0 0 30 12" aria-hidden="true" {
                path d="M1,6H29" fill="none" stroke=(stroke) stroke-width="1.2" stroke-dasharray="8 3 2 3" {}
                path d="M5,3H21L26,6L21,9H5Z" fill=(fill) stroke=(stroke) {}
            }
            "passing ship at the nearest point, and track"
        }
    }
}
