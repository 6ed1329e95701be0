//! Limits of outputs: values that should seldom be exceeded.

use crate::file::Campaign;
use fenderline_scenario::in_unit;

use crate::error::CampaignError;
use crate::row::Head;

/// A limit of an output of the campaign.
#[derive(Clone, Debug, PartialEq)]
pub struct Limit {
    /// Name of the limit.
    pub name: String,
    /// Column of the output.
    pub output: String,
    /// The limit's value, in the unit of the output's column.
    pub value: f64,
}

impl Limit {
    /// Checks the limits of a campaign against the columns of its table.
    ///
    /// # Errors
    /// Fails if an output is no number of the campaign, or if the unit of a limit does not fit the output.
    pub(crate) fn all(campaign: &Campaign, heads: &[Head]) -> Result<Vec<Limit>, CampaignError> {
        let numbers = || heads.iter().filter(|head| !head.is_text);
        let one = |limit: &crate::file::Limit| {
            let Some(head) = numbers().find(|head| head.name == limit.output) else {
                let near = fenderline_scenario::nearest(
                    &limit.output,
                    numbers().map(|head| head.name.as_str()),
                );
                let near = near.map_or(String::new(), |near| format!("; did you mean `{near}`?"));
                return Err(CampaignError::part(
                    format!("limit.{}.output", limit.name),
                    format!("the campaign has no number `{}`{near}", limit.output),
                ));
            };
            let value = in_unit(&limit.text, &head.unit);
            let value = value
                .map_err(|why| CampaignError::part(format!("limit.{}.value", limit.name), why))?;
            Ok(Limit { name: limit.name.clone(), output: limit.output.clone(), value })
        };
        campaign.limits.iter().map(one).collect()
    }
}
