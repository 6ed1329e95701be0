"""The vessel of a trial as a vessel file: her coefficients by their paths, and files with changed coefficients."""

from __future__ import annotations

import copy
import math
import re
import tomllib
from collections.abc import Iterable, Mapping
from fnmatch import fnmatchcase
from typing import Any

from fenderline._native import Scenario, scenario_of_parts, vessel_files, vessel_numbers
from fenderline._names import unknown
from fenderline._tree import dumps
from fenderline.identify._errors import IdentifyError

#: The tables of a vessel file that have coefficients.
TABLES = ("added_mass", "sway_polynomial", "drift_polynomial", "low_speed", "propeller", "rudder")
#: Keys below these tables are written one by one; all other tables of coefficients are written as a whole.
_BY_KEY = ("propeller", "rudder")
#: Keys of a scenario's vessel that a vessel file does not have.
_OF_SCENARIO = ("wind_coefficients", "current_coefficients", "wave_response", "hydrodynamics", "roll_damping", "kind", "conning")
#: Name of the file of the changed vessel among the files of a scenario.
OWN_FILE = "fenderline-identify.toml"
#: Name of the changed vessel.
OWN_NAME = "fenderline-identify"

#: Words for groups of coefficients, each a factor on all numbers of its paths that the vessel has.
WORDS: dict[str, tuple[str, ...]] = {
    "surge added mass": ("added_mass.surge", "added_mass.surge_volume"),
    "sway added mass": ("added_mass.sway", "added_mass.sway_volume"),
    "yaw added mass": ("added_mass.yaw", "added_mass.yaw_volume"),
    "resistance": ("sway_polynomial.resistance", "drift_polynomial.x_0"),
    "hull drag in turns": ("sway_polynomial.x_*", "drift_polynomial.x_[br]*"),
    "hull sway force": ("sway_polynomial.y_*", "drift_polynomial.y_*"),
    "hull yaw moment": ("sway_polynomial.n_*", "drift_polynomial.n_*"),
    "hull yaw damping": ("sway_polynomial.n_r*", "drift_polynomial.n_r*"),
    "cross-flow drag": ("low_speed.drag",),
    "rudder force": ("rudder.lift_gradient",),
    "flow straightening": ("rudder.straightening.*",),
    "thrust": ("propeller.thrust.*",),
    "wake": ("propeller.wake",),
}


