//! Warnings about input that can be computed but is probably a mistake, such as faces that overlap or stand in the
//! seabed, or masses that do not fit the hull.

use fenderline_contact::number::lesser;
use fenderline_contact::{Rotation, vec2};
use fenderline_sim::berthing::BerthingSetup;
use fenderline_sim::{BodySetup, Environment, FenderSetup};

use super::assembly::{Assembly, Checked};
use super::rows::rounded;
use fenderline_keys::any_keys;
use fenderline_keys::checked::{Of, Tables};
use fenderline_keys::keys::berthing::BerthingKey;
use fenderline_keys::keys::body::BodyKey;
use fenderline_keys::keys::fender::FenderKey;
use fenderline_keys::sources::quoted;

/// Distance of the middle of a fender's face from the water that is unusual if no depth is given (m). The
/// distance is our choice, greater than the greatest tides.
pub(super) const FAR_FROM_WATER_M: f64 = 15.0;
/// Usual range of the ratio of draught to beam of floating bodies; ships have 0.2 to 0.6, barges and pontoons less. The
/// range is our choice, wide enough for ships, barges and pontoons.
const DRAUGHT_OVER_BEAM: [f64; 2] = [0.01, 1.2];
/// Plausible range of the displacement by the particulars of a berthing, divided by the body's mass. Published examples
/// that give particulars and mass agree to a few per cent.
const DISPLACEMENT_FITS: [f64; 2] = [0.9, 1.1];
/// Plausible range of the length of the outline divided by the length between perpendiculars, and of the beam of the
/// outline divided by the beam.
const LENGTH_FITS: [f64; 2] = [0.85, 1.3];
const BEAM_FITS: [f64; 2] = [0.8, 1.25];

fn fits([low, high]: [f64; 2], value: f64) -> bool {
    value >= low && value <= high
}

impl Assembly<'_, '_> {
    /// Refuses a fender in the seabed, and warns of a fender far from the water.
    pub(super) fn check_heights(
        &mut self,
        tables: Tables<'_, FenderKey>,
        fenders: &[FenderSetup],
        environment: &Environment,
    ) -> Checked<()> {
        for ((_, table), fender) in tables.iter().zip(fenders) {
            let Some(item) = table.item(FenderKey::ABOVE_WATER) else { continue };
            let middle_m = fender.above_water_m;
            let bottom_m = middle_m - 0.5 * fender.height_m;
            let path = table.path_of(FenderKey::ABOVE_WATER);
            // A field of depths says nothing of the bottom at a quay: its cells reach over the edge.
            match environment.depth_m {
                Some(depth_m) if middle_m < -depth_m => {
                    let message = format!(
                        "`{path}`: the middle of the face is {} m below the water, under the \
                         seabed at {} m",
                        rounded(-middle_m),
                        rounded(depth_m)
                    );
                    let error = self.sources.error(&item.span, &path, message);
                    return Err(error.with_help("heights above the water are positive"));
                }
                Some(depth_m) if bottom_m < -depth_m => {
                    let message = format!(
                        "the face reaches {} m below the water, under the seabed at {} m",
                        rounded(-bottom_m),
                        rounded(depth_m)
                    );
                    self.note_at(&item.span, path, message);
                }
                _ if middle_m.abs() > FAR_FROM_WATER_M => {
                    let side = if middle_m < 0.0 { "below" } else { "above" };
                    let message = format!(
                        "the middle of the fender's face is {} m {side} the water, where there may \
                         be no ship's side",
                        rounded(middle_m.abs())
                    );
                    self.note_at(&item.span, path, message);
                }
                _ => {}
            }
        }
        Ok(())
    }

    /// Warns of fenders on one body whose faces overlap.
    pub(super) fn note_overlaps(&mut self, tables: Tables<'_, FenderKey>, fenders: &[FenderSetup]) {
        // Places along the face, for each body and direction: only neighbours in this order must be compared.
        let mut places: Vec<(usize, i64, f64, usize)> = Vec::with_capacity(fenders.len());
        for (index, fender) in fenders.iter().enumerate() {
            let out = Rotation::from_angle(fender.facing_rad).apply(vec2(1.0, 0.0));
            let direction = libm::round(fender.facing_rad * 1e6) as i64;
            let along_m = fender.position_m.dot(out.quarter_turn());
            places.push((fender.body, direction, along_m, index));
        }
        places.sort_by(|a, b| (a.0, a.1).cmp(&(b.0, b.1)).then(a.2.total_cmp(&b.2)));
        for two in places.windows(2) {
            let [(body, direction, at_m, one), (other_body, other_direction, next_m, other)] =
                [two[0], two[1]];
            if (body, direction) != (other_body, other_direction) {
                continue;
            }
            let (one, other) = if one < other { (one, other) } else { (other, one) };
            let (a, b) = (&fenders[one], &fenders[other]);
            let out = Rotation::from_angle(a.facing_rad).apply(vec2(1.0, 0.0));
            let off_m = ((a.position_m + out * a.projection_m)
                - (b.position_m + out * b.projection_m))
                .dot(out);
            let apart_m = (next_m - at_m) - 0.5 * (a.width_m + b.width_m);
            let height_m = (a.above_water_m - b.above_water_m).abs();
            let is_beside = height_m < 0.5 * (a.height_m + b.height_m) && a.floating == b.floating;
            let is_near = off_m.abs() < lesser(a.projection_m, b.projection_m);
            if apart_m < -1e-6 && is_beside && is_near {
                let (table, name) = (tables.at(other), quoted(&a.name));
                let message = format!(
                    "the face of {} overlaps that of {name} by {} m",
                    quoted(&b.name),
                    rounded(-apart_m)
                );
                let span = table
                    .item(FenderKey::WIDTH)
                    .map_or(&table.span, |item| &item.item().span)
                    .clone();
                self.note_at(&span, table.path_of(FenderKey::WIDTH), message);
            }
        }
    }

