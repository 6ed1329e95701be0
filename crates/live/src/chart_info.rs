//! The chart in the form in which pages of the browser get it.

use fenderline_contact::Vec2;
use fenderline_sim::chart::{Chart, ChartFeature, ChartShape, MarkColour};

use crate::message::{ChartInfo, Pair};

/// The features of a chart, in the order of the chart.
pub(crate) fn chart_infos(chart: &Chart) -> Vec<ChartInfo> {
    chart.features.iter().map(info).collect()
}

fn info(feature: &ChartFeature) -> ChartInfo {
    let (shape, lines) = match &feature.shape {
        ChartShape::Point(at_m) => ("point", vec![vec![place(*at_m)]]),
        ChartShape::Line(line) => ("line", vec![places(line)]),
        ChartShape::Area(rings) => ("area", rings.iter().map(|ring| places(ring)).collect()),
    };
    let light = feature.light.as_ref();
    let colour = feature.mark.map(|mark| mark.colour).or(light.map(|light| light.colour));
    ChartInfo {
        kind: feature.kind.word(),
        name: feature.name.clone(),
        depth_m: feature.depth_m,
        deepest_m: feature.deepest_m,
        clearance_m: feature.clearance_m,
        colour: colour.map(MarkColour::word),
        character: light.map(|light| light.character.clone()),
        period_s: light.and_then(|light| light.period_s),
        sector_rad: light.and_then(|light| light.sector_rad),
        range_m: light.and_then(|light| light.range_m),
        side: feature.mark.and_then(|mark| mark.side).map(|side| side.word()),
        meaning: feature.mark.map(|mark| mark.meaning.word()),
        form: feature.mark.and_then(|mark| mark.shape).map(|shape| shape.word()),
        shape,
        lines,
    }
}

fn places(line: &[Vec2]) -> Vec<Pair> {
    line.iter().copied().map(place).collect()
}

/// Rounds a position on the chart to a centimetre. A chart that is exact to a centimetre is enough for drawing, and
/// short numbers make a short message.
fn place(at_m: Vec2) -> Pair {
    [at_m.x, at_m.y].map(|coordinate| libm::round(coordinate * 100.0) / 100.0)
}
