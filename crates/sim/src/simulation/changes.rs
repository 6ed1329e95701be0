//! Changes of weather and faults during a run: planned changes, changes by calls of a program, and changes that take a
//! time.

use fenderline_contact::{Vec2, vec2};

use super::Simulation;
use fenderline_ship::environment::current::Current;
use fenderline_ship::environment::wind::{MeanWind, Wind, WindProfile};
use fenderline_world::change::{Change, ChangeError, Flow, Ramp, fog_m};
use fenderline_world::world::{Faults, WorldEvent, WorldEventKind};

impl Simulation {
    /// Changes weather, faults, lines or tugs, from the next step on. A change that takes a time continues by itself
    /// after the call.
    ///
    /// # Errors
    /// Returns a [`ChangeError`] if the change cannot be carried out; the simulation is then unchanged.
    pub fn change(&mut self, change: &Change) -> Result<(), ChangeError> {
        change.check(&self.setup)?;
        match *change {
            Change::Wind { speed_mps, from_rad, over_s } => {
                self.change_wind(Flow { speed_mps, direction_rad: from_rad }, over_s)?;
            }
            Change::Current { speed_mps, to_rad, over_s, at } => {
                self.change_current(Flow { speed_mps, direction_rad: to_rad }, over_s, at)?;
            }
            Change::Visibility { distance_m, over_s } => {
                let now_m = self.setup.world.environment.visibility_m;
                if over_s > 0.0 {
                    let ramp = Ramp::new(fog_m(now_m), fog_m(distance_m), self.time_s(), over_s);
                    self.changes.ramps.visibility = Some((ramp, distance_m));
                } else {
                    self.changes.ramps.visibility = None;
                    self.setup.world.environment.visibility_m = distance_m;
                }
            }
            Change::Fault { vessel, fault, on } => {
                self.world.vessels[vessel].faults.switch(fault, on);
            }
            Change::Thruster { vessel, unit, on } => {
                let Faults { tripped, .. } = &mut self.world.vessels[vessel].faults;
                *tripped = tripped.with(unit, on);
            }
            Change::PartLine(line) => {
                if !self.part_line(line) {
                    let line = self.setup.world.lines[line].line.name.clone();
                    return Err(ChangeError::NotFast { line });
                }
                self.changes.parted.push(line);
            }
            Change::TugOut { tug, on } => self.world.tugs[tug].out = on,
        }
        Ok(())
    }

    fn change_wind(&mut self, to: Flow, over_s: f64) -> Result<(), ChangeError> {
        let before = self.setup.world.environment.wind.as_ref();
        let Flow { speed_mps, direction_rad: from_rad } = to;
        let changed = |speed_mps| match before {
            Some(wind) => wind.changed_to(speed_mps, from_rad),
            None => Wind::steady(MeanWind { speed_mps, from_rad, profile: WindProfile::Uniform }),
        };
        let changed_now = changed(speed_mps)?;
        if over_s == 0.0 {
            self.set_wind(Some(changed_now));
            return Ok(());
        }
        let t_s = self.time_s();
        let (speed_mps, direction_rad) = before.map_or((0.0, from_rad), |wind| wind.mean_at(t_s));
        if before.is_none() {
            let calm = changed(0.0)?;
            self.set_wind(Some(calm));
        }
        let from = Flow { speed_mps, direction_rad };
        self.changes.ramps.wind = Some(Ramp::new(from, to, t_s, over_s));
        Ok(())
    }

    fn change_current(
        &mut self,
        to: Flow,
        over_s: f64,
        at: Option<usize>,
    ) -> Result<(), ChangeError> {
        if over_s == 0.0 {
            let current = Current::uniform(velocity(to))?;
            self.set_current(Some(current));
            return Ok(());
        }
        let (world, t_s) = (&self.setup.world, self.time_s());
        let (at_m, draught_m) = at.map_or((Vec2::ZERO, 0.0), |vessel| {
            let ship = &world.vessels[vessel];
            (self.states[ship.body].position_m, ship.ship.particulars.draught_m)
        });
        let water = world.environment.current(at_m, t_s, draught_m);
        let from = Flow { speed_mps: water.length(), direction_rad: libm::atan2(water.y, water.x) };
        self.changes.ramps.current = Some(Ramp::new(from, to, t_s, over_s));
        Ok(())
    }

