//! The words that say in fender and vessel files how well the source of a number is known.

use fenderline_sim::hydro::vessels::Standing;

use crate::choices::{Choice, Choices};

/// How well a number is known.
pub static STANDINGS: Choices<Standing> = Choices(&[
    Choice { word: "found", value: Standing::Found, doc: "read in a public source" },
    Choice { word: "derived", value: Standing::Derived, doc: "computed from other numbers" },
    Choice {
        word: "recalled",
        value: Standing::Recalled,
        doc: "from memory: check the number against its document before you rely on it",
    },
    Choice { word: "assumed", value: Standing::Assumed, doc: "an assumption of the file's author" },
]);
