//! Turns a checked fender file into families of fenders, and checks the rules between keys that the declarations of the
//! keys cannot express.

use std::collections::BTreeMap;

use crate::library::keys::{
    CurveKey, FactorTableKey, FamilyKey, HullPressureKey, OriginKey, SizeKey, ToleranceKey,
    UnloadingKey,
};
use fenderline_keys::checked::{Entry, Of, Tables};
use fenderline_keys::error::ScenarioError;
use fenderline_keys::held::{Curve, Number, TableOf};
use fenderline_keys::sources::{Sources, quoted};
use fenderline_keys::suggest::nearest;
use fenderline_keys::typed_key::{Key, ReadAs};

use super::family::{
    FactorTable, Family, FamilyUnloading, FenderSize, HullPressureLimit, Tolerance,
};
use super::{FenderLibrary, curve};
use fenderline_contact::{FenderLaw, Unloading};
use fenderline_sim::hydro::vessels::Standing;

type Read<T> = Result<T, ScenarioError>;

/// How far a normalised curve may be from 1 at the rated deflection: half a unit of the second decimal, because
/// catalogues print two decimals.
const ROUNDING: f64 = 0.005;

/// Adds the families of a file to the families of the library.
pub(super) fn families(
    sources: &Sources<'_>,
    tables: Tables<'_, FamilyKey>,
    library: &mut FenderLibrary,
) -> Read<()> {
    let FenderLibrary { families: known, places, .. } = library;
    for (name, table) in tables {
        let there = places.families.get(name).copied();
        match (there, table.item(FamilyKey::CURVE)) {
            (Some(there), None) => {
                more_sizes(sources, table, &mut known[there], &mut places.sizes[there])?;
            }
            (Some(_), Some(curve)) => {
                let message = format!("there is a family named {} already", quoted(name));
                let error = sources.error(&curve.key_span, &table.path, message);
                return Err(error.with_help(
                    "take another name, or give only sizes, which are added to the known family",
                ));
            }
            (None, Some(curve)) => {
                let mut sizes = BTreeMap::new();
                let family = new_family(sources, name, table, curve, &mut sizes)?;
                places.families.insert(name.clone(), known.len());
                places.sizes.push(sizes);
                known.push(family);
            }
            (None, None) => return Err(without_curve(sources, name, table, known)),
        }
    }
    Ok(())
}

/// Adds the hull pressure limits of a file to the limits of the library.
pub(super) fn hull_pressures(
    sources: &Sources<'_>,
    tables: Tables<'_, HullPressureKey>,
    library: &mut FenderLibrary,
) -> Read<()> {
    let known = &mut library.hull_pressures;
    for (name, table) in tables {
        if library.places.hull_pressures.insert(name.clone(), known.len()).is_some() {
            let message = format!("there is a limit for {} already", quoted(name));
            return Err(sources.error(&table.span, &table.path, message));
        }
        let (source, standing) = origin(table);
        let limit_npm2 = *table.given(HullPressureKey::LIMIT).number();
        known.push(HullPressureLimit { ship: name.clone(), limit_npm2, source, standing });
    }
    Ok(())
}

/// The error for a family without a curve: either the curve is missing, or the family's name is a misspelt name of a
/// known family.
fn without_curve(
    sources: &Sources<'_>,
    name: &str,
    table: Of<'_, FamilyKey>,
    known: &[Family],
) -> ScenarioError {
    let path = table.path_of(FamilyKey::CURVE);
    let message =
        format!("`{path}` is missing, and the library has no family named {}", quoted(name));
    let error = sources.error(&table.span, &path, message);
    error.with_help(match nearest(name, known.iter().map(|family| family.name.as_str())) {
        Some(name) => format!("did you mean \"{name}\"?"),
        None => format!("write [{path}] with the keys of the curve below"),
    })
}

fn more_sizes(
    sources: &Sources<'_>,
    table: Of<'_, FamilyKey>,
    family: &mut Family,
    places: &mut BTreeMap<String, usize>,
) -> Read<()> {
    let given = table.entries().find(|item| !item.is(FamilyKey::SIZE));
    if let Some(item) = given {
        let path = table.path_to(item);
        let message = format!(
            "`{path}` is for a new family, but the family {} is known already",
            quoted(&family.name)
        );
        let error = sources.error(&item.key_span, &path, message);
        return Err(error.with_help("give only sizes, or a new family with its own curve"));
    }
    sizes(sources, table, &mut family.sizes, places)
}

