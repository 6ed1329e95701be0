//! The command line.

use core::num::NonZero;
use core::str::FromStr;
use std::net::{IpAddr, SocketAddr};
use std::path::PathBuf;

use clap::builder::{PathBufValueParser, PossibleValue, TypedValueParser};
use clap::{Args, Parser, Subcommand, ValueEnum};
use fenderline_campaign::MOST_THREADS;
use fenderline_campaign::statistics::Confidence;
use fenderline_campaign::statistics::fit::Law;
use fenderline_campaign::store::Shard;
use fenderline_fmu::Platform;
use fenderline_nautical::{ChartOrigin, GeoPoint};
use fenderline_scenario::{
    LengthOrShare, Override, ScenarioError, force_n, length_m, length_or_share, percent,
};

use crate::output::Format;
use crate::version;

/// Ship, fender, quay and tug contact: run, check and validate scenarios.
///
/// Exit codes: 0 done, 1 the case failed (or its verdict is a failure: see `run --allow-failures`), 2 bad input, 130
/// the run was interrupted by Ctrl-C; its results up to then are written.
#[derive(Debug, Parser)]
#[command(name = "fenderline", version, long_version = version::long(), propagate_version = true)]
pub(crate) struct Cli {
    /// Print errors only: no summary, no notices, no progress; files, JSON and lists stay the same
    #[arg(short, long, global = true)]
    pub(crate) quiet: bool,
    #[command(subcommand)]
    pub(crate) command: Command,
}

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Run a scenario, or repeat a recorded session: print a summary; write tables, summary.json and report.html
    Run(RunArgs),
    /// Print an example scenario, or write it to a new file
    Init(InitArgs),
    /// Run a scenario, or repeat a recorded session, and write only documents: the report as a page or PDF, an Excel
    /// workbook
    Report(ReportArgs),
    /// Find the largest value of a key, such as the speed of a passing ship, with which a run stays within all limits,
    /// by bisection
    Limit(LimitArgs),
    /// Make many runs of a scenario, with every combination of some values or with values drawn from distributions: a
    /// table with a row a case, and a figure or report
    Campaign(CampaignArgs),
    /// Statistics of a column of a table, such as measured berthing speeds: exceedance, fits and design values with
    /// their bands
    Statistics(StatisticsArgs),
    /// Measured berthings from logs of docking systems, tracks and AIS: speed, angle and first fender at the touch with
    /// their uncertainties, energies by formula and by a run from the measured state
    Berthings(BerthingsArgs),
    /// Recompute published cases and compare them with the published numbers; exit code 1 if one is out of
    /// tolerance
    Validate(ValidateArgs),
    /// Run standard manoeuvres of a vessel, and print the quantities that ITTC and IMO define
    Manoeuvre(ManoeuvreArgs),
    /// List the built-in vessels, or print every number of one vessel with its source
    Vessels(VesselsArgs),
    /// List the built-in fenders, or print every number of one family or size with its source
    Fenders(FendersArgs),
    /// Make a fender file from measured, computed or catalogue curves
    #[command(subcommand)]
    Fender(FenderCommand),
    /// Write a functional mock-up unit (FMU) of a scenario, for FMI masters such as FMPy and the Open Simulation
    /// Platform
    Fmu(FmuArgs),
    /// Print the columns of the result files with their units and meanings
    Columns(ColumnsArgs),
    /// Print the JSON Schema of scenario, fender, vessel, campaign or mapping files
    Schema(SchemaArgs),
    /// Parse and check a scenario without running it
    Check(CheckArgs),
    /// Run a scenario in real time, steered from browsers
    Serve(ServeArgs),
    /// Replay a session that `serve` recorded, or a dump of an engine's steps; exit code 1 if the result differs in any
    /// bit
    Replay(ReplayArgs),
    /// Print the completions for a shell, such as `fenderline completions bash`
    Completions(CompletionsArgs),
    /// Print the manual page of the program or of a command, or write all of them into a folder
    Man(ManArgs),
}

/// Example scenarios to begin with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Example {
    Berthing,
    Dolphins,
    ShipToShip,
    Tugs,
    Moored,
    Flare,
}

impl Example {
    /// All example scenarios, in the order of the printed list.
    pub(crate) const ALL: [Example; 6] = [
        Example::Berthing,
        Example::Dolphins,
        Example::ShipToShip,
        Example::Tugs,
        Example::Moored,
        Example::Flare,
    ];
}

/// What `init` writes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Start {
    Example(Example),
    /// A scenario at a berth of the user's chart.
    Harbour,
}

impl Start {
    /// Name and description of the scenario at a berth of the user's chart.
    pub(crate) const HARBOUR: [&str; 2] =
        ["harbour", "a berth of your chart, with --chart and --berth"];
}

impl ValueEnum for Start {
    fn value_variants<'a>() -> &'a [Start] {
        const ALL: [Start; Example::ALL.len() + 1] = {
            let mut all = [Start::Harbour; Example::ALL.len() + 1];
            let mut index = 0;
            while index < Example::ALL.len() {
                all[index] = Start::Example(Example::ALL[index]);
                index += 1;
            }
            all
        };
        &ALL
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        match self {
            Start::Example(example) => {
                let [name, what, _] = example.parts();
                Some(PossibleValue::new(name).help(what))
            }
            Start::Harbour => Some(PossibleValue::new(Start::HARBOUR[0]).help(Start::HARBOUR[1])),
        }
    }
}

