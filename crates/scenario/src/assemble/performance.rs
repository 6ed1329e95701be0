//! The behaviour of a fender under load: curve, factors, unloading and stop, from a catalogue or from the fender's
//! keys.

use std::ops::RangeInclusive;

use fenderline_contact::{FenderLaw, ReactionFactors, Unloading};
use fenderline_sim::hydro::vessels::Standing;
use fenderline_sim::{FenderSource, HullPressure, Rated};

use crate::assemble::assembly::{Assembly, Checked};
use crate::library::{CatalogueFender, FenderLibrary, LookUpError, unloading_curve};
use fenderline_keys::any_keys;
use fenderline_keys::checked::{Entry, Of};
use fenderline_keys::error::ScenarioError;
use fenderline_keys::held::{Curve, Flag, Number, Text};
use fenderline_keys::keys::fender::FenderKey;
use fenderline_keys::sources::quoted;
use fenderline_keys::typed_key::Key;

/// Stiffness of a stop, divided by the mean stiffness of the fender up to the stop.
const STOP_OVER_MEAN: f64 = 50.0;

/// Compression time (s), beyond the end of the table of factors by compression time, at which the factor has returned
/// to 1, because a ship at rest compresses her fenders statically.
const STATIC_TIME_S: f64 = 1000.0;

/// The law of a fender's reaction, and the data that belong to this law.
pub(super) struct Performance {
    pub(super) law: FenderLaw,
    /// The unloading law of the fender's type.
    pub(super) unloading: Option<Unloading>,
    pub(super) rated: Option<Rated>,
    /// Deflection at which the fender's stop begins, unless the scenario gives a stop (m).
    pub(super) end_m: f64,
    /// Stiffness of the fender's stop (N/m).
    pub(super) stop_stiffness_npm: f64,
    pub(super) height_m: Option<f64>,
    pub(super) factors: ReactionFactors,
    pub(super) energy_by_angle: Vec<[f64; 2]>,
    pub(super) hull_pressure: HullPressure,
    pub(super) source: Option<FenderSource>,
}

/// Assumed share of the absorbed energy that a fender without data returns; the built-in fenders of solid rubber have
/// the same share (`fenders/cone.toml` has the reason).
const ASSUMED_RETURNED_ENERGY: f64 = 0.55;

/// Whether the reaction of a fender falls by an unloading law, and not by the restitution of the fender's material.
pub(super) fn wants_unloading(table: Of<'_, FenderKey>) -> bool {
    table.item(FenderKey::UNLOADING_LAW).is_none_or(|item| *item.flag())
}

/// The source of a fender's data, with a remark if the unloading law is assumed.
fn assumed(table: Of<'_, FenderKey>, has_type_s: bool, source: String) -> String {
    let own = table.first_of(any_keys![FenderKey: RETURNED_ENERGY, UNLOADING]).is_some();
    if has_type_s || own || !wants_unloading(table) {
        return source;
    }
    let percent = 100.0 * ASSUMED_RETURNED_ENERGY;
    format!(
        "{source}; unloading (assumed): the fender returns {percent:.0} % of the energy, as solid \
         rubber does"
    )
}

impl Assembly<'_, '_> {
    pub(super) fn performance(
        &self,
        table: Of<'_, FenderKey>,
        library: &FenderLibrary,
        stiffness_npm2: f64,
        width_m: f64,
    ) -> Checked<Performance> {
        let given = |name: Key<_, Number>| table.item(name).map(|item| *item.number());
        let factors = || ReactionFactors {
            constant: 1.0 + table.given(FenderKey::TOLERANCE).number(),
            ..ReactionFactors::default()
        };
        if let Some(item) = table.item(FenderKey::TYPE) {
            let fender = self.catalogue(table, item, library)?;
            return self.of_catalogue(table, &fender, factors());
        }
        let projection_m = given(FenderKey::PROJECTION).ok_or_else(|| {
            self.missing(
                table,
                FenderKey::PROJECTION,
                "write projection = \"1.5 m\", or give a `type`",
            )
        })?;
        let own = |law: FenderLaw, end_m: f64| {
            let rated_m = given(FenderKey::RATED_DEFLECTION).unwrap_or(end_m);
            let mean_npm = law.reaction_n(end_m) / end_m;
            Performance {
                rated: Rated::of(&law, rated_m),
                end_m,
                stop_stiffness_npm: STOP_OVER_MEAN * mean_npm,
                height_m: None,
                factors: factors(),
                energy_by_angle: Vec::new(),
                hull_pressure: HullPressure::OverFace,
                source: Some(FenderSource {
                    family: None,
                    designation: "given in the scenario".to_owned(),
                    source: assumed(table, false, "the scenario".to_owned()),
                    standing: "given".to_owned(),
                }),
                unloading: None,
                law,
            }
        };
        if let Some(stiffness_npm) = given(FenderKey::STIFFNESS) {
            return Ok(own(FenderLaw::linear(stiffness_npm), projection_m));
        }
        if let Some(item) = table.item(FenderKey::CURVE) {
            let points = self.own_curve(table, item)?;
            let end_m = points[points.len() - 1][0];
            return Ok(own(FenderLaw::Curve(points), end_m));
        }
        if let Some(item) = table.item(FenderKey::RATED_DEFLECTION) {
            let path = table.path_of(FenderKey::RATED_DEFLECTION);
            let message = format!("`{path}` is for fenders with a `stiffness` or a `curve`");
            return Err(self.sources.error(&item.key_span, &path, message));
        }
        if stiffness_npm2 == 0.0 {
            let item = table.given(FenderKey::MATERIAL);
            let path = table.path_of(FenderKey::MATERIAL);
            let message = format!(
                "`{path}`: the fender has no law of reaction, and its material {} has no stiffness",
                quoted(item.name())
            );
            let error = self.sources.error(&item.span, &path, message);
            return Err(error.with_help("give a `type`, a `stiffness` or a `curve`"));
        }
        Ok(Performance {
            law: FenderLaw::Area,
            unloading: None,
            rated: None,
            end_m: projection_m,
            stop_stiffness_npm: STOP_OVER_MEAN * stiffness_npm2 * width_m,
            height_m: None,
            factors: factors(),
            energy_by_angle: Vec::new(),
            hull_pressure: HullPressure::OverFace,
            source: None,
        })
    }

