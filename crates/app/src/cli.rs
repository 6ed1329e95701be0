//! The command line.

use core::str::FromStr;
use std::net::{IpAddr, SocketAddr};
use std::path::PathBuf;

use clap::builder::PossibleValue;
use clap::{Args, Parser, Subcommand, ValueEnum};
use fenderline_nautical::{ChartOrigin, GeoPoint};
use fenderline_scenario::{Override, ScenarioError};

use crate::output::Format;

/// Ship, fender, quay and tug contact: run, check and validate scenarios.
///
/// Exit codes: 0 done, 1 the case failed (or its verdict is a failure: see `run --allow-failures`), 2 bad input, 130 the
/// run was interrupted by Ctrl-C; its results up to then are written.
#[derive(Debug, Parser)]
#[command(name = "fenderline", version, propagate_version = true)]
pub(crate) struct Cli {
    #[command(subcommand)]
    pub(crate) command: Command,
}

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Run a scenario: print a summary; write tables, summary.json and report.html
    Run(RunArgs),
    /// Recompute published cases and compare them with the published numbers; exit code 1 if one is out of
    /// tolerance
    Validate(ValidateArgs),
    /// Standard manoeuvres of a vessel, with the measures of ITTC and IMO
    Manoeuvre(ManoeuvreArgs),
    /// List the built-in vessels, or print every number of one vessel with its source
    Vessels(VesselsArgs),
    /// Make a fender file from measured, computed or catalogue curves
    #[command(subcommand)]
    Fender(FenderCommand),
    /// Write a functional mock-up unit (FMU) of a scenario, for FMI masters such as FMPy and the Open Simulation
    /// Platform
    Fmu(FmuArgs),
    /// Print the columns of the result files with their units and meanings
    Columns(ColumnsArgs),
    /// Print the JSON Schema of scenario files, of fender files or of vessel files
    Schema(SchemaArgs),
    /// Parse and check a scenario without running it
    Check(CheckArgs),
    /// Run a scenario in real time, steered from browsers
    Serve(ServeArgs),
    /// Replay a session that `serve` recorded; exit code 1 if the result differs in any bit
    Replay(ReplayArgs),
}

#[derive(Debug, Subcommand)]
pub(crate) enum FenderCommand {
    /// Fit a fender to rows of deflection and reaction, show the fit and write a file for `fender_files`
    Fit(FitArgs),
}

#[derive(Debug, Args)]
pub(crate) struct FitArgs {
    /// csv file with the columns deflection_m or deflection_mm, reaction_n or reaction_kn, and optionally
    /// unloading (0 or 1), speed_mps, temperature_c
    #[arg(value_name = "CURVES.csv")]
    pub(crate) curves: PathBuf,
    /// Fender file to write
    #[arg(short, long, value_name = "FENDER.toml")]
    pub(crate) out: PathBuf,
    /// Extent in the direction of compression, uncompressed (m)
    #[arg(long, value_name = "METRES", allow_hyphen_values = true)]
    pub(crate) height: f64,
    /// Length along the berth (m)
    #[arg(long, value_name = "METRES", allow_hyphen_values = true)]
    pub(crate) length: Option<f64>,
    /// Rated deflection (m) [default: the end of the loading curve]
    #[arg(long, value_name = "METRES", allow_hyphen_values = true)]
    pub(crate) rated_deflection: Option<f64>,
    /// Energy returned on unloading, for a file without an unloading curve (% of the absorbed energy)
    #[arg(long, value_name = "PERCENT", allow_hyphen_values = true)]
    pub(crate) returned_energy: Option<f64>,
    /// Largest permitted difference between fit and rows (% of the rated reaction)
    #[arg(long, value_name = "PERCENT", default_value_t = 0.5, allow_hyphen_values = true)]
    pub(crate) tolerance: f64,
    /// Name of the family [default: the name of the file]
    #[arg(long, value_name = "NAME")]
    pub(crate) family: Option<String>,
    /// Designation of the size [default: the name of the file]
    #[arg(long, value_name = "NAME")]
    pub(crate) designation: Option<String>,
    /// Source of the curves [default: the name of their file]
    #[arg(long, value_name = "TEXT")]
    pub(crate) source: Option<String>,
    /// Standing of the source
    #[arg(long, value_enum, default_value_t = FitStanding::Derived)]
    pub(crate) standing: FitStanding,
    /// Page to write, with the fit and the rows
    #[arg(long, value_name = "PAGE.html")]
    pub(crate) plot: Option<PathBuf>,
}

