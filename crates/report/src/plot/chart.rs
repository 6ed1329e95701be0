//! A chart that shows series of points over two axes.

use fenderline_contact::number::greater;

use core::fmt::Write as _;

use maud::{Markup, html};

use super::axis::{Axis, Fitted};
use super::series::{Drawn, Point, Series};
use super::{colour, dash};

/// A chart to draw.
#[derive(Clone, Debug, PartialEq)]
pub struct Chart {
    /// Title, printed above the chart.
    pub title: String,
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// The series to draw, in the units of the axes.
    pub series: Vec<Series>,
    /// Horizontal lines to draw, such as a limit or an expected value.
    pub references: Vec<Reference>,
    /// Name of the group of charts that share the read-out under the pointer; `None` for no read-out.
    pub linked: Option<&'static str>,
    /// The note below the chart; empty for none.
    pub note: String,
}

/// A horizontal line of a chart.
#[derive(Clone, Debug, PartialEq)]
pub struct Reference {
    /// Label, printed at the end of the line.
    pub label: String,
    /// Height of the line, in the unit of the vertical axis.
    pub value: f64,
}

pub(super) const WIDTH: f64 = 720.0;
/// Height of a chart, so that four charts go on a page of A4 (px).
const HEIGHT: f64 = 216.0;
/// Height of a tall chart (px).
const TALL: f64 = 400.0;
const TOP: f64 = 10.0;
const BOTTOM: f64 = 40.0;
const RIGHT: f64 = 16.0;
/// Smallest left margin (px), with which the charts of a page line up unless their numbers are long.
const LEAST_LEFT: f64 = 66.0;
/// Mean width of a digit at the size of the tick labels (px).
const DIGIT: f64 = 6.4;
/// Smallest distance of drawn points: a point closer than this to the previous point is not drawn (px).
const FINEST: f64 = 0.05;

/// A chart with its axes fitted and its area measured.
struct Area {
    x: Fitted,
    y: Fitted,
    left: f64,
    height: f64,
}

impl Area {
    fn of(chart: &Chart, height: f64) -> Area {
        let points = || chart.series.iter().flat_map(|s| &s.points);
        let references = chart.references.iter().map(|r| r.value);
        let x = chart.x.fit(points().map(|p| p.x), 10);
        let y = chart.y.fit(points().map(|p| p.y).chain(references), 5);
        let longest = y.ticks().iter().map(|(_, label)| label.chars().count()).max().unwrap_or(1);
        let left = 30.0 + DIGIT * u32::try_from(longest).map_or(20.0, f64::from);
        let left = greater(left, LEAST_LEFT);
        Area { x, y, left, height }
    }

    fn right(&self) -> f64 {
        WIDTH - RIGHT
    }

    fn base(&self) -> f64 {
        self.height - BOTTOM
    }

    fn px(&self, x: f64) -> f64 {
        self.left + self.x.share(x) * (self.right() - self.left)
    }

    /// Whether a point has a place in the chart: on a logarithmic axis zero has no place.
    fn holds(&self, point: &Point) -> bool {
        self.px(point.x).is_finite() && self.py(point.y).is_finite()
    }

    fn py(&self, y: f64) -> f64 {
        self.base() - self.y.share(y) * (self.base() - TOP)
    }
}

impl Chart {
    /// Draws the chart as an HTML `figure` with its title, legend and note.
    pub fn render(&self) -> Markup {
        self.render_of(HEIGHT, "chart")
    }

    /// Draws the chart like [`Chart::render`], but twice as high, for curves from which values are read off.
    pub fn render_tall(&self) -> Markup {
        self.render_of(TALL, "chart tall")
    }

    fn render_of(&self, height: f64, class: &str) -> Markup {
        let area = Area::of(self, height);
        html! {
            figure class=(class) {
                figcaption { (self.title) }
                @if self.series.len() > 1 { (self.legend()) }
                svg viewBox={ "0 0 " (WIDTH) " " (height) } role="img" aria-label=(self.title)
                    data-link=[self.linked]
                    data-x=(format!("{} {} {:.2} {:.2}", area.x.lo, area.x.hi, area.left, area.right()))
                    data-y=(format!("{} {} {:.2} {:.2}", area.y.lo, area.y.hi, area.base(), TOP))
                    data-xunit=(self.x.unit()) data-unit=(self.y.unit()) {
                    (self.drawing(&area))
                }
                @if !self.note.is_empty() { p class="note" { (self.note) } }
            }
        }
    }

    /// Draws what stands within the picture of the chart: axes, reference lines, series.
    fn drawing(&self, area: &Area) -> Markup {
        let is_empty = self.series.iter().all(|s| s.points.is_empty());
        html! {
            (self.axes(area))
            @for reference in &self.references { (reference_line(reference, area)) }
            @for (index, series) in self.series.iter().enumerate() {
                (drawn_series(series, series.style.unwrap_or(index), area))
            }
            @if is_empty {
                text x=((area.left + area.right()) / 2.0) y=((TOP + area.base()) / 2.0)
                    text-anchor="middle" { "no data" }
            }
        }
    }

