"""Mistakes, as exceptions."""

from __future__ import annotations


class Error(Exception):
    """Every exception of this package."""


class ScenarioError(Error, ValueError):
    """A scenario that cannot be run: one mistake, and where it is.

    >>> import fenderline
    >>> try:
    ...     fenderline.Scenario.parse("[time]\\nstep = '4 kn'\\n", "tug.toml")
    ... except fenderline.ScenarioError as error:
    ...     print(error.file, error.line, error.key)
    tug.toml 2 time.step
    """

    file: str | None = None
    """The file, or for a key that was replaced what replaced it."""
    line: int | None = None
    """Line of the file, from 1; ``None`` where the mistake is in no one line."""
    column: int | None = None
    """Column in characters, from 1."""
    key: str | None = None
    """Dotted path of the key, as ``material.rubber.stiffness``."""
    message: str | None = None
    """What is wrong, in one line."""
    help: str | None = None
    """What to write in its place."""


class EngineError(Error, ValueError):
    """A call that an engine refuses; the engine is as it was."""


class SimulationError(Error, RuntimeError):
    """A step that cannot be taken, or a call that a simulation refuses."""
