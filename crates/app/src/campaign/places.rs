//! Where the files of a campaign go.

use std::path::{Path, PathBuf};

use fenderline_campaign::store::Shard;

/// File name of the figure of a full factorial campaign.
pub(super) const FIGURE: &str = "figure.html";

pub(super) fn default_folder(campaign: &Path, shard: Shard) -> PathBuf {
    let folder = Path::new("out").join(campaign.file_stem().unwrap_or_default());
    match shard {
        Shard::WHOLE => folder,
        Shard { number, of } => folder.join(format!("shard_{number}_of_{of}")),
    }
}
