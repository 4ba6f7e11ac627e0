//! A Slurm of one machine, which ends with the test.

use super::{OPTIONS, PARTS, PROGRAM, Place, SCENE, wait_until};
use crate::workspace;
use anyhow::{Context, Result, ensure};
use std::fs::{self, File};
use std::os::unix::fs::PermissionsExt;
use std::process::{Child, Command};

/// An array of seven tasks, one of which is queued again, one killed, and one told that its
/// time will be up, and a merge that waits for all of them.
pub(super) fn run(place: &Place) -> Result<String> {
    let here = place.folder.join("slurm");
    let _cluster = Cluster::start(place)?;
    for file in ["render.sbatch", "merge.sbatch"] {
        fs::copy(workspace::root().join("docs/howto/cluster").join(file), place.folder.join(file))?;
    }
    let environment = format!("SLURM_CONF={}", here.join("slurm.conf").display());
    let slurm = |program: &str, arguments: &[&str]| {
        place.output("env", &[&[environment.as_str(), program], arguments].concat())
    };
    let array = format!("0-{}", PARTS - 1);
    let render = ["--parsable", "--array", &array, "render.sbatch", PROGRAM, SCENE];
    let options: Vec<&str> = OPTIONS.split(' ').collect();
    let job = slurm("sbatch", &[&render[..], &options].concat())?;
    let after = format!("--dependency=afterok:{job}");
    let merge = ["--parsable", &after, "--kill-on-invalid-dep=yes", "merge.sbatch"];
    let merge = slurm("sbatch", &merge)?;
    place.wait_for_part(0)?;
    slurm("scontrol", &["requeue", &format!("{job}_0")])?;
    place.wait_for_part(1)?;
    place.kill_part(1)?;
    place.wait_for_part(2)?;
    let part = format!("{job}_2");
    wait_until("no signal reached part 2", || {
        // A cluster that is busy refuses now and then, and scancel tries for a minute on its own.
        let _ = slurm("timeout", &["2", "scancel", "--batch", "--signal=USR1", &part]);
        Ok(!slurm("scontrol", &["show", "job", &part])?.contains("Restarts=0"))
    })?;
    wait_until("the queue is not empty", || Ok(slurm("squeue", &["--noheader"])?.is_empty()))?;
    let end = slurm("scontrol", &["show", "job", &merge])?;
    ensure!(end.contains("JobState=COMPLETED"), "the merge did not complete:\n{}", logs(place));
    for part in [0, 1, 2] {
        ensure!(place.went_on(&format!("part-{part}.log"))?, "part {part} did not go on");
    }
    Ok(format!(
        "{PARTS} tasks, one requeued, one killed, one out of time, and a merge by dependency"
    ))
}

/// Returns the messages of the parts and of the controller.
fn logs(place: &Place) -> String {
    let parts = (0..PARTS).map(|part| format!("part-{part}.log"));
    let files = parts.chain(["slurm/slurmctld.said".to_string()]);
    let text = |file: &String| fs::read_to_string(place.folder.join(file)).unwrap_or_default();
    files.map(|file| format!("== {file}\n{}", text(&file))).collect::<Vec<_>>().join("\n")
}

/// Its daemons, in the order in which they end.
struct Cluster(Vec<Child>);

impl Cluster {
    fn start(place: &Place) -> Result<Self> {
        let here = place.folder.join("slurm");
        for folder in ["", "state", "spool"] {
            fs::create_dir(here.join(folder))?;
        }
        let key = here.join("munge.key");
        fs::write(&key, key_bytes()?)?;
        fs::set_permissions(&key, fs::Permissions::from_mode(0o600))?;
        let host = place.output("hostname", &["-s"])?;
        let user = place.output("id", &["-un"])?;
        fs::write(
            here.join("slurm.conf"),
            configuration(&here.display().to_string(), &host, &user),
        )?;
        let mut cluster = Self(Vec::new());
        let file = |name: &str| format!("{}/{name}", here.display());
        let munged = [
            "key-file=munge.key",
            "socket=munge.socket",
            "pid-file=munged.pid",
            "log-file=munged.log",
            "seed-file=munged.seed",
        ];
        let munged = munged.map(|option| {
            let (name, value) = option.split_once('=').unwrap_or_default();
            format!("--{name}={}", file(value))
        });
        let words = ["-F", "--force"].into_iter().chain(munged.iter().map(String::as_str));
        cluster.add(place, "munged", words)?;
        wait_until("munged made no socket", || Ok(here.join("munge.socket").exists()))?;
        cluster.add(place, "slurmctld", ["-D", "-c"])?;
        cluster.add(place, "slurmd", ["-D"])?;
        wait_until("the cluster is not idle", || {
            let mut sinfo = place.command("sinfo");
            let sinfo = sinfo.args(["-h", "-o", "%T"]).env("SLURM_CONF", file("slurm.conf"));
            Ok(sinfo.output()?.stdout.starts_with(b"idle"))
        })?;
        Ok(cluster)
    }

    fn add<'a>(
        &mut self,
        place: &Place,
        program: &str,
        arguments: impl IntoIterator<Item = &'a str>,
    ) -> Result<()> {
        let here = place.folder.join("slurm");
        let log = File::create(here.join(format!("{program}.said")))?;
        let mut command = place.command(program);
        command.args(arguments).env("SLURM_CONF", here.join("slurm.conf"));
        command.stdout(log.try_clone()?).stderr(log);
        let child = command.spawn().with_context(|| format!("{program} does not start"))?;
        self.0.insert(0, child);
        Ok(())
    }
}

impl Drop for Cluster {
    fn drop(&mut self) {
        for child in &mut self.0 {
            let _ = Command::new("kill").arg(child.id().to_string()).status();
            let _ = child.wait();
        }
    }
}

/// Nobody can foresee it.
fn key_bytes() -> Result<Vec<u8>> {
    use std::io::Read;
    let mut key = Vec::new();
    File::open("/dev/urandom")?.take(128).read_to_end(&mut key)?;
    Ok(key)
}

/// Writes Slurm's configuration. A job that is queued again waits for as long as a credential is
/// valid, which is two minutes unless `cred_expire` says otherwise, and then for the next look at
/// the queue.
/// `cred_expire` says otherwise, and then for the next look at the queue.
fn configuration(here: &str, host: &str, user: &str) -> String {
    // Two of those that systems give to nobody for long.
    let port = 20_000 + 2 * (std::process::id() % 5_000);
    let daemon = port + 1;
    format!(
        "\
ClusterName=local
SlurmctldHost={host}(127.0.0.1)
AuthType=auth/munge
AuthInfo=socket={here}/munge.socket,cred_expire=10
SlurmUser={user}
SlurmdUser={user}
SlurmctldPort={port}
SlurmdPort={daemon}
StateSaveLocation={here}/state
SlurmdSpoolDir={here}/spool
SlurmctldPidFile={here}/slurmctld.pid
SlurmdPidFile={here}/slurmd.pid
SlurmctldLogFile={here}/slurmctld.log
SlurmdLogFile={here}/slurmd.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=sched_interval=2,bf_interval=2,batch_sched_delay=1
ReturnToService=2
NodeName={host} NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"
    )
}