#[derive(Debug, Args)]
pub(crate) struct InitArgs {
    /// Example, or `harbour`
    #[arg(value_enum, value_name = "EXAMPLE", default_value_t = Start::Example(Example::Berthing))]
    pub(crate) start: Start,
    /// Folder of a chart that `python -m fenderline.charts` has converted
    #[arg(long, value_name = "DIR", required_if_eq("start", "harbour"))]
    pub(crate) chart: Option<PathBuf>,
    /// Name of a quay line of the chart, or latitude and longitude of both ends of the berth in degrees
    #[arg(
        long,
        value_name = "NAME|LAT,LON,LAT,LON",
        allow_hyphen_values = true,
        required_if_eq("start", "harbour")
    )]
    pub(crate) berth: Option<String>,
    /// Side of the water, seen along the berth, where the chart does not tell
    #[arg(long, value_name = "SIDE", value_parser = ["left", "right"], requires = "berth")]
    pub(crate) water: Option<String>,
    /// Ship of the vessel library [default: the longest that fits the berth]
    #[arg(long, value_name = "VESSEL", requires = "berth")]
    pub(crate) vessel: Option<String>,
    /// New file to write; an existing file is not replaced [default: print the example]
    #[arg(short, long, value_name = "SCENARIO.toml", value_parser = output_file())]
    pub(crate) out: Option<PathBuf>,
    /// List the examples
    #[arg(long, conflicts_with = "out")]
    pub(crate) list: bool,
    /// Print the list as JSON
    #[arg(long, requires = "list")]
    pub(crate) json: bool,
}

#[derive(Debug, Args)]
pub(crate) struct CompletionsArgs {
    /// Shell
    #[arg(value_enum, value_name = "SHELL")]
    pub(crate) shell: clap_complete::Shell,
}

#[derive(Debug, Args)]
pub(crate) struct ManArgs {
    /// Command, such as `run` or `fender fit` [default: the program]
    #[arg(value_name = "COMMAND")]
    pub(crate) command: Vec<String>,
    /// Folder to write all pages into, such as ~/.local/share/man/man1
    #[arg(long, value_name = "DIR", conflicts_with = "command", value_parser = output_folder())]
    pub(crate) out: Option<PathBuf>,
}

/// Parses the path of a file to write; refuses `-`, which would stand for standard output.
fn output_file() -> impl TypedValueParser<Value = PathBuf> {
    let file = |path: PathBuf| match path.as_os_str() == "-" {
        true => Err("this file cannot be written to standard output; write ./- for a file named -"),
        false => Ok(path),
    };
    PathBufValueParser::new().try_map(file)
}

/// Parses the path of a folder for several files; refuses `-`, which would stand for standard output.
fn output_folder() -> impl TypedValueParser<Value = PathBuf> {
    let folder = |path: PathBuf| match path.as_os_str() == "-" {
        true => Err(
            "several files are written, which needs a folder and not standard output; write ./- \
             for a folder named -",
        ),
        false => Ok(path),
    };
    PathBufValueParser::new().try_map(folder)
}

/// Parses the path of a file to read; refuses `-`, which would stand for standard input.
fn input_file() -> impl TypedValueParser<Value = PathBuf> {
    let file = |path: PathBuf| match path.as_os_str() == "-" {
        true => Err("this command does not read standard input; write ./- for a file named -"),
        false => Ok(path),
    };
    PathBufValueParser::new().try_map(file)
}

#[derive(Debug, Subcommand)]
pub(crate) enum FenderCommand {
    /// Fit a fender to rows of deflection and reaction, show the fit and write a file for `fender_files`
    Fit(FitArgs),
}

#[derive(Debug, Args)]
pub(crate) struct FitArgs {
    /// csv file with the columns deflection_m, deflection_mm or deflection_percent (of the height), reaction_n,
    /// reaction_kn or reaction_percent (of --rated-reaction), and optionally unloading (0 or 1), speed_mps,
    /// temperature_c
    #[arg(value_name = "CURVES.csv", value_parser = input_file())]
    pub(crate) curves: PathBuf,
    /// Fender file to write
    #[arg(short, long, value_name = "FENDER.toml", value_parser = output_file())]
    pub(crate) out: PathBuf,
    /// Height of the uncompressed fender in the direction of compression, such as "1.2 m"; a plain number is in metres
    #[arg(long, value_name = "LENGTH", value_parser = length_m, allow_hyphen_values = true)]
    pub(crate) height: f64,
    /// Length of the fender along the berth, such as "2 m"
    #[arg(long, value_name = "LENGTH", value_parser = length_m, allow_hyphen_values = true)]
    pub(crate) length: Option<f64>,
    /// Rated deflection of the fender, such as "864 mm" or "72 %" of its height [default: the end of the loading curve]
    #[arg(long, value_name = "LENGTH", value_parser = length_or_share, allow_hyphen_values = true)]
    pub(crate) rated_deflection: Option<LengthOrShare>,
    /// Rated reaction in the catalogue, such as "585 kN" [default: the reaction of the curve at the rated deflection]
    #[arg(long, value_name = "FORCE", value_parser = force_n, allow_hyphen_values = true)]
    pub(crate) rated_reaction: Option<f64>,
    /// Share of the energy that the fender returns on unloading, such as "60 %", for a file without an unloading curve;
    /// a plain number is in per cent
    #[arg(long, value_name = "PERCENT", value_parser = percent, allow_hyphen_values = true)]
    pub(crate) returned_energy: Option<f64>,
    /// Largest permitted difference between fit and rows, in per cent of the rated reaction
    #[arg(long, value_name = "PERCENT", default_value = "0.5 %", value_parser = percent, allow_hyphen_values = true)]
    pub(crate) tolerance: f64,
    /// Name of the fender's family [default: the name of the file]
    #[arg(long, value_name = "NAME")]
    pub(crate) family: Option<String>,
    /// Designation of the fender's size [default: the name of the file]
    #[arg(long, value_name = "NAME")]
    pub(crate) designation: Option<String>,
    /// Source of the curves [default: the name of their file]
    #[arg(long, value_name = "TEXT")]
    pub(crate) source: Option<String>,
    /// Standing of the source
    #[arg(long, value_enum, default_value_t = FitStanding::Derived)]
    pub(crate) standing: FitStanding,
    /// HTML page to write, which shows the fit and the rows of the csv file
    #[arg(long, value_name = "PAGE.html", value_parser = output_file())]
    pub(crate) plot: Option<PathBuf>,
}

