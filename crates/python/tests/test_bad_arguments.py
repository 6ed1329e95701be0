"""Wrong types and values in every argument of every public call: what comes back is an error of ours.

The calls and their arguments come from the type stub, so that a new one is tried without a line here; a required argument whose name
is new needs a good value in ``GOOD``.
"""

from __future__ import annotations

import ast
import inspect
import math
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import fenderline
import numpy as np
import pytest
from fenderline import _native

STUB = Path(_native.__file__).with_name("_native.pyi")

CAMPAIGN = """
scenario = "tug.toml"
number = 5
[variable.speed]
key = "body.tug.velocity.surge"
distribution = "uniform"
lower = 1
upper = 2
"""

#: Values of every kind. Those that a call takes are no mistake.
BAD: list[Any] = [
    None,
    True,
    -1,
    10**30,
    -(10**400),
    1 << 63,
    1.5,
    math.nan,
    math.inf,
    -math.inf,
    1e308,
    "",
    "x",
    "\0",
    b"x",
    [],
    [-1],
    ["x"],
    [None],
    [math.nan],
    {},
    {"x": 1},
    {1: 2},
    {"time.step": math.nan},
    set(),
    object(),
    np.float64(math.nan),
    np.int64(-1),
    np.zeros(0),
    np.full((2, 3), math.nan),
    np.zeros((1, 1), dtype=complex),
    lambda *_: None,
]

#: Calls that would take too long, or that write files where the test runs, with a value that is no mistake.
NO_MISTAKE: dict[str, Callable[[Any], bool]] = {
    "Simulation.run.until_s": lambda value: value is None or value is True,
}


@pytest.fixture
def things(tmp_path: Path) -> dict[str, Any]:
    """One of each class, and good values of arguments by name."""
    (tmp_path / "tug.toml").write_text(fenderline.example("tug_4kn").with_set({"time.duration": 1}).text)
    (tmp_path / "tugs.toml").write_text(CAMPAIGN)
    scenario = fenderline.Scenario.load(tmp_path / "tug.toml", {"time.duration": 1})
    simulation = fenderline.Simulation(scenario)
    docking = _native.Docking(
        fenderline.example("docking"),
        1,
        1,
        [(name, 1.0) for name in fenderline.Simulation(fenderline.example("docking")).control_names[:4]],
        4.0,
    )
    campaign = _native.Campaign(tmp_path / "tugs.toml")
    return {
        "Scenario": scenario,
        "Engine": fenderline.Engine(scenario),
        "Simulation": simulation,
        "SimulationState": simulation.save(),
        "Fleet": fenderline.Fleet(scenario, [{}]),
        "Docking": docking,
        "Campaign": campaign,
        "StepEvent": _native.step_event("touch", ["ship"], None),
        "tmp_path": tmp_path,
    }


def good(name: str, things: dict[str, Any]) -> Any:
    """A good value of a required argument."""
    values: dict[str, Any] = {
        "source": things["Scenario"],
        "scenario": things["Scenario"],
        "engine": things["Engine"],
        "state": things["SimulationState"],
        "campaign": things["Campaign"],
        "path": things["tmp_path"] / "tug.toml",
        "text": things["Scenario"].text,
        "tree": things["Scenario"].tree(),
        "set": {},
        "step_s": 0.1,
        "body": "tug",
        "saved": things["Engine"].save(),
        "variants": [{}],
        "indices": [0],
        "count": 1,
        "threads": 1,
        "levers": [("x", 1.0)],
        "berthed_within_m": 4.0,
        "which": [0],
        "starts": np.zeros((1, 9)),
        "actions": np.zeros((1, 4)),
        "index": 0,
        "run": 0,
        "first": 0,
        "last": 1,
        "probabilities": [0.5],
        "outputs": ["reaction"],
        "folder": things["tmp_path"],
        "rows": [],
        "name": "x",
        "replaced": [],
        "files": {},
        "parts": {},
        "kind": "touch",
        "subjects": ["ship"],
        "fender": None,
        "value": things["Scenario"],
    }
    return values[name]


