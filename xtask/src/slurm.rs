//! `cargo xtask slurm` runs a campaign as an array of a real Slurm on this machine, and checks that the merged result
//! is the table of one process, byte for byte.
//!
//! The test needs no accounts or services of Slurm: it starts `munged`, `slurmctld` and `slurmd` with files in a folder
//! of their own, and ends them with that folder.

use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitCode, Stdio};
use std::time::{Duration, Instant};

use crate::command::run_quietly;
use crate::program::program;
use crate::step::{Done, Step, run_all};
use crate::tools::Missing;

/// This step belongs to `cargo xtask test all`.
pub(crate) const STEP: Step = Step { name: "a campaign as an array of Slurm", run: slurm };

/// `cargo xtask slurm`.
pub(crate) fn slurm_command() -> ExitCode {
    run_all(&[STEP])
}

/// Tasks of the array.
const TASKS: usize = 4;
/// Longest time that the daemons and the array may take.
const PATIENCE: Duration = Duration::from_secs(120);

/// A campaign that takes some seconds.
const CAMPAIGN: &str = r#"
scenario = "quay.toml"
number = 120
seed = 5
[variable.speed]
key = "body.ship.approach.speed_normal"
distribution = "lognormal"
mean = "7.1 cm/s"
standard_deviation = "4.47 cm/s"
at_most = "40 cm/s"
[variable.angle]
key = "body.ship.approach.angle"
distribution = "uniform"
lower = "-3 deg"
upper = "5 deg"
"#;

fn slurm() -> Result<Done, String> {
    let missing =
        Missing { tool: "Slurm with munge", install: "slurm-wlm and munge of your distribution" };
    // Some of them fail without a configuration; here it counts that they start.
    let starts = |program: &&str| {
        let asked =
            Command::new(program).arg("-V").stdout(Stdio::null()).stderr(Stdio::null()).status();
        asked.is_ok()
    };
    if !["munged", "slurmctld", "slurmd", "sbatch"].iter().all(starts) {
        return Ok(Done::NotRun(missing));
    }
    if output(Command::new("id").arg("-u"))?.trim() != "0" {
        println!("not run: Slurm's daemons can be started by root alone");
        return Ok(Done::Good);
    }
    let program = program("release")?;
    let place = Place::new()?;
    std::fs::write(place.path("study.toml"), CAMPAIGN).map_err(|e| format!("study.toml: {e}"))?;
    std::fs::copy("campaigns/quay.toml", place.path("quay.toml"))
        .map_err(|e| format!("campaigns/quay.toml: {e}"))?;
    let fenderline = |arguments: &[&str]| {
        run_quietly(Command::new(&program).args(arguments).current_dir(&place.folder))
    };
    fenderline(&["campaign", "study.toml", "--out", "whole"])?;
    let script = format!(
        "#!/bin/sh\nexec '{}' campaign study.toml --threads 1 \\\n  --shard \"$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT\" \
         --out \"share_$SLURM_ARRAY_TASK_ID\"\n",
        program.display()
    );
    std::fs::write(place.path("array.sh"), script).map_err(|e| format!("array.sh: {e}"))?;
    let _cluster = Cluster::start(&place)?;
    let array = format!("--array=1-{TASKS}");
    let output = format!("--output={}", place.path("task_%a.txt").display());
    let mut batch = place.of_cluster("sbatch");
    batch.args(["--wait", &array, &output, "array.sh"]).current_dir(&place.folder);
    run_quietly(&mut batch).map_err(|why| format!("{why}\n{}", place.told()))?;
    let shares: Vec<String> = (1..=TASKS).map(|task| format!("share_{task}")).collect();
    let mut merge = vec!["campaign", "merge", "study.toml"];
    merge.extend(shares.iter().map(String::as_str));
    merge.extend(["--out", "merged"]);
    fenderline(&merge)?;
    for table in ["cases.parquet", "cases.csv"] {
        let read = |folder: &str| {
            let path = place.path(folder).join(table);
            std::fs::read(&path).map_err(|e| format!("{}: {e}", path.display()))
        };
        if read("whole")? != read("merged")? {
            return Err(format!(
                "the {table} of the array of tasks differs from the {table} of one process"
            ));
        }
    }
    println!("an array of {TASKS} tasks gives the tables of one process, byte for byte");
    Ok(Done::Good)
}

fn output(command: &mut Command) -> Result<String, String> {
    let output = command.output().map_err(|e| format!("{command:?}: {e}"))?;
    Ok(String::from_utf8_lossy(&output.stdout).into_owned())
}

/// A folder for all files of the test, which is removed when this value is dropped.
struct Place {
    folder: PathBuf,
}

impl Place {
    fn new() -> Result<Place, String> {
        let folder = std::env::temp_dir().join(format!("fenderline-slurm-{}", std::process::id()));
        for part in ["state", "spool"] {
            let path = folder.join(part);
            std::fs::create_dir_all(&path).map_err(|e| format!("{}: {e}", path.display()))?;
        }
        Ok(Place { folder })
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.join(name)
    }

    /// The command of a Slurm program that talks to the cluster of this test.
    fn of_cluster(&self, program: &str) -> Command {
        let mut command = Command::new(program);
        command.env("SLURM_CONF", self.path("slurm.conf"));
        command
    }