/// How far the source of a fender's curves has been checked.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum FitStanding {
    /// The curves were measured, or read in a public source
    Found,
    /// Computed
    Derived,
    /// The curves were not yet checked against the document that they come from
    Recalled,
}

#[derive(Debug, Args)]
pub(crate) struct ServeArgs {
    /// Scenario file, or a recorded session to continue
    #[arg(value_name = "SCENARIO.toml", value_parser = input_file())]
    pub(crate) scenario: PathBuf,
    /// Port of the server; 0 takes a free port
    #[arg(long, value_name = "N", default_value_t = 8090)]
    pub(crate) port: u16,
    /// Address to listen on
    #[arg(long, value_name = "ADDR", default_value = "127.0.0.1")]
    pub(crate) bind: IpAddr,
    /// Allow other machines to connect; needed with any --bind other than loopback
    #[arg(long)]
    pub(crate) allow_remote: bool,
    /// Host name by which other machines reach this machine; repeatable
    #[arg(long, value_name = "NAME")]
    pub(crate) host: Vec<String>,
    /// Folder with the built web pages [default: the pages that are built into the program]
    #[arg(long, value_name = "DIR")]
    pub(crate) page: Option<PathBuf>,
    /// Folder with scenarios to open from the page [default: the folder of the scenario]
    #[arg(long, value_name = "DIR")]
    pub(crate) gallery: Option<PathBuf>,
    /// Folder that sessions are recorded to
    #[arg(long, value_name = "DIR", default_value = "out/sessions", value_parser = output_folder())]
    pub(crate) sessions: PathBuf,
    /// Start paused [default: start when the first page connects]
    #[arg(long)]
    pub(crate) paused: bool,
    /// Port that chart programs connect to for NMEA 0183 and AIS sentences; 0 takes a free port
    #[arg(long, value_name = "N")]
    pub(crate) nmea_tcp: Option<u16>,
    /// UDP address to send NMEA 0183 and AIS sentences to, such as 127.0.0.1:10110
    #[arg(long, value_name = "ADDR:PORT")]
    pub(crate) nmea_udp: Option<SocketAddr>,
    /// Port, or address and port, on which a controller steers the pilot's ship by NMEA sentences: HTC, HSC, APB, ROR, PRC
    /// and TRC; 0 takes a free port. A port alone is open to this machine only
    #[arg(long, value_name = "[ADDR:]PORT", value_parser = local_port)]
    pub(crate) nmea_steer: Option<SocketAddr>,
    /// Latitude and longitude of the scenario's origin in the NMEA and AIS sentences (degrees) [default: the origin of
    /// the scenario's chart, or 0,0 without a chart]
    #[arg(long, value_name = "LAT,LON", value_parser = origin, allow_hyphen_values = true)]
    pub(crate) origin: Option<ChartOrigin>,
    /// Override one key of the scenario, such as environment.wind.speed="9 m/s"; repeatable
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub(crate) set: Vec<String>,
    #[command(flatten)]
    pub(crate) ghost: GhostArgs,
}

/// A measured ship beside the simulated ones.
#[derive(Debug, Args)]
pub(crate) struct GhostArgs {
    /// Log of a measured ship, whose dashed outline the plan shows beside the simulated ships: a docking log, a track, NMEA
    /// 0183 or AIS sentences, as for `berthings`. She takes part in nothing physical
    #[arg(long, value_name = "LOG", value_parser = input_file())]
    pub(crate) ghost: Option<PathBuf>,
    /// What the columns of the log mean, as for `berthings` [default: all that can be guessed is guessed]
    #[arg(long, value_name = "MAPPING.toml", requires = "ghost", value_parser = input_file())]
    pub(crate) ghost_mapping: Option<PathBuf>,
    /// Number of the berthing in the log, in the order of time
    #[arg(long, value_name = "N", requires = "ghost", default_value_t = 1)]
    pub(crate) ghost_berthing: usize,
    /// Time of the session at which the measured ship first touches a fender (s) [default: the first row of her way is at
    /// the start of the session]
    #[arg(long, value_name = "S", requires = "ghost", allow_hyphen_values = true)]
    pub(crate) ghost_touch: Option<f64>,
}

