//! Finds the source of each number of a vessel. Every number must have one source, and every source at least one
//! number.

use fenderline_sim::hydro::vessels::{Figure, Origin, Source, Standing};

use super::data::VesselData;
use super::figures::{Leaf, leaves};
use crate::vessels::keys::FileVesselKey;
use crate::vessels::keys::source::FileSourceKey;
use crate::vessels::keys::stern::{FilePropellerKey, FileRudderKey};
use fenderline_keys::checked::{Entry, Of};
use fenderline_keys::error::ScenarioError;
use fenderline_keys::held::Texts;
use fenderline_keys::keys::vessel::VesselKey;
use fenderline_keys::sources::{Sources, quoted};
use fenderline_keys::typed_key::AnyKey;
use fenderline_keys::{any_keys, key_path};

/// The keys that a vessel may take from the vessel of `coefficients_of`.
const INHERITED: &[AnyKey<FileVesselKey>] =
    any_keys![FileVesselKey: ADDED_MASS, SWAY_POLYNOMIAL, DRIFT_POLYNOMIAL, LOW_SPEED];
/// The keys of the propeller that a vessel may take from the vessel of `coefficients_of`.
const OF_PROPELLER: &[AnyKey<FilePropellerKey>] = any_keys![
    FilePropellerKey: THRUST, SERIES, THRUST_DEDUCTION, THRUST_DEDUCTION_ASTERN, WAKE, WAKE_CHANGE,
    PLACE
];
/// The keys of the rudder that a vessel may take from the vessel of `coefficients_of`.
const OF_RUDDER: &[AnyKey<FileRudderKey>] = any_keys![
    FileRudderKey: LIFT_GRADIENT, WAKE_RATIO, RACE_GAIN, STRAIGHTENING, STRAIGHTENING_PLACE,
    RESISTANCE_DEDUCTION, HULL_GAIN, HULL_PLACE, PLACE
];

/// The dotted paths of all keys that a vessel may take from another vessel.
fn inherited_paths() -> impl Iterator<Item = String> {
    let of = |part: AnyKey<FileVesselKey>, name: &str| key_path::join(part.name(), name);
    let propeller = FileVesselKey::PROPELLER.any();
    let rudder = FileVesselKey::RUDDER.any();
    let own = INHERITED.iter().map(|key| key.name().to_owned());
    own.chain(OF_PROPELLER.iter().map(move |key| of(propeller, key.name())))
        .chain(OF_RUDDER.iter().map(move |key| of(rudder, key.name())))
}

/// Whether a key of a source covers the number at a path.
fn covers(key: &str, path: &str) -> bool {
    path.strip_prefix(key).is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
}

fn given(group: String, figures: Vec<Figure>, source: &str, standing: Standing) -> Source {
    Source { group, figures, source: source.to_owned(), standing, is_estimate: false }
}

