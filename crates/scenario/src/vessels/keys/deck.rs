//! Keys of the outline and of the deck gear: chocks, bitts and belting.

use fenderline_keys::choices::{Choice, Choices};
use fenderline_keys::held::{Number, OneOf, Points, Vector};
use fenderline_keys::keys::quantities::{LENGTH, PLACE};
use fenderline_keys::spec::Absent::Refused;
use fenderline_keys::spec::{Kind, TableSpec, key};
use fenderline_keys::table_keys;

/// The origin from which the vertices of an outline are measured.
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
            "The origin from which the vertices of the outline are measured.",
            &["\"midship\""],
        ),
        POINTS: Points = key(
            "points",
            Kind::Outline(PLACE),
            Refused,
            "Vertices of the outline, forward and to starboard of the origin, in either direction \
             round the hull. The outline need not be convex.",
            &["[[-16, -6.5], [16, -6.5], [16, 6.5], [-16, 6.5]]"],
        ),
    }
}

static ORIGINS: Choices<OutlineOrigin> = Choices(&[
    Choice {
        word: "midship",
        value: OutlineOrigin::Midship,
        doc: "midship: the point halfway between the perpendiculars, on the centre line",
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
    doc: "A place on deck where a mooring line meets the vessel: a chock or bitts.",
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
            "Place of the chock or bitts, forward and to starboard of midship.",
            &["[140, 5]"],
        ),
        HEIGHT: Number = key(
            "height",
            Kind::Quantity(PLACE),
            Refused,
            "Height of the chock or bitts above the still water, at the vessel's draught.",
            &["\"12 m\""],
        ),
    }
}

pub(super) static BELTING: TableSpec = TableSpec {
    what: "a belting",
    doc: "A belting: a straight strip along the vessel's side or bow, which faces away from \
          midship.",
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
            "One end of the belting, forward and to starboard of midship.",
            &["[16, -4]"],
        ),
        TO: Vector = key(
            "to",
            Kind::Point(PLACE),
            Refused,
            "The other end of the belting, forward and to starboard of midship.",
            &["[16, 4]"],
        ),
        HEIGHT: Number = key(
            "height",
            Kind::Quantity(PLACE),
            Refused,
            "Height of the middle of the belting above the still water at the vessel's draught.",
            &["\"2 m\""],
        ),
        EXTENT: Number = key(
            "extent",
            Kind::Quantity(LENGTH),
            Refused,
            "Vertical extent of the belting.",
            &["\"1.5 m\""],
        ),
    }
}
