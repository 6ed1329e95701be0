//! Keys of the outline and of the deck gear: chocks, bitts and belting.

use fenderline_keys::choices::{Choice, Choices};
use fenderline_keys::held::{Number, OneOf, Points, Vector};
use fenderline_keys::keys::quantities::{LENGTH, PLACE};
use fenderline_keys::spec::Absent::Refused;
use fenderline_keys::spec::{Kind, TableSpec, key};
use fenderline_keys::table_keys;

/// The origin of the points of an outline.
#[derive(Clone, Copy, Debug)]
pub(crate) enum OutlineOrigin {
    Midship,
    AfterPerpendicular,
    CentreOfGravity,
}

pub(super) static OUTLINE: TableSpec = TableSpec {
    what: "an outline of a file",
    doc: "A vessel's outline in the horizontal plane.",
    keys: FileOutlineKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of an outline of a file.
    pub(crate) FileOutlineKey {
        ORIGIN: OneOf<OutlineOrigin> = key(
            "origin",
            Kind::Choice(&ORIGINS),
            Refused,
            "The origin of the points.",
            &["\"midship\""],
        ),
        POINTS: Points = key(
            "points",
            Kind::Outline(PLACE),
            Refused,
            "Vertices, forward and to starboard, in either direction round the hull. The outline \
             need not be convex.",
            &["[[-16, -6.5], [16, -6.5], [16, 6.5], [-16, 6.5]]"],
        ),
    }
}

static ORIGINS: Choices<OutlineOrigin> = Choices(&[
    Choice {
        word: "midship",
        value: OutlineOrigin::Midship,
        doc: "half the length between perpendiculars, on the centre line",
    },
    Choice {
        word: "after perpendicular",
        value: OutlineOrigin::AfterPerpendicular,
        doc: "the after perpendicular, on the centre line",
    },
    Choice {
        word: "centre of gravity",
        value: OutlineOrigin::CentreOfGravity,
        doc: "the centre of gravity",
    },
]);

pub(super) static DECK_POINT: TableSpec = TableSpec {
    what: "a point on deck",
    doc: "A place where a line meets the vessel.",
    keys: FileDeckPointKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a point on deck.
    pub(crate) FileDeckPointKey {
        AT: Vector = key(
            "at",
            Kind::Point(PLACE),
            Refused,
            "Forward and starboard of midship.",
            &["[140, 5]"],
        ),
        HEIGHT: Number = key(
            "height",
            Kind::Quantity(PLACE),
            Refused,
            "Height above the still water at the vessel's draught.",
            &["\"12 m\""],
        ),
    }
}

pub(super) static BELTING: TableSpec = TableSpec {
    what: "a belting",
    doc: "A straight strip along the side or the bow, facing away from midship.",
    keys: FileBeltingKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a belting.
    pub(crate) FileBeltingKey {
        FROM: Vector = key(
            "from",
            Kind::Point(PLACE),
            Refused,
            "One end: forward and starboard of midship.",
            &["[16, -4]"],
        ),
        TO: Vector = key(
            "to",
            Kind::Point(PLACE),
            Refused,
            "The other end: forward and starboard of midship.",
            &["[16, 4]"],
        ),
        HEIGHT: Number = key(
            "height",
            Kind::Quantity(PLACE),
            Refused,
            "Height of the strip's middle above the still water at the vessel's draught.",
            &["\"2 m\""],
        ),
        EXTENT: Number = key(
            "extent",
            Kind::Quantity(LENGTH),
            Refused,
            "Vertical extent of the strip.",
            &["\"1.5 m\""],
        ),
    }
}
