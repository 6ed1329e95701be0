//! The command line.

use core::str::FromStr;
use std::net::{IpAddr, SocketAddr};
use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};
use fenderline_nautical::{ChartOrigin, GeoPoint};
use fenderline_scenario::{Override, ScenarioError};

use crate::output::Format;

/// Ship, fender, quay and tug contact: run, check and validate scenarios.
///
/// Exit codes: 0 done, 1 the case failed, 2 bad input, 130 a run that was interrupted by Ctrl-C, with its results so
/// far.
#[derive(Debug, Parser)]
#[command(name = "fenderline", version, propagate_version = true)]
pub(crate) struct Cli {
    #[command(subcommand)]
    pub(crate) command: Command,
}

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Run a scenario: print a summary, write tables, summary.json and report.html
    Run(RunArgs),
    /// Reproduce published cases: a table of ours beside theirs; exit code 1 where one is out of
    /// tolerance
    Validate(ValidateArgs),
    /// Standard manoeuvres of a vessel, with the measures of ITTC and IMO
    Manoeuvre(ManoeuvreArgs),
    /// The vessels of the library; of one of them every number with its source, and what is estimated
    Vessels(VesselsArgs),
    /// Fender data: make a fender file of measured, calculated or printed curves
    #[command(subcommand)]
    Fender(FenderCommand),
    /// Write a functional mock-up unit (FMU) of a scenario, for masters of FMI: FMPy, the Open Simulation
    /// Platform and others
    Fmu(FmuArgs),
    /// Print the columns of the result files with their units and meanings
    Columns(ColumnsArgs),
    /// Print the JSON Schema of scenario files, of fender files or of vessel files
    Schema(SchemaArgs),
    /// Parse and check a scenario without running it
    Check(CheckArgs),
    /// Run a scenario in real time and let people steer it in their browsers
    Serve(ServeArgs),
    /// Play a session that `serve` recorded again: exit code 1 where it does not come to the same bits
    Replay(ReplayArgs),
}

#[derive(Debug, Subcommand)]
pub(crate) enum FenderCommand {
    /// Fit a fender to rows of deflection and reaction, show the fit and write a file for `fender_files`
    Fit(FitArgs),
}

#[derive(Debug, Args)]
pub(crate) struct FitArgs {
    /// Rows under a header: deflection_m or deflection_mm, reaction_n or reaction_kn, and where wanted
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
    /// Rated deflection (m) [default: where the loading curve ends]
    #[arg(long, value_name = "METRES", allow_hyphen_values = true)]
    pub(crate) rated_deflection: Option<f64>,
    /// Energy that comes back, where the file has no unloading curve (% of that taken)
    #[arg(long, value_name = "PERCENT", allow_hyphen_values = true)]
    pub(crate) returned_energy: Option<f64>,
    /// Largest difference of the fit from the rows (% of the rated reaction)
    #[arg(long, value_name = "PERCENT", default_value_t = 0.5, allow_hyphen_values = true)]
    pub(crate) tolerance: f64,
    /// Name of the family [default: that of the file]
    #[arg(long, value_name = "NAME")]
    pub(crate) family: Option<String>,
    /// Designation of the size [default: the name of the file]
    #[arg(long, value_name = "NAME")]
    pub(crate) designation: Option<String>,
    /// Where the curves come from [default: the name of their file]
    #[arg(long, value_name = "TEXT")]
    pub(crate) source: Option<String>,
    /// How well that is known
    #[arg(long, value_enum, default_value_t = FitStanding::Derived)]
    pub(crate) standing: FitStanding,
    /// Page with the fit and the rows to write
    #[arg(long, value_name = "PAGE.html")]
    pub(crate) plot: Option<PathBuf>,
}

