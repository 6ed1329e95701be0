//! Campaigns whose results are known in closed form.

use std::path::{Path, PathBuf};

use fenderline_campaign::store::{Opened, Shard, Store};
use fenderline_campaign::{Campaign, Law};
use fenderline_campaign::{Row, Runs, make};

/// A barge of 1000 t onto one fender of 2500 kN/m. Her speed becomes a reaction of v √(k m) and an energy of m v²/2. Steps of
/// ω Δt = 0.032 find the peak of a cosine to (ω Δt)²/8 = 1.3e-4.
const BARGE: &str = include_str!("barge.toml");

const SPEED: &str = r#"
scenario = "barge.toml"
[variable.speed]
key = "body.barge.velocity.sway"
distribution = "lognormal"
mean = "7.1 cm/s"
standard_deviation = "4.47 cm/s"
"#;

/// Reaction in kN of a speed in cm/s: √(2500 kN/m · 1000 t).
const KN_PER_CMPS: f64 = 15.811_388_300_841_896;

/// The largest error of a peak, with rounding.
const PEAK: f64 = 1.4e-4;

fn folder(name: &str) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("fenderline_{name}_{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    folder
}

/// The runs of a campaign of the barge.
fn runs(name: &str, campaign: &str) -> Runs {
    let folder = folder(name);
    std::fs::write(folder.join("barge.toml"), BARGE).expect("written");
    let path = folder.join("campaign.toml");
    std::fs::write(&path, campaign).expect("written");
    Runs::new(Campaign::load(&path).expect("a campaign")).expect("runs")
}

/// The numbers of a column, in the order of the runs.
fn column(runs: &Runs, name: &str) -> Vec<f64> {
    let place = runs.heads().iter().position(|head| head.name == name).expect("the column");
    let numbers = (0..runs.count()).into();
    let mut rows: Vec<Row> = Vec::new();
    make(runs, &numbers, 2, &|| false, &mut |row| {
        rows.push(row);
        Ok(true)
    })
    .expect("made");
    rows.sort_by_key(|row| row.run);
    rows.iter().map(|row| row.cells[place].number().unwrap_or(f64::NAN)).collect()
}

/// The numbers of a hundred million runs are not held: the folder opens at once, and the last run draws by its number.
#[test]
fn a_plan_of_a_hundred_million_runs_takes_no_memory() {
    let campaign = SPEED.replace("[variable", "number = 100000000\nseed = 3\n[variable");
    let runs = runs("many", &campaign);
    assert_eq!(runs.count(), 100_000_000);
    let last = runs.draws().of_run(99_999_999);
    assert_ne!(last, runs.draws().of_run(99_999_998));
    let out = folder("many").join("out");
    let open =
        |opened| Store::open(&out, &runs, Shard::WHOLE, opened, &mut |_| {}).expect("a folder");
    let mut store = open(Opened::Replaced);
    let missing = store.missing();
    assert_eq!((missing.count(), missing.get(99_999_999)), (100_000_000, Some(99_999_999)));
    let mut made = 0;
    make(&runs, &missing, 2, &|| false, &mut |row| {
        store.add(&row)?;
        made += 1;
        Ok(made < 5)
    })
    .expect("made");
    assert_eq!(store.done(), 5);
    store.write_so_far().expect("tables of five rows");
    std::fs::remove_dir_all(out).expect("removed");
}

#[test]
fn a_lognormal_speed_gives_a_lognormal_reaction_and_energy() {
    let number = 2000;
    let campaign = SPEED.replace("[variable", "number = 2000\nseed = 3\n[variable");
    let campaign = format!(
        "{campaign}\n[output.energy_of_speed]\nexpression = \"0.05 * speed ^ 2\"\nunit = \"kJ\"\n"
    );
    let runs = runs("lognormal", &campaign);
    let (reactions, energies) = (column(&runs, "reaction"), column(&runs, "energy"));
    let exact = column(&runs, "energy_of_speed");
    let mut touched = 0;
    for run in 0..number {
        let fenderline_campaign::Cell::Number(speed) = runs.draws().of_run(run as u64).values[0]
        else {
            panic!("a speed is a number")
        };
        // Slower than 1.5 cm/s she may not reach her largest deflection in the time of the run.
        if speed < 1.5 {
            continue;
        }
        touched += 1;
        let wanted = KN_PER_CMPS * speed;
        assert!((reactions[run] / wanted - 1.0).abs() < PEAK, "{} kN for {wanted}", reactions[run]);
        assert!(
            (energies[run] / exact[run] - 1.0).abs() < 2.0 * PEAK,
            "{} kJ for {}",
            energies[run],
            exact[run]
        );
    }
    assert!(touched > number * 95 / 100);
    // A sample's quantile has the standard error √(p (1 − p)/n)/f: four of them, a chance of 6e-5 each.
    let law = Law::lognormal(7.1, 4.47).expect("a law");
    let mut sorted = reactions.clone();
    sorted.sort_by(f64::total_cmp);
    for p in [0.2, 0.5, 0.9, 0.98] {
        let wanted = law.quantile(p);
        let density = 2e-6 / (law.quantile(p + 1e-6) - law.quantile(p - 1e-6));
        let error = (p * (1.0 - p) / number as f64).sqrt() / density;
        let own = sorted[(p * number as f64) as usize] / KN_PER_CMPS;
        assert!((own - wanted).abs() < 4.0 * error, "at {p}: {own} for {wanted} ± {error}");
    }
}

/// The mean of 40 runs over 20 seeds: its variance by a Latin hypercube is less than a tenth of that by Monte Carlo, as the output rises
/// with its one variable (McKay, Beckman and Conover 1979).
#[test]
fn a_latin_hypercube_has_less_variance_than_monte_carlo() {
    let variance = |plan: &str| {
        let mean = |seed: u32| {
            let head = format!("plan = \"{plan}\"\nnumber = 40\nseed = {seed}\n[variable");
            let runs = runs("hypercube", &SPEED.replace("[variable", &head));
            let known = column(&runs, "reaction");
            known.iter().sum::<f64>() / known.len() as f64
        };
        let means: Vec<f64> = (1..=20).map(mean).collect();
        let middle = means.iter().sum::<f64>() / 20.0;
        means.iter().map(|mean| (mean - middle) * (mean - middle)).sum::<f64>() / 19.0
    };
    let (random, hypercube) = (variance("Monte Carlo"), variance("Latin hypercube"));
    assert!(hypercube < 0.1 * random, "{hypercube} against {random}");
    let sobol = variance("Sobol");
    assert!(sobol < 0.1 * random, "{sobol} against {random}");
}

/// Table 2 of the paper: the depths at four speeds, within the 10 % that `fenderline validate` shows for them.
#[test]
fn the_paper_s_tug_over_her_speed() {
    let scenario =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenarios/paper/experiment_2_4kn.toml");
    let folder = folder("paper");
    let path = folder.join("campaign.toml");
    let text = format!(
        "scenario = {:?}\n[variable.speed]\nkey = \"body.tug.velocity.surge\"\nvalues = [\"4 kn\", \"2 kn\", \"1 kn\", \"0.5 kn\"]\n",
        scenario.display().to_string()
    );
    std::fs::write(&path, text).expect("written");
    let runs = Runs::new(Campaign::load(&path).expect("a campaign")).expect("runs");
    let depths = column(&runs, "contact_depth");
    for (own, published) in depths.iter().zip([0.96, 0.53, 0.29, 0.14]) {
        assert!((own / published - 1.0).abs() < 0.1, "{own} m for {published}");
    }
}