/// Standing of the source of curves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum FitStanding {
    /// Measured, or read in a public source
    Found,
    /// Computed
    Derived,
    /// To be checked against the document
    Recalled,
}

#[derive(Debug, Args)]
pub(crate) struct ServeArgs {
    /// Scenario file, or a recorded session to continue
    #[arg(value_name = "SCENARIO.toml")]
    pub(crate) scenario: PathBuf,
    /// Port; 0 takes a free one
    #[arg(long, value_name = "N", default_value_t = 8090)]
    pub(crate) port: u16,
    /// Address to listen on
    #[arg(long, value_name = "ADDR", default_value = "127.0.0.1")]
    pub(crate) bind: IpAddr,
    /// Allow other machines to connect; needed with any --bind other than loopback
    #[arg(long)]
    pub(crate) allow_remote: bool,
    /// Host name by which other machines reach this one; repeatable
    #[arg(long, value_name = "NAME")]
    pub(crate) host: Vec<String>,
    /// Folder with a built page [default: the repository's, built if needed]
    #[arg(long, value_name = "DIR")]
    pub(crate) page: Option<PathBuf>,
    /// Folder with scenarios to open from the page [default: the folder of the scenario]
    #[arg(long, value_name = "DIR")]
    pub(crate) gallery: Option<PathBuf>,
    /// Folder that sessions are recorded to
    #[arg(long, value_name = "DIR", default_value = "out/sessions")]
    pub(crate) sessions: PathBuf,
    /// Start paused [default: start when the first page connects]
    #[arg(long)]
    pub(crate) paused: bool,
    /// Port that chart programs connect to for NMEA 0183 and AIS sentences; 0 takes a free one
    #[arg(long, value_name = "N")]
    pub(crate) nmea_tcp: Option<u16>,
    /// UDP address to send NMEA 0183 and AIS sentences to, such as 127.0.0.1:10110
    #[arg(long, value_name = "ADDR:PORT")]
    pub(crate) nmea_udp: Option<SocketAddr>,
    /// Latitude and longitude of the scenario's origin in these sentences (degrees)
    #[arg(long, value_name = "LAT,LON", default_value = "0,0", value_parser = origin, allow_hyphen_values = true)]
    pub(crate) origin: ChartOrigin,
    /// Override one key of the scenario, such as environment.wind.speed="9 m/s"; repeatable
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub(crate) set: Vec<String>,
}

#[derive(Debug, Args)]
pub(crate) struct ReplayArgs {
    /// Recorded session
    #[arg(value_name = "SESSION")]
    pub(crate) session: PathBuf,
}

#[derive(Debug, Args)]
pub(crate) struct RunArgs {
    /// Scenario file
    #[arg(value_name = "SCENARIO.toml")]
    pub(crate) scenario: PathBuf,
    /// Folder for the results [default: `out/` and the name of the scenario file]
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
    /// Format of the tables of bodies, contacts, fenders and energy
    #[arg(long, value_enum, default_value_t = Format::Csv)]
    pub(crate) format: Format,
    /// Exit code 0 even where a structure was struck, a fender failed or a line parted
    #[arg(long)]
    pub(crate) allow_failures: bool,
    #[command(flatten)]
    pub(crate) changes: Changes,
}

