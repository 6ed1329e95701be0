//! Writes a fitted fender as a file of the fender library.

use core::fmt::Write as _;

use super::curves::Branch;
use super::fitted::FittedFender;
use super::options::FitOptions;

impl FittedFender {
    /// The text of the fitted fender as a file of the fender library.
    #[must_use]
    pub fn to_toml(&self) -> String {
        let FitOptions { family, designation, height_m, length_m, source, standing, .. } =
            &self.options;
        let family = quoted(family);
        let origin = format!("source = {}\nstanding = \"{}\"\n", quoted(source), standing.word());
        let mut text = format!(
            "# Fitted by `fenderline fender fit`.\n\n[family.{family}]\nrated_deflection = {}\nreference = {}\n",
            number(self.rated_deflection_m / height_m),
            quoted(designation),
        );
        let mut table = |title: &str, comment: &str, points: &Branch| {
            if !points.is_empty() {
                let _ = write!(text, "\n[family.{family}.{title}]\n# {comment}\npoints = [\n");
                text.push_str(&rows(points));
                let _ = write!(text, "]\n{origin}");
            }
        };
        table("curve", "[deflection over height, reaction over rated reaction]", &self.points);
        table(
            "unloading",
            "[deflection over height, reaction over rated reaction]",
            &self.unloading,
        );
        table("temperature", "[degrees Celsius, factor on the reaction]", &self.temperature);
        table(
            "velocity",
            "[time to rated deflection in s, factor on the reaction]",
            &self.velocity,
        );
        if let Some(share) = self.options.returned_energy {
            let _ = write!(
                text,
                "\n[family.{family}.unloading]\nreturned_energy = {}\n{origin}",
                number(share)
            );
        }
        let _ = write!(
            text,
            "\n[[family.{family}.size]]\ndesignation = {}\nheight = \"{} m\"\n",
            quoted(designation),
            number(*height_m)
        );
        if let Some(length_m) = length_m {
            let _ = writeln!(text, "length = \"{} m\"", number(*length_m));
        }
        let _ = write!(text, "reaction = \"{} N\"\n{origin}", number(self.rated_reaction_n));
        text
    }
}

/// A number with six digits, which is finer than any test bench measures.
fn number(value: f64) -> String {
    let rounded: f64 = format!("{value:.5e}").parse().unwrap_or(value);
    format!("{rounded}")
}

fn rows(points: &Branch) -> String {
    points.iter().map(|(d, r)| format!("    [{}, {}],\n", number(*d), number(*r))).collect()
}

/// A text in quotation marks, as a basic string of TOML.
fn quoted(text: &str) -> String {
    let mut quoted = String::from('"');
    for letter in text.chars() {
        match letter {
            '"' | '\\' => {
                quoted.push('\\');
                quoted.push(letter);
            }
            control if control.is_control() => {
                let _ = write!(quoted, "\\u{:04X}", u32::from(control));
            }
            other => quoted.push(other),
        }
    }
    quoted.push('"');
    quoted
}
