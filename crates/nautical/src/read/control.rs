//! Orders of a controller that steers a ship: HTC, HSC, APB, ROR, PRC and TRC.
//!
//! The fields are those of public descriptions. HTC: the interfaces `HTCSentence` and `SteeringMode` of Java Marine API.
//! PRC and TRC: Furuno's manual of VR-7000, pages 106 and 108 of its English appendix. ROR: Furuno's manual of FMD-3100,
//! appendix 3. HSC and APB: gpsd's description of NMEA. Only recalled are that a negative angle in ROR turns the bow to port, and that HTC
//! may end with a status flag as TRC does. IEC 61162-1 was not read, and no conformity to the standard is claimed.

use super::fields::{Fields, SentenceFault};

/// The demand on an engine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum EngineDemand {
    /// Share of the full demand, from −1 (full astern) to 1 (full ahead).
    Share(f64),
    /// Revolutions (1/min), negative astern.
    Revolutions(f64),
}

/// An order of a controller.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ControlOrder {
    /// HTC in mode H, HSC, APB: keep a heading from true north (°), from 0 to 360.
    Heading(f64),
    /// HTC in mode R, ROR: put the rudder to an angle (°), positive to starboard.
    Rudder(f64),
    /// HTC in mode M or with override: people steer by hand, so that the controller gives the helm back.
    Release,
    /// PRC: a demand on the engine of a number; 0 for a ship with one engine, odd to starboard, even to port.
    Engine {
        /// Number of the engine.
        number: u32,
        /// The demand.
        demand: EngineDemand,
    },
    /// TRC: a demand on the thruster of a number; odd for bow thrusters, even for stern thrusters.
    Thruster {
        /// Number of the thruster, from 1.
        number: u32,
        /// Share of the thruster's greatest thrust, from −1 (to port) to 1 (to starboard).
        share: f64,
        /// Direction of the thrust from the bow (°), from 0 to 360 clockwise; `None` for a thruster that does not turn.
        azimuth_deg: Option<f64>,
    },
}

/// The content of a sentence for a ship that takes orders.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Control {
    /// An order.
    Order(ControlOrder),
    /// A sentence of a controller that reports a state and orders nothing.
    Report,
    /// A sentence of another kind.
    Other,
}

/// Reads the body of a sentence, as [`super::body_of`] returns it.
///
/// # Errors
/// Names a field that does not hold what the format says, or that asks for something that a ship here cannot do: a
/// magnetic heading, track control, a pitch in degrees.
pub fn control(body: &str) -> Result<Control, SentenceFault> {
    let (kind, fields) = Fields::of(body);
    match kind {
        "HTC" => htc(&fields),
        "HSC" => hsc(&fields),
        "APB" => apb(&fields),
        "ROR" => ror(&fields),
        "PRC" => prc(&fields),
        "TRC" => trc(&fields),
        _ => Ok(Control::Other),
    }
}

/// A number that a field must have, between limits.
fn within(
    fields: &Fields<'_>,
    index: usize,
    name: &'static str,
    [least, most]: [f64; 2],
) -> Result<f64, SentenceFault> {
    let value = fields.number(index, name)?;
    let value = value.filter(|value| (least..=most).contains(value));
    value.ok_or(SentenceFault::Field(name))
}

/// The order in a sentence whose status flag is `flag`. A sentence with the flag `R` reports the present setting.
fn unless_reported(flag: &str, order: ControlOrder) -> Result<Control, SentenceFault> {
    match flag {
        "" | "C" => Ok(Control::Order(order)),
        "R" => Ok(Control::Report),
        _ => Err(SentenceFault::Field("sentence status flag")),
    }
}

/// A heading from true north, with the field that says so.
fn true_heading(
    fields: &Fields<'_>,
    at: usize,
    reference: usize,
) -> Result<ControlOrder, SentenceFault> {
    if fields.at(reference) != "T" {
        return Err(SentenceFault::Field("heading reference"));
    }
    within(fields, at, "heading to steer", [0.0, 360.0]).map(ControlOrder::Heading)
}