    /// What Slurm's daemons and tasks have written into the folder.
    fn told(&self) -> String {
        let mut text = String::new();
        let Ok(entries) = std::fs::read_dir(&self.folder) else { return text };
        let mut paths: Vec<PathBuf> =
            entries.filter_map(|entry| Some(entry.ok()?.path())).collect();
        paths.sort();
        for path in paths
            .iter()
            .filter(|path| path.extension().is_some_and(|end| end == "txt" || end == "log"))
        {
            let told = std::fs::read_to_string(path).unwrap_or_default();
            let last: Vec<&str> = told.lines().rev().take(8).collect();
            text += &format!("{}:\n", path.display());
            last.iter().rev().for_each(|line| text += &format!("  {line}\n"));
        }
        text
    }
}

impl Drop for Place {
    fn drop(&mut self) {
        // An error is ignored: it is a folder for temporary files.
        let _ = std::fs::remove_dir_all(&self.folder);
    }
}

/// Slurm's daemons, which end when this value is dropped.
struct Cluster {
    daemons: Vec<Child>,
}

impl Cluster {
    fn start(place: &Place) -> Result<Cluster, String> {
        let host = output(Command::new("hostname").arg("-s"))?.trim().to_owned();
        write_key(&place.path("munge.key"))?;
        std::fs::write(place.path("slurm.conf"), configuration(place, &host))
            .map_err(|e| format!("slurm.conf: {e}"))?;
        let mut cluster = Cluster { daemons: Vec::new() };
        let file = |option: &str, name: &str| format!("--{option}={}", place.path(name).display());
        cluster.daemon(Command::new("munged").args(["--foreground", "--force"]).args([
            file("key-file", "munge.key"),
            file("socket", "munge.socket"),
            file("pid-file", "munged.pid"),
            file("log-file", "munged.log"),
            file("seed-file", "munge.seed"),
        ]))?;
        cluster.daemon(place.of_cluster("slurmctld").arg("-D"))?;
        cluster.daemon(place.of_cluster("slurmd").args(["-D", "-N", &host]))?;
        let began = Instant::now();
        while !output(place.of_cluster("sinfo").args(["--noheader", "--format=%T"]))?
            .contains("idle")
        {
            if began.elapsed() > PATIENCE {
                return Err(format!("Slurm's node does not become idle\n{}", place.told()));
            }
            std::thread::sleep(Duration::from_millis(200));
        }
        Ok(cluster)
    }

    fn daemon(&mut self, command: &mut Command) -> Result<(), String> {
        let child =
            command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null()).spawn();
        self.daemons.push(child.map_err(|e| format!("{command:?}: {e}"))?);
        Ok(())
    }
}

impl Drop for Cluster {
    fn drop(&mut self) {
        // Errors are ignored: a daemon that has ended needs no signal.
        for daemon in self.daemons.iter_mut().rev() {
            let _ = Command::new("kill").arg(daemon.id().to_string()).status();
            let began = Instant::now();
            while matches!(daemon.try_wait(), Ok(None)) && began.elapsed() < Duration::from_secs(10)
            {
                std::thread::sleep(Duration::from_millis(50));
            }
            let _ = daemon.kill();
            let _ = daemon.wait();
        }
    }
}

/// Writes a key for this cluster alone, which nobody else can read.
fn write_key(path: &Path) -> Result<(), String> {
    use std::io::{Read as _, Write as _};
    use std::os::unix::fs::OpenOptionsExt as _;
    let written = (|| {
        let mut key = [0; 128];
        std::fs::File::open("/dev/urandom")?.read_exact(&mut key)?;
        let mut options = std::fs::OpenOptions::new();
        options.write(true).create_new(true).mode(0o400).open(path)?.write_all(&key)
    })();
    written.map_err(|e: std::io::Error| format!("{}: {e}", path.display()))
}

/// The configuration of a cluster that is this machine alone, on ports of its own.
fn configuration(place: &Place, host: &str) -> String {
    let folder = place.folder.display();
    // Two free ports would need to be kept until the daemons have them; by process they do not meet in practice.
    let port = 20_000 + 2 * (std::process::id() % 10_000);
    format!(
        "ClusterName=fenderline\nSlurmctldHost={host}(127.0.0.1)\nSlurmUser=root\nSlurmdUser=root\nAuthType=auth/munge\n\
         AuthInfo=socket={folder}/munge.socket\nCredType=cred/munge\nSlurmctldPort={port}\nSlurmdPort={}\n\
         SlurmctldPidFile={folder}/slurmctld.pid\nSlurmdPidFile={folder}/slurmd.pid\nStateSaveLocation={folder}/state\n\
         SlurmdSpoolDir={folder}/spool\nSlurmctldLogFile={folder}/slurmctld.log\nSlurmdLogFile={folder}/slurmd.log\n\
         ProctrackType=proctrack/linuxproc\nTaskPlugin=task/none\nSelectType=select/cons_tres\nSelectTypeParameters=CR_CPU\n\
         SwitchType=switch/none\nMpiDefault=none\nReturnToService=2\nJobAcctGatherType=jobacct_gather/none\n\
         AccountingStorageType=accounting_storage/none\nNodeName={host} NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN\n\
         PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP OverSubscribe=FORCE:4\n",
        port + 1
    )
}
