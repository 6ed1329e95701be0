//! The findings that a run can have.

use super::Verdict;
use super::law::Departure;
use fenderline_contact::Vec2;
use fenderline_ship::anchor::LostBy;
use fenderline_world::chain::ChainKind;
use fenderline_world::named::called;
use fenderline_world::setup::Setup;

/// Something that a run revealed, with indices into the [`Setup`] of the bodies, fenders, lines or vessels concerned.
#[derive(Clone, Debug, PartialEq)]
pub enum Finding {
    /// A hull touched a structure without a fender between them.
    StructureStruck {
        /// The two bodies.
        bodies: [usize; 2],
        /// Start of the first step in which the hull touched the structure (s).
        first_s: f64,
        /// How long the hull touched the structure (s).
        lasting_s: f64,
        /// Peak normal force (N).
        peak_force_n: f64,
        /// Peak penetration (m).
        peak_depth_m: f64,
    },
    /// A fender was compressed to its stop, or to its whole projection.
    FenderFailed {
        /// The fender.
        fender: usize,
        /// Start of the step with the peak deflection (s).
        at_s: f64,
        /// Peak deflection (m).
        deflection_m: f64,
    },
    /// A chain of a fender parted.
    ChainParted {
        /// The fender.
        fender: usize,
        /// The kind of chain.
        kind: ChainKind,
        /// Start of the step in which the chain parted (s).
        at_s: f64,
        /// The tension at which the chain parted (N).
        tension_n: f64,
    },
    /// The pile of a flexible dolphin yielded.
    PileYielded {
        /// The dolphin.
        body: usize,
        /// Start of the first step in which the pile yielded (s).
        first_s: f64,
        /// Yield load of the pile (N).
        load_n: f64,
        /// Permanent deflection (m).
        offset_m: f64,
    },
    /// A line parted.
    LineParted {
        /// The line.
        line: usize,
        /// Time at which the line parted (s).
        at_s: f64,
        /// The tension at which the line parted (N).
        tension_n: f64,
    },
    /// An anchor was lost with its chain.
    AnchorLost {
        /// The anchor.
        anchor: usize,
        /// Time at which the anchor was lost (s).
        at_s: f64,
        /// What caused the loss of the anchor: the chain parted, ran out or was slipped.
        by: LostBy,
        /// Tension of the anchor's chain (N).
        tension_n: f64,
    },
    /// An anchor dragged more than 10 m.
    AnchorDragged {
        /// The anchor.
        anchor: usize,
        /// Start of the first step in which the anchor dragged (s).
        first_s: f64,
        /// How far the anchor dragged (m).
        dragged_m: f64,
    },
    /// Two bodies started inside each other, or a fender started beyond its rated deflection (without a rating, beyond
    /// half its projection).
    StartInside {
        /// The two bodies.
        bodies: [usize; 2],
        /// The fender between the bodies, if there is one.
        fender: Option<usize>,
        /// Penetration of the hull into the structure, or deflection of the fender, at the start (m).
        depth_m: f64,
    },
    /// A vessel was aground.
    Aground {
        /// The vessel.
        vessel: usize,
        /// Start of the first step in which the vessel was aground (s).
        first_s: f64,
        /// How long the vessel was aground (s).
        lasting_s: f64,
    },
    /// A vessel left the corridor of her passage plan.
    LeftCorridor {
        /// The vessel.
        vessel: usize,
        /// Index of the leg on which the vessel was farthest outside.
        leg: usize,
        /// Start of the first step in which the vessel was outside (s).
        first_s: f64,
        /// How long the vessel was outside (s).
        lasting_s: f64,
        /// Cross-track distance where the vessel was farthest outside, positive to starboard of the track (m).
        cross_track_m: f64,
        /// Half of the width of the corridor there (m).
        half_width_m: f64,
    },
    /// A vessel was higher than the clearance of a bridge or cable over her.
    TooHigh {
        /// The vessel.
        vessel: usize,
        /// The bridge or cable, by its index in [`fenderline_world::overhead::OverheadSetup::structures`].
        structure: usize,
        /// Start of the first step in which the vessel was too high (s).
        first_s: f64,
        /// How long the vessel was too high (s).
        lasting_s: f64,
        /// The least clearance above her highest point, which is negative (m).
        clearance_m: f64,
        /// Where the vessel was at the least clearance, north and east (m).
        at_m: Vec2,
    },
    /// A limit of the scenario was exceeded.
    LimitExceeded {
        /// The limit that was exceeded, by its index in [`fenderline_world::limit::StatisticsSetup::limits`].
        limit: usize,
        /// The value of the run that exceeds the limit (m, rad, or a share).
        value: f64,
    },
    /// A fender or a line was within its capacity, but exceeds it with the user's partial factor.
    AboveWithFactor {
        /// The fender or line.
        subject: Subject,
        /// The capacity, in words.
        capacity: &'static str,
        /// The factor.
        factor: f64,
        /// Factored result over capacity.
        share: f64,
    },
    /// A fender was beyond its rating.
    FenderOverRated {
        /// The fender.
        fender: usize,
        /// `energy`, `deflection` or `reaction`: the quantity that is farthest above its rating.
        quantity: &'static str,
        /// Peak of the quantity, divided by its rated value.
        share: f64,
    },
    /// A fender took more than its catalogue's rating. The factors of the run (temperature, tolerance, speed, angle)
    /// explain this excess: the fender stayed within its rating with these factors.
    AboveCatalogue {
        /// The fender. If several fenders are above their catalogue's rating, `fender` is the fender farthest above.
        fender: usize,
        /// `energy` or `reaction`.
        quantity: &'static str,
        /// Peak of the quantity, divided by the rating of the catalogue.
        share: f64,
        /// Peak of the quantity, divided by the rating with the factors of the run.
        share_of_run: f64,
        /// How many other fenders are above their catalogue's rating.
        others: usize,
    },
    /// A fender would have pressed on a hull, but the hull has no side at the fender's height.
    NoSideAtFender {
        /// The fender.
        fender: usize,
        /// The body whose hull has no side at the fender's height.
        body: usize,
        /// Start of the first step in which the fender met no side of the hull (s).
        first_s: f64,
        /// How far the middle of the fender's face was above the highest outline of the hull (m); negative: below the
        /// lowest outline.
        off_m: f64,
    },
    /// A line could not be made fast: its ends were farther apart than the line is long.
    LineNotMadeFast {
        /// The line.
        line: usize,
        /// Time at which the line should have been made fast (s).
        at_s: f64,
    },
    /// A line was above its working load.
    LineOverWorking {
        /// The line.
        line: usize,
        /// Start of the first step in which the line's tension was above its working load (s).
        first_s: f64,
        /// How long the line's tension was above its working load (s).
        lasting_s: f64,
        /// Peak tension of the line, divided by its working load.
        share: f64,
    },
    /// A fender pressed harder on the hull than permitted.
    HullPressure {
        /// The fender.
        fender: usize,
        /// Peak pressure on the hull, divided by the permissible pressure.
        share: f64,
    },
    /// The run left the range of a physical law or of its data.
    OutsideLaw(Departure),
    /// The brake of a line's winch rendered: the drum slipped and let line out.
    LineRendered {
        /// The line.
        line: usize,
        /// Length of line that the brake let out (m).
        rendered_m: f64,
    },
    /// A fender without rating was touched.
    FenderNotRated {
        /// The fender.
        fender: usize,
        /// Largest reaction of the fender (N).
        peak_reaction_n: f64,
        /// Start of the step with the largest reaction (s).
        at_s: f64,
    },
    /// Two bodies touched, and no permissible load is given for their contact.
    ContactNotRated {
        /// The two bodies.
        bodies: [usize; 2],
        /// Peak normal force (N).
        peak_force_n: f64,
    },
    /// The scenario has fenders, and none was touched.
    NoFenderTouched,
}

