"""Making objects of the native part again from their pickles.

Functions, and not methods of the classes, so that a pickle names nothing native.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from fenderline import _native
from fenderline._errors import Error
from fenderline._native import Engine, Scenario, Simulation, SimulationState


def scenario(
    text: str,
    name: str,
    folder: str | None,
    replaced: list[tuple[str, str, str]],
    files: dict[str, str],
) -> Scenario:
    """A scenario of its text and the texts of its files. Any version can read it."""
    return _native.scenario_of_parts(text, name, folder, replaced, files)


def simulation(version: str, parts: dict[str, Any]) -> Simulation:
    """A simulation: its steps are computed again."""
    _same_version("simulation", version)
    return _native.simulation_of_parts(parts)


def simulation_state(version: str, parts: dict[str, Any]) -> SimulationState:
    """A saved state: its steps are computed again."""
    return simulation(version, parts).save()


def engine(version: str, arguments: Mapping[str, Any], uses_loads: bool, saved: bytes) -> Engine:
    """An engine with its memory."""
    _same_version("engine", version)
    made = Engine(**arguments)
    made.restore(saved)
    if made.uses_loads != uses_loads:
        made.uses_loads = uses_loads
    return made


def _same_version(what: str, version: str) -> None:
    if version != _native.__version__:
        raise Error(
            f"this {what} was pickled by fenderline {version}; fenderline {_native.__version__} "
            "would go on with other numbers: pickle its scenario, which any version reads"
        )
