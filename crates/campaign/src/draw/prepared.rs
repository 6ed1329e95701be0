//! Prepares the draws of a campaign: the values of the variables in every run.

use crate::file::{Campaign, Change, Draw, Plan, Target, Variable};
use fenderline_contact::hash::Fnv1a;
use fenderline_scenario::{Override, ScenarioError};

use super::copula::Copula;
use super::formula::Formula;
use super::plan::Probabilities;
use super::source::{Column, Measured, Source, of_downtime, open, rows, source};
use crate::downtime::DowntimePlan;
use crate::error::CampaignError;
use crate::row::{Cell, Head};

/// Gives the values of a campaign's variables in every run.
pub struct Draws {
    sources: Vec<Source>,
    /// The formulas in the order of evaluation, because formulas may use each other.
    formulas: Vec<(usize, Formula, Vec<usize>)>,
    probabilities: Option<Probabilities>,
    copula: Option<Copula>,
    counts: Vec<usize>,
    heads: Vec<Head>,
    runs: u64,
    downtime: Option<DowntimePlan>,
}

/// The values that a run draws.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawn {
    /// The value of each variable, in the order of the file.
    pub values: Vec<Cell>,
    /// The changes of the scenario as `--set` takes them, KEY=VALUE.
    pub settings: Vec<String>,
    /// For each variable the number of its choice, or the row of its file, both counted from 0; 0 for other variables.
    picked: Vec<usize>,
}

impl Drawn {
    /// The changes of the scenario as parsed overrides.
    ///
    /// # Errors
    /// Says why a value cannot stand in a scenario, such as the empty text of a table.
    pub fn overrides(&self) -> Result<Vec<Override>, String> {
        let one = |text: &String| Override::parse(text).map_err(|error| error.message().to_owned());
        self.settings.iter().map(one).collect()
    }
}

impl Draws {
    /// Reads the files that the campaign names, and prepares its laws and formulas.
    ///
    /// # Errors
    /// [`CampaignError`] if a file of values cannot be read, a column is missing, a cell has no value, no variables can
    /// have the correlations, a formula cannot be read or names an unknown number, formulas need each other, or a
    /// formula uses a variable whose values are names.
    pub fn new(campaign: &Campaign) -> Result<Draws, CampaignError> {
        let downtime = match &campaign.plan {
            Plan::Downtime(of) => Some(DowntimePlan::new(of, campaign.seed)?),
            _ => None,
        };
        let given = downtime.as_ref().map(|own| own.variables(campaign)).unwrap_or_default();
        let variables = &campaign.variables;
        let table = match &campaign.plan {
            Plan::Table { file } => Some(open(file)?),
            _ => None,
        };
        let mut sources = Vec::new();
        let mut heads = Vec::new();
        for variable in variables {
            let (source, unit) = source(variable, table.as_ref())?;
            let is_text =
                matches!(source, Source::Choices { numbers: None, .. } | Source::Texts(_));
            let head = Head::new(&variable.name, &unit, "value of the variable");
            heads.push(Head { is_text, ..head });
            sources.push(source);
        }
        for (variable, values) in given {
            let (source, head) = of_downtime(&variable, values);
            heads.push(head);
            sources.push(source);
        }
        let runs = match &campaign.plan {
            Plan::FullFactorial => campaign.cases() as u64,
            Plan::MonteCarlo { number }
            | Plan::LatinHypercube { number }
            | Plan::Sobol { number } => *number,
            Plan::Table { file } => {
                rows(&sources).ok_or_else(|| CampaignError::values(file, "there is no row"))?
            }
            Plan::Downtime(_) => downtime.as_ref().map_or(0, DowntimePlan::runs),
        };
        let probabilities = Probabilities::new(&campaign.plan, variables.len(), campaign.seed)
            .map_err(|why| CampaignError::part("plan", why))?;
        let copula = match &campaign.correlations[..] {
            [] => None,
            all => Some(Copula::new(all).map_err(|why| CampaignError::part("correlation", why))?),
        };
        Ok(Draws {
            formulas: formulas(variables, &sources)?,
            counts: sources.iter().map(Source::choices).collect(),
            sources,
            probabilities,
            copula,
            heads,
            runs,
            downtime,
        })
    }

    /// The number of runs.
    #[must_use]
    pub fn runs(&self) -> u64 {
        self.runs
    }

    /// The states and hours of a downtime campaign; `None` for a campaign with variables.
    #[must_use]
    pub fn downtime(&self) -> Option<&DowntimePlan> {
        self.downtime.as_ref()
    }