fn htc(fields: &Fields<'_>) -> Result<Control, SentenceFault> {
    let order = match (fields.at(0), fields.at(3)) {
        // Override: somebody steers by other means.
        ("A", _) | ("V", "M") => ControlOrder::Release,
        ("V", "H") => true_heading(fields, 9, 12)?,
        ("V", "R") => {
            let angle_deg = within(fields, 1, "rudder angle", [0.0, 90.0])?;
            match fields.at(2) {
                "R" => ControlOrder::Rudder(angle_deg),
                "L" => ControlOrder::Rudder(-angle_deg),
                _ => return Err(SentenceFault::Field("rudder direction")),
            }
        }
        // Stand-alone: the heading in the sentence is no input.
        ("V", "S") => return Ok(Control::Report),
        ("V", _) => return Err(SentenceFault::Field("steering mode")),
        _ => return Err(SentenceFault::Field("override")),
    };
    unless_reported(fields.at(13), order)
}

fn hsc(fields: &Fields<'_>) -> Result<Control, SentenceFault> {
    unless_reported(fields.at(4), true_heading(fields, 0, 1)?)
}

/// The heading to steer of APB. The cross-track distance in the sentence is not used.
fn apb(fields: &Fields<'_>) -> Result<Control, SentenceFault> {
    if fields.at(0) != "A" || fields.at(1) != "A" {
        return Ok(Control::Report);
    }
    true_heading(fields, 12, 13).map(Control::Order)
}

/// The order to the single or the starboard rudder.
fn ror(fields: &Fields<'_>) -> Result<Control, SentenceFault> {
    if fields.at(1) != "A" {
        return Ok(Control::Report);
    }
    let angle_deg = within(fields, 0, "rudder order", [-90.0, 90.0])?;
    Ok(Control::Order(ControlOrder::Rudder(angle_deg)))
}

/// The demand of the lever; without a valid lever, the demanded revolutions. The demanded pitch is not used.
fn prc(fields: &Fields<'_>) -> Result<Control, SentenceFault> {
    let percent = |index, name| Ok(within(fields, index, name, [-100.0, 100.0])? / 100.0);
    let demand = match (fields.at(1), fields.at(3)) {
        ("A", _) => EngineDemand::Share(percent(0, "lever demand")?),
        (_, "P") => EngineDemand::Share(percent(2, "revolutions demand")?),
        (_, "R") => {
            let revolutions = within(fields, 2, "revolutions demand", [-9999.9, 9999.9])?;
            EngineDemand::Revolutions(revolutions)
        }
        _ => return Ok(Control::Report),
    };
    let number = fields.at(7).parse().map_err(|_| SentenceFault::Field("number of engine"))?;
    Ok(Control::Order(ControlOrder::Engine { number, demand }))
}

