//! Reads published numbers and statements from the files in `validation/`.

use toml::de::DeTable;

use super::quantity::Quantity;
use super::table::Table;

/// A publication, with the numbers and statements that are compared with it.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Source {
    /// Subject of the publication: the heading of its rows.
    pub(super) subject: String,
    /// How certain the publication's numbers are.
    pub(super) standing: Standing,
    /// Name in the table.
    pub(super) short: String,
    /// In full.
    pub(super) citation: String,
    pub(super) numbers: Vec<Number>,
    pub(super) statements: Vec<Statement>,
}

/// How certain a reference number is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Standing {
    /// The number is published, and was taken from the publication.
    Published,
    /// The number was calculated by another program, from the same data.
    Computed,
    /// The number is by a formula or from a curve that was recalled, not read. Agreement with a recalled number only
    /// shows that the formula is coded as recalled.
    Recalled,
    /// The number is a closed form of mechanics.
    ClosedForm,
}

impl Standing {
    pub(super) const ALL: [Standing; 4] =
        [Standing::Published, Standing::Computed, Standing::Recalled, Standing::ClosedForm];

    /// The standing's name in the files of published numbers.
    pub(super) fn text(self) -> &'static str {
        match self {
            Standing::Published => "published",
            Standing::Computed => "computed",
            Standing::Recalled => "recalled",
            Standing::ClosedForm => "closed form",
        }
    }
}

/// Where our value comes from that is compared with a published one.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Origin {
    /// Our value comes from the run of a scenario.
    Run {
        /// The scenario that reproduces the published case.
        run: String,
        quantity: Quantity,
        /// The scenario by whose value ours is divided.
        relative_to: Option<String>,
    },
    /// Our value is a computed value, given by its name.
    Computed(String),
}

/// One published value.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Number {
    pub(super) case: String,
    /// Where in the source.
    pub(super) place: String,
    pub(super) origin: Origin,
    /// In the unit.
    pub(super) published: f64,
    pub(super) unit: String,
    pub(super) tolerance: Tolerance,
    /// Why this tolerance.
    pub(super) reason: String,
    /// How far the reference number itself may be off.
    pub(super) uncertainty: Uncertainty,
    /// True if the number is out of the tolerance, and the note says why.
    pub(super) known_mismatch: bool,
    pub(super) note: String,
}

/// The permitted difference of our value from the published value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Tolerance {
    /// The tolerance is a share of the published value.
    Relative(f64),
    /// The tolerance is a number in the unit of the value.
    Absolute(f64),
}

impl Tolerance {
    /// The same tolerance, in the unit of a published value of the given size.
    fn absolute(self, published: f64) -> f64 {
        match self {
            Tolerance::Relative(share) => share * published.abs(),
            Tolerance::Absolute(bound) => bound,
        }
    }
}

/// The uncertainty of a reference number, and how it is known. A tolerance must be below twice the uncertainty of its
/// reference: a wider tolerance would pass differences that the reference resolves.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Uncertainty {
    /// Size of the uncertainty in the terms of the row's tolerance: a share, or a number in the row's unit.
    pub(super) size: f64,
    /// Where the uncertainty of the reference comes from: repeated trials, printed digits, or the steps of either
    /// program.
    pub(super) from: String,
}

/// An uncertainty that several rows of a file share.
#[derive(Clone, Debug)]
struct SharedUncertainty {
    name: String,
    size: Tolerance,
    from: String,
}

/// A statement in words that a source makes, without a number.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Statement {
    pub(super) case: String,
    pub(super) place: String,
    /// The source's words.
    pub(super) says: String,
    /// The scenarios whose values the statement compares, in the order of the rule.
    pub(super) runs: Vec<String>,
    pub(super) quantity: Quantity,
    pub(super) rule: Rule,
    /// True if the statement does not hold, and the note says why.
    pub(super) known_mismatch: bool,
    pub(super) note: String,
}

/// The rule that a statement makes for a list of values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Rule {
    /// Each value is larger than the value before it.
    Rises,
    /// Each value is smaller than the value before it.
    Falls,
    /// No value is smaller than the value before it, and the last is larger than the first.
    DoesNotFall,
    /// Each difference between neighbouring values is smaller than the difference before it.
    Converges,
    /// All values lie between `low` and `high`, in the quantity's unit.
    Within { low: f64, high: f64 },
}

