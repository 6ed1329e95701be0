//! The columns of a campaign's results, and their cells for a run.

use crate::file::{Campaign, Plan};
use fenderline_results::WorldTotals;
use fenderline_scenario::nearest;
use fenderline_sim::{Setup, Simulation};

use super::columns;
use super::motion::Excursion;
use super::named::Named;
use super::numbers::Numbers;
use crate::downtime::LOST_BY;
use crate::draw::Formula;
use crate::error::CampaignError;
use crate::row::{Cell, Head};

/// The results of a run: the columns that all campaigns have, the columns of named parts, formulas, notices and the
/// error.
pub(super) struct Outputs {
    named: Vec<Named>,
    formulas: Vec<(Formula, Vec<usize>)>,
    /// Bodies whose motion the outputs need.
    pub(super) bodies: Vec<usize>,
    /// Whether this is a downtime campaign, which has a column with the reasons for lost hours.
    is_downtime: bool,
    /// Heads of the table's columns for variables and results, in order, without the column of the run's number.
    pub(super) heads: Vec<Head>,
}

impl Outputs {
    /// The outputs of a campaign with the given base scenario; `variables` are the heads of the campaign's variables.
    ///
    /// # Errors
    /// Fails if an output names an unknown part or quantity or is given twice, or if a formula cannot be read or uses a
    /// number that is unknown or that comes after the formula in the file.
    pub(super) fn new(
        campaign: &Campaign,
        setup: &Setup,
        variables: &[Head],
    ) -> Result<Outputs, CampaignError> {
        let mut heads = variables.to_vec();
        heads.extend(columns::heads());
        for variable in variables {
            if heads.iter().filter(|head| head.name == variable.name).count() > 1
                || ["run", "notices", "error"].contains(&variable.name.as_str())
            {
                let why =
                    "the variable has the name of a column of the results: choose another name"
                        .to_owned();
                return Err(CampaignError::part(format!("variable.{}", variable.name), why));
            }
        }
        let mut named = Vec::new();
        for text in &campaign.outputs {
            let refused = |why: String| CampaignError::part("outputs", why);
            let own = Named::parse(text, setup).map_err(refused)?;
            if heads.iter().any(|head| head.name == *text) {
                return Err(refused(format!("\"{text}\" is given twice")));
            }
            heads.push(own.head(text));
            named.push(own);
        }
        let mut formulas = Vec::new();
        for output in &campaign.expressions {
            let name = format!("output.{}", output.name);
            let refused = |why: String| CampaignError::part(name.clone(), why);
            let formula = Formula::parse(&output.expression).map_err(refused)?;
            let mut inputs = Vec::new();
            for own in formula.names() {
                let Some(input) = heads.iter().position(|head| head.name == *own) else {
                    let near = nearest(own, heads.iter().map(|head| head.name.as_str()));
                    let near =
                        near.map_or(String::new(), |near| format!("; did you mean `{near}`?"));
                    return Err(refused(format!(
                        "there is no number `{own}` above this \
                        formula{near}"
                    )));
                };
                if heads[input].is_text {
                    return Err(refused(format!("`{own}` is a word, not a number")));
                }
                inputs.push(input);
            }
            if heads.iter().any(|head| head.name == output.name) {
                return Err(refused(
                    "another column already has the name of this output".to_owned(),
                ));
            }
            heads.push(Head::new(&output.name, &output.unit, &output.expression));
            formulas.push((formula, inputs));
        }
        let is_downtime = matches!(campaign.plan, Plan::Downtime(_));
        if is_downtime {
            let meaning = "limits that were exceeded, and other findings that prevent the ship \
                from staying at the berth, the gravest first";
            heads.push(Head::of_text(LOST_BY, meaning));
        }
        heads.push(Head::new("notices", "", "number of notices of the scenario"));
        heads.push(Head::of_text("error", "reason why the run was not made, or not finished"));
        let mut bodies: Vec<usize> = named.iter().filter_map(|own: &Named| own.body()).collect();
        bodies.sort_unstable();
        bodies.dedup();
        Ok(Outputs { named, formulas, bodies, is_downtime, heads })
    }

    /// The result cells of a run that has ended, which follow the cells of the variables.
    pub(super) fn cells(
        &self,
        variables: Vec<Cell>,
        simulation: &Simulation,
        world: &WorldTotals,
        motions: &[(usize, Excursion)],
        numbers: &Numbers,
    ) -> Vec<Cell> {
        let mut cells = variables;
        cells.extend(columns::cells(numbers));
        cells.extend(self.named.iter().map(|own| own.cell(simulation, world, motions)));
        for (formula, inputs) in &self.formulas {
            let values: Vec<f64> =
                inputs.iter().map(|input| cells[*input].number().unwrap_or(f64::NAN)).collect();
            cells.push(Cell::of_number(formula.value(&values)));
        }
        if self.is_downtime {
            cells.push(match numbers.lost_by.as_str() {
                "" => Cell::Empty,
                reasons => Cell::Text(reasons.to_owned()),
            });
        }
        cells.extend([Cell::Number(numbers.notices as f64), Cell::Empty]);
        cells
    }

    /// The result cells of a run that was not made, or did not reach its end.
    pub(super) fn cells_of_failure(&self, variables: Vec<Cell>, why: String) -> Vec<Cell> {
        let mut cells = variables;
        cells.extend(columns::cells_of_failure());
        cells.resize(self.heads.len() - 1, Cell::Empty);
        cells.push(Cell::Text(why));
        cells
    }
}