/// The thrust that revolutions and pitch in percent ask for: the only one that is given, or the product of both.
fn trc(fields: &Fields<'_>) -> Result<Control, SentenceFault> {
    if fields.at(7) != "C" {
        return Ok(Control::Report);
    }
    let share = |at: usize, name, of_mode| match fields.at(at + 1) {
        "P" => Ok(Some(within(fields, at, name, [-100.0, 100.0])? / 100.0)),
        "" | "V" => Ok(None),
        _ => Err(SentenceFault::Field(of_mode)),
    };
    let revolutions = share(1, "revolutions demand", "mode of revolutions")?;
    let share = match (revolutions, share(3, "pitch demand", "mode of pitch")?) {
        (Some(revolutions), Some(pitch)) => revolutions * pitch,
        (Some(share), None) | (None, Some(share)) => share,
        (None, None) => return Ok(Control::Report),
    };
    let azimuth_deg = match fields.at(5) {
        "" => None,
        _ => Some(within(fields, 5, "azimuth demand", [0.0, 360.0])?),
    };
    let number = fields.at(0).parse().ok().filter(|number| (1..=99).contains(number));
    let number = number.ok_or(SentenceFault::Field("number of thruster"))?;
    Ok(Control::Order(ControlOrder::Thruster { number, share, azimuth_deg }))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn order(body: &str) -> ControlOrder {
        match control(body) {
            Ok(Control::Order(order)) => order,
            other => panic!("{body}: {other:?}"),
        }
    }

    #[test]
    fn each_order_is_read() {
        let heading = ControlOrder::Heading(274.5);
        for (body, expected) in [
            ("IIHTC,V,,,H,N,35.0,10.0,,,274.5,,,T", heading),
            ("IIHTC,V,,,H,N,,,,,274.5,,,T,C", heading),
            ("IIHTC,V,12.5,L,R,N,,,,,,,,T", ControlOrder::Rudder(-12.5)),
            ("IIHTC,V,12.5,R,R,N,,,,,,,,T", ControlOrder::Rudder(12.5)),
            ("IIHTC,V,,,M,N,,,,,,,,T", ControlOrder::Release),
            ("IIHTC,A,5.0,R,H,N,,,,,274.5,,,T", ControlOrder::Release),
            ("IIHSC,274.5,T,,M", heading),
            ("ECAPB,A,A,0.10,R,N,V,V,011.0,T,DEST,011.0,T,274.5,T", heading),
            ("IIROR,-7.5,A,,V,B", ControlOrder::Rudder(-7.5)),
            (
                "IIPRC,-40.0,A,,,,,B,0",
                ControlOrder::Engine { number: 0, demand: EngineDemand::Share(-0.4) },
            ),
            (
                "IIPRC,,V,55.0,R,,V,B,1",
                ControlOrder::Engine { number: 1, demand: EngineDemand::Revolutions(55.0) },
            ),
            (
                "IIPRC,,V,25,P,,V,B,0",
                ControlOrder::Engine { number: 0, demand: EngineDemand::Share(0.25) },
            ),
            (
                "IITRC,1,,V,-50.0,P,,B,C",
                ControlOrder::Thruster { number: 1, share: -0.5, azimuth_deg: None },
            ),
            (
                "IITRC,2,50.0,P,50.0,P,270.0,B,C",
                ControlOrder::Thruster { number: 2, share: 0.25, azimuth_deg: Some(270.0) },
            ),
        ] {
            assert_eq!(order(body), expected, "{body}");
        }
    }

    #[test]
    fn a_report_orders_nothing() {
        for body in [
            "IIHTC,V,,,S,N,,,,,274.5,,,T",
            "IIHTC,V,,,H,N,,,,,274.5,,,T,R",
            "ECAPB,V,A,0.10,R,N,V,V,011.0,T,DEST,011.0,T,274.5,T",
            "IIROR,-7.5,V,,V,B",
            "IIPRC,,V,,V,,V,B,0",
            "IITRC,1,50.0,P,,V,,B,R",
            "IITRC,1,50.0,P,,V,,B",
            "IITRC,1,,V,,V,,B,C",
        ] {
            assert_eq!(control(body), Ok(Control::Report), "{body}");
        }
        for body in ["GPRMC,123519,A", "", "HTC", "IIHTCX,V", "\u{e9}IHTC"] {
            assert_eq!(control(body), Ok(Control::Other), "{body}");
        }
    }

    #[test]
    fn a_field_that_cannot_be_obeyed_is_named() {
        for (body, name) in [
            ("IIHTC,V,,,H,N,,,,,274.5,,,M", "heading reference"),
            ("IIHTC,V,,,H,N,,,,,NaN,,,T", "heading to steer"),
            ("IIHTC,V,,,H,N,,,,,inf,,,T", "heading to steer"),
            ("IIHTC,V,,,H,N,,,,,-1,,,T", "heading to steer"),
            ("IIHTC,V,,,H,N,,,,,361,,,T", "heading to steer"),
            ("IIHTC,V,,,H,N,,,,,,,,T", "heading to steer"),
            ("IIHTC,V,,,T,N,,,,,274.5,,90.0,T", "steering mode"),
            ("IIHTC,,,,H,N,,,,,274.5,,,T", "override"),
            ("IIHTC", "override"),
            ("IIHTC,V,12.5,,R,N,,,,,,,,T", "rudder direction"),
            ("IIHTC,V,-12.5,L,R,N,,,,,,,,T", "rudder angle"),
            ("IIHTC,V,,,H,N,,,,,274.5,,,T,X", "sentence status flag"),
            ("IIROR,99,A,,V,B", "rudder order"),
            ("IIROR,nan,A,,V,B", "rudder order"),
            ("IIPRC,101,A,,,,,B,0", "lever demand"),
            ("IIPRC,50,A,,,,,B,", "number of engine"),
            ("IITRC,1,900,R,,V,,B,C", "mode of revolutions"),
            ("IITRC,1,,V,12,D,,B,C", "mode of pitch"),
            ("IITRC,0,50,P,,V,,B,C", "number of thruster"),
            ("IITRC,1,50,P,,V,400,B,C", "azimuth demand"),
        ] {
            assert_eq!(control(body), Err(SentenceFault::Field(name)), "{body}");
        }
    }
}