#[derive(Debug, Args)]
pub(crate) struct ReplayArgs {
    /// Recorded session, or a dump that `fl_engine_dump()` of the C interface wrote
    #[arg(value_name = "SESSION", value_parser = input_file())]
    pub(crate) session: PathBuf,
}

#[derive(Debug, Args)]
pub(crate) struct RunArgs {
    /// Scenario file, or a session that `serve` recorded; `-` reads a scenario from standard input
    #[arg(value_name = "SCENARIO.toml")]
    pub(crate) scenario: PathBuf,
    /// Branch of a recorded session [default: the branch that was steered last]
    #[arg(long, value_name = "N")]
    pub(crate) branch: Option<usize>,
    /// Folder for the results [default: `out/` and the name of the scenario file]
    #[arg(long, value_name = "DIR", value_parser = output_folder())]
    pub(crate) out: Option<PathBuf>,
    /// Format of the tables of bodies, contacts, fenders and energy
    #[arg(long, value_enum, default_value_t = Format::Csv)]
    pub(crate) format: Format,
    /// Exit code 0 even where a structure was struck, a fender failed, a line parted or the results are not valid
    #[arg(long)]
    pub(crate) allow_failures: bool,
    /// Refuse a scenario with notices, such as one of a ship that starts inside a fender: exit code 2, and no run. Exit
    /// code 1 where the run left the range of its data, such as a record of wind that ends before the run
    #[arg(long)]
    pub(crate) strict: bool,
    /// Print summary.json instead of the summary in words
    #[arg(long)]
    pub(crate) json: bool,
    /// Time that one row of a table stands for, such as 1 or "1 s"; 0 gives a row for every step; short for --set
    /// output.interval=S
    #[arg(long, value_name = "S", allow_hyphen_values = true)]
    pub(crate) interval: Option<String>,
    /// Tables to write, such as fenders,lines; short for --set output.tables=[…]
    #[arg(long, value_name = "NAMES")]
    pub(crate) tables: Option<String>,
    #[command(flatten)]
    pub(crate) documents: Documents,
    #[command(flatten)]
    pub(crate) changes: Changes,
    #[command(flatten)]
    pub(crate) title_page: TitlePage,
}

#[derive(Debug, Args)]
pub(crate) struct ReportArgs {
    /// Scenario file, or a session that `serve` recorded; `-` reads a scenario from standard input
    #[arg(value_name = "SCENARIO.toml")]
    pub(crate) scenario: PathBuf,
    /// Branch of a recorded session [default: the branch that was steered last]
    #[arg(long, value_name = "N")]
    pub(crate) branch: Option<usize>,
    /// Report page to write [default, if no other document is asked for: the scenario's name with `.html`]
    #[arg(long, value_name = "FILE.html", value_parser = output_file())]
    pub(crate) html: Option<PathBuf>,
    /// Time that one row of a sheet stands for, such as 1 or "1 s"; 0 gives a row for every step; short for --set
    /// output.interval=S
    #[arg(long, value_name = "S", allow_hyphen_values = true)]
    pub(crate) interval: Option<String>,
    /// Exit code 0 even where a structure was struck, a fender failed or a line parted
    #[arg(long)]
    pub(crate) allow_failures: bool,
    #[command(flatten)]
    pub(crate) documents: Documents,
    #[command(flatten)]
    pub(crate) changes: Changes,
    #[command(flatten)]
    pub(crate) title_page: TitlePage,
}

impl RunArgs {
    /// The changes of the scenario that the command line asks for: first the short options for `output`, then the
    /// others.
    ///
    /// # Errors
    /// Fails if a text is not of the form `KEY=VALUE`, or is empty.
    pub(crate) fn overrides(&self) -> Result<Vec<Override>, ScenarioError> {
        let mut all = Vec::new();
        if let Some(interval) = &self.interval {
            all.push(Override::new(
                &format!("--interval {interval}"),
                "output.interval",
                interval,
            )?);
        }
        if let Some(tables) = &self.tables {
            let names = tables.split(',').map(|name| format!("{:?}", name.trim()));
            let list = format!("[{}]", names.collect::<Vec<_>>().join(", "));
            all.push(Override::new(&format!("--tables {tables}"), "output.tables", &list)?);
        }
        all.extend(self.changes.overrides()?);
        all.extend(self.title_page.overrides()?);
        Ok(all)
    }
}

impl ReportArgs {
    /// All changes of the scenario that the command line asks for.
    ///
    /// # Errors
    /// Fails if a text is not of the form `KEY=VALUE`, or is empty.
    pub(crate) fn overrides(&self) -> Result<Vec<Override>, ScenarioError> {
        let mut all = Vec::new();
        if let Some(interval) = &self.interval {
            let option = format!("--interval {interval}");
            all.push(Override::new(&option, "output.interval", interval)?);
        }
        all.extend(self.changes.overrides()?);
        all.extend(self.title_page.overrides()?);
        Ok(all)
    }
}

