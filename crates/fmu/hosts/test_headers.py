"""The library has every function for co-simulation of the standard's headers, as shipped by FMPy."""

import ctypes
import re
from pathlib import Path

import fmpy
import pytest
from conftest import BERTHING
from fmpy import extract

HEADERS = Path(fmpy.__file__).parent / "c-code"
# The header of FMI 2.0 has these functions for model exchange only.
MODEL_EXCHANGE = {
    "fmi2EnterEventMode", "fmi2NewDiscreteStates", "fmi2EnterContinuousTimeMode", "fmi2CompletedIntegratorStep",
    "fmi2SetTime", "fmi2SetContinuousStates", "fmi2GetDerivatives", "fmi2GetEventIndicators",
    "fmi2GetContinuousStates", "fmi2GetNominalsOfContinuousStates",
}  # fmt: skip


@pytest.mark.parametrize("fmi, unneeded", [(2, MODEL_EXCHANGE), (3, set())])
def test_every_function_of_the_header_is_there(fenderline, fmi, unneeded):
    header = (HEADERS / f"fmi{fmi}FunctionTypes.h").read_text()
    names = {name.removesuffix("TYPE") for name in re.findall(rf"\b(fmi{fmi}\w+TYPE)\b", header)}
    assert len(names) > 40
    (library,) = Path(extract(str(fenderline.fmu(BERTHING, "engine", fmi)))).glob("binaries/*/*.so")
    found = ctypes.CDLL(str(library))
    assert [name for name in sorted(names - unneeded) if not hasattr(found, name)] == []