    /// Draws the chart with a given height and the width [`WIDTH`], without title, legend and note.
    pub(super) fn bare(&self, height: f64) -> Markup {
        self.drawing(&Area::of(self, height))
    }

    /// The series that have a name, each with the number of its style: a series without a name belongs to the series
    /// before it.
    pub(super) fn named(&self) -> impl Iterator<Item = (usize, &Series)> {
        let styled = self.series.iter().enumerate();
        styled.map(|(index, s)| (s.style.unwrap_or(index), s)).filter(|(_, s)| !s.name.is_empty())
    }

    fn legend(&self) -> Markup {
        html! {
            ul class="legend" {
                @for (style, series) in self.named() {
                    li {
                        svg width="30" height="12" viewBox="0 0 30 12" aria-hidden="true" {
                            (key_of(series, style))
                        }
                        (series.name)
                    }
                }
            }
        }
    }

    fn axes(&self, area: &Area) -> Markup {
        let (left, right, base) = (area.left, area.right(), area.base());
        let (mut grid, mut zero) = (String::new(), None);
        for (value, _) in area.x.ticks() {
            let _ = write!(grid, "M{:.1},{TOP}V{base}", area.px(value));
        }
        for (value, _) in area.y.ticks() {
            let _ = write!(grid, "M{left:.1},{:.1}H{right}", area.py(value));
            if value == 0.0 && area.y.lo < 0.0 {
                zero = Some(area.py(value));
            }
        }
        let middle = (TOP + base) / 2.0;
        html! {
            path class="grid" d=(grid) {}
            @if let Some(y) = zero { path class="zero" d=(format!("M{left:.1},{y:.1}H{right}")) {} }
            path class="frame" d=(format!("M{left:.1},{TOP}V{base}H{right}")) {}
            g class="ticks" {
                @for (value, label) in area.x.ticks() {
                    text x=(format!("{:.1}", area.px(value))) y=(base + 15.0) text-anchor="middle" {
                        (label)
                    }
                }
                @for (value, label) in area.y.ticks() {
                    text x=(format!("{:.1}", left - 6.0))
                        y=(format!("{:.1}", area.py(value) + 3.8)) text-anchor="end" { (label) }
                }
            }
            text class="axis" x=(format!("{:.1}", (left + right) / 2.0)) y=(area.height - 6.0)
                text-anchor="middle" { (self.x.title()) }
            text class="axis" text-anchor="middle"
                transform=(format!("translate(12 {middle:.1}) rotate(-90)")) { (self.y.title()) }
        }
    }
}

/// The legend's sample of how a series is drawn, 30 px wide and 12 px high.
pub(super) fn key_of(series: &Series, style: usize) -> Markup {
    html! {
        @if series.drawn == Drawn::Band {
            rect class="band" x="1" y="1" width="28" height="10" fill=(colour(style)) {}
        }
        @if series.drawn == Drawn::Dots {
            path class="dots" d="M5,8h0M14,4h0M24,7h0" stroke=(colour(style)) {}
        }
        @if matches!(series.drawn, Drawn::Line | Drawn::LineAndMarks) {
            path d="M1,6H29" fill="none" stroke=(colour(style))
                stroke-width="1.8" stroke-dasharray=(dash(style)) {}
        }
        @if matches!(series.drawn, Drawn::Marks | Drawn::LineAndMarks) { (mark(style, 15.0, 6.0)) }
    }
}

fn reference_line(reference: &Reference, area: &Area) -> Markup {
    let y = area.py(reference.value);
    // On the side away from zero, where there is more room.
    let text_y = if reference.value < 0.0 { y + 12.0 } else { y - 4.0 };
    html! {
        path class="reference" d=(format!("M{:.1},{y:.1}H{}", area.left, area.right())) {}
        text class="reference halo" x=(area.right() - 3.0) y=(format!("{text_y:.1}"))
            text-anchor="end" { (reference.label) }
    }
}

fn drawn_series(series: &Series, style: usize, area: &Area) -> Markup {
    html! {
        @if series.drawn == Drawn::Band {
            path class="band" d=(area_of(&series.points, area)) fill=(colour(style)) {}
        }
        @if series.drawn == Drawn::Dots {
            path class="dots" d=(dots_of(&series.points, area)) stroke=(colour(style)) {}
        }
        @if matches!(series.drawn, Drawn::Line | Drawn::LineAndMarks) {
            path class="line" data-name=(series.name) d=(path_of(&series.points, area))
                stroke=(colour(style)) stroke-dasharray=(dash(style)) {}
        }
        @if matches!(series.drawn, Drawn::Marks | Drawn::LineAndMarks) {
            @for p in series.points.iter().filter(|p| area.holds(p)) {
                (mark(style, area.px(p.x), area.py(p.y)))
            }
        }
    }
}