#[derive(Debug, Args)]
#[command(args_conflicts_with_subcommands = true, subcommand_negates_reqs = true)]
pub(crate) struct CampaignArgs {
    #[command(subcommand)]
    pub(crate) part: Option<CampaignPart>,
    #[command(flatten)]
    pub(crate) run: CampaignRunArgs,
}

#[derive(Debug, Subcommand)]
pub(crate) enum CampaignPart {
    /// Put the shares of a campaign together; the table equals that of an undivided campaign, byte for byte
    Merge(CampaignMergeArgs),
    /// Run one case of a campaign by itself, as `fenderline run` does, with its report
    Replay(CampaignReplayArgs),
    /// Write the report of a campaign's table again, for instance of a table that Python made
    Report(CampaignReportArgs),
}

#[derive(Debug, Args)]
pub(crate) struct CampaignRunArgs {
    /// Campaign file: a scenario and what differs from run to run
    #[arg(value_name = "CAMPAIGN.toml", value_parser = input_file(), required = true)]
    pub(crate) campaign: Option<PathBuf>,
    /// Folder for the table and the figure or report [default: `out/` and the name of the campaign file]
    #[arg(long, value_name = "DIR", value_parser = output_folder())]
    pub(crate) out: Option<PathBuf>,
    /// Go on with the campaign that the folder holds
    #[arg(long, conflicts_with = "replace")]
    pub(crate) resume: bool,
    /// Remove the campaign that the folder holds, and begin anew
    #[arg(long)]
    pub(crate) replace: bool,
    /// Make one share of the runs, such as 2/8 for the second of eight shares; `campaign merge` puts the shares
    /// together
    #[arg(long, value_name = "I/N", value_parser = shard)]
    pub(crate) shard: Option<Shard>,
    /// Write the report as PDF too; needs a browser (Chromium, Chrome or Edge)
    #[arg(long, value_name = "FILE.pdf", value_parser = output_file())]
    pub(crate) pdf: Option<PathBuf>,
    /// Write the table as an Excel workbook too
    #[arg(long, value_name = "FILE.xlsx", value_parser = output_file())]
    pub(crate) xlsx: Option<PathBuf>,
    /// Variable on the horizontal axis of the figure [default: the first variable whose values are numbers]
    #[arg(long, value_name = "NAME")]
    pub(crate) x: Option<String>,
    /// Variable that makes the lines of the figure [default: the first of the other variables]
    #[arg(long, value_name = "NAME")]
    pub(crate) lines: Option<String>,
    /// Number of threads; the results do not depend on it [default: all threads of the machine]
    #[arg(long, value_name = "N", value_parser = threads)]
    pub(crate) threads: Option<NonZero<usize>>,
    /// Run nothing; print the command that runs the case of this number by itself, with its report
    #[arg(long, value_name = "CASE")]
    pub(crate) command: Option<u64>,
}

