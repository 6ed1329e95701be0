//! Approaches: computes a ship's position, heading and velocity at the start from a speed and an angle at a fender.

mod sweep;

use fenderline_contact::number::{greater, lesser};
use fenderline_contact::{Pose, Rotation, Vec2, vec2};
use fenderline_sim::{Approach, BodySetup, BodyVelocity, FenderSetup, Setup, Side};

use self::sweep::{Face, are_apart, moved, travel_m};
use super::assembly::listed;
use super::assembly::{Assembly, Checked, Names};
use super::pairs::Pairs;
use super::rows::rounded;
use fenderline_keys::any_keys;
use fenderline_keys::checked::{Entry, Of, Tables, Value};
use fenderline_keys::error::ScenarioError;
use fenderline_keys::held::Number;
use fenderline_keys::keys::approach::{AbnormalKey, ApproachKey};
use fenderline_keys::keys::body::BodyKey;
use fenderline_keys::row_names::number_in_row;
use fenderline_keys::sources::quoted;
use fenderline_keys::suggest::nearest;
use fenderline_keys::typed_key::Key;

/// A hull that meets something this much before the intended fender gets a warning (m).
const EARLIER_M: f64 = 0.01;

/// The words that `contact` may have, each with the distance of the contact point from the end of the ship as a share
/// of her length.
const POINTS: [(&str, f64); 3] =
    [("quarter point", 0.25), ("third point", 1.0 / 3.0), ("midship", 0.5)];

/// The fender of the berth that the ship is to meet, in the horizontal plane.
struct Target {
    fender: usize,
    face: Face,
    /// Unit vector in the direction in which the fender faces, out of the berth.
    out: Vec2,
    /// Direction of the fender, clockwise from north (rad).
    out_rad: f64,
}

impl Assembly<'_, '_> {
    /// Notes approaches that take longer than the run.
    pub(super) fn note_late_arrivals(&mut self, bodies: Tables<'_, BodyKey>, setup: &Setup) {
        for approach in &setup.approaches {
            let needs_s = approach.distance_m / approach.speed_mps();
            let Some(item) = bodies.at(approach.body).item(BodyKey::APPROACH) else { continue };
            if needs_s < setup.duration_s {
                continue;
            }
            let table = item.table();
            let message = format!(
                "the {} m to the fender take {:.0} s at {} m/s, but the run lasts {} s: the ship \
                 does not reach the fender at this speed",
                rounded(approach.distance_m),
                libm::ceil(needs_s),
                rounded(approach.speed_mps()),
                rounded(setup.duration_s)
            );
            let [distance, speed] =
                [ApproachKey::DISTANCE, ApproachKey::SPEED_NORMAL].map(|key| table.given(key));
            let given = if distance.is_default { speed } else { distance };
            self.note_at(&given.span, table.path_to(given), message);
        }
    }

    /// Sets the start of every body with an approach.
    pub(super) fn approaches(
        &mut self,
        tables: Tables<'_, BodyKey>,
        bodies: &mut [BodySetup],
        fenders: &[FenderSetup],
        pairs: &Pairs,
        names: &Names,
    ) -> Checked<Vec<Approach>> {
        let mut approaches = Vec::new();
        for (index, (_, body)) in tables.iter().enumerate() {
            let Some(item) = body.item(BodyKey::APPROACH) else { continue };
            self.refuse_a_start_beside_the_approach(body)?;
            let table = item.table();
            let berth = self.berth(table, index, bodies, pairs, names)?;
            let (approach, start) = self.approach(table, index, &berth, bodies, fenders)?;
            let ship = &mut bodies[index];
            (ship.position_m, ship.heading_rad, ship.velocity) = start;
            self.check_way(table, &approach, &berth, bodies, fenders)?;
            approaches.push(approach);
        }
        Ok(approaches)
    }

    fn refuse_a_start_beside_the_approach(&self, body: Of<'_, BodyKey>) -> Checked<()> {
        let starts = any_keys![BodyKey: POSITION, HEADING, VELOCITY];
        let start = starts.iter().find_map(|key| body.item(*key).filter(|item| !item.is_default));
        let Some(item) = start else { return Ok(()) };
        let path = body.path_to(item);
        let message = format!(
            "`{path}` does not go together with `approach`, which already gives the start of the \
             ship"
        );
        let error = self.sources.error(&item.key_span, &path, message);
        Err(error.with_help("keep only one of the two keys"))
    }

