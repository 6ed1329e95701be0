"""Texts of the files: a layer as GeoJSON, and the tables of the scenario."""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Any

from fenderline.charts._area import Area


def layer_text(layer: str, features: Sequence[dict[str, Any]]) -> str:
    """A layer as GDAL writes it: its name, and one feature in a line."""
    lines = ",\n".join(json.dumps(feature, ensure_ascii=False, separators=(",", ":")) for feature in features)
    return f'{{\n"type":"FeatureCollection",\n"name":{json.dumps(layer)},\n"features":[\n{lines}\n]\n}}\n'


def snippet(
    area: Area, origin: tuple[float, float], charts: Sequence[str], surveys: Sequence[str], about: Sequence[str], current: tuple[str, Sequence[str]] | None = None
) -> str:
    """The tables ``[chart]``, ``[environment.bottom]`` and ``[environment.current]`` of a scenario beside the files."""
    of_charts = f" ({'; '.join(about)})" if about else ""
    lines = [f"# Made by python -m fenderline.charts from a chart or survey{of_charts}; area {area}. Not for navigation."]
    if charts:
        latitude, longitude = origin
        lines += [
            "[chart]",
            "files = [",
            *(f"    {json.dumps(name)}," for name in charts),
            "]",
            'coordinates = "longitude_latitude"',
            'projection = "transverse_mercator"',
            f'origin = {{ latitude = "{latitude} deg", longitude = "{longitude} deg" }}',
            "",
        ]
    if surveys:
        names = ", ".join(json.dumps(name) for name in surveys)
        lines += ["[environment.bottom]", f"survey = [{names}]", ""]
    elif any(name in ("DEPARE.geojson", "DRGARE.geojson") for name in charts):
        lines += ["[environment.bottom]", 'chart = "interpolated"          # or "least"', ""]
    if current:
        name, told = current
        lines += ["[environment.current]", *(f"# {line}" for line in told), f"file = {json.dumps(name)}", ""]
    return "\n".join(lines)