#[derive(Debug, Args)]
pub(crate) struct ValidateArgs {
    /// Folder for validation.html, validation.csv and validation.json [default: none]
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub(crate) struct ManoeuvreArgs {
    /// Name of a vessel that `fenderline vessels` lists
    #[arg(value_name = "VESSEL")]
    pub(crate) vessel: String,
    /// Manoeuvre
    #[arg(value_enum, value_name = "MANOEUVRE", default_value_t = ManoeuvreChoice::All)]
    pub(crate) manoeuvre: ManoeuvreChoice,
    /// File with your own vessels; repeatable
    #[arg(long, value_name = "VESSELS.toml")]
    pub(crate) file: Vec<PathBuf>,
    /// Rudder angle of turning circle and zig-zag in degrees [default: hard over; 10 and 20]
    #[arg(long, value_name = "DEG", value_parser = positive, allow_hyphen_values = true)]
    pub(crate) rudder: Option<f64>,
    /// Speed of approach in knots [default: the vessel's own]
    #[arg(long, value_name = "KN", value_parser = positive, allow_hyphen_values = true)]
    pub(crate) speed: Option<f64>,
    /// Water depth in metres or draughts, such as 31.2 or "1.5 T"; the measures are printed beside those in deep
    /// water [default: deep water only]
    #[arg(long, value_name = "DEPTH", allow_hyphen_values = true)]
    pub(crate) depth: Option<WaterDepth>,
    /// Side force for crabbing in kilonewtons [default: the drag in deep water at a Froude number of 0.01]
    #[arg(long, value_name = "KILONEWTONS", value_parser = positive, allow_hyphen_values = true)]
    pub(crate) push: Option<f64>,
    /// Print JSON instead of tables
    #[arg(long)]
    pub(crate) json: bool,
    /// Folder for the tracks, one csv file per run [default: none]
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub(crate) struct VesselsArgs {
    /// Name of a vessel [default: list all]
    #[arg(value_name = "VESSEL")]
    pub(crate) vessel: Option<String>,
    /// File with your own vessels; repeatable
    #[arg(long, value_name = "VESSELS.toml")]
    pub(crate) file: Vec<PathBuf>,
    /// Print JSON instead of text
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Debug, Args)]
pub(crate) struct FmuArgs {
    /// Scenario file
    #[arg(value_name = "SCENARIO.toml")]
    pub(crate) scenario: PathBuf,
    /// Kind of FMU
    #[arg(long, value_enum)]
    pub(crate) kind: FmuKind,
    /// Version of the standard
    #[arg(long, value_enum, default_value_t = FmiVersion::Two)]
    pub(crate) fmi: FmiVersion,
    /// File to write; its name without extension is the name of the model. A description for the Open Simulation
    /// Platform is written beside it
    #[arg(short, long, value_name = "X.fmu")]
    pub(crate) out: PathBuf,
    /// Shared library of the FMU [default: the one beside this program]
    #[arg(long, value_name = "PATH")]
    pub(crate) library: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) changes: Changes,
}

/// Kind of FMU.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum FmuKind {
    /// The contact engine: inputs are states of bodies, outputs are wrenches and fenders
    Engine,
    /// The whole scenario: inputs are controls and external forces, outputs are states and forces
    Simulation,
}

/// Version of FMI.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum FmiVersion {
    /// FMI 2.0
    #[value(name = "2")]
    Two,
    /// FMI 3.0
    #[value(name = "3")]
    Three,
}

#[derive(Debug, Args)]
pub(crate) struct ColumnsArgs {
    /// Print JSON instead of Markdown
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Debug, Args)]
pub(crate) struct SchemaArgs {
    /// Kind of file
    #[arg(value_enum, value_name = "FILES", default_value_t = SchemaOf::Scenario)]
    pub(crate) of: SchemaOf,
}

/// A kind of file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum SchemaOf {
    /// Scenarios
    Scenario,
    /// Fender data
    Fenders,
    /// Vessel data
    Vessels,
}

/// A manoeuvre, or all that the vessel can do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ManoeuvreChoice {
    /// This one.
    One(Manoeuvre),
    /// All.
    All,
}

impl ValueEnum for ManoeuvreChoice {
    fn value_variants<'a>() -> &'a [ManoeuvreChoice] {
        use ManoeuvreChoice::{All, One};
        &[
            One(Manoeuvre::Turning),
            One(Manoeuvre::Zigzag),
            One(Manoeuvre::CrashStop),
            One(Manoeuvre::Crabbing),
            One(Manoeuvre::BollardPull),
            All,
        ]
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        match self {
            ManoeuvreChoice::One(manoeuvre) => manoeuvre.to_possible_value(),
            ManoeuvreChoice::All => {
                Some(PossibleValue::new("all").help("Every manoeuvre that the vessel can do"))
            }
        }
    }
}

/// A manoeuvre.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Manoeuvre {
    /// Turning circle to either side
    Turning,
    /// Zig-zag 10°/10° and 20°/20°, first to either side
    Zigzag,
    /// From full ahead to standstill by the propeller astern
    CrashStop,
    /// Sideways under a steady force at midship, engine stopped
    Crabbing,
    /// Pull on a bollard, ahead and astern
    BollardPull,
}

