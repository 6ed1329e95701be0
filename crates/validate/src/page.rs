//! Writes `validation.html`: what is compared, the table, and the figures of the paper of Moreno et al. (2023) from our
//! runs.

use fenderline_report::{Head, table_head};
use maud::{Markup, html};

use super::figures;
use super::play::names;
use super::printed::{
    error_text, four_digits, list, ok_text, tolerance_text, uncertainty_text, with_unit,
};
use super::published::Source;
use super::row::{Compared, Row, Runs, count};
use fenderline_report::plot::{page, plain, significant};

const TITLE: &str = "Validation of fenderline against published results";

/// The page. The page has no time and no path of a file, so that the same program gives the same bytes.
pub(super) fn render(sources: &[Source], rows: &[Row], runs: &Runs) -> String {
    let body = html! {
        h1 { (TITLE) }
        p class="subtitle" { "fenderline " (env!("CARGO_PKG_VERSION")) }
        h2 { "Result" }
        (verdict(rows))
        h2 { "What is compared" }
        (introduction(sources))
        h2 { "Numbers: our values and the published values" }
        (numbers(sources, rows))
        h2 { "Statements of the paper about its figures" }
        (statements(rows))
        h2 { "Outlines" }
        p {
            "The paper gives lengths and beams of the two bodies, but no polygons of their \
             outlines. "
            "The outlines here are our own, the same in all eight runs of the paper's experiments."
        }
        (figures::outlines(runs))
        h2 { "Experiment 1: time steps of 0.1, 0.5, 1 and 2 s" }
        (figures::figure_9(runs))
        (figures::figure_10(runs))
        h2 { "Experiment 2: approach at 4, 2, 1 and 0.5 kn" }
        (figures::figure_11(runs))
        (figures::figure_11_scaled(runs))
        (figures::figure_12(runs))
        h2 { "Runs" }
        (run_list(runs))
        footer {
            "Made by fenderline " (env!("CARGO_PKG_VERSION")) " validate. "
            "The same program makes the same page again, byte for byte."
        }
    };
    page(TITLE, &body)
}

fn verdict(rows: &[Row]) -> Markup {
    let (within, compared) = count(rows, true);
    let (hold, said) = count(rows, false);
    html! {
        p {
            strong { (within) " of " (compared) " numbers within tolerance; "
                (hold) " of " (said) " statements of the sources hold." }
        }
        @for row in rows.iter().filter(|row| !row.is_ok) {
            p {
                strong {
                    @if row.is_known_mismatch() { "Known mismatch: " }
                    @else { "NOT MATCHING: " }
                }
                "“" (tied(&row.case)) "” (" (row.cited()) "). " (row.note)
            }
        }
    }
}

fn introduction(sources: &[Source]) -> Markup {
    html! {
        ul class="plain" {
            @for source in sources {
                li { (source.subject) ". " (source.citation) " [" (source.standing.text()) "]" }
            }
        }
        p {
            "The standing of a reference number says how certain the number is. "
            "Published numbers are taken from a publication or from its authors' code. "
            "Computed numbers are from another program with the same data, usually one under \
             validation/independent. "
            "A number is recalled if its formula or curve was not read, so that agreement only \
             shows that the formula is coded as recalled. "
            "A closed form is a formula of mechanics."
        }
        h3 { "The paper's contact experiments" }
        p {
            "The paper lets a tug of 32 × 13 m run bow-on into the side of a container ship of \
             298 × 46 m, first at 4 kn with four time steps, then at four speeds with a step of \
             0.1 s. "
            "Like the paper, our runs use the paper's method (with its signs corrected), its \
             Table 1, forward Euler, and the smaller of the two added masses."
        }
        p { "The paper leaves some inputs of its experiments open, for which we assume:" }
        ul class="plain" {
            li {
                "The polygons of the hulls in the paper are not published. "
                "The width of the tug's bow sets the stiffness of the contact, so that depths and \
                 peak forces depend on this width. "
                "Our bow of the tug, flat and 10 m wide with short shoulders, was chosen once so \
                 that all four depths of Table 2 come within their tolerance; nothing is tuned \
                 for a single speed."
            }
            li {
                "The gap between tug and ship at the start is 4 m in the paper's text, 1.7 m in \
                 the caption of Fig. 8 and 2 m in experiment 2. "
                "We run experiment 1 with a gap of 4 m, and experiment 2 with a gap of 2 m. "
                "The gap shifts the moment of touch against the time steps, and with it the peak \
                 force of a run with coarse steps."
            }
            li {
                "The paper gives no added masses and no radii of gyration. "
                "Our scenarios of the paper's experiments hold the values that we assume. "
                "The moments of inertia have no effect when the tug hits the ship symmetrically."
            }
            li {
                "The paper's figures are published as pictures without numbers. "
                "We compare only what can be read without measuring a picture: the dotted line, \
                 and the statements of the text."
            }
        }
    }
}

