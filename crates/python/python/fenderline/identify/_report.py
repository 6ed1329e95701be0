"""The result of an identification as text and as a page."""

from __future__ import annotations

import math
from collections.abc import Sequence
from html import escape
from typing import TYPE_CHECKING

import numpy as np

from fenderline._html import _table

if TYPE_CHECKING:
    from fenderline.identify import Coefficient, Identification


def _percent(value: float) -> str:
    return "–" if math.isnan(value) else f"{100.0 * value:.2g} %"


def _rows(found: Identification) -> list[list[str]]:
    rows = []
    for own in found.coefficients:
        if own.refused is None:
            band = f"{own.band[0]:.3f} to {own.band[1]:.3f}"
            rows.append([own.name, f"{own.factor:.4f}", _percent(own.deviation), band, "profile" if own.profile else "standard error"])
        else:
            rows.append([own.name, "1 (start value)", "–", "–", f"not told: {own.refused}"])
    return rows


_HEAD = ["coefficient", "factor", "standard error", "95 % band", "band by"]
_BEFORE = ["track", "rows", "place before [m]", "place after [m]", "largest before [m]", "largest after [m]", "heading before [°]", "heading after [°]", "memory"]


def _before(found: Identification) -> list[list[str]]:
    return [
        [
            own.label,
            str(own.rows),
            *(f"{value:.3g}" for value in (own.before_m, own.after_m, own.largest_before_m, own.largest_after_m, own.before_deg, own.after_deg, own.inflation)),
        ]
        for own in found.quality
    ]


