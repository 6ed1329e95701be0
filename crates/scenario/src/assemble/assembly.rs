//! What all parts of the assembly of a set-up share: the sources of the scenario file, the names in the file, and the
//! warnings about the file.

use std::collections::BTreeMap;

use fenderline_sim::{BodySetup, NamedMaterial};

use crate::files::Files;
use fenderline_keys::checked::{Entry, Of};
use fenderline_keys::error::{Notice, ScenarioError};
use fenderline_keys::held::Name;
use fenderline_keys::sources::{Sources, quoted};
use fenderline_keys::suggest::nearest;
use fenderline_keys::typed_key::Key;

pub(super) type Checked<T> = Result<T, ScenarioError>;

/// The names of bodies and materials, to which pairs and loads refer.
pub(super) struct Names {
    pub(super) bodies: BTreeMap<String, usize>,
    pub(super) materials: BTreeMap<String, usize>,
}

impl Names {
    pub(super) fn new(bodies: &[BodySetup], materials: &[NamedMaterial]) -> Names {
        let numbered = |names: &mut dyn Iterator<Item = &String>| {
            names.enumerate().map(|(index, name)| (name.clone(), index)).collect()
        };
        Names {
            bodies: numbered(&mut bodies.iter().map(|body| &body.name)),
            materials: numbered(&mut materials.iter().map(|material| &material.name)),
        }
    }
}

pub(super) struct Assembly<'s, 'a> {
    pub(super) sources: &'s Sources<'a>,
    pub(super) files: &'s Files,
    pub(super) notices: &'s mut Vec<Notice>,
}

impl Assembly<'_, '_> {
    pub(super) fn body_named<T, V>(
        &self,
        table: Of<'_, T>,
        item: Entry<'_, V>,
        name: &str,
        names: &Names,
    ) -> Checked<usize> {
        self.reference("body", "bodies", &names.bodies, table, item, name)
    }

    /// The floating body that a key names; the text `why` says in the error for a fixed body what a fixed body cannot
    /// do.
    pub(super) fn floating_body<T>(
        &self,
        table: Of<'_, T>,
        key: Key<T, Name>,
        bodies: &[BodySetup],
        names: &Names,
        why: &str,
    ) -> Checked<usize> {
        let item = table.given(key);
        let body = self.body_named(table, item, item.name(), names)?;
        if bodies[body].mass.is_none() {
            let path = table.path_of(key);
            let message = format!("`{path}`: body {} is fixed, {why}", quoted(item.name()));
            return Err(self.sources.error(&item.span, &path, message));
        }
        Ok(body)
    }

    pub(super) fn material_named<T>(
        &self,
        table: Of<'_, T>,
        item: Entry<'_, Name>,
        names: &Names,
    ) -> Checked<usize> {
        self.reference("material", "materials", &names.materials, table, item, item.name())
    }

    pub(super) fn reference<T, V>(
        &self,
        kind: &str,
        kinds: &str,
        known: &BTreeMap<String, usize>,
        table: Of<'_, T>,
        item: Entry<'_, V>,
        name: &str,
    ) -> Checked<usize> {
        known.get(name).copied().ok_or_else(|| {
            let path = table.path_to(item);
            let message = format!("`{path}`: there is no {kind} {}", quoted(name));
            let error = self.sources.error(&item.span, &path, message);
            error.with_help(match nearest(name, known.keys().map(String::as_str)) {
                Some(near) => format!("did you mean \"{near}\"?"),
                None if known.is_empty() => format!("the scenario has no {kinds}"),
                None => format!(
                    "the scenario has the {kinds} {}",
                    listed(known.keys().map(String::as_str))
                ),
            })
        })
    }
}

/// The first few names of a list, in quotes, for a message.
pub(super) fn listed<'n>(names: impl Iterator<Item = &'n str> + Clone) -> String {
    const SHOWN: usize = 8;
    let left_out = names.clone().count().saturating_sub(SHOWN);
    let shown = names.take(SHOWN).map(quoted).collect::<Vec<_>>().join(", ");
    if left_out == 0 { shown } else { format!("{shown} and {left_out} more") }
}
