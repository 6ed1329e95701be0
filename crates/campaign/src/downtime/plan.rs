//! The runs of a downtime analysis: one for each state, and one for each sampled hour with its own weather.

use crate::file::{Campaign, Downtime, Draw, Plan, Target, TargetOrigins, Variable};
use fenderline_scenario::Scenario;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng as _, SeedableRng as _};

use super::quantity::Agent;
use super::states::{State, states};
use super::weather::Weather;
use crate::error::CampaignError;

/// Column of the table with the reasons for which a run is lost.
pub(crate) const LOST_BY: &str = "lost_by";
/// Separator between two reasons in the column `lost_by`.
pub(crate) const BETWEEN: &str = "; ";

/// Stream of random numbers from which the sample is drawn; no run uses this stream.
const STREAM_OF_SAMPLE: u64 = u64::MAX / 2;

/// The values of a variable, one for each run.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Given {
    Numbers(Vec<f64>),
    Texts(Vec<String>),
}

/// The weather of a berth, its states, and the sample of single hours.
#[derive(Clone, Debug, PartialEq)]
pub struct DowntimePlan {
    weather: Weather,
    states: Vec<State>,
    /// Index of the state (group of similar hours) to which each row of the weather belongs.
    state_of: Vec<usize>,
    /// Weather rows of the sampled hours, which are run with their own weather, in rising order.
    sample: Vec<usize>,
    most_states: u64,
    seed: u64,
}

impl DowntimePlan {
    /// Reads the weather of a downtime campaign and groups its hours into states.
    ///
    /// # Errors
    /// Fails if the weather file is refused, if the sample has more hours than the weather, or if a sample is asked of
    /// a scatter diagram.
    pub(crate) fn new(of: &Downtime, seed: u64) -> Result<DowntimePlan, CampaignError> {
        let weather = Weather::read(&of.file)?;
        let states = states(&weather, usize::try_from(of.states).unwrap_or(usize::MAX));
        let mut state_of = vec![0; weather.len()];
        for (number, state) in states.iter().enumerate() {
            for row in &state.rows {
                state_of[*row] = number;
            }
        }
        let wanted = if weather.is_series() { of.sample } else { 0 };
        if wanted > weather.len() as u64 {
            let why = format!(
                "the series has {} rows, fewer than the {wanted} of `sample`",
                weather.len()
            );
            return Err(CampaignError::part("downtime.sample", why));
        }
        let sample = drawn(weather.len(), wanted as usize, seed);
        Ok(DowntimePlan { weather, states, state_of, sample, most_states: of.states, seed })
    }

    /// The weather.
    #[must_use]
    pub fn weather(&self) -> &Weather {
        &self.weather
    }

    /// The number of states; run number i, from 0, is state i.
    #[must_use]
    pub fn states(&self) -> usize {
        self.states.len()
    }

    /// Largest number of states.
    #[must_use]
    pub fn most_states(&self) -> u64 {
        self.most_states
    }

    /// Hours of a state.
    #[must_use]
    pub fn hours_of(&self, state: usize) -> f64 {
        self.states[state].hours
    }

    /// The state to which a row of the weather belongs.
    #[must_use]
    pub fn state_of(&self, row: usize) -> usize {
        self.state_of[row]
    }

    /// Name and unit of each quantity of the weather, as in the campaign's table.
    #[must_use]
    pub fn shown(&self) -> Vec<(&'static str, &'static str)> {
        self.weather.quantities.iter().map(|own| (own.name, own.unit)).collect()
    }

    /// The weather rows of the sampled hours, which are run after the states.
    #[must_use]
    pub fn sample(&self) -> &[usize] {
        &self.sample
    }

    /// The number of runs.
    pub(crate) fn runs(&self) -> u64 {
        (self.states.len() + self.sample.len()) as u64
    }

    /// Refuses a scenario that has no limits, whose water is too shallow for the waves, or that has a limit whose name
    /// contains a semicolon.
    pub(crate) fn check(&self, base: &Scenario) -> Result<(), CampaignError> {
        let world = &base.setup.world;
        let limits = &world.statistics.limits;
        if limits.is_empty() {
            let why = "the scenario has no [limit.NAME]: without limits no hour is lost";
            return Err(CampaignError::part("downtime", why));
        }
        if let Some(limit) = limits.iter().find(|limit| limit.name.contains(BETWEEN.trim())) {
            let why = format!(
                "the name of the limit `{}` has a semicolon, which separates the reasons in the \
                 table",
                limit.name
            );
            return Err(CampaignError::part("downtime", why));
        }
        let bottom = world.environment.bottom.as_ref();
        match world.environment.depth_m.or(bottom.map(|bottom| bottom.range_m()[1])) {
            Some(depth_m) => {
                let [_, highest_m] = world.environment.level_range_m();
                self.weather.check_breaking(depth_m, highest_m)
            }
            None => Ok(()),
        }
    }

