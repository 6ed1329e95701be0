//! The report's notes on the contact method and the model.

use fenderline_results::Outcome;
use fenderline_sim::Method;
use maud::{Markup, html};

use super::vessels;

pub(super) fn method_notes(outcome: &Outcome<'_>) -> Markup {
    html! {
        ul class="plain" {
            li {
                "Contact forces: the overlap method of Moreno, Sasaki, Makiyama and Tannuri \
                (TransNav 17(4), 2023), with its sign errors corrected: normal force from the overlap \
                area and its rate, friction by a shear spring that sticks and slips, and an \
                impulse-momentum limiter that sets the rebound by the coefficient of restitution."
            }
            @match outcome.setup.method {
                Method::Paper => (paper_notes(outcome.setup.step_s)),
                Method::Coupled => (coupled_notes(outcome.setup.step_s)),
            }
            li {
                "Bodies are rigid, and move in the horizontal plane. "
                @if outcome.setup.world.vessels.is_empty() {
                    "The water acts by added mass alone, without damping, wind or current."
                } @else {
                    "On vessels act hull, propeller, rudder and thrusters by the MMG method, extended to low \
                    speed, and wind, current and mean wave drift; on other bodies the water acts by added \
                    mass alone. "
                    (vessels::degrees_of_freedom(outcome.setup))
                }
            }
            li {
                "Energy: the kinetic energy at the start plus the work of the loads equals the \
                 kinetic energy at the end plus the work done against contact forces. Work is \
                 force times the mean velocity of the step, so that this balance is exact. The \
                 residual of the balance is rounding and, if surge and sway have different added \
                 mass, the integration error of the Coriolis terms. Energy taken by contact forces \
                 is stored, lost to restitution, damping and friction, or is a numerical loss or \
                 gain of method and time step. The numerical part decreases with the time step, \
                 except where outlines meet in a corner, because the contact law there has no \
                 potential."
            }
            @if !outcome.setup.fenders.is_empty() {
                li {
                    "The force of a fender is the gradient of its stored energy: its reaction at the mean \
                    deflection over the fender's width, times the factor that speed, angle, temperature and \
                    tolerance gave at the first touch. The energy of a fender is the integral of \
                    its reaction. Beyond the travel of the fender its stop acts, then the \
                    structure behind the fender."
                }
            }
        }
    }
}

fn paper_notes(step_s: f64) -> Markup {
    html! {
        li {
            "Paper method: the limiter treats each pair on its own, without the other contacts and the \
            loads. Where a body rests on several other bodies at once, or is pressed by a steady load, \
            depth and rebound may be wrong (docs/contact_model.md, section 5). The limiter uses the mass \
            with the smallest added mass."
        }
        li {
            (format!(
                "Forces are those at the start of the time step over which they act ({step_s} s \
                 here). "
            ))
            "The peak rises and the contact shortens with a smaller step, while the \
            impulse stays the same; compare two time steps before a peak is used in design."
        }
    }
}

fn coupled_notes(step_s: f64) -> Markup {
    html! {
        li {
            "Coupled method: the forces of all contacts of a step are solved together, with the \
            external loads and the full mass matrix of each body, so that several fenders \
            share one rebound and a steady load is held at its static depth."
        }
        li {
            (format!("Forces in the charts are means over the time step ({step_s} s here). "))
            "If the time step is too long for a contact, the engine takes sub-steps. Peaks in the \
             tables include the sub-steps."
        }
    }
}
