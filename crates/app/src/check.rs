//! `fenderline check` and `fenderline schema`.

use fenderline_report::plot::counted;
use fenderline_scenario::{LoadError, Notice, Place, ScenarioError, printable_number};
use fenderline_sim::Simulation;
use serde_json::{Value, json};

use crate::cli::{CheckArgs, SchemaOf};
use crate::failure::Failure;
use crate::load::Source;
use crate::played::error;
use crate::terminal::{notice, say, say_json};
use crate::vessels::estimates;

/// Checks a scenario as `run` does, and writes nothing. With `--json` a mistake of the scenario is printed as JSON, and as
/// text to standard error.
///
/// # Errors
/// Bad input.
pub(crate) fn check(args: &CheckArgs) -> Result<(), Failure> {
    let overrides = args.changes.overrides().map_err(Failure::input)?;
    let refused = |error: &LoadError| match args.json {
        true => say_json(&format!("{:#}\n", refused_json(error))),
        false => Ok(()),
    };
    let loaded = Source::read(&args.scenario).and_then(|source| {
        let scenario = source.scenario(&overrides)?;
        Ok((source, scenario))
    });
    let (source, scenario) = match loaded {
        Ok(loaded) => loaded,
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
    for approach in &setup.approaches {
        say(&format!("{}\n{}\n", approach.sentence(setup), approach.start_sentence(setup)))?;
    }
    for vessel in &setup.world.vessels {
        say(&estimates(&setup.bodies[vessel.body].name, &vessel.origin))?;
    }
    Ok(())
}

/// What `--strict` makes of notices.
///
/// # Errors
/// There are any.
pub(crate) fn refuse_notices(count: usize) -> Result<(), Failure> {
    match count {
        0 => Ok(()),
        _ => {
            let count = counted(count as u64, "notice", "notices");
            Err(Failure::input(format_args!("error: {count}, which --strict does not permit")))
        }
    }
}

fn refused_json(error: &LoadError) -> Value {
    let error = match error {
        LoadError::Unreadable(why) => json!({ "message": format!("cannot read {why}") }),
        LoadError::Refused(error) => error_json(error),
    };
    json!({ "good": false, "error": error })
}

fn error_json(error: &ScenarioError) -> Value {
    let mut json = json!({ "message": error.message(), "key": error.key(), "help": error.help() });
    add_place(&mut json, error.place());
    json
}

fn notice_json(notice: &Notice) -> Value {
    let mut json = json!({ "message": notice.message, "key": notice.key });
    add_place(&mut json, &notice.place);
    json
}

/// Adds file, line and column, or the option of the command line.
fn add_place(json: &mut Value, place: &Place) {
    match place {
        Place::File { name, line, column } => {
            json["file"] = json!(name);
            json["line"] = json!(line);
            json["column"] = json!(column);
        }
        Place::WholeFile { name } => json["file"] = json!(name),
        Place::Option { text } => json["option"] = json!(text),
    }
}

/// Prints the JSON Schema of a kind of file.
///
/// # Errors
/// Standard output that cannot be written.
pub(crate) fn schema(of: SchemaOf) -> Result<(), Failure> {
    let schema = match of {
        SchemaOf::Scenario => fenderline_scenario::schema(),
        SchemaOf::Fenders => fenderline_scenario::fender_schema(),
        SchemaOf::Campaign => fenderline_scenario::campaign_schema(),
        SchemaOf::Vessels => fenderline_scenario::vessel_schema(),
    };
    say_json(&format!("{schema:#}\n"))
}
