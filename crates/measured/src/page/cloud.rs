//! The cloud of speed against displacement.

use fenderline_report::plot::{Axis, Chart, Point, Series};
use maud::{Markup, html};

use crate::berthing::Berthings;
use crate::log::LogKind;

/// The section with the chart of speeds against displacements.
pub(super) fn section(berthings: &Berthings) -> Markup {
    let kinds = [LogKind::Docking, LogKind::Track, LogKind::Nmea, LogKind::Ais];
    let points = |kind: LogKind| {
        let of_kind = berthings.all.iter().filter(move |own| own.kind == kind);
        let point = |own: &crate::berthing::Berthing| Point {
            x: berthings.berths[own.berth].displacement_t() / 1e3,
            y: 100.0 * own.touch.speed_mps.value,
        };
        of_kind.map(point).collect::<Vec<_>>()
    };
    let series: Vec<Series> = kinds
        .into_iter()
        .enumerate()
        .map(|(style, kind)| Series::marks(kind.words(), points(kind)).styled(style))
        .filter(|series| series.largest() > 0.0)
        .collect();
    let chart = Chart {
        title: "Speed at the first touch against displacement".to_owned(),
        x: Axis::new("displacement", "1000 t").including(0.0),
        y: Axis::new("speed square to the quay", "cm/s").including(0.0),
        series,
        references: Vec::new(),
        linked: None,
        note: "Displacements are those of the scenario or of the mapping's ships. No published curve is drawn, because \
               none could be read in its source."
            .to_owned(),
    };
    html! {
        @if !berthings.all.is_empty() {
            h2 { "Speed against displacement" }
            (chart.render())
        }
    }
}
