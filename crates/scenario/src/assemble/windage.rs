//! A vessel's wind areas, and the method that computes wind forces from them.

use fenderline_sim::environment::wind::{
    BLENDERMANN_TYPES, Blendermann, Fujiwara, Isherwood, ShipWindage, WindMethod,
};
use fenderline_sim::hydro::Particulars;

use super::assembly::{Assembly, Checked};
use fenderline_keys::checked::{Item, Table};
use fenderline_keys::keys::windage::{METHODS, WindageMethod};
use fenderline_keys::sources::quoted;
use fenderline_keys::suggest::nearest;

impl Assembly<'_, '_> {
    pub(super) fn windage(
        &self,
        vessel: &Table,
        ship: &Particulars,
    ) -> Checked<Option<ShipWindage>> {
        let Some(item) = vessel.item("windage") else { return Ok(None) };
        let of = item.table();
        let method = of.given("method").choice();
        self.only_particulars_of(of, item, method)?;
        let number = |name: &str| *of.given(name).number();
        let windage = ShipWindage {
            length_m: of.item("length_overall").map_or(ship.length_m, |item| *item.number()),
            beam_m: ship.beam_m,
            frontal_m2: number("frontal_area"),
            lateral_m2: number("lateral_area"),
            centroid_forward_m: number("centroid_forward"),
            centroid_height_m: number("centroid_height"),
            method: match method {
                WindageMethod::Blendermann => WindMethod::Blendermann(self.blendermann(of)?),
                WindageMethod::Isherwood => WindMethod::Isherwood(Isherwood {
                    perimeter_m: number("perimeter"),
                    superstructure_m2: number("superstructure_area"),
                    mast_groups: number("mast_groups"),
                }),
                WindageMethod::Fujiwara => WindMethod::Fujiwara(Fujiwara {
                    on_deck_m2: number("deck_area"),
                    on_deck_forward_m: number("deck_centroid_forward"),
                    top_height_m: number("top_height"),
                }),
            },
        };
        windage.check().map_err(|error| self.refused(vessel, item, &error))?;
        Ok(Some(windage))
    }

    /// Checks that the table has all particulars of its method, and no particulars of another method.
    fn only_particulars_of(
        &self,
        of: &Table,
        windage: &Item,
        method: WindageMethod,
    ) -> Checked<()> {
        let name = of.given("method").word();
        for foreign in METHODS.0.iter().filter(|foreign| foreign.value != method) {
            let other = foreign.word;
            for key in foreign.value.keys() {
                if let Some(item) = of.item(key) {
                    let path = of.path_of(key);
                    let message = format!("`{path}` is for the method \"{other}\", not \"{name}\"");
                    let error = self.sources.error(&item.key_span, &path, message);
                    return Err(
                        error.with_help(format!("remove it, or write method = \"{other}\""))
                    );
                }
            }
        }
        match method.keys().iter().find(|key| of.item(key).is_none()) {
            None => Ok(()),
            Some(key) => {
                let path = of.path_of(key);
                let message = format!("`{path}` is missing; the method \"{name}\" needs it");
                let error = self.sources.error(&windage.span, &path, message);
                let example = of.spec.key(key).and_then(|key| key.examples.first());
                Err(match example {
                    Some(example) => error.with_help(format!("write {key} = {example}")),
                    None => error,
                })
            }
        }
    }

    fn blendermann(&self, of: &Table) -> Checked<Blendermann> {
        let kind = of.given("type");
        Blendermann::of_type(kind.text()).ok_or_else(|| {
            let names = BLENDERMANN_TYPES.map(|kind| kind.name);
            let path = of.path_of("type");
            let message = format!("`{path}`: there is no type {}", quoted(kind.text()));
            let error = self.sources.error(&kind.span, &path, message);
            error.with_help(match nearest(kind.text(), names) {
                Some(near) => format!("did you mean \"{near}\"?"),
                None => format!("there are \"{}\"", names.join("\", \"")),
            })
        })
    }
}
