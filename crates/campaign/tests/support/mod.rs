//! A table of a campaign as a report takes it, of a made-up berth: numbers by closed forms, nothing is simulated.

use core::fmt::Write as _;
use std::path::Path;

use fenderline_campaign::report::{Campaign, Input, ReportError, render};
use fenderline_campaign::statistics::Confidence;
use fenderline_campaign::statistics::design::Asked;
use fenderline_campaign::statistics::fit::{Distribution, Law};
use fenderline_campaign::statistics::return_value::Traffic;
use fenderline_campaign::table::Table;
use fenderline_contact::number::lesser;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng as _, SeedableRng as _};

/// A table of `runs` runs as comma-separated text.
pub(crate) fn table(runs: usize) -> String {
    let mut random = ChaCha8Rng::seed_from_u64(22);
    let mut uniform = || ((random.next_u64() >> 12) as f64 + 0.5) / (1_u64 << 52) as f64;
    let speed_law = fenderline_campaign::Law::lognormal(7.1, 4.47).expect("a law");
    let angle_law = Distribution::Normal { mean: 0.0, deviation: 2.0 };
    let wind_law = Distribution::Weibull { shape: 2.0, scale: 8.0 };
    let ships = [("feeder", 12.0), ("panamax", 60.0), ("post_panamax", 120.0)];
    let mut text = String::from(
        "speed [cm/s],angle [deg],ship,wind_speed [m/s],wind_direction [deg],verdict,gravity,energy [kJ],reaction [kN],\
         hull_pressure [kN/m²],formula_energy [kJ]\n",
    );
    for run in 0..runs {
        let speed = speed_law.quantile(1.0 - uniform());
        let angle = angle_law.value_exceeded(uniform()).unwrap();
        let (ship, mass_kt) = ships[((uniform() * 3.0) as usize).min(2)];
        let wind = wind_law.value_exceeded(uniform()).unwrap();
        let direction = 360.0 * uniform();
        // Onshore wind, from the west, drives her on.
        let onshore = wind * -libm::sin(direction.to_radians());
        let touch = speed + if onshore > 0.0 { 0.04 * onshore * onshore } else { 0.0 };
        let formula = 0.5 * mass_kt * 1.5 * 0.55 * 0.1 * speed * speed;
        let share = 0.7 + 0.1 * lesser(angle.abs(), 6.0) + 0.1 * uniform();
        let energy = share * formula * (touch / speed) * (touch / speed);
        let reaction = 1400.0 * (1.0 - libm::exp(-energy / 600.0)) + 0.25 * energy;
        if run % 997 == 500 {
            let _ = writeln!(text, "{speed},{angle},{ship},{wind},{direction},error,,,,,");
            continue;
        }
        let (verdict, gravity) = match energy {
            e if e > 2500.0 => ("fender_failed", "failed"),
            e if e > 1400.0 => ("fender_over_rated", "attention"),
            _ => ("all_well", "ok"),
        };
        let _ = writeln!(
            text,
            "{speed},{angle},{ship},{wind},{direction},{verdict},{gravity},{energy},{reaction},{},{formula}",
            reaction / 9.0
        );
    }
    text
}

/// The report of that table.
pub(crate) fn report(path: &Path) -> Result<String, ReportError> {
    let table = Table::open(path)?;
    let input = |column: &str, distribution: &str, source: &str| Input {
        column: column.to_owned(),
        distribution: distribution.to_owned(),
        source: source.to_owned(),
    };
    let inputs = [
        input(
            "speed",
            "log-normal, mean 7.1 cm/s, deviation 4.47 cm/s",
            "Cho (2018), a tanker terminal",
        ),
        input("angle", "normal, mean 0°, deviation 2°", ""),
        input("ship", "one of three alike", "assumed for the demonstration"),
        input("wind_speed", "Weibull, shape 2, scale 8 m/s", "assumed for the demonstration"),
        input("wind_direction", "uniform from 0 to 360°", "assumed for the demonstration"),
    ];
    let asked = Asked {
        confidence: Confidence::USUAL,
        traffic: Traffic::new(60.0).ok(),
        periods_years: vec![10.0, 50.0, 100.0],
        life_years: Some(50.0),
        laws: vec![Law::LogNormal, Law::Weibull, Law::Gumbel, Law::Gev, Law::Pareto],
        threshold: Some(800.0),
    };
    render(&Campaign {
        title: "Demonstration: a made-up berth",
        scenario: "made_up.toml",
        plan: "made up",
        planned: 0,
        notices: &[],
        table: &table,
        inputs: &inputs,
        outputs: &["energy", "reaction", "hull_pressure"].map(str::to_owned),
        weights: None,
        success: None,
        limits: &[],
        seen: &[],
        asked: &asked,
        replay: &|row| format!("fenderline campaign replay {}", row + 1),
    })
}