/// The sources of the numbers of a vessel in a vessel file.
///
/// # Errors
/// Fails if a number has no source, if a source covers no number, or if a key has two sources.
pub(super) fn of_file(
    sources: &Sources<'_>,
    table: Of<'_, FileVesselKey>,
) -> Result<Vec<Source>, ScenarioError> {
    let entries = table.given(FileVesselKey::SOURCE).list();
    let leaves = leaves(table.table());
    let keys: Vec<(usize, Entry<'_, Texts>, &String)> = entries
        .iter()
        .enumerate()
        .flat_map(|(index, entry)| {
            let of = entry.given(FileSourceKey::OF);
            of.texts().iter().map(move |key| (index, of, key))
        })
        .collect();
    for (place, (index, of, key)) in keys.iter().enumerate() {
        let complain = |message: String| {
            let path = entries.at(*index).path_of(FileSourceKey::OF);
            Err(sources.error(&of.span, &path, format!("`{path}`: {message}")))
        };
        if !leaves.iter().any(|leaf| !leaf.is_default && covers(key, &leaf.figure.name)) {
            return complain(format!("the vessel has no number under {}", quoted(key)));
        }
        if keys[..place].iter().any(|(_, _, other)| other == key) {
            return complain(format!("{} has two sources", quoted(key)));
        }
    }
    let mut found: Vec<Source> = entries
        .iter()
        .map(|entry| {
            let source = entry.given(FileSourceKey::SOURCE).text();
            let standing = entry.given(FileSourceKey::STANDING).choice();
            given(entry.given(FileSourceKey::OF).texts().join(", "), Vec::new(), source, standing)
        })
        .collect();
    let mut defaults = Vec::new();
    for Leaf { figure, is_default, key_span } in leaves {
        if is_default {
            defaults.push(figure);
            continue;
        }
        let nearest = keys.iter().filter(|(_, _, key)| covers(key, &figure.name));
        let Some((index, ..)) = nearest.max_by_key(|(_, _, key)| key.len()) else {
            let path = format!("{}.{}", table.path, figure.name);
            let error = sources.error(&key_span, &path, format!("`{path}` has no source"));
            return Err(error.with_help(format!(
                "write [[{}.source]] with of = [\"{}\"], source and standing",
                table.path, figure.name
            )));
        };
        found[*index].figures.push(figure);
    }
    found.extend(defaults_of(defaults));
    Ok(found)
}

/// The sources of the numbers of a vessel that a scenario defines.
pub(super) fn of_scenario<T>(table: Of<'_, T>) -> Vec<Source> {
    of_leaves(leaves(table.table()))
}

fn of_leaves(leaves: Vec<Leaf>) -> Vec<Source> {
    let (defaults, own): (Vec<_>, Vec<_>) = leaves.into_iter().partition(|leaf| leaf.is_default);
    let figures = |leaves: Vec<Leaf>| leaves.into_iter().map(|leaf| leaf.figure).collect();
    let mut all = Vec::new();
    if !own.is_empty() {
        all.push(given("given".to_owned(), figures(own), "the scenario", Standing::Given));
    }
    all.extend(defaults_of(figures(defaults)));
    all
}

/// The source of numbers that are the program's defaults.
pub(super) fn defaults_of(figures: Vec<Figure>) -> Option<Source> {
    let source = "default of the program";
    (!figures.is_empty()).then(|| given("defaults".to_owned(), figures, source, Standing::Assumed))
}

/// The source of numbers that are scaled by Froude's law from another vessel.
pub(super) fn scaled(figures: Vec<Figure>, base: &VesselData) -> Option<Source> {
    let source = format!("by Froude's law from {}", base.origin.title);
    let group = figures.iter().map(|figure| figure.name.clone()).collect::<Vec<_>>().join(", ");
    (!figures.is_empty()).then(|| given(group, figures, &source, Standing::Derived))
}

/// The sources of coefficients that are taken from another vessel.
pub(super) fn inherited<T>(table: Of<'_, T>, base: &VesselData) -> Vec<Source> {
    let own = leaves(table.table());
    let is_own =
        |key: &str| own.iter().any(|leaf| !leaf.is_default && covers(key, &leaf.figure.name));
    let taken: Vec<String> = inherited_paths().filter(|key| !is_own(key)).collect();
    let of_base = base.origin.sources.iter().filter(|source| !source.is_estimate);
    of_base
        .filter_map(|source| {
            let mut source = source.clone();
            source.figures.retain(|figure| taken.iter().any(|key| covers(key, &figure.name)));
            source.group = format!("as {}", base.origin.title);
            (!source.figures.is_empty()).then_some(source)
        })
        .collect()
}

/// The sources of a vessel that a scenario derives from another vessel, without the sources of the replaced numbers.
/// Propeller and rudder of the derived vessel are replaced key by key, everything else by whole tables.
pub(super) fn replaced<T>(base: &Origin, table: Of<'_, T>) -> Origin {
    let by_key = |name: &str| {
        covers(VesselKey::PROPELLER.name(), name) || covers(VesselKey::RUDDER.name(), name)
    };
    let own = leaves(table.table());
    let is_replaced = |figure: &Figure| {
        let group = figure.name.split('.').next().unwrap_or_default();
        let mut names = own.iter().map(|leaf| &leaf.figure.name);
        if by_key(&figure.name) {
            names.any(|name| *name == figure.name)
        } else {
            names.any(|name| covers(group, name))
        }
    };
    let mut sources: Vec<Source> = base.sources.clone();
    for source in sources.iter_mut().filter(|source| !source.is_estimate) {
        source.figures.retain(|figure| !is_replaced(figure));
    }
    sources.retain(|source| source.is_estimate || !source.figures.is_empty());
    sources.extend(of_leaves(own));
    Origin { sources, ..base.clone() }
}
