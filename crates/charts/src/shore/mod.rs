//! The solid parts of a chart as one outline: `cut` cuts areas into parts, `strip` gives lines a width, `borders` knows
//! what is taken already.

mod borders;
mod cut;
mod strip;

use std::collections::BTreeMap;

use fenderline_contact::{Outline, Vec2};
use fenderline_sim::chart::{Chart, ChartClass, ChartFeature, ChartShape};

use self::borders::{Borders, Meets};

/// What the shore is made from.
pub struct Request<'r> {
    /// The chart with the solid features.
    pub chart: &'r Chart,
    /// Classes of features that are solid, in the order in which they are taken.
    pub classes: &'r [String],
    /// Width of the strip along a line (m).
    pub width_m: f64,
    /// Names of areas that are the outlines of bodies.
    pub bodies: &'r [&'r str],
}

/// The shore.
#[derive(Debug)]
pub struct Shore {
    /// The outline of all solid features together.
    pub outline: Outline,
    /// What was taken and what was not, by class.
    pub classes: Vec<ChartClass>,
    /// For each taken feature, its index in the chart and its parts.
    pub of_features: Vec<(usize, Vec<Outline>)>,
    /// Pairs of features that overlap, by index in the chart.
    pub overlaps: Vec<[usize; 2]>,
    /// True if a line has become a strip.
    pub has_strips: bool,
}

/// Why there is no shore.
#[derive(Debug)]
pub enum Refusal {
    /// A class without features in the chart.
    NoFeature(String),
    /// A feature is not a simple area.
    Feature(usize, String),
    /// No feature of the classes could be taken.
    Nothing,
}

/// Makes the shore.
///
/// # Errors
/// [`Refusal`].
pub fn make(request: &Request<'_>) -> Result<Shore, Refusal> {
    let mut counts: BTreeMap<&str, (usize, BTreeMap<&'static str, usize>)> = BTreeMap::new();
    let mut borders = Borders::default();
    let mut shore = Taken::default();
    // Areas first, so that a line along an area is known to be its border.
    for is_of_areas in [true, false] {
        for class in request.classes {
            let of_class =
                request.chart.features.iter().enumerate().filter(|(_, of)| of.class == class);
            let mut has_feature = false;
            for (index, feature) in of_class {
                has_feature = true;
                if matches!(feature.shape, ChartShape::Area(_)) != is_of_areas {
                    continue;
                }
                let count = counts.entry(class).or_default();
                match shore.add(request, &mut borders, index, feature)? {
                    None => count.0 += 1,
                    Some(why) => *count.1.entry(why).or_default() += 1,
                }
            }
            if !has_feature {
                return Err(Refusal::NoFeature(class.clone()));
            }
        }
    }
    let parts: Vec<Outline> =
        shore.of_features.iter().flat_map(|(_, parts)| parts.iter().cloned()).collect();
    let outline = Outline::of_parts(&shore.rings, &parts).map_err(|_| Refusal::Nothing)?;
    let class = |(class, (read, left_out)): (&str, (usize, BTreeMap<&'static str, usize>))| {
        let left_out = left_out.into_iter().map(|(why, count)| (count, why.to_owned())).collect();
        ChartClass { class: class.to_owned(), read, left_out }
    };
    let classes = counts.into_iter().map(class).collect();
    let Taken { of_features, overlaps, has_strips, .. } = shore;
    Ok(Shore { outline, classes, of_features, overlaps, has_strips })
}

/// What of the shore is taken so far.
#[derive(Default)]
struct Taken {
    rings: Vec<Vec<Vec2>>,
    of_features: Vec<(usize, Vec<Outline>)>,
    overlaps: Vec<[usize; 2]>,
    has_strips: bool,
}

impl Taken {
    /// Adds a feature. Says why the feature is not taken; `None`: it is.
    fn add(
        &mut self,
        request: &Request<'_>,
        borders: &mut Borders,
        index: usize,
        feature: &ChartFeature,
    ) -> Result<Option<&'static str>, Refusal> {
        if !feature.name.is_empty() && request.bodies.contains(&feature.name.as_str()) {
            return Ok(Some("is the outline of a body"));
        }
        match &feature.shape {
            ChartShape::Point(_) => Ok(Some("is a point")),
            ChartShape::Area(rings) => self.add_area(borders, index, rings),
            ChartShape::Line(line) => Ok(self.add_line(request, borders, index, line)),
        }
    }

    fn add_area(
        &mut self,
        borders: &mut Borders,
        index: usize,
        rings: &[Vec<Vec2>],
    ) -> Result<Option<&'static str>, Refusal> {
        let regions = cut::regions(rings);
        let mut parts = Vec::new();
        for region in &regions {
            for part in cut::parts(region.clone()) {
                match Outline::new(&part) {
                    Ok((outline, _)) => parts.push(outline),
                    // A sliver between a cut and a border.
                    Err(fenderline_contact::OutlineError::ZeroArea) => {}
                    Err(fenderline_contact::OutlineError::SelfIntersection { edges }) => {
                        let at_m = part[edges[1].from];
                        return Err(Refusal::Feature(
                            index,
                            format!(
                                "its border crosses or touches itself {:.1} m north and {:.1} m east of the origin, so that it cannot be solid",
                                at_m.x, at_m.y
                            ),
                        ));
                    }
                    Err(error) => {
                        return Err(Refusal::Feature(
                            index,
                            format!("it cannot be solid: {error}"),
                        ));
                    }
                }
            }
        }
        let Some(first) = parts.first() else { return Ok(Some("has no area")) };
        let piece = &first.pieces()[0];
        let inner_m = piece.iter().fold(Vec2::ZERO, |sum, v| sum + *v) * (1.0 / piece.len() as f64);
        let own: Vec<Vec<Vec2>> = regions.iter().flat_map(cut::borders).cloned().collect();
        match borders.meets(&own, inner_m) {
            Meets::LiesWithin => return Ok(Some("lies within a solid area that is taken")),
            Meets::Overlaps(others) => {
                self.overlaps.extend(others.into_iter().map(|other| [other, index]));
            }
        }
        borders.add(index, own.clone());
        self.rings.extend(own);
        self.of_features.push((index, parts));
        Ok(None)
    }

    fn add_line(
        &mut self,
        request: &Request<'_>,
        borders: &Borders,
        index: usize,
        line: &[Vec2],
    ) -> Option<&'static str> {
        let strips = strip::strips(line, request.width_m);
        if strips.is_empty() {
            return Some("is too short");
        }
        let middle = |strip: &[Vec2; 4]| strip.iter().fold(Vec2::ZERO, |sum, v| sum + *v) * 0.25;
        let is_free = |strip: &[Vec2; 4]| !borders.holds(middle(strip), 0.5 * request.width_m);
        let free = strips.into_iter().filter(is_free);
        let (mut rings, mut parts) = (Vec::new(), Vec::new());
        for strip in free {
            if let Ok((outline, _)) = Outline::new(&strip) {
                rings.push(strip.to_vec());
                parts.push(outline);
            }
        }
        if parts.is_empty() {
            return Some("runs along or within a solid area");
        }
        self.has_strips = true;
        self.rings.extend(rings);
        self.of_features.push((index, parts));
        None
    }
}
