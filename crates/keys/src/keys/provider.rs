//! Keys of external programs that apply forces to bodies.

use super::load::FLOATING_BODY;
use super::quantities::TIME;
use crate::held::{Name, Number, Texts};
use crate::spec::Absent::{Is, Refused};
use crate::spec::{Kind, Quantity, TableSpec, key};
use crate::table_keys;
use crate::units::measures as unit;

pub(super) static PROVIDER: TableSpec = TableSpec {
    what: "a provider",
    doc: "An external program that applies a force to a body. The external program is started when \
        the run starts. In each step the external program gets one line of JSON on its standard \
        input and answers with one line on its standard output (examples/provider has an example \
        in Python).",
    keys: ProviderKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a provider.
    pub ProviderKey {
        BODY: Name = FLOATING_BODY,
        COMMAND: Texts = key(
            "command",
            Kind::Texts,
            Refused,
            "The external program and its arguments. Relative paths in the command start from the \
             folder in which the run was started.",
            &["[\"python3\", \"examples/provider/drag.py\"]"],
        ),
        TIMEOUT: Number = key(
            "timeout",
            Kind::Quantity(Quantity { measure: &unit::TIME, low: 1e-3, high: 3600.0 }),
            Is("1"),
            "Longest time that a step waits for the external program's answer.",
            &["\"0.5 s\""],
        ),
        HOLD: Number = key(
            "hold",
            Kind::Quantity(TIME),
            Is("5"),
            "How long the last force stays in effect if the external program's answers stop; \
             afterwards there is no force.",
            &["\"2 s\""],
        ),
    }
}