#[derive(Debug, Args)]
pub(crate) struct CampaignMergeArgs {
    /// Campaign file whose runs were made in shares
    #[arg(value_name = "CAMPAIGN.toml", value_parser = input_file())]
    pub(crate) campaign: PathBuf,
    /// Folders of all shares, in any order
    #[arg(value_name = "SHARE", required = true)]
    pub(crate) shares: Vec<PathBuf>,
    /// Folder for the table [default: `out/` and the name of the campaign file]
    #[arg(long, value_name = "DIR", value_parser = output_folder())]
    pub(crate) out: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub(crate) struct CampaignReplayArgs {
    /// Campaign file
    #[arg(value_name = "CAMPAIGN.toml", value_parser = input_file())]
    pub(crate) campaign: PathBuf,
    /// Number of the case, as in the column `case` of the table
    #[arg(value_name = "CASE")]
    pub(crate) case: u64,
    /// Folder for tables, summary and report [default: `out/case_` and the number of the case]
    #[arg(long, value_name = "DIR", value_parser = output_folder())]
    pub(crate) out: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub(crate) struct CampaignReportArgs {
    /// Campaign file
    #[arg(value_name = "CAMPAIGN.toml", value_parser = input_file())]
    pub(crate) campaign: PathBuf,
    /// Folder with the table [default: `out/` and the name of the campaign file]
    #[arg(long, value_name = "DIR", value_parser = output_folder())]
    pub(crate) out: Option<PathBuf>,
    /// Write the report as PDF too; needs a browser (Chromium, Chrome or Edge)
    #[arg(long, value_name = "FILE.pdf", value_parser = output_file())]
    pub(crate) pdf: Option<PathBuf>,
}

/// A share, as 2/8.
fn shard(text: &str) -> Result<Shard, String> {
    let parts = text
        .split_once('/')
        .and_then(|(number, of)| Some((number.parse().ok()?, of.parse().ok()?)));
    let (number, of) = parts.ok_or("write a share as 2/8 for the second of eight shares")?;
    Shard::new(number, of)
}

#[derive(Debug, Args)]
pub(crate) struct StatisticsArgs {
    /// Table to read: a csv file whose first line names the columns, as in `speed [cm/s]`, or a Parquet file, such as
    /// the table of a campaign
    #[arg(value_name = "TABLE", value_parser = input_file())]
    pub(crate) table: PathBuf,
    /// Column whose numbers are analysed [default: list the columns]
    #[arg(long, value_name = "NAME")]
    pub(crate) column: Option<String>,
    /// Column with the weights of importance sampling [default: all rows count alike]
    #[arg(long, value_name = "NAME", requires = "column")]
    pub(crate) weights: Option<String>,
    /// Number of berthings a year [default: design values refer to rare single berthings]
    #[arg(long, value_name = "N", allow_hyphen_values = true, requires = "column")]
    pub(crate) per_year: Option<f64>,
    /// Return periods in years [default: 10,50,100]
    #[arg(
        long,
        value_name = "YEARS",
        value_delimiter = ',',
        allow_hyphen_values = true,
        requires = "per_year"
    )]
    pub(crate) return_period: Vec<f64>,
    /// Lifetime in years, for the largest value among all berthings of the lifetime
    #[arg(long, value_name = "YEARS", allow_hyphen_values = true, requires = "per_year")]
    pub(crate) life: Option<f64>,
    /// Probability laws to fit: normal, lognormal, weibull, gumbel, gev, gpd [default: lognormal,weibull,gumbel,gev;
    /// gpd too with --threshold]
    #[arg(long, value_name = "NAME", value_delimiter = ',', requires = "column")]
    pub(crate) fit: Vec<Law>,
    /// Threshold above which the law gpd (generalised Pareto) is fitted, in the unit of the column
    #[arg(long, value_name = "X", allow_hyphen_values = true, requires = "column")]
    pub(crate) threshold: Option<f64>,
    /// Confidence level of the confidence bands
    #[arg(long, value_name = "LEVEL", default_value = "0.95", allow_hyphen_values = true)]
    pub(crate) confidence: Confidence,
    /// Print JSON instead of text
    #[arg(long)]
    pub(crate) json: bool,
    /// Folder for statistics.html and statistics.json [default: none]
    #[arg(long, value_name = "DIR", value_parser = output_folder(), requires = "column")]
    pub(crate) out: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub(crate) struct BerthingsArgs {
    /// Logs: tables of docking systems or of tracks, NMEA 0183 or AIS sentences
    #[arg(value_name = "LOG", value_parser = input_file(), required = true)]
    pub(crate) logs: Vec<PathBuf>,
    /// Scenario of the berth, with its fenders, its ship and a table `[berthing]`
    #[arg(long, value_name = "BERTH.toml", value_parser = input_file())]
    pub(crate) berth: PathBuf,
    /// What the columns mean, where sensors and antenna stand, and which ship is which; `fenderline schema mapping`
    /// lists the keys [default: all that can be guessed is guessed]
    #[arg(long, value_name = "MAPPING.toml", value_parser = input_file())]
    pub(crate) mapping: Option<PathBuf>,
    /// Table to write, with a row a berthing: Parquet or csv, by the ending of the name [default: none]
    #[arg(short, long, value_name = "TABLE.parquet|.csv", value_parser = table_file())]
    pub(crate) out: Option<PathBuf>,
    /// Report to write [default: none]
    #[arg(long, value_name = "REPORT.html", value_parser = output_file())]
    pub(crate) report: Option<PathBuf>,
}

/// Parses the path of a table to write, whose ending says the form.
fn table_file() -> impl TypedValueParser<Value = PathBuf> {
    let file = |path: PathBuf| {
        let ending = path.extension().map(|ending| ending.to_ascii_lowercase());
        match ending {
            Some(ending) if ending == "parquet" || ending == "csv" => Ok(path),
            _ => Err("the name of the table must end in .parquet or .csv"),
        }
    };
    PathBufValueParser::new().try_map(file)
}

#[derive(Debug, Args)]
pub(crate) struct ValidateArgs {
    /// Instead of the published cases, sweep every force over its whole domain and check continuity, mirror image, laws
    /// of physics and ratios to references; exit code 1 if a check fails
    #[arg(long)]
    pub(crate) sweeps: bool,
    /// Folder for validation.html, validation.csv and validation.json; with --sweeps for sweeps.html, sweeps.csv,
    /// sweeps.json and a picture of each sweep [default: none]
    #[arg(long, value_name = "DIR", value_parser = output_folder())]
    pub(crate) out: Option<PathBuf>,
    /// Print JSON instead of tables
    #[arg(long)]
    pub(crate) json: bool,
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
    #[arg(long, value_name = "VESSELS.toml", value_parser = input_file())]
    pub(crate) file: Vec<PathBuf>,
    /// Rudder angle of turning circle and zig-zag in degrees [default: hard over; 10 and 20]
    #[arg(long, value_name = "DEG", value_parser = positive, allow_hyphen_values = true)]
    pub(crate) rudder: Option<f64>,
    /// Speed of approach in knots [default: the speed in the vessel's data]
    #[arg(long, value_name = "KN", value_parser = positive, allow_hyphen_values = true)]
    pub(crate) speed: Option<f64>,
    /// Water depth in metres or draughts, such as 31.2 or "1.5 T"; the results are printed beside those in deep water
    /// [default: deep water only]
    #[arg(long, value_name = "DEPTH", allow_hyphen_values = true)]
    pub(crate) depth: Option<WaterDepth>,
    /// Side force for crabbing in kilonewtons [default: the drag in deep water at a Froude number of 0.01]
    #[arg(long, value_name = "KILONEWTONS", value_parser = positive, allow_hyphen_values = true)]
    pub(crate) push: Option<f64>,
    /// Print JSON instead of tables
    #[arg(long)]
    pub(crate) json: bool,
    /// Folder for the tracks, one csv file per run [default: none]
    #[arg(long, value_name = "DIR", value_parser = output_folder())]
    pub(crate) out: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub(crate) struct VesselsArgs {
    /// Name of a vessel [default: list all]
    #[arg(value_name = "VESSEL")]
    pub(crate) vessel: Option<String>,
    /// File with your own vessels; repeatable
    #[arg(long, value_name = "VESSELS.toml", value_parser = input_file())]
    pub(crate) file: Vec<PathBuf>,
    /// Print JSON instead of text
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Debug, Args)]
pub(crate) struct FendersArgs {
    /// Family, such as cone [default: list all]
    #[arg(value_name = "FAMILY")]
    pub(crate) family: Option<String>,
    /// Size of the family, such as "3300x6500 50kPa" [default: all]
    #[arg(value_name = "SIZE")]
    pub(crate) size: Option<String>,
    /// File with your own fenders; repeatable
    #[arg(long, value_name = "FENDERS.toml", value_parser = input_file())]
    pub(crate) file: Vec<PathBuf>,
    /// Print JSON instead of text
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Debug, Args)]
pub(crate) struct FmuArgs {
    /// Scenario file; `-` reads it from standard input
    #[arg(value_name = "SCENARIO.toml")]
    pub(crate) scenario: PathBuf,
    /// Kind of FMU
    #[arg(long, value_enum)]
    pub(crate) kind: FmuKind,
    /// Version of the standard
    #[arg(long, value_enum, default_value_t = FmiVersion::Two)]
    pub(crate) fmi: FmiVersion,
    /// FMU file to write; its name without extension is the name of the model. A description for the Open Simulation
    /// Platform is written beside the FMU
    #[arg(short, long, value_name = "X.fmu", value_parser = output_file())]
    pub(crate) out: PathBuf,
    /// Platforms that the FMU runs on, by the names of FMI 3.0: x86_64-linux, aarch64-linux, x86_64-windows
    /// [default: all that this program has a library for]
    #[arg(long, value_name = "NAMES", value_delimiter = ',', value_parser = platform)]
    pub(crate) platforms: Vec<Platform>,
    /// Shared library for the FMU, used in place of the library that is built into the program; once for each platform
    #[arg(long, value_name = "PATH", conflicts_with = "platforms")]
    pub(crate) library: Vec<PathBuf>,
    #[command(flatten)]
    pub(crate) changes: Changes,
}

