"""Attack by inconsistent hosts through Python: random positions and velocities, any time step, altered states.

`FENDERLINE_ATTACK_SECONDS` is the duration, `FENDERLINE_ATTACK_SEED` the seed; see `cargo xtask attack`.
"""

import math
import os
import random
import resource
import struct
import time
from pathlib import Path

import fenderline
import numpy as np
from fenderline import Engine, EngineError, Scenario

SECONDS = float(os.environ.get("FENDERLINE_ATTACK_SECONDS", "3"))
SEED = int(os.environ.get("FENDERLINE_ATTACK_SEED", "1"))
CALLS_OF_ONE = int(os.environ.get("FENDERLINE_ATTACK_CALLS", "20000"))


BERTH = Path(__file__).resolve().parents[3] / "scenarios" / "berth" / "eight_cones_at_5_deg.toml"


def any_float(draw: random.Random) -> float:
    kind = draw.randrange(4)
    if kind == 0:
        return float(struct.unpack("d", draw.randbytes(8))[0])
    if kind == 1:
        return draw.choice([0.0, -0.0, 1e308, -1e308, 5e-324, math.inf, -math.inf, math.nan])
    return draw.uniform(-1, 1) * math.pow(10.0, draw.uniform(-6, 6))


def a_step_s(draw: random.Random) -> float:
    return 0.1 if draw.random() < 0.6 else math.pow(10.0, draw.uniform(-9, 6))


def an_engine(draw: random.Random) -> Engine:
    scenario = fenderline.example("tug_4kn") if draw.random() < 0.5 else Scenario.load(BERTH)
    host = draw.choice(["direct", "cosimulation"])
    if host == "cosimulation":
        return Engine(scenario, method="coupled", host="cosimulation", delay_steps=draw.randrange(3))
    return Engine(scenario, method=draw.choice(["coupled", "paper"]))


def corrupt(engine: Engine, draw: random.Random) -> None:
    """Does something that no correct host does."""
    body = draw.randrange(len(engine.bodies))
    kind = draw.randrange(6)
    if kind == 0:
        engine.states[body] = [any_float(draw) for _ in range(6)]
    elif kind == 1:
        engine.states[body, :2] += [draw.uniform(-30, 30), draw.uniform(-30, 30)]
        engine.states[body, 2] += draw.uniform(-3, 3)
    elif kind == 2:
        engine.states[body, 3:] = [draw.uniform(-9, 9) for _ in range(3)]
    elif kind == 3:
        engine.loads[body, draw.randrange(engine.loads.shape[1])] = any_float(draw)
    elif kind == 4:
        engine.mark_teleported(engine.bodies[body])
    else:
        engine.states[body, draw.randrange(6)] = any_float(draw)


def test_any_input_gives_finite_results_or_an_error() -> None:
    draw = random.Random(SEED)
    until = time.monotonic() + SECONDS
    engines = steps = refused = altered = taken = 0
    slowest_s = 0.0
    while time.monotonic() < until:
        engine = an_engine(draw)
        good, no_loads = engine.states.copy(), engine.loads.copy()
        engines += 1
        for _ in range(60):
            if draw.random() < 0.3:
                try:
                    corrupt(engine, draw)
                except EngineError:
                    refused += 1
            began = time.process_time()
            try:
                engine.step(any_float(draw) if draw.random() < 0.1 else a_step_s(draw))
            except EngineError:
                refused += 1
                engine.states[:] = good
                engine.loads[:] = no_loads
                continue
            finally:
                slowest_s = max(slowest_s, time.process_time() - began)
            steps += 1
            assert np.isfinite(engine.wrenches).all(), (SEED, engines)
            assert np.isfinite(engine.peak_wrenches).all(), (SEED, engines)
        whole = engine.save()
        saved = bytearray(whole)
        for _ in range(draw.randrange(1, 4)):
            saved[draw.randrange(len(saved))] ^= 1 << draw.randrange(8)
        length = draw.randrange(len(saved) + 1) if draw.random() < 0.3 else len(saved)
        # Two flips may cancel.
        if bytes(saved[:length]) == whole:
            continue
        altered += 1
        try:
            engine.restore(bytes(saved[:length]))
            taken += 1
        except EngineError:
            pass
    print(
        f"hosts through Python: {engines} engines, {steps} steps, {refused} refused; "
        f"{altered} altered states, {taken} taken; slowest step {slowest_s:.3f} s; seed {SEED}"
    )
    assert steps > 0
    assert taken == 0, "a check sum detects flipped bits"
    assert slowest_s < 10.0


def test_many_calls_do_not_grow_memory() -> None:
    engine = Engine(Scenario.load(BERTH))
    draw = random.Random(SEED)
    start = engine.states.copy()
    early_kib = 0
    for call in range(CALLS_OF_ONE):
        if call % 500 == 0:
            engine.states[:] = start
            engine.reset()
        engine.step(draw.choice([1 / 60, 0.1, 0.5]))
        engine.states[:] = engine.states_after
        if call == CALLS_OF_ONE // 5:
            early_kib = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    late_kib = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    print(f"one engine through Python: {CALLS_OF_ONE} steps, {early_kib} to {late_kib} KiB at most")
    assert np.isfinite(engine.wrenches).all()
    assert late_kib < early_kib + (16 << 10)
