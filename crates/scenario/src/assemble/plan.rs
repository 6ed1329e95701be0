//! Reads passage plans.

use fenderline_keys::checked::{Of, Tables};
use fenderline_keys::keys::plan::{PlanKey, WaypointKey};
use fenderline_keys::sources::quoted;
use fenderline_sim::Setup;
use fenderline_sim::track::{PassagePlan, TrackError, Waypoint};

use super::assembly::{Assembly, Checked, Names};

/// Most waypoints of a plan.
const MOST_WAYPOINTS: usize = 1000;
/// Turning radius of a waypoint without one, in lengths of the ship; our choice.
const TURNING_LENGTHS: f64 = 3.0;

impl Assembly<'_, '_> {
    /// Gives vessels their passage plans.
    pub(super) fn plans(
        &mut self,
        tables: Tables<'_, PlanKey>,
        setup: &mut Setup,
        names: &Names,
    ) -> Checked<()> {
        for (name, table) in tables.iter() {
            let item = table.given(PlanKey::VESSEL);
            let body = self.body_named(table, item, item.name(), names)?;
            let vessels = &mut setup.world.vessels;
            let Some(vessel) = vessels.iter_mut().find(|vessel| vessel.body == body) else {
                let message = format!("body {} has no vessel", quoted(item.name()));
                return Err(self.refused(table, item, &message));
            };
            if let Some(other) = &vessel.plan {
                let message = format!(
                    "{} already has the plan {}: a vessel has at most one plan",
                    quoted(item.name()),
                    quoted(&other.name)
                );
                return Err(self.refused(table, item, &message));
            }
            let length_m = vessel.ship.particulars.length_m;
            vessel.plan = Some(self.plan(name, table, length_m)?);
        }
        Ok(())
    }

    fn plan(&mut self, name: &str, table: Of<'_, PlanKey>, length_m: f64) -> Checked<PassagePlan> {
        let list = table.given(PlanKey::WAYPOINT);
        let waypoints: Vec<Of<'_, WaypointKey>> = list.list().into_iter().collect();
        if waypoints.len() > MOST_WAYPOINTS {
            let message = format!("a plan has at most {MOST_WAYPOINTS} waypoints");
            return Err(self.refused(table, list, &message));
        }
        let number = |way: Of<'_, WaypointKey>, key| way.item(key).map(|item| *item.number());
        let read = waypoints.iter().map(|&way| Waypoint {
            name: way.item(WaypointKey::NAME).map_or("", |item| item.text()).to_owned(),
            at_m: *way.given(WaypointKey::POSITION).vector(),
            turning_radius_m: number(way, WaypointKey::TURNING_RADIUS)
                .unwrap_or(TURNING_LENGTHS * length_m),
            speed_mps: number(way, WaypointKey::SPEED),
            half_width_m: number(way, WaypointKey::HALF_WIDTH),
        });
        let reach_m = table.item(PlanKey::REACH).map_or(length_m, |item| *item.number());
        let plan = PassagePlan::new(name.to_owned(), read.collect(), reach_m);
        let plan = plan.map_err(|error| match error {
            TrackError::Near { waypoint } | TrackError::Bend { waypoint, .. } => {
                // The first waypoint is number 1 in pages and reports, but the error counts from 0.
                let way = waypoints[waypoint];
                self.refused(way, way.given(WaypointKey::POSITION), &error)
            }
            _ => self.refused(table, list, &error),
        })?;
        if let (Some(&first), Some(&last)) = (waypoints.first(), waypoints.last()) {
            self.note_idle(first, WaypointKey::SPEED, "no leg leads to the first waypoint");
            self.note_idle(first, WaypointKey::HALF_WIDTH, "no leg leads to the first waypoint");
            self.note_idle(first, WaypointKey::TURNING_RADIUS, "the first waypoint has no turn");
            self.note_idle(last, WaypointKey::TURNING_RADIUS, "the last waypoint has no turn");
        }
        Ok(plan)
    }
}