    /// Adds all values that were read from files to a hash.
    pub(crate) fn add_values(&self, hash: &mut Fnv1a) {
        for source in &self.sources {
            match source {
                Source::Measured(Measured { values, target, .. })
                | Source::Numbers(Column { values, target, .. })
                | Source::States { values, target } => {
                    hash.bytes(target.unit.as_bytes());
                    values.iter().for_each(|value| hash.word(value.to_bits()));
                }
                Source::Texts(all) => all.values.iter().for_each(|text| {
                    hash.bytes(text.as_bytes());
                    hash.bytes(&[0]);
                }),
                Source::Words { values, .. } => values.iter().for_each(|text| {
                    hash.bytes(text.as_bytes());
                    hash.bytes(&[0]);
                }),
                Source::Choices { .. } | Source::Law(..) | Source::Formula(_) => {}
            }
        }
    }

    /// Whether values of the campaign come from the given file.
    pub(crate) fn reads(&self, file: &str) -> bool {
        self.sources.iter().filter_map(Source::file).any(|own| own.display().to_string() == file)
    }

    /// Names and units of the campaign's variables.
    #[must_use]
    pub fn heads(&self) -> &[Head] {
        &self.heads
    }

    /// The values that a run draws; `run` counts from 0.
    ///
    /// # Panics
    /// Panics if the campaign has no run of this number.
    #[must_use]
    pub fn of_run(&self, run: u64) -> Drawn {
        assert!(run < self.runs, "there are {} runs", self.runs);
        let probabilities = self.probabilities.as_ref().map(|plan| {
            let mut probabilities = plan.of_run(run);
            if let Some(copula) = &self.copula {
                copula.correlate(&mut probabilities);
            }
            probabilities
        });
        self.at(run, probabilities.as_deref())
    }

    /// The values of the variables at the given probabilities, one for each variable; the probabilities of variables
    /// with formulas are not used. Rare-event methods, which choose the probabilities themselves, use this function.
    ///
    /// # Errors
    /// Fails if the campaign has no random plan, if there is not one probability for each variable, or if a probability
    /// is not between 0 and 1.
    pub fn at_probabilities(&self, probabilities: &[f64]) -> Result<Drawn, String> {
        if self.probabilities.is_none() {
            return Err("the campaign's plan is not random: it has no probabilities".to_owned());
        }
        if probabilities.len() != self.sources.len() {
            let (own, wanted) = (probabilities.len(), self.sources.len());
            return Err(format!("there are {own} probabilities for {wanted} variables"));
        }
        if let Some(bad) = probabilities.iter().find(|p| !(0.0 < **p && **p < 1.0)) {
            return Err(format!("the probability {bad} is not between 0 and 1"));
        }
        let mut correlated = probabilities.to_vec();
        if let Some(copula) = &self.copula {
            copula.correlate(&mut correlated);
        }
        Ok(self.at(0, Some(&correlated)))
    }

    fn at(&self, run: u64, probabilities: Option<&[f64]>) -> Drawn {
        let mut values: Vec<Cell> = Vec::with_capacity(self.sources.len());
        let mut picked = vec![0; self.sources.len()];
        for (index, source) in self.sources.iter().enumerate() {
            let p = probabilities.map(|all| all[index]);
            values.push(match source {
                Source::Choices { choices, numbers, cumulative } => {
                    let own = match p {
                        Some(p) => {
                            cumulative.partition_point(|sum| *sum <= p).min(choices.len() - 1)
                        }
                        None => self.combination(run, index),
                    };
                    picked[index] = own;
                    match numbers {
                        Some(numbers) => Cell::Number(numbers[own]),
                        None => Cell::Text(choices[own].label.clone()),
                    }
                }
                Source::Law(law, _) => {
                    Cell::Number(law.quantile(p.expect("a variable with a law has a random plan")))
                }
                Source::Measured(Measured { values, rows, .. }) => {
                    let p = p.expect("a variable with measured values has a random plan");
                    let own = ((p * values.len() as f64) as usize).min(values.len() - 1);
                    picked[index] = rows[own];
                    Cell::Number(values[own])
                }
                Source::Formula(_) => Cell::Empty,
                Source::States { values, .. } => Cell::Number(values[run as usize]),
                Source::Words { values, .. } => match values[run as usize].as_str() {
                    "" => Cell::Empty,
                    text => Cell::Text(text.to_owned()),
                },
                Source::Numbers(all) => {
                    picked[index] = run as usize;
                    Cell::Number(all.values[run as usize])
                }
                Source::Texts(all) => {
                    picked[index] = run as usize;
                    Cell::Text(all.values[run as usize].clone())
                }
            });
        }
        for (index, formula, inputs) in &self.formulas {
            let numbers: Vec<f64> =
                inputs.iter().map(|input| values[*input].number().unwrap_or(f64::NAN)).collect();
            values[*index] = Cell::of_number(formula.value(&numbers));
        }
        let mut settings = Vec::new();
        for (index, (source, value)) in self.sources.iter().zip(&values).enumerate() {
            match source {
                Source::Choices { choices, .. } => {
                    let changes: &[Change] = &choices[picked[index]].changes;
                    settings.extend(changes.iter().map(|change| change.text.clone()));
                }
                _ => {
                    let target = source.target().expect("only choices have none");
                    let text = text_of(target, value);
                    settings.extend(target.keys.iter().map(|key| format!("{key}={text}")));
                }
            }
        }
        Drawn { values, settings, picked }
    }

