//! `cargo xtask state-hashes [REVISION]` makes a hash of all numbers that each scenario writes, and compares it with
//! that of an older revision of the program. An equal hash shows that a change of names or structure changed no result.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use crate::command::{cargo, run, run_quietly};
use crate::scenarios;

/// Folder below `target` for programs, checkouts and results.
const FOLDER: &str = "target/state-hashes";

/// The hashes of the numbers that each scenario writes.
type Hashes = BTreeMap<PathBuf, Result<Vec<u64>, String>>;

/// Prints a line for each scenario; with a revision, also reports which scenarios differ from it.
pub(crate) fn state_hashes_command(revision: Option<&str>) -> ExitCode {
    match state_hashes(revision) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(why) => {
            eprintln!("{why}");
            ExitCode::FAILURE
        }
    }
}

fn state_hashes(revision: Option<&str>) -> Result<bool, String> {
    let folder = std::env::current_dir().map_err(|e| format!("the workspace's folder: {e}"))?;
    let before = revision.map(|revision| of_revision(&folder, revision)).transpose()?;
    let now = of_checkout(&folder, &folder.join(FOLDER).join("now"))?;
    let mut same = true;
    for (scenario, columns) in &now {
        let now = columns.as_ref().map_err(|why| format!("{}: {why}", scenario.display()))?;
        let verdict = match before.as_ref().map(|before| before.get(scenario)) {
            None => String::new(),
            Some(None) => " new".into(),
            Some(Some(Err(why))) => format!(" the older program failed: {why}"),
            Some(Some(Ok(before))) if before == now => " same".into(),
            Some(Some(Ok(before))) => {
                same = false;
                let (lost, gained) = (missing(before, now), missing(now, before));
                format!(
                    " DIFFERS: {lost} columns of numbers of the older program are missing, {gained} columns \
                         are new"
                )
            }
        };
        println!("{:016x} {}{verdict}", hash(now.iter().copied()), scenario.display());
    }
    for scenario in before.iter().flat_map(BTreeMap::keys).filter(|old| !now.contains_key(*old)) {
        println!("gone: {}", scenario.display());
    }
    Ok(same)
}

/// How many hashes of the sorted list `some` are missing in the sorted list `others`.
fn missing(some: &[u64], others: &[u64]) -> usize {
    some.iter().filter(|column| others.binary_search(column).is_err()).count()
}

/// Hashes of the scenarios of a revision, run by the program of that revision, which is built in a separate checkout.
fn of_revision(folder: &Path, revision: &str) -> Result<Hashes, String> {
    let name: String = revision.chars().filter(char::is_ascii_alphanumeric).collect();
    let checkout = folder.join(FOLDER).join(format!("checkout-{name}"));
    let git = |arguments: &[&str]| run_quietly(Command::new("git").args(arguments));
    if !checkout.exists() {
        git(&["worktree", "prune"])?;
        let path = checkout.display().to_string();
        git(&["worktree", "add", "--quiet", "--detach", &path, revision])?;
    }
    let wanted = git(&["rev-parse", &format!("{revision}^{{commit}}")])?;
    let at = git(&["-C", &checkout.display().to_string(), "rev-parse", "HEAD"])?;
    if wanted != at {
        return Err(format!("{} is not at {revision}: remove it", checkout.display()));
    }
    of_checkout(&checkout, &folder.join(FOLDER).join(format!("results-{name}")))
}

/// Builds the program of a checkout and runs each of its scenarios. Each checkout has a target folder of its own: in a
/// shared folder cargo takes the crates of one checkout for those of the other.
fn of_checkout(checkout: &Path, results: &Path) -> Result<Hashes, String> {
    let target = results.join("target");
    let mut build = cargo(["build", "--quiet", "--package", "fenderline"]);
    run(build.current_dir(checkout).env("CARGO_TARGET_DIR", &target))?;
    let program = target.join("debug/fenderline");
    let own = std::env::current_dir().map_err(|e| format!("this folder: {e}"))?;
    std::env::set_current_dir(checkout).map_err(|e| format!("{}: {e}", checkout.display()))?;
    let all = scenarios::all();
    std::env::set_current_dir(&own).map_err(|e| format!("{}: {e}", own.display()))?;
    let hashes = all?.into_iter().map(|scenario| {
        let out = results.join("out");
        let columns = play(&program, checkout, &scenario, &out);
        (scenario, columns)
    });
    Ok(hashes.collect())
}

/// Runs a scenario into an empty folder and hashes the numbers of its results.
fn play(program: &Path, checkout: &Path, scenario: &Path, out: &Path) -> Result<Vec<u64>, String> {
    if out.exists() {
        std::fs::remove_dir_all(out).map_err(|e| format!("{}: {e}", out.display()))?;
    }
    let mut command = Command::new(program);
    let ran =
        run_quietly(command.current_dir(checkout).arg("run").arg(scenario).arg("--out").arg(out));
    // Exit code 1 of a whole result is its verdict: a structure was struck, say.
    if !out.join("summary.json").is_file() {
        ran?;
    }
    columns(out)
}

/// The sorted hashes of all columns of numbers in the tables of a folder. The names and the order of columns and tables
/// do not count, nor do cells of text.
fn columns(folder: &Path) -> Result<Vec<u64>, String> {
    let unreadable = |path: &Path, e: std::io::Error| format!("{}: {e}", path.display());
    let mut hashes = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(|e| unreadable(folder, e))? {
        let path = entry.map_err(|e| unreadable(folder, e))?.path();
        if path.extension().is_some_and(|extension| extension == "csv") {
            let table = std::fs::read_to_string(&path).map_err(|e| unreadable(&path, e))?;
            hashes.extend(columns_of(&table));
        }
    }
    hashes.sort_unstable();
    Ok(hashes)
}

fn columns_of(table: &str) -> Vec<u64> {
    let mut columns: Vec<Vec<u64>> = Vec::new();
    for line in table.lines().skip(1) {
        for (index, cell) in line.split(',').enumerate() {
            if columns.len() <= index {
                columns.push(Vec::new());
            }
            columns[index].extend(cell.parse::<f64>().map(f64::to_bits));
        }
    }
    columns.into_iter().filter(|column| !column.is_empty()).map(hash).collect()
}

/// The FNV-1a hash over the bytes of 64-bit words.
fn hash(words: impl IntoIterator<Item = u64>) -> u64 {
    let mut hash = 0xcbf2_9ce4_8422_2325_u64;
    for word in words {
        for byte in word.to_le_bytes() {
            hash = (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }
    hash
}

#[cfg(test)]
mod tests {
    use super::columns_of;

    #[test]
    fn renamed_or_moved_columns_do_not_count_but_each_bit_of_a_number_does() {
        let sorted = |table: &str| {
            let mut columns = columns_of(table);
            columns.sort_unstable();
            columns
        };
        let table = sorted("time,name,force\n0.1,a,2\n0.2,a,3\n");
        assert_eq!(table.len(), 2);
        assert_eq!(table, sorted("force_n,t_s,body\n2,0.1,b\n3,0.2,b\n"));
        assert_ne!(table, sorted("time,name,force\n0.1,a,2\n0.2,a,3.0000000000000004\n"));
        assert_ne!(table, sorted("time,name,force\n0.1,a,3\n0.2,a,2\n"));
    }
}
