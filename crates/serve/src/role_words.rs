//! Roles in words.

use fenderline_live::message::Role;

/// The words for a role in the list of links and in people's labels.
pub(crate) fn role_words(role: &Role) -> String {
    match role {
        Role::Instructor => "instructor".to_owned(),
        Role::Pilot { vessel: None } => "pilot".to_owned(),
        Role::Pilot { vessel: Some(ship) } => format!("pilot of {ship}"),
        Role::Tugmaster { tug } => format!("master of {tug}"),
        Role::Observer => "observer".to_owned(),
    }
}