    /// The bodies that form the berth: the body that the key `to` names, or the dolphins of a row.
    fn berth(
        &self,
        table: Of<'_, ApproachKey>,
        ship: usize,
        bodies: &[BodySetup],
        pairs: &Pairs,
        names: &Names,
    ) -> Checked<Vec<usize>> {
        let to = table.given(ApproachKey::TO);
        let row = to.name();
        let in_row = |body: &BodySetup| body.is_fixed() && number_in_row(row, &body.name).is_some();
        let dolphins: Vec<usize> =
            (0..bodies.len()).filter(|index| in_row(&bodies[*index])).collect();
        let berth = match dolphins.is_empty() || names.bodies.contains_key(row) {
            true => vec![self.body_named(table, to, row, names)?],
            false => dolphins,
        };
        let path = table.path_of(ApproachKey::TO);
        if berth.contains(&ship) {
            let message = format!("`{path}`: a ship does not come alongside herself");
            return Err(self.sources.error(&to.span, &path, message));
        }
        if !berth.iter().any(|body| pairs.may_touch([ship, *body])) {
            let message = format!(
                "`{path}`: {} never meets {}: no pair names the two",
                quoted(&bodies[ship].name),
                quoted(row)
            );
            let error = self.sources.error(&to.span, &path, message);
            return Err(error.with_help("add a [[pair]] of the two bodies"));
        }
        Ok(berth)
    }

    /// Reads an approach, and computes position, heading and velocity of the ship at the start of the approach.
    fn approach(
        &self,
        table: Of<'_, ApproachKey>,
        ship: usize,
        berth: &[usize],
        bodies: &[BodySetup],
        fenders: &[FenderSetup],
    ) -> Checked<(Approach, (Vec2, f64, BodyVelocity))> {
        let number = |name: Key<_, Number>| *table.given(name).number();
        let (angle_rad, distance_m) = (number(ApproachKey::ANGLE), number(ApproachKey::DISTANCE));
        let (along_mps, side) =
            (number(ApproachKey::ALONG), table.given(ApproachKey::SIDE).choice());
        let targets = targets(berth, bodies, fenders);
        let (target, by_fender) = self.fender_met(table, &targets, fenders)?;

        // Alongside, the ship's side faces into the berth; the bow turns towards the berth by the angle.
        let quarter = core::f64::consts::FRAC_PI_2;
        let (alongside_rad, heading_rad, to_starboard) = match side {
            Side::Starboard => {
                (target.out_rad + quarter, target.out_rad + quarter + angle_rad, 1.0)
            }
            Side::Port => (target.out_rad - quarter, target.out_rad - quarter - angle_rad, -1.0),
        };
        let attitude = Rotation::from_angle(heading_rad);
        let outline = bodies[ship].outline.vertices();
        let (low, high) = bodies[ship].outline.bounds();
        let midship_m = 0.5 * (low.x + high.x);
        let point_m = if by_fender {
            foremost(outline, attitude.apply_inverse(-target.out))
        } else {
            let x_m = midship_m + self.contact_m(table, high.x - low.x, angle_rad)?;
            side_point(outline, x_m, side).ok_or_else(|| {
                let item = table.given(ApproachKey::CONTACT);
                let path = table.path_of(ApproachKey::CONTACT);
                let message = format!(
                    "`{path}`: {} m forward of midship is off the hull, which reaches from {} to \
                     {} m",
                    rounded(x_m - midship_m),
                    rounded(low.x - midship_m),
                    rounded(high.x - midship_m)
                );
                self.sources.error(&item.span, &path, message)
            })?
        };
        let approach = Approach {
            body: ship,
            fender: target.fender,
            side,
            contact_m: point_m.x - midship_m,
            normal_speed_mps: number(ApproachKey::SPEED_NORMAL),
            along_mps,
            angle_rad,
            distance_m,
            energy_factor: self.energy_factor(table)?,
        };
        let forward = Rotation::from_angle(alongside_rad).apply(vec2(1.0, 0.0));
        let speed_mps = approach.speed_mps();
        // While the contact point closes the distance, it also moves along the berth. At the end it must
        // be at the middle of the fender.
        let before = target.out * distance_m - forward * (along_mps * distance_m / speed_mps);
        let position_m = target.face.middle_m() + before - attitude.apply(point_m);
        let (sine, cosine) = (libm::sin(angle_rad), libm::cos(angle_rad));
        let velocity = BodyVelocity {
            surge_mps: along_mps * cosine + speed_mps * sine,
            sway_mps: to_starboard * (speed_mps * cosine - along_mps * sine),
            yaw_radps: 0.0,
        };
        Ok((approach, (position_m, heading_rad, velocity)))
    }

