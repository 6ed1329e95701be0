//! The report's table of the fenders as the scenario set them.

use fenderline_contact::FenderLaw;
use fenderline_sim::{FenderSetup, Setup};
use maud::{Markup, html};

use crate::plot::{plain, significant};
use crate::run_page::signed::signed;
use crate::run_page::tables::{ROWS, more, number};
use crate::table::breakable;
use crate::{Head, table_head};

/// The table with one row per fender: position, size and rating.
pub(in crate::run_page) fn setup_table(setup: &Setup) -> Markup {
    let material = |fender: &FenderSetup| setup.materials[fender.material].name.as_str();
    let one_material = setup.fenders.iter().all(|f| f.material == setup.fenders[0].material);
    html! {
        div class="wide" {
            table {
                (table_head(&[
                    Head::Number("No.", ""),
                    Head::Name("Fender"),
                    Head::Text("On", if one_material { "" } else { "material" }),
                    Head::Number("Position", "forward, starboard, m"),
                    Head::Number("Facing", "deg"),
                    Head::Number("Height", "of the middle, m"),
                    Head::Number("Face", "width × height, m"),
                    Head::Number("Projection", "m"),
                    Head::Number("Rated", "mm, kN, kJ"),
                    Head::Number("Stop", "from mm, MN/m"),
                ]))
                tbody {
                    @for (index, fender) in setup.fenders.iter().enumerate().take(ROWS) {
                        (row(index, fender, setup, one_material))
                    }
                }
            }
        }
        (more(setup.fenders.len()))
        p class="note" {
            @if one_material && !setup.fenders.is_empty() { "Material of all: " (material(&setup.fenders[0])) ". " }
            "Position and facing are in the axes of the body that carries the fender; heights are \
             above datum on a fixed body, and above the water on a floating body. Ratings are \
             without factors; the rated energy is the integral of the reaction."
        }
    }
}

fn row(index: usize, fender: &FenderSetup, setup: &Setup, one_material: bool) -> Markup {
    let material = &setup.materials[fender.material];
    html! {
        tr {
            (number(&(index + 1).to_string()))
            td class="name" { (breakable(&fender.name)) }
            td {
                (setup.bodies[fender.body].name)
                @if !one_material { small { (material.name) } }
            }
            (number(&format!("{}, {}",
                plain(fender.position_m.x, 5), plain(fender.position_m.y, 5))))
            (number(&plain(fender.facing_rad.to_degrees(), 4)))
            (number(&signed(fender.above_water_m)))
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
