//! A force provider and the processes that it started, which are all ended together.
//!
//! On Unix a provider leads a process group of its own. Ctrl-C at the terminal therefore does not reach the provider:
//! the run decides when the provider ends. A process that leaves the provider's group by `setsid` is not ended. On
//! other systems only the provider itself is ended.

use std::io;
use std::process::{Child, Command};
#[cfg(unix)]
use std::sync::Mutex;

#[cfg(unix)]
use rustix::process::{Pid, Signal, WaitId, WaitIdOptions, kill_process_group, waitid};

/// The process groups that are running, so that the program can end them when it ends early. A group is removed from
/// this list before its leader is waited for: until then no other process or group can have the group's number.
#[cfg(unix)]
static GROUPS: Mutex<Vec<Pid>> = Mutex::new(Vec::new());

/// A process group.
pub(super) struct Group {
    #[cfg(unix)]
    leader: Pid,
}

impl Group {
    /// Starts a command as the leader of a group of its own.
    pub(super) fn start(command: &mut Command) -> io::Result<(Child, Group)> {
        #[cfg(unix)]
        {
            use std::os::unix::process::CommandExt as _;
            // The lock prevents that all groups are ended between its start and its entry.
            let mut groups = lock();
            let child = command.process_group(0).spawn()?;
            let leader = Pid::from_child(&child);
            groups.push(leader);
            Ok((child, Group { leader }))
        }
        #[cfg(not(unix))]
        Ok((command.spawn()?, Group {}))
    }

    /// Whether the leader of the process group has ended. The leader is not waited for, so that its process number is
    /// not reused.
    pub(super) fn has_leader_ended(&self, child: &mut Child) -> bool {
        #[cfg(unix)]
        {
            let _ = child;
            let how = WaitIdOptions::EXITED | WaitIdOptions::NOHANG | WaitIdOptions::NOWAIT;
            // An error means that it was waited for.
            !matches!(waitid(WaitId::Pid(self.leader), how), Ok(None))
        }
        #[cfg(not(unix))]
        matches!(child.try_wait(), Ok(Some(_)) | Err(_))
    }

    /// Ends all processes of the group; does nothing if they were ended before.
    pub(super) fn end(&self) {
        #[cfg(unix)]
        {
            let mut groups = lock();
            if let Some(place) = groups.iter().position(|leader| *leader == self.leader) {
                end(groups.swap_remove(place));
            }
        }
    }
}

/// Ends the processes of all providers when the program ends early.
#[cfg(unix)]
pub(crate) fn end_all() {
    lock().drain(..).for_each(end);
}

#[cfg(unix)]
fn end(leader: Pid) {
    // An error means that no process is left.
    let _ = kill_process_group(leader, Signal::KILL);
}

#[cfg(unix)]
fn lock() -> std::sync::MutexGuard<'static, Vec<Pid>> {
    // A list of numbers is valid even after a panic of its last user.
    GROUPS.lock().unwrap_or_else(std::sync::PoisonError::into_inner)
}