fn new_family(
    sources: &Sources<'_>,
    name: &str,
    table: Of<'_, FamilyKey>,
    item: Entry<'_, TableOf<CurveKey>>,
    places: &mut BTreeMap<String, usize>,
) -> Read<Family> {
    let inner = item.table();
    let points = inner.given(CurveKey::POINTS);
    let curve = points.curve().to_vec();
    if curve[0] != (0.0, 0.0) {
        let path = inner.path_of(CurveKey::POINTS);
        let message = format!("`{path}` must start with [0, 0]");
        return Err(sources.error(&points.span, &path, message));
    }
    let rated_deflection = rated_deflection(sources, table, &curve)?;
    let mut all_sizes = Vec::new();
    sizes(sources, table, &mut all_sizes, places)?;
    let (source, standing) = origin(inner);
    Ok(Family {
        name: name.to_owned(),
        rated_deflection,
        published_energy: inner
            .item(CurveKey::PUBLISHED_ENERGY)
            .map_or_else(Vec::new, |item| item.curve().to_vec()),
        unloading: match table.item(FamilyKey::UNLOADING) {
            Some(item) => Some(unloading(sources, item.table(), &curve)?),
            None => None,
        },
        curve,
        source,
        standing,
        temperature: table.item(FamilyKey::TEMPERATURE).map(|item| factor_table(item.table())),
        velocity: table.item(FamilyKey::VELOCITY).map(|item| factor_table(item.table())),
        angle_energy: table.item(FamilyKey::ANGLE_ENERGY).map(|item| factor_table(item.table())),
        angle_reaction: table
            .item(FamilyKey::ANGLE_REACTION)
            .map(|item| factor_table(item.table())),
        tolerance: table.item(FamilyKey::TOLERANCE).map(|item| tolerance(item.table())),
        reference: reference(sources, table, &all_sizes, places)?,
        sizes: all_sizes,
    })
}

/// Reads the rated deflection, and checks that the curve has the rated reaction at this deflection.
fn rated_deflection(
    sources: &Sources<'_>,
    table: Of<'_, FamilyKey>,
    curve: &[(f64, f64)],
) -> Read<f64> {
    let path = table.path_of(FamilyKey::RATED_DEFLECTION);
    let Some(item) = table.item(FamilyKey::RATED_DEFLECTION) else {
        return Err(sources.error(&table.span, &path, format!("`{path}` is missing")));
    };
    let rated = *item.number();
    let complain = |message| Err(sources.error(&item.span, &path, message));
    let Some(reaction) = curve::value(curve, rated) else {
        let end = curve.last().map_or(0.0, |point| point.0);
        return complain(format!("`{path}` is {rated}, but the curve already ends at {end}"));
    };
    if (reaction - 1.0).abs() > ROUNDING {
        return complain(format!(
            "at `{path}` = {rated} the curve's reaction is {reaction}, but must be 1"
        ));
    }
    Ok(rated)
}

fn reference(
    sources: &Sources<'_>,
    table: Of<'_, FamilyKey>,
    sizes: &[FenderSize],
    places: &BTreeMap<String, usize>,
) -> Read<Option<usize>> {
    let Some(item) = table.item(FamilyKey::REFERENCE) else { return Ok(None) };
    let name = item.text();
    if let Some(index) = places.get(name) {
        return Ok(Some(*index));
    }
    let path = table.path_of(FamilyKey::REFERENCE);
    let message = format!("`{path}`: the family has no size {}", quoted(name));
    let error = sources.error(&item.span, &path, message);
    Err(match nearest(name, sizes.iter().map(|size| size.designation.as_str())) {
        Some(near) => error.with_help(format!("did you mean \"{near}\"?")),
        None => error,
    })
}

