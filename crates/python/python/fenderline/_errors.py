"""Exceptions."""

from __future__ import annotations


class Error(Exception):
    """Base class of all exceptions of this package."""

    run: int | None = None
    """Of many runs, the number of the one that failed, from 0."""


class ArgumentError(Error, ValueError):
    """An argument of a call that is out of its range; nothing has changed.

    >>> import fenderline
    >>> simulation = fenderline.Simulation(fenderline.example("tug_4kn"))
    >>> try:
    ...     simulation.step(-1)
    ... except fenderline.ArgumentError as error:
    ...     print(error)
    steps must be from 0 to 1000000000, but is -1
    """


class ScenarioError(Error, ValueError):
    """An error in a scenario, with its location.

    >>> import fenderline
    >>> try:
    ...     fenderline.Scenario.parse("[time]\\nstep = '4 kn'\\n", "tug.toml")
    ... except fenderline.ScenarioError as error:
    ...     print(error.file, error.line, error.key)
    tug.toml 2 time.step
    """

    file: str | None = None
    """The file, or for a replaced key the replacement."""
    line: int | None = None
    """Line of the file, from 1; ``None`` if the error is not in a single line."""
    column: int | None = None
    """Column in characters, from 1."""
    key: str | None = None
    """Dotted path of the key, as ``material.rubber.stiffness``."""
    message: str | None = None
    """The error, in one line."""
    help: str | None = None
    """A suggested correction."""


class EngineError(Error, ValueError):
    """An invalid call of an engine; the engine is unchanged."""


class SimulationError(Error, RuntimeError):
    """A failed step, or an invalid call of a simulation."""


class CampaignError(Error, ValueError):
    """A campaign that cannot begin or go on: what is wrong with its file, its values or its folder."""