    /// The changes of this simulation that are planned or under way, with times counted from the present: what remains
    /// of changes over a time, and planned changes.
    #[must_use]
    pub fn changes_to_come(&self) -> Vec<(f64, Change)> {
        let t_s = self.time_s();
        let ramps = &self.changes.ramps;
        let wind = ramps.wind.map(|ramp| {
            let (Flow { speed_mps, direction_rad }, over_s) = ramp.rest(t_s);
            Change::Wind { speed_mps, from_rad: direction_rad, over_s }
        });
        let current = ramps.current.map(|ramp| {
            let (Flow { speed_mps, direction_rad }, over_s) = ramp.rest(t_s);
            Change::Current { speed_mps, to_rad: direction_rad, over_s, at: None }
        });
        let visibility = ramps
            .visibility
            .map(|(ramp, distance_m)| Change::Visibility { distance_m, over_s: ramp.rest(t_s).1 });
        let ramps = [wind, current, visibility].into_iter().flatten().map(|change| (0.0, change));
        let planned = self.setup.world.planned.iter().enumerate();
        let waiting = planned.filter(|(index, _)| !self.is_taken(*index));
        ramps.chain(waiting.map(|(_, planned)| (planned.at_s - t_s, planned.change))).collect()
    }

    fn is_taken(&self, planned: usize) -> bool {
        self.changes.taken.get(planned).copied().unwrap_or(false)
    }

    /// Returns true if a change is planned for the next step, or is under way.
    pub(super) fn changes_are_due(&self) -> bool {
        let end_s = self.time_s() + self.setup.step_s;
        let mut planned = self.setup.world.planned.iter().enumerate();
        self.changes.ramps.any()
            || planned.any(|(index, planned)| planned.at_s < end_s && !self.is_taken(index))
    }

    /// Carries out the changes that are planned for the next step, and the changes that are under way.
    pub(super) fn run_changes(&mut self) {
        let end_s = self.time_s() + self.setup.step_s;
        let planned = self.setup.world.planned.len();
        self.changes.taken.resize(planned, false);
        for index in 0..planned {
            let of = self.setup.world.planned[index];
            if self.changes.taken[index] || of.at_s >= end_s {
                continue;
            }
            self.changes.taken[index] = true;
            // All other faults were checked with the set-up.
            if let (Err(_), Change::PartLine(line)) = (self.change(&of.change), of.change) {
                self.changes.not_parted.push(line);
            }
        }
        self.run_ramps(end_s);
    }

    fn run_ramps(&mut self, end_s: f64) {
        let ramps = self.changes.ramps;
        if let Some(ramp) = ramps.wind {
            let Flow { speed_mps, direction_rad } = ramp.at(end_s);
            let wind = self.setup.world.environment.wind.as_ref();
            // A wind between two accepted winds is acceptable too.
            if let Some(Ok(wind)) = wind.map(|wind| wind.changed_to(speed_mps, direction_rad)) {
                self.set_wind(Some(wind));
            }
            self.changes.ramps.wind = Some(ramp).filter(|ramp| !ramp.is_over(end_s));
        }
        if let Some(ramp) = ramps.current {
            if let Ok(current) = Current::uniform(velocity(ramp.at(end_s))) {
                self.set_current(Some(current));
            }
            self.changes.ramps.current = Some(ramp).filter(|ramp| !ramp.is_over(end_s));
        }
        if let Some((ramp, last_m)) = ramps.visibility {
            let is_over = ramp.is_over(end_s);
            self.setup.world.environment.visibility_m =
                if is_over { last_m } else { Some(ramp.at(end_s).0) };
            if is_over {
                self.changes.ramps.visibility = None;
            }
        }
    }

    /// Reports the lines that a change has parted, and the lines that a change should have parted, in the events of
    /// this step.
    pub(super) fn report_changes(&mut self) {
        let events = &mut self.world.events;
        let event = |kind| move |who| WorldEvent { who, kind };
        events.extend(self.changes.parted.drain(..).map(event(WorldEventKind::LineParted)));
        let not = self.changes.not_parted.drain(..);
        events.extend(not.map(event(WorldEventKind::LineNotParted)));
    }
}

fn velocity(of: Flow) -> Vec2 {
    vec2(libm::cos(of.direction_rad), libm::sin(of.direction_rad)) * of.speed_mps
}