def arguments(function: ast.FunctionDef) -> Iterator[tuple[str, bool]]:
    """Names of a function's arguments, and whether each must be given."""
    plain = [argument.arg for argument in function.args.args]
    needed = len(plain) - len(function.args.defaults)
    for place, name in enumerate(plain):
        if name not in ("self", "cls"):
            yield name, place < needed
    for argument, default in zip(function.args.kwonlyargs, function.args.kw_defaults, strict=True):
        yield argument.arg, default is None


def calls() -> list[tuple[str, list[tuple[str, bool]]]]:
    """Every public call of the native module, as ``Class.method`` or ``function``, with its arguments."""
    found = []
    for node in ast.parse(STUB.read_text(encoding="utf-8")).body:
        if isinstance(node, ast.FunctionDef):
            found.append((node.name, list(arguments(node))))
        if isinstance(node, ast.ClassDef):
            for method in node.body:
                is_public = isinstance(method, ast.FunctionDef) and (
                    not method.name.startswith("_") or method.name == "__new__"
                )
                if is_public and isinstance(method, ast.FunctionDef):
                    found.append((f"{node.name}.{method.name}", list(arguments(method))))
    return [(name, given) for name, given in found if given]


def is_ours(error: BaseException) -> bool:
    """An error of this package; or a wrong type, with the argument's name; or an index or a file that is not there."""
    if isinstance(error, fenderline.Error | IndexError | OSError):
        return True
    return isinstance(error, TypeError) and str(error) != ""


@pytest.mark.parametrize(("name", "given"), calls(), ids=[name for name, _ in calls()])
def test_a_wrong_argument_is_an_error_of_ours(
    name: str, given: list[tuple[str, bool]], things: dict[str, Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(things["tmp_path"])
    class_name, _, method = name.rpartition(".")
    others_error = []
    for argument, _ in given:
        for bad in BAD:
            if NO_MISTAKE.get(f"{name}.{argument}", lambda _: False)(bad):
                continue
            needed = {other: good(other, things) for other, is_needed in given if is_needed}
            if method == "__new__":
                call = getattr(_native, class_name)
            elif class_name:
                call = getattr(things[class_name], method)
            else:
                call = getattr(_native, name)
            try:
                call(**needed | {argument: bad})
            except Exception as error:  # noqa: BLE001
                if not is_ours(error):
                    others_error.append(f"{argument}={bad!r:.40}: {type(error).__name__}: {error}")
            except BaseException as error:
                if isinstance(error, KeyboardInterrupt):
                    raise
                others_error.append(f"{argument}={bad!r:.40}: {type(error).__name__}: {error}")
    assert others_error == []


def test_every_call_is_in_the_stub() -> None:
    known = {name for name, _ in calls()}
    for class_name, own in vars(_native).items():
        if inspect.isclass(own):
            for method, function in vars(own).items():
                if not callable(function) or method.startswith("_"):
                    continue
                # `**keys` take any name: the scenario's reader looks at them.
                named = [
                    name
                    for name, parameter in inspect.signature(function).parameters.items()
                    if name != "self" and parameter.kind is not inspect.Parameter.VAR_KEYWORD
                ]
                if named:
                    assert f"{class_name}.{method}" in known


def test_minus_one_step_is_named() -> None:
    simulation = fenderline.Simulation(fenderline.example("tug_4kn"))
    before = simulation.states.copy()
    with pytest.raises(fenderline.ArgumentError, match="steps must be from 0 to 1000000000, but is -1"):
        simulation.step(-1)
    with pytest.raises(TypeError, match="steps must be a whole number, but is 1.5"):
        simulation.step(1.5)  # type: ignore[arg-type]
    with pytest.raises(fenderline.EngineError):
        fenderline.Engine(fenderline.example("tug_4kn")).step(-1)
    assert (simulation.states == before).all()
