//! The words for how well the source of a number is known, in fender and vessel files.

use fenderline_sim::hydro::vessels::Standing;

use crate::choices::{Choice, Choices};

/// How well a number is known.
pub static STANDINGS: Choices<Standing> = Choices(&[
    Choice { word: "found", value: Standing::Found, doc: "read in a public source" },
    Choice { word: "derived", value: Standing::Derived, doc: "computed from others" },
    Choice {
        word: "recalled",
        value: Standing::Recalled,
        doc: "to be checked against the document before it is relied on",
    },
    Choice { word: "assumed", value: Standing::Assumed, doc: "an assumption of the file's author" },
]);