def _plain(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    widths = [max(len(row[column]) for row in [head, *rows]) for column in range(len(head))]
    return "\n".join("  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip() for row in [head, *rows])


def text(found: Identification) -> str:
    """Coefficients and errors before and after, as text."""
    parts = [_plain(_HEAD, _rows(found)), _plain(_BEFORE, _before(found)), f"condition number {found.condition:.3g}, {found.runs} runs"]
    return "\n\n".join(parts)


def _polyline(x: np.ndarray, y: np.ndarray, box: tuple[float, float, float, float], size: tuple[int, int], colour: str, dots: bool = False) -> str:
    """A line, or dots, in a box of data (least x, greatest x, least y, greatest y)."""
    most = max(1, len(x) // 1500)
    across = (x[::most] - box[0]) / (box[1] - box[0] or 1.0) * size[0]
    down = (box[3] - y[::most]) / (box[3] - box[2] or 1.0) * size[1]
    if dots:
        return "".join(f'<circle cx="{a:.1f}" cy="{d:.1f}" r="1.2" fill="{colour}"/>' for a, d in zip(across, down, strict=True))
    points = " ".join(f"{a:.1f},{d:.1f}" for a, d in zip(across, down, strict=True))
    return f'<polyline points="{points}" fill="none" stroke="{colour}" stroke-width="1.3"/>'


def _figure(inside: str, size: tuple[int, int], box: tuple[float, float, float, float], x_name: str, y_name: str) -> str:
    """A framed figure with the numbers of its edges."""
    width, height = size
    marks = "".join(
        f'<text x="{x}" y="{y}" text-anchor="{anchor}">{escape(label)}</text>'
        for x, y, anchor, label in (
            (0, height + 16, "start", f"{box[0]:.4g}"),
            (width, height + 16, "end", f"{box[1]:.4g}"),
            (width / 2, height + 16, "middle", x_name),
            (-4, height, "end", f"{box[2]:.4g}"),
            (-4, 10, "end", f"{box[3]:.4g}"),
        )
    )
    turned = f'<text transform="translate(-40,{height / 2:.0f}) rotate(-90)" text-anchor="middle">{escape(y_name)}</text>'
    zero = ""
    if box[2] < 0.0 < box[3]:
        y = box[3] / (box[3] - box[2]) * height
        zero = f'<line x1="0" x2="{width}" y1="{y:.1f}" y2="{y:.1f}" stroke="#bbb"/>'
    return (
        f'<svg role="img" aria-label="{escape(y_name)} over {escape(x_name)}" viewBox="-60 -10 {width + 75} {height + 40}" width="{width + 75}">'
        f'<rect width="{width}" height="{height}" fill="none" stroke="#888"/>{zero}{inside}{marks}{turned}</svg>'
    )


_MEASURED, _OLD, _NEW = "#777", "#c55a11", "#1f5fa8"


def _way(found: Identification, number: int) -> str:
    """The measured way with the runs before and after."""
    trial = found.trials[number]
    measured = trial.measured
    ways = [(measured, _MEASURED, True), (measured - found.misses_before[number], _OLD, False), (measured - found.misses[number], _NEW, False)]
    every = np.concatenate([way[:, :2] for way, _, _ in ways])
    low, high = every.min(axis=0), every.max(axis=0)
    # One scale to both sides.
    span = float(max(high - low)) * 1.04 or 1.0
    middle = (low + high) / 2.0
    box = (middle[1] - span / 2, middle[1] + span / 2, middle[0] - span / 2, middle[0] + span / 2)
    inside = "".join(_polyline(way[:, 1], way[:, 0], box, (420, 420), colour, dots) for way, colour, dots in ways)
    return _figure(inside, (420, 420), box, "east [m]", "north [m]")


def _left(found: Identification, number: int) -> str:
    """What is left over, over time: distance along north and east, and heading."""
    times = found.trials[number].track.time_s
    figures = []
    for columns, factor, name in (((0, 1), 1.0, "measured less computed [m]"), ((2,), 180.0 / math.pi, "heading [°]")):
        before = np.column_stack([found.misses_before[number][:, column] for column in columns]) * factor
        after = np.column_stack([found.misses[number][:, column] for column in columns]) * factor
        most = float(max(np.abs(before).max(), np.abs(after).max())) * 1.05 or 1.0
        box = (float(times[0]), float(times[-1]), -most, most)
        inside = "".join(_polyline(times, own[:, column], box, (620, 180), colour) for own, colour in ((before, _OLD), (after, _NEW)) for column in range(own.shape[1]))
        figures.append(_figure(inside, (620, 180), box, "time [s]", name))
    return "".join(figures)


def _profile(own: Coefficient) -> str:
    profile = own.profile
    assert profile is not None
    x, y = np.array(profile.factors), np.array(profile.rises)
    box = (float(x.min()), float(x.max()), 0.0, max(5.0, float(y.max())))
    edge = (1.0 - 3.84 / box[3]) * 140
    inside = f'<line x1="0" x2="300" y1="{edge:.1f}" y2="{edge:.1f}" stroke="{_OLD}"/>' + _polyline(x, y, box, (300, 140), _NEW) + _polyline(x, y, box, (300, 140), _NEW, True)
    return f"<figure>{_figure(inside, (300, 140), box, 'factor', 'rise')}<figcaption>{escape(own.name)}: the band ends where the rise is 3.84</figcaption></figure>"


_STYLE = """body{font:15px/1.5 system-ui,sans-serif;max-width:60rem;margin:2rem auto;padding:0 1rem;color:#222}
table{border-collapse:collapse;margin:1rem 0}td,th{border:1px solid #ccc;padding:.25rem .6rem;text-align:left}
svg{max-width:100%;height:auto}svg text{font-size:11px;fill:#444}figure{margin:1rem 0}.refused{color:#a33}"""


def page(found: Identification) -> str:
    """A page of its own, without scripts."""
    parts = [f"<h1>Identification of {escape(found.vessel)}</h1>"]
    parts.append("<p>Each coefficient is a factor on the number that the vessel had before. The state of the ship at the start of each track is fitted too.</p>")
    parts.append(_table(_HEAD, _rows(found)))
    for own in found.coefficients:
        if own.refused is not None:
            parts.append(f'<p class="refused">The data do not tell <b>{escape(own.name)}</b>: {escape(own.refused)}. It stays at its start value; the other values hold for this start value.</p>')
    parts.append("<h2>Numbers</h2>")
    numbers = [(path, f"{old:.6g}", f"{new:.6g}") for own in found.coefficients for path, (old, new) in own.values.items()]
    parts.append(_table(["path in the vessel's file", "before", "after"], numbers))
    if len(found.fitted) > 1:
        parts.append("<h2>Correlation</h2>")
        parts.append(_table(["", *found.fitted], [[name, *(f"{value:.2f}" for value in row)] for name, row in zip(found.fitted, found.correlation, strict=True)]))
    parts.append(f"<p>Condition number of the scaled Jacobian: {found.condition:.3g}.</p>")
    parts.append("<h2>Before and after</h2>")
    parts.append("<p>Root of the mean squared error. The last column says how many times wider the variances are because what is left over follows itself: about 1 for the noise of a receiver, more where the model is what is left.</p>")
    parts.append(_table(_BEFORE, _before(found)))
    profiles = [own for own in found.coefficients if own.profile is not None]
    if profiles:
        parts.append("<h2>Profiles of the likelihood</h2>" + "".join(map(_profile, profiles)))
    for number, quality in enumerate(found.quality):
        parts.append(f"<h2>{escape(quality.label)}</h2>")
        parts.append(f'<p>Measured <span style="color:{_MEASURED}">●</span>, before <span style="color:{_OLD}">■</span>, after <span style="color:{_NEW}">■</span></p>')
        parts.append(_way(found, number) + "<h3>What is left over</h3>" + _left(found, number))
    if found.remarks:
        parts.append("<h2>Remarks</h2><ul>" + "".join(f"<li>{escape(remark)}</li>" for remark in found.remarks) + "</ul>")
    return f'<!doctype html><html lang="en"><head><meta charset="utf-8"><title>Identification of {escape(found.vessel)}</title><style>{_STYLE}</style></head><body>{"".join(parts)}</body></html>\n'