    /// Warns of a mass that does not fit the body's outline.
    pub(super) fn note_masses(
        &mut self,
        tables: Tables<'_, BodyKey>,
        bodies: &[BodySetup],
        environment: &Environment,
    ) {
        for ((_, table), body) in tables.iter().zip(bodies) {
            let (Some(item), Some(mass)) = (table.item(BodyKey::MASS), body.mass) else { continue };
            let (low, high) = body.outline.bounds();
            let beam_m = lesser(high.x - low.x, high.y - low.y);
            let kg_per_m = environment.water_density_kgpm3 * body.outline.area_m2();
            let draught_m = mass.mass_kg / kg_per_m;
            if fits(DRAUGHT_OVER_BEAM, draught_m / beam_m) {
                continue;
            }
            let [least_t, most_t] =
                DRAUGHT_OVER_BEAM.map(|share| share * beam_m * kg_per_m / 1000.0);
            let mut message = format!(
                "{} t over the {} m² of the outline is a draught of {} m at a beam of {} m; from \
                 {} to {} t was expected",
                figures(mass.mass_kg / 1000.0),
                figures(body.outline.area_m2()),
                figures(draught_m),
                figures(beam_m),
                figures(least_t),
                figures(most_t)
            );
            if fits(DRAUGHT_OVER_BEAM, 1000.0 * draught_m / beam_m) {
                message += ": tonnes, \"t\", in place of kilograms?";
            }
            self.note_at(&item.span, table.path_of(BodyKey::MASS), message);
        }
    }

    /// Warns of particulars of a berthing that do not fit the body.
    pub(super) fn note_particulars(
        &mut self,
        table: Of<'_, BerthingKey>,
        study: &BerthingSetup,
        bodies: &[BodySetup],
        environment: &Environment,
    ) {
        let body = &bodies[study.ship];
        let Some(mass) = body.mass else { return };
        let volume_m3 =
            study.length_bp_m * study.beam_m * study.draught_m * study.block_coefficient;
        let displacement_kg = environment.water_density_kgpm3 * volume_m3;
        let shape = any_keys![BerthingKey: BLOCK_COEFFICIENT, DRAUGHT, BEAM, LENGTH_BP];
        let given = shape.iter().find_map(|key| table.item(*key));
        if let Some(item) = given
            && !fits(DISPLACEMENT_FITS, displacement_kg / mass.mass_kg)
        {
            let message = format!(
                "length, beam, draught and block coefficient displace {} t, but {} has a mass of {} t; a block coefficient \
                 of {} would fit",
                figures(displacement_kg / 1000.0),
                quoted(&body.name),
                figures(mass.mass_kg / 1000.0),
                figures(study.block_coefficient * mass.mass_kg / displacement_kg)
            );
            self.note_at(&item.span, table.path_to(item), message);
        }
        let (low, high) = body.outline.bounds();
        let size = high - low;
        let measures = [
            (BerthingKey::LENGTH_BP, size.x, study.length_bp_m, LENGTH_FITS),
            (BerthingKey::BEAM, size.y, study.beam_m, BEAM_FITS),
        ];
        for (key, outline_m, given_m, range) in measures {
            if let Some(item) = table.item(key)
                && !fits(range, outline_m / given_m)
            {
                let name = quoted(&body.name);
                let message = format!(
                    "the outline of {name} measures {} m, but {} m is given",
                    figures(outline_m),
                    figures(given_m)
                );
                self.note_at(&item.span, table.path_of(key), message);
            }
        }
    }
}

/// Rounds a number to three figures, for messages.
pub(super) fn figures(value: f64) -> f64 {
    if value == 0.0 {
        return 0.0;
    }
    let places = 2 - libm::floor(libm::log10(value.abs())) as i32;
    let scale = libm::pow(10.0, f64::from(places.abs()));
    if places >= 0 {
        libm::round(value * scale) / scale
    } else {
        libm::round(value / scale) * scale
    }
}