/// A fender or a line, by its index in the [`Setup`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subject {
    /// A fender.
    Fender(usize),
    /// A line.
    Line(usize),
}

impl Finding {
    /// The verdict on a run that has only this finding.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        match self {
            Finding::StructureStruck { .. } | Finding::TooHigh { .. } => Verdict::StructureStruck,
            Finding::FenderFailed { .. } | Finding::ChainParted { .. } => Verdict::FenderFailed,
            Finding::PileYielded { .. } => Verdict::PileYielded,
            Finding::LineParted { .. } => Verdict::LineParted,
            Finding::AnchorLost { .. } => Verdict::AnchorLost,
            Finding::AnchorDragged { .. } => Verdict::AnchorDragged,
            Finding::StartInside { .. } => Verdict::StartInside,
            Finding::Aground { .. } => Verdict::Aground,
            Finding::FenderOverRated { .. } => Verdict::FenderOverRated,
            Finding::LimitExceeded { .. }
            | Finding::AboveWithFactor { .. }
            | Finding::LeftCorridor { .. } => Verdict::LimitExceeded,
            Finding::AboveCatalogue { .. } => Verdict::AboveCatalogue,
            Finding::NoSideAtFender { .. } => Verdict::NoSideAtFender,
            Finding::LineOverWorking { .. } => Verdict::LineOverWorking,
            Finding::LineNotMadeFast { .. } => Verdict::LineNotMadeFast,
            Finding::HullPressure { .. } => Verdict::HullPressure,
            Finding::OutsideLaw(Departure { law, .. }) => law.row().verdict,
            Finding::LineRendered { .. } => Verdict::LineRendered,
            Finding::FenderNotRated { .. } | Finding::ContactNotRated { .. } => Verdict::NotRated,
            Finding::NoFenderTouched => Verdict::NoFenderTouched,
        }
    }

    /// The physical law or the data whose range the run left; `None` for other kinds of findings.
    #[must_use]
    pub fn departure(&self) -> Option<&Departure> {
        match self {
            Finding::OutsideLaw(departure) => Some(departure),
            _ => None,
        }
    }

    /// Names of the bodies, fenders, lines, anchors or vessels that the finding concerns.
    #[must_use]
    pub fn names<'a>(&self, setup: &'a Setup) -> Vec<&'a str> {
        let body = |index: usize| setup.bodies[index].name.as_str();
        let fender = |index: usize| setup.fenders[index].name.as_str();
        match *self {
            Finding::StructureStruck { bodies, .. }
            | Finding::ContactNotRated { bodies, .. }
            | Finding::StartInside { bodies, fender: None, .. } => bodies.map(body).to_vec(),
            Finding::StartInside { bodies, fender: Some(index), .. } => {
                let mut names = vec![fender(index)];
                names.extend(bodies.map(body));
                names
            }
            Finding::NoSideAtFender { fender: index, body: of, .. } => {
                vec![fender(index), body(of)]
            }
            Finding::FenderFailed { fender: index, .. }
            | Finding::ChainParted { fender: index, .. }
            | Finding::FenderOverRated { fender: index, .. }
            | Finding::AboveCatalogue { fender: index, .. }
            | Finding::HullPressure { fender: index, .. }
            | Finding::FenderNotRated { fender: index, .. } => vec![fender(index)],
            Finding::LineParted { line, .. }
            | Finding::LineOverWorking { line, .. }
            | Finding::LineNotMadeFast { line, .. }
            | Finding::LineRendered { line, .. } => {
                vec![setup.world.lines[line].line.name.as_str()]
            }
            Finding::AboveWithFactor { subject: Subject::Fender(index), .. } => vec![fender(index)],
            Finding::AboveWithFactor { subject: Subject::Line(line), .. } => {
                vec![setup.world.lines[line].line.name.as_str()]
            }
            Finding::AnchorLost { anchor, .. } | Finding::AnchorDragged { anchor, .. } => {
                vec![setup.world.anchors[anchor].gear.name.as_str()]
            }
            Finding::LimitExceeded { limit, .. } => {
                vec![setup.world.statistics.limits[limit].name.as_str()]
            }
            Finding::PileYielded { body: of, .. } => vec![body(of)],
            Finding::Aground { vessel, .. }
            | Finding::LeftCorridor { vessel, .. }
            | Finding::TooHigh { vessel, .. } => {
                vec![body(setup.world.vessels[vessel].body)]
            }
            Finding::OutsideLaw(departure) => departure.subject.names(setup),
            Finding::NoFenderTouched => vec![],
        }
    }

    /// The finding as one sentence with its numbers, without a full stop at the end.
    #[must_use]
    pub fn sentence(&self, setup: &Setup) -> String {
        let names = self.names(setup);
        match *self {
            Finding::StructureStruck { first_s, lasting_s, peak_force_n, peak_depth_m, .. } => {
                format!(
                    "{} struck {} without a fender between them, from {first_s:.1} s for {}: {}, {} deep",
                    names[0],
                    names[1],
                    duration(lasting_s),
                    force(peak_force_n),
                    length(peak_depth_m)
                )
            }
            Finding::FenderFailed { at_s, deflection_m, .. } => format!(
                "{} was compressed {} at {at_s:.1} s, into its stop or flat; the structure behind it carried \
                 the hull",
                called("Fender", names[0]),
                length(deflection_m)
            ),
            Finding::ChainParted { kind, at_s, tension_n, .. } => format!(
                "A {} chain of {} parted at {at_s:.1} s under {}",
                kind.word(),
                called("fender", names[0]),
                force(tension_n)
            ),
            Finding::PileYielded { first_s, load_n, offset_m, .. } => format!(
                "The pile of {} yielded at {first_s:.1} s under {}: {} of its deflection stay",
                names[0],
                force(load_n),
                length(offset_m)
            ),
            Finding::LineParted { at_s, tension_n, .. } => {
                format!(
                    "{} parted at {at_s:.1} s under {}",
                    called("Line", names[0]),
                    force(tension_n)
                )
            }
            Finding::AnchorLost { at_s, by, tension_n, .. } => format!(
                "{} was lost at {at_s:.1} s: its chain {} under {}",
                called("Anchor", names[0]),
                match by {
                    LostBy::Parted => "parted",
                    LostBy::RanOut => "ran out and the bitter end gave way",
                    LostBy::Slipped => "was slipped",
                },
                force(tension_n)
            ),
            Finding::AnchorDragged { first_s, dragged_m, .. } => format!(
                "{} dragged {}, first at {first_s:.1} s",
                called("Anchor", names[0]),
                length(dragged_m)
            ),
            Finding::StartInside { fender: None, depth_m, .. } => format!(
                "{} starts {} inside {}; forces of the first contact are not physical: correct the start position",
                names[0],
                length(depth_m),
                names[1]
            ),
            Finding::StartInside { fender: Some(_), depth_m, .. } => format!(
                "{} starts compressed {} between {} and {}, more than any berthing explains; forces of the first \
                 contact are not physical",
                called("Fender", names[0]),
                length(depth_m),
                names[1],
                names[2]
            ),
            Finding::Aground { first_s, lasting_s, .. } => {
                format!("{} was aground from {first_s:.1} s for {}", names[0], duration(lasting_s))
            }
            Finding::LeftCorridor {
                vessel,
                leg,
                first_s,
                lasting_s,
                cross_track_m,
                half_width_m,
            } => {
                let plan = setup.world.vessels[vessel].plan.as_ref();
                let to = plan.map_or("", |plan| plan.waypoints()[leg + 1].name.as_str());
                let to =
                    if to.is_empty() { format!("waypoint {}", leg + 2) } else { to.to_owned() };
                let side = if cross_track_m < 0.0 { "port" } else { "starboard" };
                format!(
                    "{} left the corridor of her passage plan from {first_s:.1} s for {}: {:.0} m to {side} of the \
                     track on the leg to {to}, where {half_width_m:.0} m are planned",
                    names[0],
                    duration(lasting_s),
                    cross_track_m.abs()
                )
            }
            Finding::TooHigh { structure, first_s, lasting_s, clearance_m, at_m, .. } => format!(
                "{} was {} too high for the {}, {:.0} m north and {:.0} m east of the origin, from {first_s:.1} s \
                 for {}",
                names[0],
                length(-clearance_m),
                setup.world.overhead.structures[structure].name,
                at_m.x,
                at_m.y,
                duration(lasting_s)
            ),
            Finding::FenderOverRated { quantity, share, .. } => {
                format!(
                    "{}: {quantity} {:.0} % of rated",
                    called("Fender", names[0]),
                    100.0 * share
                )
            }
            Finding::LimitExceeded { limit, value } => {
                let limit = &setup.world.statistics.limits[limit];
                format!(
                    "Limit {}: {} was {}, above {}",
                    limit.name,
                    limit.subject(setup),
                    limit.shown(value),
                    limit.shown(limit.most)
                )
            }
            Finding::AboveWithFactor { subject, capacity, factor, share } => format!(
                "{}: {:.0} % of its {capacity} with the partial factor {factor} of {}",
                match subject {
                    Subject::Fender(_) => called("Fender", names[0]),
                    Subject::Line(_) => called("Line", names[0]),
                },
                100.0 * share,
                setup.world.factors.source
            ),
            Finding::AboveCatalogue { quantity, share, share_of_run, others, .. } => {
                let others = match others {
                    0 => String::new(),
                    1 => "; one other fender is above it too".to_owned(),
                    others => format!("; {others} other fenders are above it too"),
                };
                format!(
                    "{}: {quantity} {:.0} % of the catalogue's rating, {:.0} % of the rating with this run's factors \
                     (temperature, tolerance, speed, angle){others}",
                    called("Fender", names[0]),
                    100.0 * share,
                    100.0 * share_of_run
                )
            }
            Finding::NoSideAtFender { first_s, off_m, .. } => format!(
                "{} has no side at {}, {} {}, at {first_s:.1} s: the fender did not touch her",
                names[1],
                called("fender", names[0]),
                length(off_m.abs()),
                if off_m > 0.0 { "above her highest outline" } else { "below her lowest outline" }
            ),
            Finding::LineOverWorking { first_s, lasting_s, share, .. } => format!(
                "{}: {:.0} % of its working load, above it from {first_s:.1} s for {}",
                called("Line", names[0]),
                100.0 * share,
                duration(lasting_s)
            ),
            Finding::LineNotMadeFast { at_s, .. } => {
                format!("{} could not be made fast at {at_s:.1} s", called("Line", names[0]))
            }
            Finding::HullPressure { share, .. } => format!(
                "{}: {:.0} % of the permissible hull pressure",
                called("Fender", names[0]),
                100.0 * share
            ),
            Finding::OutsideLaw(departure) => departure.sentence(setup, &names),
            Finding::LineRendered { rendered_m, .. } => {
                format!("The winch of {} rendered {}", called("line", names[0]), length(rendered_m))
            }
            Finding::FenderNotRated { peak_reaction_n, at_s, .. } => format!(
                "{} carried at most {}, at {at_s:.1} s; the scenario gives it no rating",
                called("Fender", names[0]),
                force(peak_reaction_n)
            ),
            Finding::ContactNotRated { peak_force_n, .. } => format!(
                "{} and {} touched with at most {}; no permissible load is known for them",
                names[0],
                names[1],
                force(peak_force_n)
            ),
            Finding::NoFenderTouched => "No fender was touched".to_owned(),
        }
    }
}

fn force(force_n: f64) -> String {
    if force_n >= 1e6 {
        format!("{:.2} MN", force_n / 1e6)
    } else {
        format!("{:.1} kN", force_n / 1e3)
    }
}

pub(super) fn length(length_m: f64) -> String {
    if length_m < 1.0 { format!("{:.0} mm", length_m * 1e3) } else { format!("{length_m:.2} m") }
}

pub(super) fn duration(lasting_s: f64) -> String {
    if lasting_s < 600.0 {
        format!("{lasting_s:.1} s")
    } else {
        format!("{:.0} min", lasting_s / 60.0)
    }
}
