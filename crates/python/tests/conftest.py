"""Paths of the repository, for the tests."""

import signal
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).resolve().parents[3]


@pytest.fixture(scope="session")
def root() -> Path:
    return ROOT


@pytest.fixture(scope="session")
def scenarios() -> Path:
    return ROOT / "scenarios"


@pytest.fixture
def interruptible() -> Iterator[None]:
    """Programs in the background of a shell ignore interrupts, so that a test of one would never end there."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.fixture(scope="session")
def ray() -> Iterator[Any]:
    """Ray on this machine. It waits for its own services for half a minute, which a busy machine may need."""
    library = pytest.importorskip("ray")
    for _ in range(3):
        try:
            library.init(num_cpus=2, include_dashboard=False, log_to_driver=False)
        except Exception as error:
            print(error)
            library.shutdown()
        else:
            yield library
            library.shutdown()
            return
    pytest.skip("Ray's own services did not start in three tries")
