//! Reads a vessel's wind areas, and the method that computes wind forces from the areas.

use fenderline_sim::environment::wind::{
    BLENDERMANN_TYPES, Blendermann, Fujiwara, Isherwood, ShipWindage, WindMethod,
};
use fenderline_sim::hydro::Particulars;

use super::assembly::{Assembly, Checked};
use fenderline_keys::checked::{Entry, Of};
use fenderline_keys::held::{Number, TableOf};
use fenderline_keys::keys::windage::{METHODS, WindageKey, WindageMethod};
use fenderline_keys::sources::quoted;
use fenderline_keys::suggest::nearest;
use fenderline_keys::typed_key::Key;

impl Assembly<'_, '_> {
    pub(super) fn windage<T>(
        &self,
        vessel: Of<'_, T>,
        key: Key<T, TableOf<WindageKey>>,
        ship: &Particulars,
    ) -> Checked<Option<ShipWindage>> {
        let Some(item) = vessel.item(key) else { return Ok(None) };
        let of = item.table();
        let method = of.given(WindageKey::METHOD).choice();
        self.only_particulars_of(of, item, method)?;
        let number = |name: Key<_, Number>| *of.given(name).number();
        let windage = ShipWindage {
            length_m: of
                .item(WindageKey::LENGTH_OVERALL)
                .map_or(ship.length_m, |item| *item.number()),
            beam_m: ship.beam_m,
            frontal_m2: number(WindageKey::FRONTAL_AREA),
            lateral_m2: number(WindageKey::LATERAL_AREA),
            centroid_forward_m: number(WindageKey::CENTROID_FORWARD),
            centroid_height_m: number(WindageKey::CENTROID_HEIGHT),
            method: match method {
                WindageMethod::Blendermann => WindMethod::Blendermann(self.blendermann(of)?),
                WindageMethod::Isherwood => WindMethod::Isherwood(Isherwood {
                    perimeter_m: number(WindageKey::PERIMETER),
                    superstructure_m2: number(WindageKey::SUPERSTRUCTURE_AREA),
                    mast_groups: number(WindageKey::MAST_GROUPS),
                }),
                WindageMethod::Fujiwara => WindMethod::Fujiwara(Fujiwara {
                    on_deck_m2: number(WindageKey::DECK_AREA),
                    on_deck_forward_m: number(WindageKey::DECK_CENTROID_FORWARD),
                    top_height_m: number(WindageKey::TOP_HEIGHT),
                }),
            },
        };
        windage.check().map_err(|error| self.refused(vessel, item, &error))?;
        Ok(Some(windage))
    }

    /// Checks that a table of wind areas has all particulars that its method needs, and no particulars of another
    /// method.
    fn only_particulars_of<V>(
        &self,
        of: Of<'_, WindageKey>,
        windage: Entry<'_, V>,
        method: WindageMethod,
    ) -> Checked<()> {
        let name = of.given(WindageKey::METHOD).word();
        for foreign in METHODS.0.iter().filter(|foreign| foreign.value != method) {
            let other = foreign.word;
            for &key in foreign.value.keys() {
                if let Some(item) = of.item(key) {
                    let path = of.path_of(key);
                    let message = format!(
                        "`{path}` is for the method \"{other}\", not for the method \"{name}\""
                    );
                    let error = self.sources.error(&item.key_span, &path, message);
                    return Err(
                        error.with_help(format!("remove it, or write method = \"{other}\""))
                    );
                }
            }
        }
        match method.keys().iter().find(|key| of.item(**key).is_none()) {
            None => Ok(()),
            Some(&key) => {
                let path = of.path_of(key);
                let message = format!("`{path}` is missing; the method \"{name}\" needs this key");
                let error = self.sources.error(&windage.span, &path, message);
                let example = of.spec.key(key.name()).and_then(|key| key.examples.first());
                Err(match example {
                    Some(example) => error.with_help(format!("write {key} = {example}")),
                    None => error,
                })
            }
        }
    }

    fn blendermann(&self, of: Of<'_, WindageKey>) -> Checked<Blendermann> {
        let kind = of.given(WindageKey::TYPE);
        Blendermann::of_type(kind.text()).ok_or_else(|| {
            let names = BLENDERMANN_TYPES.map(|kind| kind.name);
            let path = of.path_of(WindageKey::TYPE);
            let message = format!("`{path}`: there is no type {}", quoted(kind.text()));
            let error = self.sources.error(&kind.span, &path, message);
            error.with_help(match nearest(kind.text(), names) {
                Some(near) => format!("did you mean \"{near}\"?"),
                None => format!("there are \"{}\"", names.join("\", \"")),
            })
        })
    }
}
