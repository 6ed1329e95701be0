"""A reader of TELEMAC's results: SELAFIN, plane meshes.

The packages that read SELAFIN are under the GPL, so this is our own reader. The form: records of Fortran, big-endian, each between two counts of
its bytes. The title has 80 characters, of which the last eight say whether numbers have four bytes (``SERAFIN``) or eight (``SERAFIND``).
"""

from __future__ import annotations

import datetime
import struct
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from fenderline.charts._errors import ChartError

SUFFIXES = (".slf", ".sel", ".res", ".srf")
LARGEST_BYTES = 2 << 30


@dataclass
class Selafin:
    """A plane result of TELEMAC."""

    names: list[str]
    """Names of the variables, with their units removed."""
    start: datetime.datetime | None
    """Date of time 0, if the file has it."""
    x: Any
    """First coordinates of the nodes."""
    y: Any
    """Second coordinates of the nodes."""
    triangles: Any
    """Nodes of each triangle."""
    times_s: list[float]
    """Times (s)."""
    values: list[list[Any]]
    """Values at the nodes, by time and variable."""


class _Records:
    """The records of a file, one by one."""

    def __init__(self, file: Path) -> None:
        if file.stat().st_size > LARGEST_BYTES:
            raise ChartError(f"it is larger than {LARGEST_BYTES >> 30} GiB", file)
        self.file, self.data, self.at = file, file.read_bytes(), 0

    def done(self) -> bool:
        return self.at >= len(self.data)

    def next(self, what: str, length: int | None = None) -> bytes:
        (count,) = struct.unpack_from(">i", self.data, self.at) if self.at + 4 <= len(self.data) else (-1,)
        end = self.at + 4 + count
        if count < 0 or end + 4 > len(self.data) or struct.unpack_from(">i", self.data, end)[0] != count:
            raise ChartError(f"it is not SELAFIN, or it is cut off: the record of the {what} does not end where it says", self.file)
        if length is not None and count != length:
            raise ChartError(f"the record of the {what} has {count} bytes, not {length}", self.file)
        record = self.data[self.at + 4 : end]
        self.at = end + 4
        return record


def read(file: Path) -> Selafin:
    """Reads a file; the error names what is wrong with it."""
    import numpy as np

    records = _Records(file)
    title = records.next("title", 80).decode("latin-1")
    if "SERAFIN" not in title and "SELAFIN" not in title:
        raise ChartError("it is not SELAFIN: its title does not end with SERAFIN", file)
    number = ">f8" if title.rstrip().endswith("SERAFIND") else ">f4"
    size = int(number[-1])
    linear, quadratic = struct.unpack(">2i", records.next("numbers of variables", 8))
    if not 0 < linear + quadratic < 1000:
        raise ChartError(f"it has {linear + quadratic} variables", file)
    names = [records.next("name of a variable", 32)[:16].decode("latin-1").strip() for _ in range(linear + quadratic)]
    parameters = struct.unpack(">10i", records.next("parameters", 40))
    start = None
    if parameters[9] == 1:
        date = struct.unpack(">6i", records.next("date", 24))
        try:
            start = datetime.datetime(*date)
        except ValueError as error:
            raise ChartError(f"its date {date} is none", file) from error
    elements, nodes, corners, _ = struct.unpack(">4i", records.next("size of the mesh", 16))
    if parameters[6] > 1 or corners != 3:
        raise ChartError(f"its mesh has {max(parameters[6], 1)} planes and elements of {corners} corners: results of TELEMAC-2D are read, or 2D results of TELEMAC-3D", file)
    triangles = np.frombuffer(records.next("elements", 12 * elements), ">i4").reshape(elements, 3).astype("int64") - 1
    records.next("boundary", 4 * nodes)
    # The origin of the mesh is in whole metres, and is not part of the coordinates.
    x, y = (np.frombuffer(records.next("coordinates", size * nodes), number).astype("float64") + parameters[2 + axis] for axis in (0, 1))
    if elements and (triangles.min() < 0 or triangles.max() >= nodes):
        raise ChartError(f"an element names a node that is not of its {nodes} nodes", file)
    times_s, values = [], []
    while not records.done():
        times_s.append(float(np.frombuffer(records.next("time", size), number)[0]))
        values.append([np.frombuffer(records.next(f"values of {name}", size * nodes), number) for name in names])
    return Selafin(names, start, x, y, triangles, times_s, values)