    /// The fender that the ship meets, and whether the key `contact` names this fender.
    fn fender_met<'t>(
        &self,
        table: Of<'_, ApproachKey>,
        targets: &'t [Target],
        fenders: &[FenderSetup],
    ) -> Checked<(&'t Target, bool)> {
        if targets.is_empty() {
            let to = table.given(ApproachKey::TO);
            let path = table.path_of(ApproachKey::TO);
            let message = format!("`{path}`: {} has no fenders to meet", quoted(to.name()));
            return Err(self.sources.error(&to.span, &path, message));
        }
        let named = |name: &str| targets.iter().find(|t| fenders[t.fender].name == name);
        let contact = table.given(ApproachKey::CONTACT);
        if let Value::Text(text) = &contact.value
            && point(text).is_none()
        {
            if let Some(item) = table.item(ApproachKey::FENDER) {
                let path = table.path_of(ApproachKey::FENDER);
                let message = format!("`{path}` does not go together with a fender in `contact`");
                let error = self.sources.error(&item.key_span, &path, message);
                return Err(error.with_help("keep only one of the two keys"));
            }
            let target = named(text)
                .ok_or_else(|| self.no_fender(table, contact, text, targets, fenders))?;
            return Ok((target, true));
        }
        if let Some(item) = table.item(ApproachKey::FENDER) {
            let target = named(item.text())
                .ok_or_else(|| self.no_fender(table, item, item.text(), targets, fenders))?;
            return Ok((target, false));
        }
        let sum = targets.iter().fold(Vec2::ZERO, |sum, target| sum + target.face.middle_m());
        let mean_m = sum * (1.0 / targets.len() as f64);
        let off_m = |target: &Target| (target.face.middle_m() - mean_m).length();
        let nearest = targets.iter().min_by(|one, other| off_m(one).total_cmp(&off_m(other)));
        Ok((nearest.expect("there is a fender"), false))
    }

    fn no_fender<V>(
        &self,
        table: Of<'_, ApproachKey>,
        item: Entry<'_, V>,
        name: &str,
        targets: &[Target],
        fenders: &[FenderSetup],
    ) -> ScenarioError {
        let path = table.path_to(item);
        let to = quoted(table.given(ApproachKey::TO).name());
        let message = format!("`{path}`: {to} has no fender {}", quoted(name));
        let known = || targets.iter().map(|target| fenders[target.fender].name.as_str());
        let words = POINTS.iter().map(|(word, _)| *word).filter(|_| item.is(ApproachKey::CONTACT));
        let error = self.sources.error(&item.span, &path, message);
        error.with_help(match nearest(name, words.chain(known())) {
            Some(near) => format!("did you mean \"{near}\"?"),
            None if item.is(ApproachKey::CONTACT) => format!(
                "write \"quarter point\", \"third point\", \"midship\", a distance forward of \
                 midship, or one of {}",
                listed(known())
            ),
            None => format!("{to} has the fenders {}", listed(known())),
        })
    }

    /// Distance of the contact point forward of midship (m).
    fn contact_m(&self, table: Of<'_, ApproachKey>, length_m: f64, angle_rad: f64) -> Checked<f64> {
        Ok(match &table.given(ApproachKey::CONTACT).value {
            Value::Number(along_m) => *along_m,
            Value::Text(text) => {
                let share = point(text).unwrap_or_else(|| unreachable!("{text} is a fender"));
                let from_midship_m = (0.5 - share) * length_m;
                if angle_rad < 0.0 { -from_midship_m } else { from_midship_m }
            }
            other => unreachable!("contact holds {other:?}"),
        })
    }

    fn energy_factor(&self, table: Of<'_, ApproachKey>) -> Checked<f64> {
        let Some(abnormal) = table.item(ApproachKey::ABNORMAL).map(Entry::table) else {
            return Ok(1.0);
        };
        match (abnormal.item(AbnormalKey::ENERGY_FACTOR), abnormal.item(AbnormalKey::SPEED_FACTOR))
        {
            (Some(energy), None) => Ok(*energy.number()),
            (None, Some(speed)) => Ok(speed.number() * speed.number()),
            (Some(_), Some(speed)) => {
                let path = abnormal.path_of(AbnormalKey::SPEED_FACTOR);
                let message = format!("`{path}` does not go together with `energy_factor`");
                let error = self.sources.error(&speed.key_span, &path, message);
                Err(error.with_help(
                    "keep only one of the two keys: energy is proportional to the \
                                square of the speed",
                ))
            }
            (None, None) => {
                let help = "write energy_factor = 1.5, or speed_factor = 1.25";
                Err(self.missing(abnormal, AbnormalKey::ENERGY_FACTOR, help))
            }
        }
    }

    /// Refuses a start of the ship inside the berth, and warns if the hull meets something before the intended fender.
    fn check_way(
        &mut self,
        table: Of<'_, ApproachKey>,
        approach: &Approach,
        berth: &[usize],
        bodies: &[BodySetup],
        fenders: &[FenderSetup],
    ) -> Checked<()> {
        let ship = &bodies[approach.body];
        let targets = targets(berth, bodies, fenders);
        let target = targets.iter().find(|target| target.fender == approach.fender);
        let target = target.expect("the fender must be a fender of the berth");
        let hull = moved(ship.outline.vertices(), pose(ship));
        let structures = berth.iter().flat_map(|body| {
            let body = &bodies[*body];
            let near = body.outline.polygons().filter(|polygon| {
                !body.outline.is_of_parts() || are_near(polygon, ship, approach.distance_m)
            });
            near.map(move |polygon| (body, moved(polygon, pose(body))))
        });
        let more_m = distance_to_clear_m(&hull, &targets, structures.clone(), target.out);
        // A hull that touches a face from outside does not start inside.
        let clear: Vec<Vec2> = hull.iter().map(|point| *point + target.out * EARLIER_M).collect();
        let inside = |what: &str, name: &str| {
            let path = table.path_of(ApproachKey::DISTANCE);
            let message = format!("`{path}`: the ship starts inside {what} {}", quoted(name));
            let error =
                self.sources.error(&table.given(ApproachKey::DISTANCE).span, &path, message);
            let smaller = if approach.angle_rad == 0.0 { "" } else { "; or take a smaller angle" };
            Err(error.with_help(format!(
                "from {} m on she starts clear of the berth{smaller}",
                libm::ceil((approach.distance_m + more_m) * 10.0) / 10.0
            )))
        };
        let velocity = Rotation::from_angle(ship.heading_rad)
            .apply(vec2(ship.velocity.surge_mps, ship.velocity.sway_mps));
        let way = velocity * (1.0 / velocity.length());
        let mut first: Option<(f64, String)> = None;
        let mut meet = |at_m: Option<f64>, what: String| {
            if let Some(at_m) = at_m
                && first.as_ref().is_none_or(|(first_m, _)| at_m < *first_m)
            {
                first = Some((at_m, what));
            }
        };
        for (body, outline) in structures {
            if !are_apart(&clear, &outline) {
                return inside("the body", &body.name);
            }
            meet(
                travel_m(&hull, &outline, true, way),
                format!("the body {} itself", quoted(&body.name)),
            );
        }
        for other in &targets {
            let name = &fenders[other.fender].name;
            if !are_apart(&clear, &other.face.box_m()) {
                return inside("the fender", name);
            }
            let face = [other.face.ends_m[0], other.face.ends_m[1]];
            meet(travel_m(&hull, &face, false, way), format!("the fender {}", quoted(name)));
        }
        let ends_m = target.face.ends_m;
        let at_m = travel_m(&hull, &ends_m, false, way);
        let (path, span) =
            (table.path_of(ApproachKey::CONTACT), table.given(ApproachKey::CONTACT).span.clone());
        let name = quoted(&fenders[approach.fender].name);
        match (at_m, first) {
            (None, _) => {
                let message =
                    format!("`{path}`: on this course the hull never meets the fender {name}");
                Err(self.sources.error(&span, &path, message))
            }
            (Some(at_m), Some((first_m, what))) if at_m - first_m > EARLIER_M => {
                let earlier_m = rounded(at_m - first_m);
                let message =
                    format!("the hull meets {what} first, {earlier_m} m before the fender {name}");
                self.note_at(&span, path, message);
                Ok(())
            }
            _ => Ok(()),
        }
    }
}