/// Adds the sizes of a family's table; `places` holds the index of each size by its designation.
fn sizes(
    sources: &Sources<'_>,
    family: Of<'_, FamilyKey>,
    sizes: &mut Vec<FenderSize>,
    places: &mut BTreeMap<String, usize>,
) -> Read<()> {
    for table in family.given(FamilyKey::SIZE).list() {
        let item = table.given(SizeKey::DESIGNATION);
        let designation = item.text();
        if places.insert(designation.to_owned(), sizes.len()).is_some() {
            let path = table.path_of(SizeKey::DESIGNATION);
            let message = format!("`{path}`: there is a size {} already", quoted(designation));
            return Err(sources.error(&item.span, &path, message));
        }
        let number = |key: Key<_, Number>| table.item(key).map(|item| *item.number());
        let (hull_pressure_npm2, initial_pressure_npm2) =
            (number(SizeKey::HULL_PRESSURE), number(SizeKey::INITIAL_PRESSURE));
        if let (Some(item), Some(initial)) =
            (table.item(SizeKey::INITIAL_PRESSURE), initial_pressure_npm2)
            && hull_pressure_npm2.is_none_or(|rated| rated <= initial)
        {
            let path = table.path_of(SizeKey::INITIAL_PRESSURE);
            let message =
                format!("`{path}` needs a `hull_pressure` that is higher than this pressure");
            let error = sources.error(&item.span, &path, message);
            return Err(error.with_help(
                "give in `hull_pressure` the pressure on the hull at the rated deflection",
            ));
        }
        let (source, standing) = origin(table);
        sizes.push(FenderSize {
            designation: designation.to_owned(),
            height_m: *table.given(SizeKey::HEIGHT).number(),
            length_m: number(SizeKey::LENGTH),
            rated_reaction_n: *table.given(SizeKey::REACTION).number(),
            published_energy_j: number(SizeKey::PUBLISHED_ENERGY),
            hull_pressure_npm2,
            initial_pressure_npm2,
            source,
            standing,
        });
    }
    Ok(())
}

fn factor_table<T: ReadAs<FactorTableKey> + ReadAs<OriginKey>>(table: Of<'_, T>) -> FactorTable {
    let (source, standing) = origin(table);
    let table = table.read_as::<FactorTableKey>();
    FactorTable {
        points: table.given(FactorTableKey::POINTS).curve().to_vec(),
        holds: table.item(FactorTableKey::HOLDS).map(|item| item.text().to_owned()),
        source,
        standing,
    }
}

/// Reads the unloading law of a family of fenders with the loading curve `curve`.
fn unloading(
    sources: &Sources<'_>,
    table: Of<'_, UnloadingKey>,
    curve: &[(f64, f64)],
) -> Read<FamilyUnloading> {
    let law = match (table.item(UnloadingKey::RETURNED_ENERGY), table.item(UnloadingKey::POINTS)) {
        (Some(share), None) => Unloading::ReturnedEnergy(*share.number()),
        (None, Some(points)) => {
            let path = table.path_of(UnloadingKey::POINTS);
            Unloading::Curve(unloading_curve(sources, points, &path, curve)?)
        }
        (Some(_), Some(points)) => {
            let path = table.path_of(UnloadingKey::POINTS);
            let message = format!("`{path}` does not go together with `returned_energy`");
            let error = sources.error(&points.key_span, &path, message);
            return Err(error.with_help("keep only one of the two keys"));
        }
        (None, None) => {
            let path = table.path_of(UnloadingKey::RETURNED_ENERGY);
            let error = sources.error(&table.span, &path, format!("`{path}` is missing"));
            return Err(
                error.with_help("give `returned_energy`, or the `points` of the unloading curve")
            );
        }
    };
    let (source, standing) = origin(table);
    Ok(FamilyUnloading { law, source, standing })
}

/// Reads the points of an unloading curve. An unloading curve must begin at (0, 0) and be nowhere above the loading
/// curve.
pub(crate) fn unloading_curve(
    sources: &Sources<'_>,
    item: Entry<'_, Curve>,
    path: &str,
    loading: &[(f64, f64)],
) -> Read<Vec<[f64; 2]>> {
    let pairs = |points: &[(f64, f64)]| points.iter().map(|&(x, y)| [x, y]).collect();
    let (points, loading): (Vec<[f64; 2]>, Vec<[f64; 2]>) = (pairs(item.curve()), pairs(loading));
    if points[0] != [0.0, 0.0] {
        let message = format!("`{path}` must begin with [0, 0]: zero deflection, zero reaction");
        return Err(sources.error(&item.span, path, message));
    }
    let Some([at, reaction]) = Unloading::first_point_above(&points, &loading) else {
        return Ok(points);
    };
    let most = FenderLaw::Curve(loading).reaction_n(at);
    let message = format!(
        "`{path}` must not be above the loading curve: at a deflection of {at} the reaction must \
         be between 0 and {most}, but is {reaction}"
    );
    Err(sources.error(&item.span, path, message))
}

fn tolerance(table: Of<'_, ToleranceKey>) -> Tolerance {
    let (source, standing) = origin(table);
    Tolerance { value: *table.given(ToleranceKey::VALUE).number(), source, standing }
}

fn origin<T: ReadAs<OriginKey>>(table: Of<'_, T>) -> (String, Standing) {
    let table = table.read_as::<OriginKey>();
    (table.given(OriginKey::SOURCE).text().to_owned(), table.given(OriginKey::STANDING).choice())
}