impl Rule {
    /// Whether the given values satisfy the rule.
    pub(super) fn holds(self, values: &[f64]) -> bool {
        let all = |fits: fn(f64, f64) -> bool| values.windows(2).all(|two| fits(two[0], two[1]));
        match self {
            Rule::Rises => all(|a, b| a < b),
            Rule::Falls => all(|a, b| a > b),
            Rule::DoesNotFall => all(|a, b| a <= b) && values.first() < values.last(),
            Rule::Converges => values
                .windows(3)
                .all(|three| (three[1] - three[2]).abs() < (three[0] - three[1]).abs()),
            Rule::Within { low, high } => values.iter().all(|v| (low..=high).contains(v)),
        }
    }
}

impl Source {
    /// Reads the text of a file of published numbers: its sources with their numbers and statements.
    ///
    /// # Errors
    /// Fails with a message that says what is wrong in the file, at which case and key.
    pub(super) fn parse(text: &str) -> Result<Vec<Source>, String> {
        let document = DeTable::parse(text).map_err(|e| e.to_string())?.into_inner();
        let file = Table { name: "file".to_owned(), table: &document };
        file.allow(&["subject", "reference", "uncertainty", "number", "statement"])?;
        let subject = file.text("subject")?;
        let references = file.tables("reference")?;
        let mut sources = references
            .iter()
            .map(|reference| reference_of(reference, &subject))
            .collect::<Result<Vec<Source>, String>>()?;
        let shared = file.tables("uncertainty")?;
        let shared = shared
            .iter()
            .map(shared_uncertainty)
            .collect::<Result<Vec<SharedUncertainty>, String>>()?;
        let numbers = file.tables("number")?;
        for table in &numbers {
            cited(table, &mut sources)?.numbers.push(number(table, &shared)?);
        }
        let is_used = |one: &&SharedUncertainty| {
            numbers.iter().any(|table| table.text("uncertainty").is_ok_and(|name| name == one.name))
        };
        if let Some(idle) = shared.iter().find(|one| !is_used(one)) {
            return Err(format!("uncertainty \"{}\": no row names it", idle.name));
        }
        for table in file.tables("statement")? {
            cited(&table, &mut sources)?.statements.push(statement(&table)?);
        }
        Ok(sources)
    }
}

fn reference_of(table: &Table<'_, '_>, subject: &str) -> Result<Source, String> {
    table.allow(&["short", "citation", "standing"])?;
    let standing = table.text("standing")?;
    let known = Standing::ALL.into_iter().find(|known| known.text() == standing);
    Ok(Source {
        subject: subject.to_owned(),
        standing: known.ok_or_else(|| table.error(&format!("standing: \"{standing}\" is none")))?,
        short: table.text("short")?,
        citation: table.text("citation")?,
        numbers: Vec::new(),
        statements: Vec::new(),
    })
}

fn shared_uncertainty(table: &Table<'_, '_>) -> Result<SharedUncertainty, String> {
    table.allow(&["name", "share", "absolute", "from"])?;
    let size = if table.has("absolute") {
        Tolerance::Absolute(table.float("absolute")?)
    } else {
        Tolerance::Relative(table.float("share")?)
    };
    Ok(SharedUncertainty { name: table.text("name")?, size, from: table.text("from")? })
}

/// Reads the uncertainty of a row: an uncertainty of the file, by its name, or the row's own, which is a number in the
/// terms of the tolerance with `uncertainty_from`. The tolerance of the row must be below twice the uncertainty.
fn uncertainty(
    table: &Table<'_, '_>,
    shared: &[SharedUncertainty],
    published: f64,
    tolerance: Tolerance,
) -> Result<Uncertainty, String> {
    let (size, from) = match table.text("uncertainty") {
        Ok(name) => {
            let found = shared.iter().find(|one| one.name == name);
            let found = found.ok_or_else(|| {
                table.error(&format!(
                    "uncertainty: the file has no uncertainty with the name \"{name}\""
                ))
            })?;
            (found.size.absolute(published), found.from.clone())
        }
        Err(_) => {
            let size = table.float("uncertainty")?;
            let size = match tolerance {
                Tolerance::Relative(_) => Tolerance::Relative(size),
                Tolerance::Absolute(_) => Tolerance::Absolute(size),
            };
            (size.absolute(published), table.text("uncertainty_from")?)
        }
    };
    let widest = tolerance.absolute(published);
    if size.is_nan() || size <= 0.0 || widest >= 2.0 * size {
        return Err(table.error(&format!(
            "tolerance: {widest} is not below twice the uncertainty of {size}, in the unit of the row"
        )));
    }
    let size = match tolerance {
        Tolerance::Relative(_) => size / published.abs(),
        Tolerance::Absolute(_) => size,
    };
    Ok(Uncertainty { size, from })
}

