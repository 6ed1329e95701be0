//! A chart as a separate file: an SVG picture with title, legend and style.

use maud::{Markup, PreEscaped, html};

use super::chart::{Chart, WIDTH, key_of};

/// Height of the drawing (px).
const HEIGHT: f64 = 300.0;
const MARGIN: f64 = 10.0;
const TITLE: f64 = 24.0;
const LEGEND_LINE: f64 = 18.0;
/// Width of a series' line sample in the legend, and of the space after a name (px).
const KEY: f64 = 35.0;
const GAP: f64 = 16.0;
/// Mean width of a letter of the legend (px).
const LETTER: f64 = 6.6;

/// The rules of `page.css` about charts, for a picture that stands without a page.
const STYLE: &str = "
text { font: 11px 'Segoe UI', 'Helvetica Neue', Arial, 'DejaVu Sans', sans-serif; fill: #3a4552; }
text.axis { font-size: 11.5px; fill: #1b2430; }
text.title { font-size: 14px; font-weight: 600; fill: #1b2430; }
text.legend { font-size: 12px; fill: #1b2430; }
text.reference { fill: #333; }
text.halo { paint-order: stroke; stroke: #fff; stroke-width: 3px; stroke-linejoin: round; }
.grid { stroke: #e3e8ed; stroke-width: 1; fill: none; }
.zero { stroke: #8a94a0; stroke-width: 1; fill: none; }
.frame { stroke: #5b6675; stroke-width: 1; fill: none; }
.line { fill: none; stroke-width: 1.8; stroke-linejoin: round; }
.band { opacity: 0.16; stroke: none; }
.dots { fill: none; stroke-width: 3.2; stroke-linecap: round; stroke-opacity: 0.55; }
.mark { fill: #fff; fill-opacity: 0.6; stroke-width: 1.5; }
path.reference { stroke: #333; stroke-width: 1; stroke-dasharray: 5 4; fill: none; }
";

impl Chart {
    /// Writes the chart as a whole SVG file on a white ground, without its note, for documents that show pictures.
    #[must_use]
    pub fn stand_alone(&self) -> String {
        let (legend, lines) = self.legend_lines();
        let top = MARGIN + TITLE + LEGEND_LINE * f64::from(lines);
        let (width, height) = (WIDTH + 2.0 * MARGIN, top + HEIGHT + MARGIN);
        let picture = html! {
            svg xmlns="http://www.w3.org/2000/svg" viewBox={ "0 0 " (width) " " (height) }
                width=(width) height=(height) role="img" aria-label=(self.title) {
                style { (PreEscaped(STYLE)) }
                rect width="100%" height="100%" fill="#fff" {}
                text class="title" x=(MARGIN) y=(MARGIN + 14.0) { (self.title) }
                (legend)
                g transform={ "translate(" (MARGIN) " " (top) ")" } { (self.bare(HEIGHT)) }
            }
        };
        format!("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n{}\n", picture.into_string())
    }

    /// Draws the legend, broken into lines, and returns its number of lines.
    fn legend_lines(&self) -> (Markup, u32) {
        if self.series.len() < 2 {
            return (html! {}, 0);
        }
        let (mut x, mut line) = (0.0, 0_u32);
        let mut placed = Vec::new();
        for (style, series) in self.named() {
            let letters = u32::try_from(series.name.chars().count()).map_or(0.0, f64::from);
            let width = KEY + LETTER * letters + GAP;
            if x > 0.0 && x + width > WIDTH {
                (x, line) = (0.0, line + 1);
            }
            placed.push((
                style,
                series,
                MARGIN + x,
                MARGIN + TITLE + LEGEND_LINE * f64::from(line),
            ));
            x += width;
        }
        let legend = html! {
            @for (style, series, x, y) in placed {
                g transform={ "translate(" (format!("{x:.1}")) " " (y) ")" } { (key_of(series, style)) }
                text class="legend" x=(format!("{:.1}", x + KEY)) y=(y + 10.0) { (series.name) }
            }
        };
        (legend, line + 1)
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Axis, Point, Series};
    use super::*;

    #[test]
    fn a_picture_of_its_own_has_title_legend_and_style_and_escapes_texts() {
        let line =
            |name| Series::line(name, vec![Point { x: 0.0, y: 1.0 }, Point { x: 1.0, y: 2.0 }]);
        let long = "a name so long that the next one goes to a line of its own, and the drawing moves down for it";
        let picture = Chart {
            title: "a <b>".to_owned(),
            x: Axis::new("time", "s"),
            y: Axis::new("force", "kN"),
            series: vec![line(long), line("b & c")],
            references: Vec::new(),
            linked: None,
            note: String::new(),
        }
        .stand_alone();
        assert!(picture.starts_with("<?xml") && picture.contains("<style>"));
        assert!(picture.contains("a &lt;b&gt;") && picture.contains("b &amp; c"));
        assert!(picture.contains("viewBox=\"0 0 740 380\""), "two lines of the legend: {picture}");
    }
}