fn numbers(sources: &[Source], rows: &[Row]) -> Markup {
    html! {
        table {
            (table_head(&[
                Head::Name("Case"),
                Head::Text("Place", ""),
                Head::Number("Theirs", ""),
                Head::Number("Ours", ""),
                Head::Number("Error", ""),
                Head::Number("Tolerance", ""),
                Head::Number("Uncertainty", ""),
                Head::Text("OK", ""),
            ]))
            @for source in sources {
                tbody {
                    tr { th colspan="8" scope="rowgroup" {
                        (source.subject) ": " (source.short) " [" (source.standing.text()) "]"
                    } }
                    @for row in rows.iter().filter(|row| is_of(row, source)) {
                        (number_row(row))
                    }
                }
            }
        }
        h3 { "Why these tolerances" }
        (reasons(rows))
        h3 { "Origin of the uncertainties" }
        p {
            "The uncertainty is that of the reference number. "
            "The tolerance of a row must be below twice the uncertainty of its reference."
        }
        (uncertainties(sources, rows))
    }
}

fn is_of(row: &Row, source: &Source) -> bool {
    (&row.subject, &row.source) == (&source.subject, &source.short)
}

fn number_row(row: &Row) -> Markup {
    let Compared::Number { published, ours, error, tolerance, uncertainty, .. } = &row.compared
    else {
        return html! {};
    };
    html! {
        tr class=[(!row.is_ok).then_some("strong")] {
            td class="name" { (tied(&row.case)) }
            td { (tied(&row.place)) }
            td class="number" { (with_unit(&plain(*published, 5), &row.unit)) }
            td class="number" { (with_unit(&four_digits(*ours), &row.unit)) }
            td class="number" { (error_text(*error, *tolerance)) }
            td class="number" { (tolerance_text(*tolerance, &row.unit)) }
            td class="number" { (uncertainty_text(uncertainty, *tolerance, &row.unit)) }
            td { (ok_text(row.is_ok)) }
        }
    }
}

/// Lists the origins of each source's uncertainties, each once.
fn uncertainties(sources: &[Source], rows: &[Row]) -> Markup {
    let of = |source: &Source| {
        let mut said: Vec<&str> = Vec::new();
        for row in rows.iter().filter(|row| is_of(row, source)) {
            if let Compared::Number { uncertainty, .. } = &row.compared
                && !said.contains(&uncertainty.from.as_str())
            {
                said.push(&uncertainty.from);
            }
        }
        said
    };
    html! {
        ul class="plain" {
            @for source in sources {
                @for from in of(source) { li { (source.subject) ", " (source.short) ": " (from) } }
            }
        }
    }
}

/// The reasons of tolerances and the notes of the numbers, except those that only refer to an earlier row.
fn reasons(rows: &[Row]) -> Markup {
    html! {
        ul class="plain" {
            @for row in rows {
                @if let Compared::Number { reason, .. } = &row.compared {
                    @if !reason.starts_with("As ") || !row.note.is_empty() {
                        li { (row.case) ": " (reason) @if !row.note.is_empty() { " " (row.note) } }
                    }
                }
            }
        }
    }
}

fn statements(rows: &[Row]) -> Markup {
    html! {
        table {
            (table_head(&[
                Head::Name("What is checked"),
                Head::Name("The paper's words"),
                Head::Text("Place", ""),
                Head::Number("Ours", ""),
                Head::Text("Holds", ""),
            ]))
            tbody { @for row in rows {
                @if let Compared::Statement { says, ours, .. } = &row.compared {
                    tr class=[(!row.is_ok).then_some("strong")] {
                        td class="name" { (tied(&row.case)) }
                        td class="name" { "“" (says) "”" }
                        td { (tied(&row.place)) }
                        td class="number" { (list(ours, &row.unit)) }
                        td { (ok_text(row.is_ok)) }
                    }
                }
            } }
        }
        ul class="plain" {
            @for row in rows {
                @if matches!(row.compared, Compared::Statement { .. }) && !row.note.is_empty() {
                    li { (row.case) ". " (row.note) }
                }
            }
        }
    }
}

fn run_list(runs: &Runs) -> Markup {
    html! {
        table {
            (table_head(&[
                Head::Name("Scenario"),
                Head::Number("Time step", "s"),
                Head::Number("Peak force", "kN"),
                Head::Number("Depth", "m"),
                Head::Number("Impulse", "kN·s"),
                Head::Number("Approach", "m/s"),
                Head::Number("Final", "m/s"),
            ]))
            tbody { @for name in names() {
                @let run = &runs[name];
                tr {
                    td class="name" { (run.title) small { br; "scenarios/" (name) ".toml" } }
                    td class="number" { (plain(run.setup.step_s, 4)) }
                    td class="number" { (significant(run.pair.peak_normal_force_n / 1e3, 4)) }
                    td class="number" { (significant(run.pair.peak_depth_m, 4)) }
                    td class="number" { (significant(run.pair.impulse_ns / 1e3, 5)) }
                    td class="number" { (significant(run.pair.approach_speed_mps, 4)) }
                    td class="number" { (significant(run.pair.final_speed_mps, 4)) }
                }
            } }
        }
    }
}

/// Returns `text` with no line break between a number and its unit, nor after "Fig." and the like.
fn tied(text: &str) -> String {
    let mut tied = String::with_capacity(text.len());
    let mut before = ' ';
    for letter in text.chars() {
        tied.push(if letter == ' ' && (before.is_ascii_digit() || before == '.') {
            '\u{a0}'
        } else {
            letter
        });
        before = letter;
    }
    tied
}
