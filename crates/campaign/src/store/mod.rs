//! The folder of a campaign's results.
//!
//! While a campaign runs, each run that has ended is appended to a journal (`rows.journal`). A record of the journal is
//! whole or absent, so that a killed program loses at most the runs under way. At the end the rows are written in the
//! order of the runs, as `cases.parquet` and, where there are not too many, `cases.csv`; the journal is then removed.
//! The table does not depend on the order in which the runs ended, on the threads or on interruptions.

mod folder;
mod journal;
mod merge;
mod places;
mod tables;
mod whole;

pub use self::folder::{Opened, Shard, Store, check, is_finished};
pub use self::journal::{decode_all, encode};
pub use self::merge::merge;
pub use self::tables::{
    About, EachRow, MOST_CSV_ROWS, TABLE_CSV, TABLE_PARQUET, write_rows, write_tables,
};
