//! `fenderline check` and `fenderline schema`.

use fenderline_campaign::Campaign;
use fenderline_report::plot::counted;
use fenderline_scenario::{LoadError, printable_number};
use fenderline_sim::chart::{ChartClass, SHORE};
use fenderline_sim::{Bottom, Simulation};
use serde_json::{Value, json};

use crate::campaign;
use crate::cli::{CheckArgs, SchemaOf};
use crate::failure::Failure;
use crate::load::Source;
use crate::mistake::{notice_json, refuse_notices, refused_json};
use crate::played::error;
use crate::terminal::{notice, say, say_json};
use crate::vessels::estimates;

/// Checks a scenario as `run` does, or a campaign as `campaign` does, and writes nothing. With `--json` a mistake is
/// printed as JSON, and as text to standard error.
///
/// # Errors
/// Bad input.
pub(crate) fn check(args: &CheckArgs) -> Result<(), Failure> {
    let overrides = args.changes.overrides().map_err(Failure::input)?;
    let refused = |error: &LoadError| match args.json {
        true => say_json(&format!("{:#}\n", refused_json(error))),
        false => Ok(()),
    };
    let source = match Source::read(&args.scenario) {
        Ok(source) => source,
        Err(error) => {
            refused(&error)?;
            return Err(Failure::input(error));
        }
    };
    if Campaign::is_one(&source.text) {
        return campaign::check(args);
    }
    let scenario = match source.scenario(&overrides) {
        Ok(scenario) => scenario,
        Err(error) => {
            refused(&error)?;
            return Err(Failure::input(error));
        }
    };
    let mut notices: Vec<Value> = scenario.notices.iter().map(notice_json).collect();
    if !args.json {
        scenario.notices.iter().for_each(notice);
    }
    let simulation = match Simulation::new(scenario.setup) {
        Ok(simulation) => simulation,
        Err(why) => {
            if args.json {
                let found = json!({ "good": false, "error": { "message": why.to_string() } });
                say_json(&format!("{found:#}\n"))?;
            }
            return Err(error(why));
        }
    };
    let setup = simulation.setup();
    for finding in simulation.start_findings() {
        let sentence = finding.sentence(setup);
        if !args.json {
            notice(&sentence);
        }
        notices.push(json!({ "message": sentence }));
    }
    if args.json {
        let found = json!({
            "good": !args.strict || notices.is_empty(),
            "title": scenario.title,
            "notices": notices,
            "bodies": setup.bodies.iter().map(|body| &body.name).collect::<Vec<_>>(),
            "fenders": setup.fenders.iter().map(|fender| &fender.name).collect::<Vec<_>>(),
            "pairs": setup.pairs.len(),
            "steps": simulation.steps_total(),
            "step_s": setup.step_s,
            "chart": chart_json(&setup.world.chart.classes),
            "solid": chart_json(&setup.world.chart.solid),
            "bottom": setup.world.environment.bottom.as_ref().map(Bottom::in_words),
        });
        say_json(&format!("{found:#}\n"))?;
    }
    if args.strict {
        refuse_notices(notices.len())?;
    }
    if args.json {
        return Ok(());
    }
    say(&format!(
        "{}: good; {}, {} named, {} of {} s\n",
        source.shown,
        counted(setup.bodies.len() as u64, "body", "bodies"),
        counted(setup.pairs.len() as u64, "pair", "pairs"),
        counted(simulation.steps_total(), "step", "steps"),
        printable_number(setup.step_s)
    ))?;
    if let Some(read) = setup.world.chart.read_in_words() {
        say(&format!("chart: {read}\n"))?;
    }
    if let Some(left_out) = setup.world.chart.left_out_in_words() {
        say(&format!("left out of the chart: {left_out}\n"))?;
    }
    if let Some(solid) = setup.world.chart.solid_in_words() {
        say(&format!("solid, as the body \"{SHORE}\": {solid}\n"))?;
    }
    if let Some(bottom) = &setup.world.environment.bottom {
        say(&format!("{}\n", bottom.in_words()))?;
    }
    for approach in &setup.approaches {
        say(&format!("{}\n{}\n", approach.sentence(setup), approach.start_sentence(setup)))?;
    }
    for vessel in &setup.world.vessels {
        say(&estimates(&setup.bodies[vessel.body].name, &vessel.origin))?;
    }
    Ok(())
}

/// The objects of a chart that were read and those that were left out, by class of object, as JSON.
fn chart_json(classes: &[ChartClass]) -> Value {
    let class = |class: &ChartClass| {
        let left_out =
            class.left_out.iter().map(|(count, why)| json!({ "count": count, "why": why }));
        json!({ "class": class.class, "read": class.read, "left_out": left_out.collect::<Vec<_>>() })
    };
    classes.iter().map(class).collect()
}

/// Prints the JSON Schema of a kind of file.
///
/// # Errors
/// Fails if standard output cannot be written.
pub(crate) fn schema(of: SchemaOf) -> Result<(), Failure> {
    let schema = match of {
        SchemaOf::Scenario => fenderline_scenario::schema(),
        SchemaOf::Fenders => fenderline_scenario::fender_schema(),
        SchemaOf::Campaign => fenderline_campaign::campaign_schema(),
        SchemaOf::Vessels => fenderline_scenario::vessel_schema(),
        SchemaOf::Mapping => fenderline_measured::mapping_schema(),
    };
    say_json(&format!("{schema:#}\n"))
}
