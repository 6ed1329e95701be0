//! `fenderline campaign merge` puts the shares of a campaign together into one table.

use fenderline_campaign::Campaign;
use fenderline_campaign::Runs;
use fenderline_campaign::store::{self, Shard};

use super::places::default_folder;
use super::report;
use crate::cli::CampaignMergeArgs;
use crate::failure::Failure;
use crate::terminal::say;

/// Merges shares.
///
/// # Errors
/// Fails if a folder holds no share of the campaign, if a share is missing, not finished or given twice, or if the
/// folder for the table holds a campaign already.
pub(super) fn merge(args: &CampaignMergeArgs) -> Result<(), Failure> {
    let campaign = Campaign::load(&args.campaign).map_err(Failure::input)?;
    let runs = Runs::new(campaign).map_err(Failure::input)?;
    let folder = args.out.clone().unwrap_or_else(|| default_folder(&args.campaign, Shard::WHOLE));
    store::merge(&runs, &args.shares, &folder).map_err(Failure::input)?;
    report::write(&runs, &args.campaign, &folder, None)?;
    let path = folder.join(store::TABLE_PARQUET);
    say(&format!(
        "{}: {} cases of {} shares: {}\n",
        runs.campaign().title,
        runs.count(),
        args.shares.len(),
        path.display()
    ))
}
