//! Any file and any option give a scenario or one error, never a panic.

use fenderline_scenario::{Override, Scenario};
use proptest::prelude::*;

const TEXT: &str = include_str!("../../../scenarios/oblique_hit.toml");

/// Pieces that TOML and scenarios are made of.
const PIECES: &[&str] = &[
    "[",
    "]",
    "[[",
    "]]",
    "{",
    "}",
    "=",
    "\"",
    "'",
    "\"\"\"",
    ".",
    ",",
    "\n",
    "#",
    "*",
    "-",
    "e",
    "nan",
    "inf",
    "0x",
    "1e308",
    "-1",
    "true",
    "1979-05-27",
    "m",
    "kN/",
    "^9",
    "°",
    "body",
    "pair",
    "fixed = true",
    "outline",
    "mass",
    "\\u0000",
    "\u{feff}",
    "\r",
    "é",
    "…",
];

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    #[test]
    fn a_damaged_file_does_not_panic(
        cuts in prop::collection::vec((0..TEXT.len(), 0_usize..20, 0..PIECES.len()), 1..6),
    ) {
        let mut text = TEXT.to_owned();
        for (start, length, piece) in cuts {
            let start = text.floor_char_boundary(start);
            let end = text.floor_char_boundary(start + length).max(start);
            text.replace_range(start..end, PIECES[piece]);
        }
        if let Err(error) = Scenario::parse(&text, "x.toml") {
            let shown = error.to_string();
            prop_assert!(shown.lines().count() <= 6 && shown.starts_with("error: "), "{}", shown);
        }
    }

    #[test]
    fn any_line_does_not_panic(line in "[\\[\\]{}=\".,#a-z0-9 '\\\\-]{0,60}", at in 0..TEXT.len()) {
        let line_end = TEXT[TEXT.floor_char_boundary(at)..].find('\n').map_or(TEXT.len(), |n| {
            TEXT.floor_char_boundary(at) + n
        });
        let text = format!("{}\n{line}{}", &TEXT[..line_end], &TEXT[line_end..]);
        if let Err(error) = Scenario::parse(&text, "x.toml") {
            prop_assert!(!error.to_string().is_empty());
        }
    }

    #[test]
    fn any_override_does_not_panic(
        key in "(time|body|pair|load|contact|material|\"\"|[a-z*0]{0,3})(\\.[a-z_\"0-9]{0,8}){0,3}",
        value in "\\PC{0,20}",
    ) {
        if let Ok(change) = Override::parse(&format!("{key}={value}"))
            && let Err(error) = Scenario::parse_with(TEXT, "x.toml", &[change])
        {
            prop_assert!(!error.to_string().is_empty());
        }
    }
}