    /// The changes of the scenario by the drawn values, each with its place in the campaign's file or in the file of
    /// its values, so that errors point to this place. `run` counts from 0; the error's text below the place names the
    /// run. Slower than [`Drawn::overrides`].
    ///
    /// # Errors
    /// Fails if a value cannot stand in a scenario, such as the empty text of a table.
    pub fn located(&self, drawn: &Drawn, run: Option<u64>) -> Result<Vec<Override>, ScenarioError> {
        let mut all = Vec::new();
        for (index, source) in self.sources.iter().enumerate() {
            if let Source::Choices { choices, .. } = source {
                let changes = choices[drawn.picked[index]].changes.iter();
                all.extend(changes.map(|change| change.set.clone()));
                continue;
            }
            let target = source.target().expect("only choices have none");
            let text = text_of(target, &drawn.values[index]);
            for (key, key_origin) in target.keys.iter().zip(&target.origins.keys) {
                let of_run = run.map_or(String::new(), |run| format!("run {} sets ", run + 1));
                let note = format!("{of_run}{key}={text}");
                let origin =
                    source.origin(drawn.picked[index]).unwrap_or_else(|| key_origin.clone());
                let value = (text.as_str(), origin.with_note(note));
                all.push(Override::from_files((key, key_origin.clone()), value)?);
            }
        }
        Ok(all)
    }

    /// Index of a variable's choice in a case of a full factorial; the choice of the last variable changes fastest.
    fn combination(&self, run: u64, index: usize) -> usize {
        let faster: u64 = self.counts[index + 1..].iter().map(|count| *count as u64).product();
        (run / faster % self.counts[index] as u64) as usize
    }
}

/// The text of a value for the keys that a variable sets, written as for `--set`.
fn text_of(target: &Target, value: &Cell) -> String {
    match value {
        Cell::Number(number) => target.value(*number),
        Cell::Text(text) => text.clone(),
        // A formula without a value: the scenario refuses it, and the row says so.
        Cell::Empty => "nan".to_owned(),
    }
}

/// Sorts the formulas so that each formula comes after the formulas that it uses.
fn formulas(
    variables: &[Variable],
    sources: &[Source],
) -> Result<Vec<(usize, Formula, Vec<usize>)>, CampaignError> {
    let mut waiting = Vec::new();
    for (index, variable) in variables.iter().enumerate() {
        let Draw::Expression { text, .. } = &variable.draw else { continue };
        let refused = |why: String| {
            CampaignError::part(format!("variable.{}.expression", variable.name), why)
        };
        let formula = Formula::parse(text).map_err(refused)?;
        let mut inputs = Vec::new();
        for name in formula.names() {
            let Some(input) = variables.iter().position(|variable| variable.name == *name) else {
                let names = variables.iter().map(|variable| variable.name.as_str());
                let near = fenderline_scenario::nearest(name, names);
                let near = near.map_or(String::new(), |near| format!("; did you mean `{near}`?"));
                return Err(refused(format!("there is no variable `{name}`{near}")));
            };
            if matches!(sources[input], Source::Choices { numbers: None, .. } | Source::Texts(_)) {
                return Err(refused(format!("the values of `{name}` are names, not numbers")));
            }
            inputs.push(input);
        }
        waiting.push((index, formula, inputs));
    }
    let mut ordered: Vec<(usize, Formula, Vec<usize>)> = Vec::new();
    while !waiting.is_empty() {
        let is_open = |input: &usize, waiting: &[(usize, Formula, Vec<usize>)]| {
            waiting.iter().any(|(own, ..)| own == input)
        };
        let ready = waiting
            .iter()
            .position(|(_, _, inputs)| !inputs.iter().any(|input| is_open(input, &waiting)));
        let Some(ready) = ready else {
            let name = format!("variable.{}.expression", variables[waiting[0].0].name);
            return Err(CampaignError::part(
                name,
                "the formula needs another formula that needs this formula: there is no order to \
                 compute them",
            ));
        };
        ordered.push(waiting.remove(ready));
    }
    Ok(ordered)
}