class VesselFile:
    """The vessel of a body, with her coefficients by their paths in a vessel file."""

    def __init__(self, scenario: Scenario, body: str) -> None:
        self.scenario = scenario
        self.body = body
        self._parts = scenario.__reduce__()[1]
        self._tree = scenario.tree()
        bodies = self._tree.get("body", {})
        if body not in bodies:
            raise IdentifyError(unknown("body", body, bodies))
        name = bodies[body].get("vessel")
        if name is None:
            raise IdentifyError(f"the body {body!r} of {scenario.name} is no vessel: give it a `vessel`")
        own = self._tree.get("vessel", {}).get(name)
        self.is_of_scenario = own is not None
        #: Name of the vessel in the library, in a file, or in the scenario.
        self.name: str = name if own is None else own.get("from", name)
        self._own_name = name
        if own is not None and "from" not in own:
            self.table = {key: value for key, value in own.items() if key not in _OF_SCENARIO}
            self.table = {"title": str(own.get("title", name))} | self.table
            given = sorted(key for key in self.table if key != "title")
            self.table["source"] = [{"of": given, "source": f"the scenario {scenario.name}", "standing": "assumed"}]
        else:
            self.table = self._of_files(self.name)
        numbers = dict(vessel_numbers(scenario, body))
        #: Length between perpendiculars (m).
        self.length_m: float = numbers.pop("particulars.length_bp")
        #: Place of the centre of gravity forward of midship (m), to which the states of a body belong.
        self.gravity_m: float = numbers.pop("particulars.centre_of_gravity")
        #: Each coefficient by its path: the number or text of the vessel's file, or else the number that the program took.
        self.values: dict[str, Any] = self._own_values()
        self._taken = {path: value for path, value in numbers.items() if self._is_free(path)}
        self.values |= self._taken

    def _of_files(self, name: str) -> dict[str, Any]:
        files = dict(vessel_files())
        files |= dict(self._parts[4])
        for file, text in files.items():
            if not file.endswith(".toml"):
                continue
            vessels = tomllib.loads(text).get("vessel", {})
            if name in vessels and isinstance(vessels[name], dict) and "title" in vessels[name]:
                return copy.deepcopy(vessels[name])
        raise IdentifyError(f"the vessel {name!r} of {self.scenario.name} is in no vessel file")

    def _own_values(self) -> dict[str, Any]:
        found: dict[str, Any] = {}

        def collect(table: Mapping[str, Any], path: str) -> None:
            for key, value in table.items():
                if isinstance(value, dict):
                    collect(value, f"{path}.{key}")
                elif _number(value) is not None:
                    found[f"{path}.{key}"] = value

        for name in TABLES:
            collect(self.table.get(name, {}), name)
        return found

    def _is_free(self, path: str) -> bool:
        """Whether the vessel's file leaves this number to the program."""
        table, *below = path.split(".")
        if table not in self.table:
            return True
        return table in _BY_KEY and below[0] not in self.table[table]

    def paths(self, name: str) -> list[str]:
        """The paths of a coefficient, of a pattern such as ``sway_polynomial.n_*``, or of a word such as ``rudder force``."""
        patterns = WORDS.get(name, (name,))
        found = [path for path in self.values if any(fnmatchcase(path, pattern) for pattern in patterns)]
        if not found:
            raise IdentifyError(f"{self.name}: {unknown('coefficient', name, [*WORDS, *self.values])}")
        usable = [path for path in found if self.number(path) != 0.0]
        if not usable:
            raise IdentifyError(f"{self.name}: {name} is 0, and a factor changes nothing: write your guess into the vessel's file")
        return usable

    def number(self, path: str) -> float:
        """The number at a path, in the unit of the file."""
        value = _number(self.values[path])
        assert value is not None
        return value

    def changed(self, factors: Mapping[str, float]) -> dict[str, Any]:
        """The table of the vessel with numbers multiplied by factors."""
        # Only these tables change; an outline of a hundred points need not be copied for each run.
        table = self.table | {name: copy.deepcopy(self.table[name]) for name in TABLES if name in self.table}
        names = {path.split(".")[0] for path in factors}
        wholes = {name for name in names if name not in _BY_KEY and name not in self.table}
        keys = {tuple(path.split(".")[:2]) for path in factors if path.split(".")[0] in _BY_KEY and path in self._taken}
        # The change of the wake is an estimate only where the wake is one.
        if ("propeller", "wake") in keys:
            keys |= {("propeller", "wake_change")}
        for path, value in self._taken.items():
            name, key, *_ = path.split(".")
            if name in wholes or (name, key) in keys:
                _put(table, path, value)
        for path, factor in factors.items():
            _put(table, path, _times(self.values[path], factor))
        return table

    def written(self, name: str, factors: Mapping[str, float], sources: Mapping[str, str], title: str | None = None) -> str:
        """The text of a vessel file with changed numbers. ``sources`` has the source of each changed path."""
        table = self.changed(factors)
        given = set(_leaves(self.table))
        entries = [dict(entry) for entry in table.pop("source")]
        taken = sorted(path for path in _leaves(table) if path not in given and path not in sources)
        for entry in entries:
            entry["of"] = [key for key in entry["of"] if key not in sources]
        entries = [entry for entry in entries if entry["of"]]
        for text in dict.fromkeys(sources.values()):
            entries.append({"of": [path for path, own in sources.items() if own == text], "source": text, "standing": "derived"})
        if taken:
            entries.append({"of": taken, "source": "as the program took it for the vessel that was the start of the fit", "standing": "derived"})
        table["title"] = title or f"{table['title']}, fitted"
        return dumps({"vessel": {name: table | {"source": entries}}})

    def scenario_with(self, table: Mapping[str, Any], keys: Mapping[str, str]) -> Scenario:
        """The scenario with a changed vessel in a file of its own; ``keys`` replaces keys."""
        text, name, folder, _, files = self._parts
        tree = self._tree | {"vessel_files": [*self._tree.get("vessel_files", []), OWN_FILE]}
        if self.is_of_scenario:
            own = tree["vessel"][self._own_name]
            rest = {key: value for key, value in own.items() if "from" in own or key in _OF_SCENARIO}
            tree["vessel"] = tree["vessel"] | {self._own_name: rest | {"from": OWN_NAME}}
        else:
            tree["body"] = tree["body"] | {self.body: tree["body"][self.body] | {"vessel": OWN_NAME}}
        replaced = [(f"set {key}", key, value) for key, value in keys.items()]
        vessel = dict(table) | {"source": _one_source(table)}
        return scenario_of_parts(dumps(tree), name, folder, replaced, dict(files) | {OWN_FILE: dumps({"vessel": {OWN_NAME: vessel}})})


def _one_source(table: Mapping[str, Any]) -> list[dict[str, Any]]:
    """One source for all numbers of a vessel that is tried."""
    of = [key for key in table if key not in ("title", "tank_model", "coefficients_of", "source")]
    return [{"of": of, "source": "a trial of the fit", "standing": "assumed"}]


def _leaves(table: Mapping[str, Any], path: str = "") -> Iterable[str]:
    for key, value in table.items():
        if key == "source" and not path:
            continue
        if isinstance(value, dict):
            yield from _leaves(value, f"{path}{key}.")
        else:
            yield f"{path}{key}"


def _put(table: dict[str, Any], path: str, value: object) -> None:
    *above, last = path.split(".")
    for key in above:
        table = table.setdefault(key, {})
    table[last] = value


def _number(value: object) -> float | None:
    """The number of a value, without its unit.

    >>> _number("112.5 m^2"), _number(0.5), _number("B4-70 pitch 0.8"), _number(True)
    (112.5, 0.5, None, None)
    """
    if isinstance(value, bool):
        return None
    if isinstance(value, int | float):
        return float(value) if math.isfinite(value) else None
    found = re.fullmatch(r"\s*([-+]?[0-9.]+(?:[eE][-+]?[0-9]+)?)\s*[^\s0-9].*", str(value))
    try:
        return None if found is None else float(found[1])
    except ValueError:
        return None


def _times(value: object, factor: float) -> object:
    """A number times a factor, with its unit.

    >>> _times("112.5 m^2", 1.1), _times(0.5, 1.1)
    ('123.75 m^2', 0.55)
    """
    number = _number(value)
    assert number is not None
    product = float(f"{number * factor:.9g}")
    if isinstance(value, str):
        unit = re.sub(r"^\s*[-+]?[0-9.]+(?:[eE][-+]?[0-9]+)?\s*", "", value)
        return f"{product!r} {unit}"
    return product