/// Finds the source that a case names; without a name, the only source of the file.
fn cited<'s>(table: &Table<'_, '_>, sources: &'s mut [Source]) -> Result<&'s mut Source, String> {
    if sources.len() == 1 && !table.has("source") {
        return Ok(&mut sources[0]);
    }
    let short = table.text("source")?;
    let found = sources.iter_mut().find(|source| source.short == short);
    found.ok_or_else(|| {
        table.error(&format!("source: the file has no source with the name \"{short}\""))
    })
}

fn number(table: &Table<'_, '_>, shared: &[SharedUncertainty]) -> Result<Number, String> {
    table.allow(&[
        "case",
        "source",
        "place",
        "run",
        "quantity",
        "relative_to",
        "computed",
        "published",
        "unit",
        "tolerance",
        "tolerance_absolute",
        "reason",
        "uncertainty",
        "uncertainty_from",
        "known_mismatch",
        "note",
    ])?;
    let (origin, unit) = origin(table)?;
    let published = table.float("published")?;
    let tolerance = if table.has("tolerance_absolute") {
        Tolerance::Absolute(table.float("tolerance_absolute")?)
    } else if published != 0.0 {
        Tolerance::Relative(table.float("tolerance")?)
    } else {
        return Err(
            table.error("tolerance: a share of zero allows no difference; use tolerance_absolute")
        );
    };
    let (known_mismatch, note) = mismatch(table)?;
    Ok(Number {
        case: table.text("case")?,
        place: table.text("place")?,
        origin,
        published,
        unit,
        tolerance,
        reason: table.text("reason")?,
        uncertainty: uncertainty(table, shared, published, tolerance)?,
        known_mismatch,
        note,
    })
}

/// Reads where our value comes from, and its unit. The unit of a computed value is checked when the rows are made.
fn origin(table: &Table<'_, '_>) -> Result<(Origin, String), String> {
    let unit = table.text("unit")?;
    if table.has("computed") {
        for other in ["run", "quantity", "relative_to"] {
            if table.has(other) {
                return Err(table.error(&format!(
                    "{other}: a row with a computed value may not have this key"
                )));
            }
        }
        return Ok((Origin::Computed(table.text("computed")?), unit));
    }
    let quantity = quantity(table)?;
    let relative_to = table.has("relative_to").then(|| table.text("relative_to")).transpose()?;
    let expected = if relative_to.is_some() { "" } else { quantity.unit() };
    if unit != expected {
        return Err(table.error(&format!(
            "unit: the row has \"{unit}\", but the quantity has the unit \"{expected}\""
        )));
    }
    Ok((Origin::Run { run: table.text("run")?, quantity, relative_to }, unit))
}

/// Reads the quantity that a row compares.
fn quantity(table: &Table<'_, '_>) -> Result<Quantity, String> {
    let name = table.text("quantity")?;
    Quantity::named(&name)
        .ok_or_else(|| table.error(&format!("there is no quantity with the name {name}")))
}

/// Reads whether a mismatch is known, and the note, which must then give the reason.
fn mismatch(table: &Table<'_, '_>) -> Result<(bool, String), String> {
    let known_mismatch = table.has("known_mismatch") && table.flag("known_mismatch")?;
    let note = table.text_or_empty("note")?;
    if known_mismatch && note.is_empty() {
        return Err(
            table.error("note: a row with a known mismatch needs a note that gives the reason")
        );
    }
    Ok((known_mismatch, note))
}