    /// The unloading law of a fender, which comes from the fender's keys or from the fender's type, or else is assumed
    /// as for solid rubber. `None` if `unloading_law` is false: the reaction then falls by the restitution of the
    /// material.
    pub(super) fn unloading(
        &self,
        table: Of<'_, FenderKey>,
        performance: &Performance,
    ) -> Checked<Option<Unloading>> {
        if let Some(item) = table.item(FenderKey::RETURNED_ENERGY) {
            return Ok(Some(Unloading::ReturnedEnergy(*item.number())));
        }
        let Some(item) = table.item(FenderKey::UNLOADING) else {
            return Ok(wants_unloading(table).then(|| {
                let of_type = performance.unloading.clone();
                of_type.unwrap_or(Unloading::ReturnedEnergy(ASSUMED_RETURNED_ENERGY))
            }));
        };
        let path = table.path_of(FenderKey::UNLOADING);
        let FenderLaw::Curve(points) = &performance.law else {
            let message = format!("`{path}` is for fenders with a `stiffness` or a `curve`");
            let error = self.sources.error(&item.key_span, &path, message);
            return Err(error.with_help("give `returned_energy`, or give the fender a `curve`"));
        };
        let loading: Vec<(f64, f64)> = points.iter().map(|&[m, n]| (m, n)).collect();
        Ok(Some(Unloading::Curve(unloading_curve(self.sources, item, &path, &loading)?)))
    }

    fn own_curve(
        &self,
        table: Of<'_, FenderKey>,
        item: Entry<'_, Curve>,
    ) -> Checked<Vec<[f64; 2]>> {
        let points: Vec<[f64; 2]> = item.curve().iter().map(|&(m, n)| [m, n]).collect();
        let path = table.path_of(FenderKey::CURVE);
        if points[0] != [0.0, 0.0] {
            let message =
                format!("`{path}` must begin with [0, 0]: zero deflection, zero reaction");
            return Err(self.sources.error(&item.span, &path, message));
        }
        Ok(points)
    }

    /// The catalogue fender that the table of a fender names.
    pub(super) fn catalogue(
        &self,
        table: Of<'_, FenderKey>,
        family: Entry<'_, Text>,
        library: &FenderLibrary,
    ) -> Checked<CatalogueFender> {
        let name = family.text();
        library.family(name).map_err(|error| self.looked_up(table, family, &error))?;
        if let Some(size) = table.item(FenderKey::SIZE) {
            let found = library.fender(name, size.text());
            return found.map_err(|error| self.looked_up(table, size, &error));
        }
        let Some(height) = table.item(FenderKey::HEIGHT) else {
            return Err(self.missing(
                table,
                FenderKey::SIZE,
                "write size = \"…\", or height = \"1.2 m\"",
            ));
        };
        let height_m = *height.number();
        match table.item(FenderKey::RATED_REACTION) {
            Some(rated) => library
                .rated(name, height_m, *rated.number())
                .map_err(|error| self.looked_up(table, rated, &error)),
            None => library
                .scaled(name, height_m)
                .map_err(|error| self.looked_up(table, height, &error)),
        }
    }