/// Kind of FMU.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum FmuKind {
    /// The contact engine: inputs are states of bodies, outputs are wrenches on bodies and results of fenders
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
    /// Campaigns
    Campaign,
    /// Mappings of measured berthings
    Mapping,
}

/// The choice of one manoeuvre, or of all manoeuvres that the vessel can do.
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
    /// Turning circles to starboard and to port
    Turning,
    /// Zig-zag 10°/10° and 20°/20°, each begun to starboard and to port
    Zigzag,
    /// Crash stop: from full ahead to standstill by the propeller astern
    CrashStop,
    /// Crabbing: motion sideways under a steady force at midship, engine stopped
    Crabbing,
    /// Pull on a bollard, ahead and astern
    BollardPull,
}

/// A water depth as given on the command line, in metres or in draughts.
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

/// An address with a port, or a port of this machine alone.
fn local_port(text: &str) -> Result<SocketAddr, String> {
    let port = text.parse().map(|port| SocketAddr::from(([127, 0, 0, 1], port)));
    port.or_else(|_| text.parse::<SocketAddr>())
        .map_err(|_| "it must be a port from 0 to 65535, or an address and a port".to_owned())
}

fn platform(text: &str) -> Result<Platform, String> {
    Platform::of_name(text).ok_or_else(|| {
        let names: Vec<&str> = Platform::ALL.into_iter().map(Platform::name).collect();
        format!("expected one of {}", names.join(", "))
    })
}

/// Parses a number of threads.
fn threads(text: &str) -> Result<NonZero<usize>, String> {
    let number = text.parse::<NonZero<usize>>().ok().filter(|number| number.get() <= MOST_THREADS);
    number.ok_or_else(|| format!("the number of threads must be from 1 to {MOST_THREADS}"))
}

/// Parses a number above zero and below a million; no angle, speed or force of a manoeuvre needs more.
fn positive(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(number) if number > 0.0 && number < 1e6 => Ok(number),
        Ok(_) => Err("the number must be above 0 and below 1000000".to_owned()),
        Err(_) => Err("the value is not a number".to_owned()),
    }
}

#[derive(Debug, Args)]
pub(crate) struct LimitArgs {
    /// Scenario file; `-` reads it from standard input
    #[arg(value_name = "SCENARIO.toml")]
    pub(crate) scenario: PathBuf,
    /// Key of the scenario to change, such as passing.feeder.speed; larger values must bring the run nearer to its
    /// limits
    #[arg(long, value_name = "KEY")]
    pub(crate) key: String,
    /// Smallest value of the key, with its unit, such as "2 kn"
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    pub(crate) from: String,
    /// Largest value of the key, with the same unit
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    pub(crate) to: String,
    /// Accuracy of the limit, in the unit of the values [default: a hundredth of the range]
    #[arg(long, value_name = "NUMBER")]
    pub(crate) within: Option<f64>,
    /// Print the limit that was found and all runs as JSON
    #[arg(long)]
    pub(crate) json: bool,
    #[command(flatten)]
    pub(crate) changes: Changes,
}