    /// The variables of a downtime campaign, and their values in each run.
    pub(crate) fn variables(&self, campaign: &Campaign) -> Vec<(Variable, Given)> {
        let origin = match &campaign.plan {
            Plan::Downtime(of) => of.origin.clone(),
            _ => None,
        };
        let variable = |name: &str, key: Option<&str>, unit: &str, source: String| Variable {
            name: name.to_owned(),
            source: Some(source),
            draw: Draw::Column {
                column: name.to_owned(),
                target: Target {
                    keys: key.map(str::to_owned).into_iter().collect(),
                    unit: unit.to_owned(),
                    is_plain: unit.is_empty(),
                    origins: TargetOrigins {
                        keys: key.and(origin.clone()).into_iter().collect(),
                        values: origin.clone(),
                    },
                },
            },
        };
        let mut all = Vec::new();
        let runs = self.runs() as usize;
        let states = self.states.len();
        let kind = |run: usize| if run < states { "state" } else { "hour" }.to_owned();
        all.push((
            variable(
                "kind",
                None,
                "",
                "whether the run is of a state or of a single hour".to_owned(),
            ),
            Given::Texts((0..runs).map(kind).collect()),
        ));
        if self.weather.is_series() {
            let time = |run: usize| match run.checked_sub(states) {
                Some(own) => self.weather.times[self.sample[own]].clone(),
                None => String::new(),
            };
            all.push((
                variable("time", None, "", format!("of an hour in {}", self.weather.file_name())),
                Given::Texts((0..runs).map(time).collect()),
            ));
        }
        let number = |run: usize| match run.checked_sub(states) {
            Some(own) => self.state_of[self.sample[own]] + 1,
            None => run + 1,
        };
        all.push((
            variable(
                "state",
                None,
                "",
                "number of the state, or of the state to which the hour belongs".to_owned(),
            ),
            Given::Numbers((0..runs).map(|run| number(run) as f64).collect()),
        ));
        let hours = |run: usize| match run.checked_sub(states) {
            Some(own) => self.weather.hours[self.sample[own]],
            None => self.states[run].hours,
        };
        all.push((
            variable(
                "hours",
                None,
                "h",
                "hours of the weather for which the run stands".to_owned(),
            ),
            Given::Numbers((0..runs).map(hours).collect()),
        ));
        for (index, quantity) in self.weather.quantities.iter().enumerate() {
            let value = |run: usize| match run.checked_sub(states) {
                Some(own) => self.weather.rows[self.sample[own]][index],
                None => self.states[run].means[index],
            };
            let source = format!("{} of {}", quantity.column, self.weather.file_name());
            all.push((
                variable(quantity.name, Some(quantity.key), quantity.unit, source),
                Given::Numbers((0..runs).map(value).collect()),
            ));
        }
        let mut agents: Vec<Agent> = self.weather.quantities.iter().map(|own| own.agent).collect();
        agents.dedup();
        for (name, key) in agents.into_iter().filter_map(Agent::seed) {
            all.push((
                variable(
                    name,
                    Some(key),
                    "",
                    "seed of the random phases: each run has other phases".to_owned(),
                ),
                Given::Numbers((0..runs).map(|run| seed_of_run(self.seed, run)).collect()),
            ));
        }
        all
    }
}

/// The seed of a run's random phases, cut to 32 bits, because the scenario's keys take no more.
fn seed_of_run(seed: u64, run: usize) -> f64 {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    random.set_stream(run as u64);
    f64::from((random.next_u64() >> 32) as u32)
}

/// Draws `number` different numbers below `of`, in rising order (by the beginning of a Fisher–Yates shuffle).
fn drawn(of: usize, number: usize, seed: u64) -> Vec<usize> {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    random.set_stream(STREAM_OF_SAMPLE);
    let mut all: Vec<usize> = (0..of).collect();
    for first in 0..number {
        let left = (of - first) as u128;
        let other = ((u128::from(random.next_u64()) * left) >> 64) as usize;
        all.swap(first, first + other);
    }
    all.truncate(number);
    all.sort_unstable();
    all
}