/// The SVG path of the line through the points; a point that is not finite breaks the line.
fn path_of(points: &[Point], area: &Area) -> String {
    let mut path = String::with_capacity(points.len() * 12);
    let mut last: Option<(f64, f64)> = None;
    for (index, point) in points.iter().enumerate() {
        if !area.holds(point) {
            last = None;
            continue;
        }
        let (x, y) = (area.px(point.x), area.py(point.y));
        let is_end = index + 1 == points.len();
        match last {
            None => {
                let _ = write!(path, "M{x:.1},{y:.1}");
                last = Some((x, y));
            }
            Some((x0, y0)) => {
                if is_end || (x - x0).abs() > FINEST || (y - y0).abs() > FINEST {
                    let _ = write!(path, "L{x:.1},{y:.1}");
                    last = Some((x, y));
                }
            }
        }
    }
    path
}

/// The SVG path of the closed line around the filled area of a series.
fn area_of(points: &[Point], area: &Area) -> String {
    let mut path = String::new();
    for point in points.iter().filter(|point| area.holds(point)) {
        let letter = if path.is_empty() { 'M' } else { 'L' };
        let _ = write!(path, "{letter}{:.1},{:.1}", area.px(point.x), area.py(point.y));
    }
    if !path.is_empty() {
        path.push('Z');
    }
    path
}

/// The SVG path that draws dots as lines without length, which have round ends.
fn dots_of(points: &[Point], area: &Area) -> String {
    let mut path = String::with_capacity(points.len() * 14);
    for point in points.iter().filter(|point| area.holds(point)) {
        let _ = write!(path, "M{:.1},{:.1}h0", area.px(point.x), area.py(point.y));
    }
    path
}

/// Draws the mark of style number `style`, which is hollow, so that the mark covers nothing.
fn mark(style: usize, x: f64, y: f64) -> Markup {
    let r = 3.6;
    let path = match style % 4 {
        0 => format!("M{:.1},{y:.1}a{r},{r} 0 1 0 {d},0a{r},{r} 0 1 0 -{d},0Z", x - r, d = 2.0 * r),
        1 => format!("M{:.1},{:.1}h{d}v{d}h-{d}Z", x - r, y - r, d = 2.0 * r),
        2 => format!("M{x:.1},{:.1}l{r},{h:.1}h-{d}Z", y - r, h = 1.8 * r, d = 2.0 * r),
        _ => format!("M{x:.1},{:.1}l{r},{r}l-{r},{r}l-{r},-{r}Z", y - r),
    };
    html! { path class="mark" d=(path) stroke=(colour(style)) {} }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chart(series: Vec<Series>) -> String {
        Chart {
            title: "a <b>".to_owned(),
            x: Axis::new("time", "s"),
            y: Axis::new("force", "kN"),
            series,
            references: vec![Reference { label: "limit & more".to_owned(), value: 3.0 }],
            linked: Some("time"),
            note: String::new(),
        }
        .render()
        .into_string()
    }

    #[test]
    fn texts_are_escaped() {
        let svg = chart(vec![Series::line("x\"><script>", vec![Point { x: 0.0, y: 1.0 }])]);
        assert!(!svg.contains("<script"));
        assert!(svg.contains("a &lt;b&gt;") && svg.contains("limit &amp; more"));
    }

    #[test]
    fn no_coordinate_is_ever_nan_or_infinite() {
        let points = [(0.0, f64::NAN), (1.0, f64::INFINITY), (2.0, 1e300), (f64::NAN, 0.0)];
        let points: Vec<_> = points.iter().map(|&(x, y)| Point { x, y }).collect();
        for series in
            [vec![], vec![Series::line("s", points.clone())], vec![Series::marks("s", points)]]
        {
            let svg = chart(series);
            assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
        }
    }

    #[test]
    fn zero_has_no_place_on_a_logarithmic_axis() {
        let points = |ys: [f64; 3]| -> Vec<Point> {
            ys.iter().enumerate().map(|(i, &y)| Point { x: i as f64, y }).collect()
        };
        let svg = Chart {
            title: "p".to_owned(),
            x: Axis::new("x", ""),
            y: Axis::new("p", "").logarithmic(),
            series: vec![
                Series::band("band", points([0.1, 0.0, 1e-4]), points([0.5, 0.1, 1e-3])),
                Series::dots("dots", points([0.2, 0.0, -1.0])),
                Series::line("line", points([0.2, 0.02, 0.0])),
            ],
            references: Vec::new(),
            linked: None,
            note: String::new(),
        }
        .render_tall()
        .into_string();
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
        assert!(svg.contains("class=\"band\"") && svg.contains("class=\"dots\""));
    }

    #[test]
    fn a_line_breaks_where_a_value_is_missing() {
        let points = [0.0, 1.0, f64::NAN, 3.0, 4.0].iter().enumerate();
        let points = points.map(|(i, &y)| Point { x: i as f64, y }).collect();
        let svg = chart(vec![Series::line("s", points).with_marks()]);
        let line = svg.split("class=\"line\"").nth(1).unwrap_or_default();
        let d = line.split(" d=\"").nth(1).and_then(|s| s.split('"').next()).unwrap_or_default();
        assert_eq!(d.matches('M').count(), 2, "{d}");
    }
}