/// How far a hull must move out of the berth until the hull is clear of the berth (m).
/// Whether a part of the shore may be in the way of a ship that begins `distance_m` off her berth.
fn are_near(part: &[Vec2], ship: &BodySetup, distance_m: f64) -> bool {
    let reach_m = distance_m + 2.0 * ship.outline.radius_m();
    let ends = |of: fn(&Vec2) -> f64| {
        let low = part.iter().map(of).fold(f64::INFINITY, libm::fmin);
        [low, part.iter().map(of).fold(f64::NEG_INFINITY, libm::fmax)]
    };
    let ([low, high], [west, east]) = (ends(|v| v.x), ends(|v| v.y));
    let at = ship.position_m;
    (low - reach_m..=high + reach_m).contains(&at.x)
        && (west - reach_m..=east + reach_m).contains(&at.y)
}

fn distance_to_clear_m<'b>(
    hull: &[Vec2],
    targets: &[Target],
    structures: impl Iterator<Item = (&'b BodySetup, Vec<Vec2>)>,
    out: Vec2,
) -> f64 {
    // Further than any ship is long.
    const FAR_M: f64 = 1e5;
    let far: Vec<Vec2> = hull.iter().map(|point| *point + out * FAR_M).collect();
    let of_structures = structures.filter_map(|(_, outline)| travel_m(&far, &outline, true, -out));
    let of_fenders =
        targets.iter().filter_map(|other| travel_m(&far, &other.face.box_m(), true, -out));
    let back_m = of_structures.chain(of_fenders).min_by(f64::total_cmp);
    back_m.map_or(0.0, |back_m| FAR_M - back_m)
}

