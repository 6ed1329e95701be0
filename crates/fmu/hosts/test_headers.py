"""The library has every function of the standard's headers (those that FMPy ships) for what it is."""

import ctypes
import re
from pathlib import Path

import fmpy
import pytest
from conftest import BERTHING
from fmpy import extract

HEADERS = Path(fmpy.__file__).parent / "c-code"
# Of FMI 2.0, what a master asks of co-simulation: its header has model exchange too.
MODEL_EXCHANGE = {
    "fmi2EnterEventMode", "fmi2NewDiscreteStates", "fmi2EnterContinuousTimeMode", "fmi2CompletedIntegratorStep",
    "fmi2SetTime", "fmi2SetContinuousStates", "fmi2GetDerivatives", "fmi2GetEventIndicators",
    "fmi2GetContinuousStates", "fmi2GetNominalsOfContinuousStates",
}  # fmt: skip


@pytest.mark.parametrize("fmi, untold", [(2, MODEL_EXCHANGE), (3, set())])
def test_every_function_of_the_header_is_there(fenderline, fmi, untold):
    header = (HEADERS / f"fmi{fmi}FunctionTypes.h").read_text()
    names = {name.removesuffix("TYPE") for name in re.findall(rf"\b(fmi{fmi}\w+TYPE)\b", header)}
    assert len(names) > 40
    (library,) = Path(extract(str(fenderline.fmu(BERTHING, "engine", fmi)))).glob("binaries/*/*.so")
    found = ctypes.CDLL(str(library))
    assert [name for name in sorted(names - untold) if not hasattr(found, name)] == []