#[derive(Debug, Args)]
pub(crate) struct CheckArgs {
    /// Scenario or campaign file; `-` reads a scenario from standard input
    #[arg(value_name = "FILE.toml")]
    pub(crate) scenario: PathBuf,
    /// Exit code 2 if there are notices, such as one of a ship that starts inside a fender, or of a campaign's case
    /// that cannot start
    #[arg(long)]
    pub(crate) strict: bool,
    /// Print the mistake or the notices of the file as JSON, each with file, line, column and key
    #[arg(long)]
    pub(crate) json: bool,
    #[command(flatten)]
    pub(crate) changes: Changes,
}

/// Options for the documents of a run that people read (PDF report, Excel workbook), beside the result tables.
#[derive(Debug, Default, Args)]
pub(crate) struct Documents {
    /// Write the report as PDF too; needs a browser (Chromium, Chrome or Edge)
    #[arg(long, value_name = "FILE.pdf", value_parser = output_file())]
    pub(crate) pdf: Option<PathBuf>,
    /// Write the results as an Excel workbook too
    #[arg(long, value_name = "FILE.xlsx", value_parser = output_file())]
    pub(crate) xlsx: Option<PathBuf>,
    /// Result tables to add to the workbook, each as a sheet with its time series, such as fenders,lines [default:
    /// none]
    #[arg(long, value_name = "NAMES", requires = "xlsx")]
    pub(crate) sheets: Option<String>,
}

/// Options for the lines of the report's title page; each option is short for `--set report.KEY=TEXT`.
#[derive(Debug, Default, Args)]
#[command(next_help_heading = "Title page of the report")]
pub(crate) struct TitlePage {
    /// Project
    #[arg(long, value_name = "TEXT")]
    project: Option<String>,
    /// Client
    #[arg(long, value_name = "TEXT")]
    client: Option<String>,
    /// Number of the document
    #[arg(long, value_name = "TEXT")]
    number: Option<String>,
    /// Revision of the document
    #[arg(long, value_name = "TEXT")]
    revision: Option<String>,
    /// Status of the document, such as "for review"
    #[arg(long, value_name = "TEXT")]
    status: Option<String>,
    /// Date of the document, as the title page is to show it
    #[arg(long, value_name = "TEXT")]
    date: Option<String>,
    /// Author of the document
    #[arg(long, value_name = "TEXT")]
    author: Option<String>,
    /// Who checked the document
    #[arg(long, value_name = "TEXT")]
    checked_by: Option<String>,
}

impl TitlePage {
    /// The lines of the title page that the user gave, as overrides of the scenario.
    ///
    /// # Errors
    /// An empty text.
    pub(crate) fn overrides(&self) -> Result<Vec<Override>, ScenarioError> {
        let lines = [
            ("project", &self.project),
            ("client", &self.client),
            ("number", &self.number),
            ("revision", &self.revision),
            ("status", &self.status),
            ("date", &self.date),
            ("author", &self.author),
            ("checked_by", &self.checked_by),
        ];
        let given = lines.into_iter().filter_map(|(key, text)| Some((key, text.as_ref()?)));
        let change = |(key, text): (&str, &String)| {
            let option = format!("--{} {text}", key.replace('_', "-"));
            // As a TOML string: a revision of `2` is a text, not a number.
            let value = toml_text(text);
            Override::new(&option, &format!("report.{key}"), &value)
        };
        given.map(change).collect()
    }
}

/// Writes a text as a basic string of TOML.
fn toml_text(text: &str) -> String {
    let mut quoted = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => quoted.extend(['\\', c]),
            c if c.is_control() => quoted.push_str(&format!("\\u{:04X}", u32::from(c))),
            c => quoted.push(c),
        }
    }
    quoted.push('"');
    quoted
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
    /// Override one key of the scenario, such as body.tug.velocity.surge="2 kn"; `*` in a name means all names that
    /// fit, as in fender.*.temperature="40 degC"; repeatable
    #[arg(long = "set", value_name = "KEY=VALUE")]
    set: Vec<String>,
}

impl Changes {
    /// All changes of the scenario: first those of the short options, then those of `--set`.
    ///
    /// # Errors
    /// Fails if a text is not of the form `KEY=VALUE`.
    pub(crate) fn overrides(&self) -> Result<Vec<Override>, ScenarioError> {
        let shorthands = self
            .shorthands()
            .map(|(option, key, value)| Override::new(&format!("{option} {value}"), key, value));
        shorthands.chain(self.set.iter().map(|text| Override::parse(text))).collect()
    }

    /// Keys and values of all changes of the scenario, in the order of [`Changes::overrides`].
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

impl Cli {
    /// Whether standard output is JSON, so that nothing else may be in it.
    pub(crate) fn has_json(&self) -> bool {
        match &self.command {
            Command::Run(args) => args.json,
            Command::Check(args) => args.json,
            Command::Limit(args) => args.json,
            Command::Statistics(args) => args.json,
            Command::Validate(args) => args.json,
            Command::Manoeuvre(args) => args.json,
            _ => false,
        }
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