/// A water depth on the command line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum WaterDepth {
    /// In metres.
    Metres(f64),
    /// In the vessel's draughts.
    Draughts(f64),
}

impl FromStr for WaterDepth {
    type Err = String;

    fn from_str(text: &str) -> Result<WaterDepth, String> {
        let text = text.trim();
        let (number, in_draughts) = match text.strip_suffix('T') {
            Some(number) => (number, true),
            None => (text.strip_suffix('m').unwrap_or(text), false),
        };
        let value: f64 = number.trim().parse().map_err(|_| {
            "a number of metres or of draughts, such as 31.2 or \"1.5 T\"".to_owned()
        })?;
        if !(value > 0.0 && value.is_finite()) {
            return Err("must be positive".to_owned());
        }
        Ok(if in_draughts { WaterDepth::Draughts(value) } else { WaterDepth::Metres(value) })
    }
}

/// Latitude and longitude in degrees.
fn origin(text: &str) -> Result<ChartOrigin, String> {
    let two = text.split_once(',').and_then(|(latitude, longitude)| {
        Some((latitude.trim().parse().ok()?, longitude.trim().parse().ok()?))
    });
    let (latitude_deg, longitude_deg) = two.ok_or("it must be LAT,LON in degrees")?;
    ChartOrigin::new(GeoPoint { latitude_deg, longitude_deg }).map_err(|e| e.to_string())
}

/// A number above zero and below a million; no rudder, ship or tug needs more.
fn positive(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(number) if number > 0.0 && number < 1e6 => Ok(number),
        Ok(_) => Err("it must be above 0 and below 1000000".to_owned()),
        Err(_) => Err("it is not a number".to_owned()),
    }
}

#[derive(Debug, Args)]
pub(crate) struct CheckArgs {
    /// Scenario file
    #[arg(value_name = "SCENARIO.toml")]
    pub(crate) scenario: PathBuf,
    #[command(flatten)]
    pub(crate) changes: Changes,
}

/// Keys of the scenario that the command line overrides.
#[derive(Debug, Default, Args)]
pub(crate) struct Changes {
    /// Time step, such as 0.5 or "0.5 s"; short for --set time.step=S
    #[arg(long, value_name = "S", allow_hyphen_values = true)]
    step: Option<String>,
    /// Length of the run, such as 60 or "1 min"; short for --set time.duration=S
    #[arg(long, value_name = "S", allow_hyphen_values = true)]
    duration: Option<String>,
    /// Contact method; short for --set contact.method=METHOD
    #[arg(long, value_name = "METHOD")]
    method: Option<String>,
    /// Override one key of the scenario, such as body.tug.velocity.surge="2 kn"; repeatable
    #[arg(long = "set", value_name = "KEY=VALUE")]
    set: Vec<String>,
}

impl Changes {
    /// All changes, the shorthands first.
    ///
    /// # Errors
    /// A text that is not `KEY=VALUE`.
    pub(crate) fn overrides(&self) -> Result<Vec<Override>, ScenarioError> {
        let shorthands = self
            .shorthands()
            .map(|(option, key, value)| Override::new(&format!("{option} {value}"), key, value));
        shorthands.chain(self.set.iter().map(|text| Override::parse(text))).collect()
    }

    /// Keys and values of all changes, in the same order.
    ///
    /// # Errors
    /// As [`Changes::overrides`].
    pub(crate) fn keys_and_values(&self) -> Result<Vec<[String; 2]>, ScenarioError> {
        self.overrides()?;
        let shorthands = self.shorthands().map(|(_, key, value)| [key.to_owned(), value.clone()]);
        // Texts without `=` were refused.
        let set = self.set.iter().filter_map(|text| text.split_once('='));
        Ok(shorthands.chain(set.map(|(key, value)| [key.to_owned(), value.to_owned()])).collect())
    }

    fn shorthands(&self) -> impl Iterator<Item = (&'static str, &'static str, &String)> {
        let shorthands = [
            ("--step", "time.step", &self.step),
            ("--duration", "time.duration", &self.duration),
            ("--method", "contact.method", &self.method),
        ];
        shorthands
            .into_iter()
            .filter_map(|(option, key, value)| value.as_ref().map(|value| (option, key, value)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory as _;

    #[test]
    fn the_command_line_is_well_formed() {
        Cli::command().debug_assert();
    }
}
