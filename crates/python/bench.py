"""Benchmarks of the Python package.

    python crates/python/bench.py

- the cost of a step call, beside the same step called from Rust
- 10,000 tug impacts of varying speed and angle by each method, on one thread and on all, with the processor time that they got, as
  wall-clock time includes waiting for other work on the machine
- steps per second of the docking environment with random actions: one environment, and many on one thread and on all
"""

from __future__ import annotations

import os
import time
from collections.abc import Callable
from typing import Any

import fenderline
import numpy as np
from fenderline._native import seconds_of_steps
from fenderline.docking import DockingEnv, DockingVectorEnv


def step_call() -> None:
    scenario = fenderline.example("tug_4kn").with_set(
        {"contact.method": "coupled", "body.tug.velocity.surge": 0, "body.tug.position": [0, -38.9]}
    )
    engine = fenderline.Engine(scenario)
    engine.step(0.1)
    # The minimum of many short runs: on a busy machine the others are interrupted.
    count, step = 500, engine.step
    best_rust = best_python = np.inf
    for _ in range(500):
        best_rust = min(best_rust, seconds_of_steps(engine, 0.1, count))
        start = time.perf_counter()
        for _ in range(count):
            step(0.1)
        best_python = min(best_python, time.perf_counter() - start)
    rust_us, python_us = best_rust / count * 1e6, best_python / count * 1e6
    print(
        f"step call in contact: {python_us:.2f} µs from Python, {rust_us:.2f} µs from Rust: "
        f"{python_us - rust_us:.2f} µs more, ratio {python_us / rust_us:.2f}"
    )


def timed(work: Callable[[], Any]) -> tuple[float, float, float]:
    """Wall-clock time, processor time, and processor time of this thread (s)."""
    wall, cpu, own = time.perf_counter(), time.process_time(), time.thread_time()
    work()
    return time.perf_counter() - wall, time.process_time() - cpu, time.thread_time() - own


def impacts(method: str) -> None:
    count, random = 10_000, np.random.default_rng(1)
    variants = {
        "body.tug.velocity.surge": random.uniform(0.2, 2.1, count),
        "body.tug.heading": np.pi / 2 + random.uniform(-0.3, 0.3, count),
    }
    scenario = fenderline.example("tug_4kn").with_set({"contact.method": method})
    threads = os.cpu_count() or 1
    # The minimum of five, alternating, as other work may disturb some of them.
    on_one, on_all = [], []
    for _ in range(5):
        on_one.append(timed(lambda: fenderline.run_many(scenario, variants, threads=1)))
        on_all.append(timed(lambda: fenderline.run_many(scenario, variants, threads=threads)))
    (one_wall, one_cpu, _), (all_wall, all_cpu, serial) = min(on_one), min(on_all)
    print(
        f"{count} tug impacts of 200 steps, {method} method: {one_wall:.2f} s on one thread ({one_cpu:.2f} s of processors), "
        f"{all_wall:.2f} s on {threads} ({all_cpu:.2f} s): {one_wall / all_wall:.2f} times as fast, "
        f"{all_cpu / all_wall:.2f} processors busy; load {os.getloadavg()[0]:.1f}"
    )
    # The calling thread waits while the others run: its own time is the serial part.
    ideal = one_cpu / (serial + (all_cpu - serial) / threads)
    print(
        f"  serial part: {serial:.3f} s; with {threads} processors to itself it would be {ideal:.2f} times as fast"
    )


def docking() -> None:
    """Actions are drawn beforehand: a learner computes them by itself."""
    draws = 16
    single = DockingEnv()
    single.reset(seed=0)
    single.action_space.seed(0)
    actions = [single.action_space.sample() for _ in range(draws)]

    def play_one() -> None:
        for step in range(2000):
            _, _, terminated, truncated, _ = single.step(actions[step % draws])
            if terminated or truncated:
                single.reset()

    _, cpu, _ = min(timed(play_one) for _ in range(5))
    print(f"docking, one environment: {2000 / cpu:,.0f} steps a second of a core")
    for count in (64, 1024):
        for threads in (1, os.cpu_count() or 1):
            vector = DockingVectorEnv(count, threads=threads)
            vector.reset(seed=0)
            vector.action_space.seed(0)
            batches = [vector.action_space.sample() for _ in range(draws)]
            steps = 100_000 // count

            def play(
                vector: DockingVectorEnv = vector,
                batches: list[Any] = batches,
                steps: int = steps,
            ) -> None:
                for step in range(steps):
                    vector.step(batches[step % draws])

            wall, cpu, _ = min(timed(play) for _ in range(5))
            done = steps * count
            print(
                f"docking, {count} environments on {threads} threads: {done / wall:,.0f} steps a second, "
                f"{done / cpu:,.0f} a second of a core; load {os.getloadavg()[0]:.1f}"
            )


if __name__ == "__main__":
    step_call()
    impacts("paper")
    impacts("coupled")
    docking()
