"""Contact forces between ships, fenders, quays and tugs, and the ship-manoeuvring simulator around them.

- :class:`Engine`: the contact engine for your own simulator. Set states, call ``step``, add its wrenches to your forces.
- :class:`Simulation`: a whole scenario, step by step; :func:`run` runs one to its end.
- :func:`run_many`: thousands of variants on all cores; :class:`Fleet`: many simulations in lockstep.
- :mod:`fenderline.campaign`: runs with values drawn from distributions, on one machine or many.
- :mod:`fenderline.identify`: coefficients of a vessel from measured tracks; :mod:`fenderline.reliability`: rare events.
- :mod:`fenderline.plot`: figures of results.
- :mod:`fenderline.hydrodynamics`: hydrodynamic data of Capytaine, WAMIT, HAMS, Nemoh and AQWA for ships in waves.
- :mod:`fenderline.docking`: a Gymnasium environment, ``fenderline/Docking-v0``; :mod:`fenderline.tugs`: two tugs, for PettingZoo.

Lengths are in metres, angles in radians, forces in newtons, times in seconds. x points north, y east, headings are
clockwise from north; a body's own axes point forward and to starboard.
"""

from fenderline._errors import (
    ArgumentError,
    CampaignError,
    EngineError,
    Error,
    ScenarioError,
    SimulationError,
)
from fenderline._native import (
    CONTACT_TYPE,
    Engine,
    Fleet,
    Scenario,
    Simulation,
    SimulationState,
    StepEvent,
    __version__,
)
from fenderline._results import Column, Results, Table
from fenderline._runs import Runs, example, run, run_many

__all__ = [
    "ArgumentError",
    "CONTACT_TYPE",
    "CampaignError",
    "Column",
    "Engine",
    "EngineError",
    "Error",
    "Fleet",
    "Results",
    "Runs",
    "Scenario",
    "ScenarioError",
    "Simulation",
    "SimulationError",
    "SimulationState",
    "StepEvent",
    "Table",
    "__version__",
    "example",
    "run",
    "run_many",
]
