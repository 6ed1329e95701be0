//! Force providers: other programs that apply forces to bodies. Each provider is a process that answers one line of
//! JSON with another line.

mod group;
mod process;
mod protocol;

use fenderline_contact::Wrench;
use fenderline_results::{ProviderNotice, ProviderNotices};
use fenderline_sim::external::{ForceRequest, HeldWrench, ProviderEvent};
use fenderline_sim::{ProviderSetup, Simulation};

#[cfg(unix)]
pub(crate) use self::group::end_all;
use self::process::Process;
use crate::failure::Failure;

/// All force providers of a run.
pub(crate) struct Providers {
    all: Vec<Provider>,
    wrenches: Vec<Wrench>,
    events: Vec<ProviderEvent>,
}

struct Provider {
    setup: ProviderSetup,
    process: Process,
    provided: HeldWrench,
}

impl Providers {
    /// Starts the force providers of a set-up as processes.
    ///
    /// # Errors
    /// Fails if a command cannot be started.
    pub(crate) fn start(simulation: &Simulation) -> Result<Providers, Failure> {
        let setup = simulation.setup();
        let mut all = Vec::with_capacity(setup.world.providers.len());
        for provider in &setup.world.providers {
            let body = &setup.bodies[provider.body].name;
            let hello = protocol::hello(body, setup.step_s);
            let process = Process::start(&provider.command, provider.timeout_s, &hello);
            let process = process.map_err(|why| {
                let command = provider.command.join(" ");
                Failure::case(format_args!("error: cannot start the provider `{command}`: {why}"))
            })?;
            let provided = HeldWrench::new(provider.hold_s);
            all.push(Provider { setup: provider.clone(), process, provided });
        }
        let wrenches = vec![Wrench::default(); setup.bodies.len()];
        Ok(Providers { all, wrenches, events: Vec::new() })
    }

    /// Asks every force provider for the next step and gives the sums of the forces to the simulation. Late or wrong
    /// answers are added to `notices`.
    pub(crate) fn ask(&mut self, simulation: &mut Simulation, notices: &mut ProviderNotices) {
        if self.all.is_empty() {
            return;
        }
        self.wrenches.fill(Wrench::default());
        let (t_s, step_s) = (simulation.time_s(), simulation.setup().step_s);
        for (index, provider) in self.all.iter_mut().enumerate() {
            let body = provider.setup.body;
            let question = ForceRequest { t_s, step_s, state: simulation.states()[body] };
            let wrench =
                provider.provided.wrench(&mut provider.process, &question, &mut self.events);
            if provider.provided.is_silent() {
                simulation.note_silent_provider(index);
            }
            self.wrenches[body].force_n += wrench.force_n;
            self.wrenches[body].moment_nm += wrench.moment_nm;
            for event in self.events.drain(..) {
                notices.add(ProviderNotice { t_s, provider: index, event });
            }
        }
        simulation.set_external(&self.wrenches);
    }
}
