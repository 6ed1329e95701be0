//! The messages between the program and a force provider, one line of JSON each:
//!
//! | sender | line |
//! |---|---|
//! | program, once | `{"fenderline": 1, "body": "ship", "step_s": 0.1}` |
//! | program, each step | `{"n": 0, "t_s": 0.0, "step_s": 0.1, "x_m": …, "y_m": …, "heading_rad": …, "u_mps": …, "v_mps": …, "r_radps": …}` |
//! | provider, each step | `{"n": 0, "force_n": [north, east], "moment_nm": …}` or `{"n": 0, "body_force_n": [forward, starboard], "moment_nm": …}` |
//!
//! `n` counts the questions. An answer repeats `n`, so that a late answer is recognised. u and v are in the body's
//! axes; moments are about the body's centre of gravity, positive to starboard.

use fenderline_contact::{Rotation, Vec2, Wrench, vec2};
use fenderline_sim::external::ForceRequest;
use serde_json::{Value, json};

/// The version of this protocol.
const VERSION: u32 = 1;

pub(super) fn hello(body: &str, step_s: f64) -> String {
    json!({ "fenderline": VERSION, "body": body, "step_s": step_s }).to_string()
}

pub(super) fn question(n: u64, question: &ForceRequest) -> String {
    let state = &question.state;
    let own = Rotation::from_angle(state.heading_rad).apply_inverse(state.velocity_mps);
    json!({
        "n": n,
        "t_s": question.t_s,
        "step_s": question.step_s,
        "x_m": state.position_m.x,
        "y_m": state.position_m.y,
        "heading_rad": state.heading_rad,
        "u_mps": own.x,
        "v_mps": own.y,
        "r_radps": state.yaw_rate_radps,
    })
    .to_string()
}

/// Number and wrench of an answer; `None` if the line is no answer.
pub(super) fn answer(line: &str, asked: &ForceRequest) -> Option<(u64, Wrench)> {
    let value: Value = serde_json::from_str(line).ok()?;
    let n = value["n"].as_u64()?;
    let moment_nm = match &value["moment_nm"] {
        Value::Null => 0.0,
        moment => moment.as_f64()?,
    };
    let force_n = match (&value["force_n"], &value["body_force_n"]) {
        (Value::Null, Value::Null) => Vec2::ZERO,
        (force, Value::Null) => two(force)?,
        (Value::Null, own) => {
            let own = two(own)?;
            earth_fixed(asked, own.x, own.y)
        }
        _ => return None,
    };
    Some((n, Wrench { force_n, moment_nm }))
}

/// Turns a force in a body's axes into earth-fixed axes.
fn earth_fixed(question: &ForceRequest, forward_n: f64, starboard_n: f64) -> Vec2 {
    let own = vec2(forward_n, starboard_n);
    Rotation::from_angle(question.state.heading_rad).apply(own)
}

fn two(value: &Value) -> Option<Vec2> {
    match value.as_array()?.as_slice() {
        [x, y] => Some(vec2(x.as_f64()?, y.as_f64()?)),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use fenderline_contact::BodyState;

    #[test]
    fn answers_are_read_in_both_frames_and_other_lines_are_ignored() {
        let state = BodyState { heading_rad: core::f64::consts::FRAC_PI_2, ..Default::default() };
        let asked = ForceRequest { t_s: 0.0, step_s: 0.1, state };
        let (n, wrench) =
            answer(r#"{"n": 3, "force_n": [1, 2], "moment_nm": 4}"#, &asked).expect("an answer");
        assert_eq!((n, wrench.force_n, wrench.moment_nm), (3, vec2(1.0, 2.0), 4.0));
        let (_, own) = answer(r#"{"n": 3, "body_force_n": [1, 0]}"#, &asked).expect("an answer");
        assert!((own.force_n - vec2(0.0, 1.0)).length() < 1e-15);
        for line in [
            "",
            "NaN",
            "{}",
            "[]",
            r#"{"n": -1}"#,
            r#"{"n": 0, "force_n": [1]}"#,
            r#"{"n": 0, "force_n": ["a", 1]}"#,
            r#"{"n": 0, "force_n": [1, 1], "body_force_n": [1, 1]}"#,
        ] {
            assert_eq!(answer(line, &asked), None, "{line}");
        }
    }
}