fn statement(table: &Table<'_, '_>) -> Result<Statement, String> {
    table.allow(&[
        "case",
        "source",
        "place",
        "says",
        "runs",
        "quantity",
        "holds",
        "low",
        "high",
        "known_mismatch",
        "note",
    ])?;
    let rule = match table.text("holds")?.as_str() {
        "rises" => Rule::Rises,
        "falls" => Rule::Falls,
        "does_not_fall" => Rule::DoesNotFall,
        "converges" => Rule::Converges,
        "within" => Rule::Within { low: table.float("low")?, high: table.float("high")? },
        other => {
            return Err(table.error(&format!("holds: there is no rule with the name \"{other}\"")));
        }
    };
    let (known_mismatch, note) = mismatch(table)?;
    Ok(Statement {
        case: table.text("case")?,
        place: table.text("place")?,
        says: table.text("says")?,
        runs: table.texts("runs")?,
        quantity: quantity(table)?,
        rule,
        known_mismatch,
        note,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_rule_accepts_and_refuses_the_right_values() {
        let table = [
            (Rule::Rises, &[1.0, 2.0, 3.0][..], true),
            (Rule::Rises, &[1.0, 1.0, 3.0], false),
            (Rule::Falls, &[3.0, 2.0, 1.0], true),
            (Rule::Falls, &[3.0, f64::NAN, 1.0], false),
            (Rule::DoesNotFall, &[1.0, 1.0, 2.0], true),
            (Rule::DoesNotFall, &[1.0, 1.0, 1.0], false),
            (Rule::Converges, &[1.0, 3.0, 4.0], true),
            (Rule::Converges, &[1.0, 2.0, 4.0], false),
            (Rule::Within { low: 1.0, high: 2.0 }, &[1.0, 2.0], true),
            (Rule::Within { low: 1.0, high: 2.0 }, &[0.9, 1.5], false),
        ];
        for (rule, values, holds) in table {
            assert_eq!(rule.holds(values), holds, "{rule:?} of {values:?}");
        }
    }

    #[test]
    fn errors_in_a_file_name_case_and_key() {
        let good = "subject = 'x'\n[[reference]]\nshort = 's'\ncitation = 'c'\n\
                    standing = 'published'\n[[number]]\ncase = 'depth'\nplace = 'p'\n\
                    run = 'r'\nquantity = 'peak_depth'\npublished = 1\nunit = 'm'\n\
                    tolerance = 0.1\nreason = 'x'\nuncertainty = 0.06\nuncertainty_from = 'y'\n";
        assert!(Source::parse(good).is_ok());
        let table = [
            (
                "unit = 'm'",
                "unit = 'kN'",
                "depth: unit: the row has \"kN\", but the quantity has the unit \"m\"",
            ),
            ("reason", "raeson", "depth: unknown key raeson"),
            ("published = 1\n", "published = 'one'\n", "depth: published is no number"),
            ("published = 1\n", "published = 0\n", "depth: tolerance: a share of zero"),
            ("tolerance = 0.1\n", "", "depth: tolerance is missing"),
            ("'peak_depth'", "'depth'", "depth: there is no quantity with the name depth"),
            ("uncertainty = 0.06\n", "", "depth: uncertainty is missing"),
            ("uncertainty_from = 'y'\n", "", "depth: uncertainty_from is missing"),
            (
                "0.06",
                "'trials'",
                "depth: uncertainty: the file has no uncertainty with the name \"trials\"",
            ),
            ("0.06", "0.05", "depth: tolerance: 0.1 is not below twice the uncertainty of 0.05"),
            ("0.06", "0", "depth: tolerance: 0.1 is not below twice the uncertainty of 0"),
            (
                "[[number]]",
                "[[uncertainty]]\nname = 'z'\nshare = 0.1\nfrom = 'w'\n[[number]]",
                "uncertainty \"z\": no row names it",
            ),
            ("'published'", "'sure'", "reference: standing: \"sure\" is none"),
            (
                "place = 'p'",
                "place = 'p'\nsource = 't'",
                "depth: source: the file has no source with the name \"t\"",
            ),
            (
                "place = 'p'",
                "place = 'p'\ncomputed = 't'",
                "depth: run: a row with a computed value may not have this key",
            ),
            (
                "place = 'p'",
                "place = 'p'\nknown_mismatch = true",
                "depth: note: a row with a known mismatch",
            ),
        ];
        for (from, to, message) in table {
            let got = Source::parse(&good.replacen(from, to, 1)).expect_err(message);
            assert!(got.starts_with(message), "{got}");
        }
    }

    #[test]
    fn a_shared_uncertainty_is_converted_to_the_terms_of_each_row() {
        let file = |size: &str, row: &str| {
            format!(
                "subject = 'x'\n[[reference]]\nshort = 's'\ncitation = 'c'\nstanding = 'published'\n\
                 [[uncertainty]]\nname = 'trials'\n{size}\nfrom = 'two runs'\n[[number]]\ncase = 'speed'\n\
                 place = 'p'\ncomputed = 'v'\npublished = -4\nunit = 'm/s'\n{row}\nreason = 'x'\n\
                 uncertainty = 'trials'\n"
            )
        };
        let size_of = |size: &str, row: &str| {
            let sources = Source::parse(&file(size, row))?;
            Ok::<f64, String>(sources[0].numbers[0].uncertainty.size)
        };
        assert_eq!(size_of("share = 0.05", "tolerance = 0.09"), Ok(0.05));
        assert_eq!(size_of("share = 0.05", "tolerance_absolute = 0.3"), Ok(0.2));
        assert_eq!(size_of("absolute = 0.2", "tolerance = 0.09"), Ok(0.05));
        assert!(size_of("absolute = 0.2", "tolerance = 0.11").is_err(), "0.44 m/s");
        assert!(
            size_of("share = 0.05", "tolerance_absolute = 0.4").is_err(),
            "not below twice 0.2 m/s"
        );
    }
}
