//! Reads `validation/sweeps.toml`: the references of the sweeps, the sweeps without a reference, and the faults that
//! are known.

use toml::de::DeTable;

use crate::published::{Origin, Source, Standing};
use crate::table::Table;

/// What the file says.
#[derive(Debug)]
pub(super) struct References {
    pub(super) references: Vec<Reference>,
    pub(super) none: Vec<NoReference>,
    pub(super) known_faults: Vec<KnownFault>,
}

/// A reference with which a curve of a sweep is compared.
#[derive(Debug)]
pub(super) struct Reference {
    /// The key of the sweep, and the curve in the sweep.
    pub(super) sweep: String,
    pub(super) curve: String,
    pub(super) short: String,
    pub(super) citation: String,
    pub(super) standing: Standing,
    pub(super) is: Is,
    /// The greatest difference that is allowed, as a share of the reference, or of a quarter of its largest value where
    /// the reference is smaller.
    pub(super) band: f64,
    /// Why this band.
    pub(super) band_from: String,
    /// Why the curve is known to be outside the band; empty if it is not.
    pub(super) known_mismatch: String,
}

/// What a reference is.
#[derive(Debug)]
pub(super) enum Is {
    /// The reference is a list of places on the axis and values.
    Points(Vec<[f64; 2]>),
    /// The reference is a formula of the sweep, between two places on the axis.
    Line { from: f64, to: f64 },
}

/// A sweep for which there is no reference.
#[derive(Debug)]
pub(super) struct NoReference {
    pub(super) sweep: String,
    /// What was looked for as a reference, or why there is none.
    pub(super) looked_for: String,
}

/// A check of a curve that is known to fail.
#[derive(Debug)]
pub(super) struct KnownFault {
    pub(super) sweep: String,
    pub(super) curve: String,
    pub(super) check: String,
    pub(super) note: String,
}

impl References {
    /// Reads the file of references; `sources` has the rows of other validation files, to which references may refer.
    ///
    /// # Errors
    /// Fails with a message that says what is wrong in the file, at which table and key.
    pub(super) fn parse(text: &str, sources: &[Source]) -> Result<References, String> {
        let document = DeTable::parse(text).map_err(|e| e.to_string())?.into_inner();
        let file = Table { name: "file".to_owned(), table: &document };
        file.allow(&["reference", "no_reference", "known_fault"])?;
        let references = file.tables("reference")?;
        let none = file.tables("no_reference")?;
        let faults = file.tables("known_fault")?;
        Ok(References {
            references: references
                .iter()
                .map(|table| reference(table, sources))
                .collect::<Result<_, _>>()?,
            none: none.iter().map(no_reference).collect::<Result<_, _>>()?,
            known_faults: faults.iter().map(known_fault).collect::<Result<_, _>>()?,
        })
    }
}

fn reference(table: &Table<'_, '_>, sources: &[Source]) -> Result<Reference, String> {
    table.allow(&[
        "sweep",
        "curve",
        "short",
        "citation",
        "standing",
        "points",
        "rows",
        "factor",
        "line",
        "band",
        "band_from",
        "known_mismatch",
    ])?;
    let short = table.text("short")?;
    let factor = if table.has("factor") { table.float("factor")? } else { 1.0 };
    let (is, citation, standing) = if table.has("rows") {
        let named: Vec<&Source> = sources.iter().filter(|source| source.short == short).collect();
        let (points, source) = rows(table, &named, factor)?;
        (Is::Points(points), source.citation.clone(), source.standing)
    } else {
        let is = match table.has("line") {
            true => match table.pairs("line")?.as_slice() {
                [[from, to]] => Is::Line { from: *from, to: *to },
                _ => return Err(table.error("line: exactly one pair of places must be given")),
            },
            false => {
                let points = table.pairs("points")?.into_iter();
                Is::Points(points.map(|[x, y]| [x, factor * y]).collect())
            }
        };
        let standing = table.text("standing")?;
        let known = Standing::ALL.into_iter().find(|known| known.text() == standing);
        let known =
            known.ok_or_else(|| table.error(&format!("standing: \"{standing}\" is none")))?;
        (is, table.text("citation")?, known)
    };
    Ok(Reference {
        sweep: table.text("sweep")?,
        curve: table.text("curve")?,
        short,
        citation,
        standing,
        is,
        band: table.float("band")?,
        band_from: table.text("band_from")?,
        known_mismatch: table.text_or_empty("known_mismatch")?,
    })
}

/// Reads points from rows of other files, each with its place on the axis, and their source. Sources of several files
/// may have the same name.
fn rows<'s>(
    table: &Table<'_, '_>,
    named: &[&'s Source],
    factor: f64,
) -> Result<(Vec<[f64; 2]>, &'s Source), String> {
    let mut points = Vec::new();
    let mut of = None;
    for (x, name) in table.named_places("rows")? {
        let is_it = |origin: &Origin| matches!(origin, Origin::Computed(own) if *own == name);
        let row = named.iter().find_map(|source| {
            let row = source.numbers.iter().find(|number| is_it(&number.origin))?;
            Some((*source, row))
        });
        let (source, row) = row.ok_or_else(|| {
            table.error(&format!(
                "rows: no source with the name of this reference has the row {name}"
            ))
        })?;
        points.push([x, factor * row.published]);
        of = Some(source);
    }
    let source = of.ok_or_else(|| table.error("rows: none"))?;
    Ok((points, source))
}

fn no_reference(table: &Table<'_, '_>) -> Result<NoReference, String> {
    table.allow(&["sweep", "looked_for"])?;
    Ok(NoReference { sweep: table.text("sweep")?, looked_for: table.text("looked_for")? })
}

fn known_fault(table: &Table<'_, '_>) -> Result<KnownFault, String> {
    table.allow(&["sweep", "curve", "check", "note"])?;
    Ok(KnownFault {
        sweep: table.text("sweep")?,
        curve: table.text("curve")?,
        check: table.text("check")?,
        note: table.text("note")?,
    })
}