    fn of_catalogue(
        &self,
        table: Of<'_, FenderKey>,
        fender: &CatalogueFender,
        mut factors: ReactionFactors,
    ) -> Checked<Performance> {
        let count = table.item(FenderKey::COUNT).map_or(1.0, |item| *item.number());
        let wanted = |key: Key<_, Flag>| table.item(key).is_none_or(|item| *item.flag());
        let points = |from: &[(f64, f64)], times: f64| -> Vec<[f64; 2]> {
            from.iter().map(|&(x, y)| [x, y * times]).collect()
        };
        factors.constant *= self.temperature_factor(table, fender)?;
        let mut energy_by_angle = Vec::new();
        if wanted(FenderKey::ANGLE_FACTOR) {
            factors.by_angle = points(&fender.angle_reaction_factors, 1.0);
            energy_by_angle = points(&fender.angle_energy_factors, 1.0);
        }
        if wanted(FenderKey::VELOCITY_FACTOR) {
            factors.by_compression_time = points(&fender.velocity_factors, 1.0);
            if let Some(&[last_s, _]) = factors.by_compression_time.last()
                && last_s < STATIC_TIME_S
            {
                factors.by_compression_time.push([STATIC_TIME_S, 1.0]);
            }
        }
        let curve = points(&fender.curve, count);
        let [end_m, _] = curve[curve.len() - 1];
        let law = FenderLaw::Curve(curve);
        let unloading = match &fender.unloading {
            Some(Unloading::Curve(points)) => {
                let of_all = points.iter().map(|&[m, n]| [m, n * count]);
                Some(Unloading::Curve(of_all.collect()))
            }
            other => other.clone(),
        };
        let pieces = if count == 1.0 { String::new() } else { format!("{count} × ") };
        let given_by_user = table.item(FenderKey::RATED_REACTION).is_some();
        Ok(Performance {
            unloading,
            rated: Rated::of(&law, fender.rated_deflection_m)
                .map(|rated| rated.with_reaction(count * fender.rated_reaction_n)),
            end_m,
            stop_stiffness_npm: STOP_OVER_MEAN * count * fender.rated_reaction_n / end_m,
            height_m: Some(fender.height_m),
            factors,
            energy_by_angle,
            hull_pressure: hull_pressure(fender),
            source: Some(FenderSource {
                family: Some(fender.family.clone()),
                designation: format!("{pieces}{} {}", fender.family, fender.designation),
                source: assumed(table, fender.unloading.is_some(), fender.source.clone()),
                standing: match (given_by_user, fender.standing) {
                    (true, Standing::Found) => "curve found, rating given".to_owned(),
                    (true, standing) => format!("curve {}, rating given", standing.word()),
                    (false, standing) => standing.word().to_owned(),
                },
            }),
            law,
        })
    }

    fn temperature_factor(
        &self,
        table: Of<'_, FenderKey>,
        fender: &CatalogueFender,
    ) -> Checked<f64> {
        let Some(item) = table.item(FenderKey::TEMPERATURE) else { return Ok(1.0) };
        let celsius = *item.number();
        let path = table.path_of(FenderKey::TEMPERATURE);
        let factors = &fender.temperature_factors;
        let (Some(first), Some(last)) = (factors.first(), factors.last()) else {
            let message = format!(
                "`{path}`: no temperature factors are known for {} fenders",
                quoted(&fender.family)
            );
            let error = self.sources.error(&item.span, &path, message);
            return Err(error.with_help(format!(
                "put the maker's factors into the fender file: [family.{:?}.temperature] with \
                 points = [[-10, 1.2], [23, 1], [50, 0.9]]; or give a factor as `tolerance`",
                fender.family
            )));
        };
        let known: RangeInclusive<f64> = first.0..=last.0;
        if !known.contains(&celsius) {
            let message = format!(
                "`{path}` must be between {} and {} °C, where factors are known, but is {celsius}",
                first.0, last.0
            );
            return Err(self.sources.error(&item.span, &path, message));
        }
        let two = factors.windows(2).find(|two| celsius <= two[1].0);
        let [(x0, y0), (x1, y1)] = two.map_or([*last, *last], |two| [two[0], two[1]]);
        Ok(if x1 > x0 { y0 + (y1 - y0) * (celsius - x0) / (x1 - x0) } else { y0 })
    }

    pub(super) fn looked_up<T, V>(
        &self,
        table: Of<'_, T>,
        item: Entry<'_, V>,
        error: &LookUpError,
    ) -> ScenarioError {
        let path = table.path_to(item);
        self.sources.error(&item.span, &path, format!("`{path}`: {error}")).with_help(error.help())
    }
}

/// How a catalogue fender presses on the hull.
pub(super) fn hull_pressure(fender: &CatalogueFender) -> HullPressure {
    match (fender.has_panel, fender.initial_pressure_npm2, fender.hull_pressure_npm2) {
        (true, _, _) => HullPressure::OverFace,
        (false, Some(initial_npm2), Some(rated_npm2)) => HullPressure::Inner {
            initial_npm2,
            rated_npm2,
            rated_deflection_m: fender.rated_deflection_m,
        },
        _ => HullPressure::Unknown,
    }
}
