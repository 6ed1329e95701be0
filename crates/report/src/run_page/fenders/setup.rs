//! The fenders as the scenario set them.

use fenderline_contact::FenderLaw;
use fenderline_sim::{FenderSetup, Setup};
use maud::{Markup, html};

use crate::plot::{plain, significant};
use crate::run_page::tables::{ROWS, more, number};
use crate::{Head, table_head};

/// One row per fender: position, size and rating.
pub(in crate::run_page) fn setup_table(setup: &Setup) -> Markup {
    html! {
        div class="wide" {
            table {
                (table_head(&[
                    Head::Name("Fender"),
                    Head::Text("On", "material"),
                    Head::Number("Position", "forward, starboard, m"),
                    Head::Number("Facing", "deg"),
                    Head::Number("Face", "width × height, m"),
                    Head::Number("Projection", "m"),
                    Head::Number("Rated", "mm, kN, kJ"),
                    Head::Number("Stop", "from mm, MN/m"),
                ]))
                tbody {
                    @for fender in setup.fenders.iter().take(ROWS) { (row(fender, setup)) }
                }
            }
        }
        (more(setup.fenders.len()))
        p class="note" {
            "Position and facing are in the axes of the body that carries the fender. Ratings are without factors; the "
            "rated energy is the integral of the reaction."
        }
    }
}

fn row(fender: &FenderSetup, setup: &Setup) -> Markup {
    let material = &setup.materials[fender.material];
    html! {
        tr {
            td class="name" { (fender.name) }
            td { (setup.bodies[fender.body].name) small { (material.name) } }
            (number(&format!("{}, {}",
                plain(fender.position_m.x, 5), plain(fender.position_m.y, 5))))
            (number(&plain(fender.facing_rad.to_degrees(), 4)))
            (number(&format!("{} × {}", plain(fender.width_m, 3), plain(fender.height_m, 3))))
            (number(&plain(fender.projection_m, 3)))
            @match (&fender.law, fender.rated) {
                (_, Some(rated)) => {
                    (number(&format!("{}, {}, {}",
                        significant(rated.deflection_m * 1e3, 3),
                        significant(rated.reaction_n / 1e3, 3),
                        significant(rated.energy_j / 1e3, 3))))
                }
                (FenderLaw::Area, None) => {
                    (number(&format!("{} kN/m²",
                        plain(material.material.stiffness_npm2 / 1e3, 4))))
                }
                (FenderLaw::Curve(_), None) => (number("–")),
            }
            @match fender.stop {
                Some(stop) => {
                    (number(&format!("{}, {}",
                        significant(stop.from_m * 1e3, 3),
                        significant(stop.stiffness_npm / 1e6, 3))))
                }
                None => (number("–")),
            }
        }
    }
}