/// The distance of the contact point from the end of the ship, as a share of her length, for a word of `contact`.
fn point(text: &str) -> Option<f64> {
    let plain = text.replace(['-', '_'], " ");
    POINTS.iter().find(|(word, _)| *word == plain).map(|(_, share)| *share)
}

fn pose(body: &BodySetup) -> Pose {
    Pose::new(body.position_m, body.heading_rad)
}

fn targets(berth: &[usize], bodies: &[BodySetup], fenders: &[FenderSetup]) -> Vec<Target> {
    let on_berth = fenders.iter().enumerate().filter(|(_, fender)| berth.contains(&fender.body));
    let target = |(index, fender): (usize, &FenderSetup)| {
        let body = &bodies[fender.body];
        let out = Rotation::from_angle(fender.facing_rad).apply(vec2(1.0, 0.0));
        let half = out.quarter_turn() * (0.5 * fender.width_m);
        let middle = fender.position_m + out * fender.projection_m;
        let at = |point: Vec2| pose(body).apply(point);
        let face = Face {
            ends_m: [at(middle - half), at(middle + half)],
            mounting_m: [at(fender.position_m + half), at(fender.position_m - half)],
        };
        Target {
            fender: index,
            face,
            out: Rotation::from_angle(body.heading_rad).apply(out),
            out_rad: body.heading_rad + fender.facing_rad,
        }
    };
    on_berth.map(target).collect()
}

/// The point of an outline that is foremost in a direction. If an edge at right angles to the direction is foremost,
/// the middle of this edge.
fn foremost(outline: &[Vec2], direction: Vec2) -> Vec2 {
    let reach_m = outline.iter().map(|point| point.dot(direction)).fold(f64::MIN, greater);
    let far: Vec<Vec2> =
        outline.iter().copied().filter(|point| reach_m - point.dot(direction) < 0.01).collect();
    far.iter().fold(Vec2::ZERO, |sum, point| sum + *point) * (1.0 / far.len() as f64)
}

/// The point on the port or starboard side of an outline at a distance forward of the origin; `None` beyond bow and
/// stern.
fn side_point(outline: &[Vec2], x_m: f64, side: Side) -> Option<Vec2> {
    let outer = |one: f64, other: f64| match side {
        Side::Starboard => greater(one, other),
        Side::Port => lesser(one, other),
    };
    let mut found: Option<f64> = None;
    for (index, a) in outline.iter().enumerate() {
        let b = outline[(index + 1) % outline.len()];
        let (low, high) = (lesser(a.x, b.x), greater(a.x, b.x));
        if x_m < low || x_m > high {
            continue;
        }
        let y_m = if high > low {
            a.y + (b.y - a.y) * (x_m - a.x) / (b.x - a.x)
        } else {
            outer(a.y, b.y)
        };
        found = Some(found.map_or(y_m, |other| outer(other, y_m)));
    }
    found.map(|y_m| vec2(x_m, y_m))
}