/// How well the source of curves is known.
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
    /// Scenario file, or a recorded session to go on with
    #[arg(value_name = "SCENARIO.toml")]
    pub(crate) scenario: PathBuf,
    /// Port; 0 takes a free one
    #[arg(long, value_name = "N", default_value_t = 8090)]
    pub(crate) port: u16,
    /// Address to listen on
    #[arg(long, value_name = "ADDR", default_value = "127.0.0.1")]
    pub(crate) bind: IpAddr,
    /// Let other machines in; needed with any --bind but loopback
    #[arg(long)]
    pub(crate) allow_remote: bool,
    /// A name that other machines know this one by; repeatable
    #[arg(long, value_name = "NAME")]
    pub(crate) host: Vec<String>,
    /// Folder with a page that was built [default: the repository's, built where need be]
    #[arg(long, value_name = "DIR")]
    pub(crate) page: Option<PathBuf>,
    /// Folder with scenarios to open from the page [default: that of the scenario]
    #[arg(long, value_name = "DIR")]
    pub(crate) gallery: Option<PathBuf>,
    /// Folder that sessions are recorded to
    #[arg(long, value_name = "DIR", default_value = "out/sessions")]
    pub(crate) sessions: PathBuf,
    /// Begin paused; else it begins when the first page comes
    #[arg(long)]
    pub(crate) paused: bool,
    /// Port that chart programs connect to for NMEA 0183 and AIS sentences; 0 takes a free one
    #[arg(long, value_name = "N")]
    pub(crate) nmea_tcp: Option<u16>,
    /// Where NMEA 0183 and AIS sentences are sent to by UDP, such as 127.0.0.1:10110
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
    /// Folder for the results; without it `out/`, then the name of the scenario file
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
    /// Format of the tables of bodies, contacts, fenders and energy
    #[arg(long, value_enum, default_value_t = Format::Csv)]
    pub(crate) format: Format,
    #[command(flatten)]
    pub(crate) changes: Changes,
}

#[derive(Debug, Args)]
pub(crate) struct ValidateArgs {
    /// Folder for validation.html, validation.csv and validation.json [default: none is written]
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub(crate) struct ManoeuvreArgs {
    /// Vessel, one of those that `fenderline vessels` lists
    #[arg(value_name = "VESSEL")]
    pub(crate) vessel: String,
    /// Manoeuvre
    #[arg(value_enum, value_name = "MANOEUVRE", default_value_t = ManoeuvreName::All)]
    pub(crate) manoeuvre: ManoeuvreName,
    /// File with vessels of your own; repeatable
    #[arg(long, value_name = "VESSELS.toml")]
    pub(crate) file: Vec<PathBuf>,
    /// Rudder angle of turning circle and zig-zag in degrees [default: hard over; 10 and 20]
    #[arg(long, value_name = "DEG", value_parser = positive, allow_hyphen_values = true)]
    pub(crate) rudder: Option<f64>,
    /// Speed of approach in knots [default: the vessel's own]
    #[arg(long, value_name = "KN", value_parser = positive, allow_hyphen_values = true)]
    pub(crate) speed: Option<f64>,
    /// Depth of water in metres or in draughts, such as 31.2 or "1.5 T": the measures there, beside those in deep
    /// water [default: deep water alone]
    #[arg(long, value_name = "DEPTH", allow_hyphen_values = true)]
    pub(crate) depth: Option<WaterDepth>,
    /// Side force of the crabbing in kilonewtons [default: what drag balances in deep water at a Froude number of 0.01]
    #[arg(long, value_name = "KILONEWTONS", value_parser = positive, allow_hyphen_values = true)]
    pub(crate) push: Option<f64>,
    /// Print JSON instead of tables
    #[arg(long)]
    pub(crate) json: bool,
    /// Folder for the tracks, one csv a run [default: none is written]
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub(crate) struct VesselsArgs {
    /// Vessel; without it all are listed
    #[arg(value_name = "VESSEL")]
    pub(crate) vessel: Option<String>,
    /// File with vessels of your own; repeatable
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
    /// What the FMU is
    #[arg(long, value_enum)]
    pub(crate) kind: FmuKind,
    /// Version of the standard
    #[arg(long, value_enum, default_value_t = FmiVersion::Two)]
    pub(crate) fmi: FmiVersion,
    /// File to write; its name without ending is the model's. A description for the Open Simulation
    /// Platform is written beside it
    #[arg(short, long, value_name = "X.fmu")]
    pub(crate) out: PathBuf,
    /// Shared library of the FMU [default: that beside this program, where cargo puts it]
    #[arg(long, value_name = "PATH")]
    pub(crate) library: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) changes: Changes,
}

/// What an FMU is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum FmuKind {
    /// The contact engine: states of the bodies in, wrenches and fenders out
    Engine,
    /// The whole scenario: controls and further forces in, states and forces out
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
    /// Of which files
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
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum ManoeuvreName {
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
    /// Every manoeuvre that the vessel can do
    All,
}

/// A depth of water as it is ordered.
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

/// A number above zero and below a million: no rudder, ship or tug has more.
fn positive(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(number) if number > 0.0 && number < 1e6 => Ok(number),
        Ok(_) => Err("it must be above 0 and below 1000000".to_owned()),
        Err(_) => Err("it is no number".to_owned()),
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
    /// A text that is no `KEY=VALUE`.
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
        // What has no `=` was refused.
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
