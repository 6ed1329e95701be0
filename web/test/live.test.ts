import { expect, test } from "vitest";
import { Latency, Live, STALE_MS } from "../src/live";
import type { BodyNow, Frame, Hello, Role } from "../src/protocol";

function frame(tick: number, north: number, paused = false): Frame {
  const bodies: BodyNow[] = [
    [north, 0, 0, 0, 0, 0],
    [0, 40, 1, 0, 0, 0],
  ];
  return {
    type: "frame",
    tick,
    t_s: tick / 10,
    at_ms: 0,
    bodies,
    eyes: null,
    vessels: [],
    fenders: [],
    contacts: [],
    lines: [],
    anchors: [],
    tugs: [],
    traffic: [],
    passages: [],
    run: {
      paused,
      pace: 1,
      late_ticks: 0,
      latest_ms: 0,
      branch: 0,
      branches: [],
      last_tick: tick,
      clients: 1,
      opening: null,
    },
    wind: { speed_mps: 5, from_rad: 0 },
    current: { speed_mps: 0, to_rad: 0 },
    waves: null,
    water_level_m: 0,
    visibility_m: null,
    approach_mps: 0.15,
    alarms: [],
    verdict: { key: "all_well", text: "All well", gravity: "ok", findings: [] },
    exercise: null,
    events: [],
  };
}

test("bodies are interpolated between the last two ticks, and stop at the last one", () => {
  const live = new Live();
  live.tick(frame(1, 0), 1000);
  live.tick(frame(2, 10), 1100);
  expect(live.bodies(1100)[0]?.[0]).toBe(0);
  expect(live.bodies(1150)[0]?.[0]).toBeCloseTo(5, 6);
  expect(live.bodies(1300)[0]?.[0]).toBe(10);
});

test("a rewind is not interpolated", () => {
  const live = new Live();
  live.tick(frame(500, 90), 1000);
  live.tick(frame(100, 10), 1100);
  expect(live.bodies(1100)[0]?.[0]).toBe(10);
});

/** A frame of the pilot whose receiver is frozen at 0 m, while the ship is at `north`. */
const frozen = (tick: number, north: number): Frame => ({
  ...frame(tick, 0),
  eyes: { body: 0, now: [north, 0, 0, 0, 0, 0], water_mps: [0, 0] },
});

test("a frozen instrument does not freeze the view out of the window", () => {
  const live = new Live();
  live.tick(frozen(2, 10), 1000);
  live.tick(frozen(3, 20), 1100);
  expect(live.seenBodies(1150)[0]?.[0]).toBeCloseTo(15, 6);
  expect(live.bodies(1150)[0]?.[0], "the instruments stay").toBe(0);
  expect(live.seenBodies(1150)[1]).toEqual(live.bodies(1150)[1]);
});

test("the view is steady when an instrument freezes, when it works again, and right after a rewind", () => {
  const live = new Live();
  const north = (now_ms: number) => live.seenBodies(now_ms)[0]?.[0];
  live.tick(frame(1, 40), 1000);
  live.tick(frozen(2, 50), 1100);
  expect(north(1100)).toBe(40);
  expect(north(1150)).toBeCloseTo(45, 6);
  live.tick(frame(3, 60), 1200);
  expect(north(1200)).toBe(50);
  expect(north(1250)).toBeCloseTo(55, 6);
  live.tick(frozen(100, 700), 1300);
  expect(north(1300)).toBe(700);
  live.tick(frozen(20, 90), 1400);
  expect(north(1400)).toBe(90);
});

test("missing frames are a fault while the session runs, not while it is paused", () => {
  const live = new Live();
  live.tick(frame(1, 0), 0);
  expect(live.silence(STALE_MS)).toBeNull();
  expect(live.silence(STALE_MS + 1)).toBe(STALE_MS + 1);
  live.tick(frame(2, 0, true), STALE_MS + 2);
  expect(live.silence(100_000)).toBeNull();
});

test("the delay is absolute if the clocks agree, and relative if they do not", () => {
  const together = new Latency();
  for (const ms of [10, 12, 14]) together.add(ms);
  expect(together.figures()).toEqual({ median: 12, p99: 14, clocks: false });
  const apart = new Latency();
  for (const ms of [-50_000, -49_990, -49_980]) apart.add(ms);
  expect(apart.figures()).toEqual({ median: 10, p99: 20, clocks: true });
});

test("each role's page is about its ship, and the instructor chooses any", () => {
  const vessel = (name: string, is_tug = false, serves: number | null = null) => ({
    name,
    is_tug,
    serves,
  });
  const hello = (role: Role, file = "a.toml") =>
    ({
      role,
      file,
      vessels: [vessel("tug", true, 2), vessel("bulker"), vessel("coaster")],
      tugs: [{ name: "pusher", vessel: 1 }],
    }) as unknown as Hello;
  const shipOf = (role: Role) => {
    const live = new Live();
    live.welcome(hello(role));
    return live.ship();
  };
  expect(shipOf({ name: "observer" })).toBe(1);
  expect(shipOf({ name: "pilot" })).toBe(1);
  expect(shipOf({ name: "pilot", vessel: "coaster" })).toBe(2);
  expect(shipOf({ name: "tugmaster", tug: "tug" })).toBe(2);
  expect(shipOf({ name: "tugmaster", tug: "pusher" })).toBe(1);
  const live = new Live();
  live.welcome(hello({ name: "pilot" }));
  expect(live.choice()).toEqual([]);
  live.choose("coaster");
  expect(live.ship(), "a pilot chooses no ship").toBe(1);
  live.welcome(hello({ name: "instructor" }, "b.toml"));
  expect(live.choice().map(({ name }) => name)).toEqual(["bulker", "coaster"]);
  expect(live.ship()).toBe(1);
  live.choose("coaster");
  expect(live.ship()).toBe(2);
  // Kept over a new greeting; another scenario begins with its own ship.
  live.welcome(hello({ name: "instructor" }, "b.toml"));
  expect(live.ship()).toBe(2);
  live.welcome(hello({ name: "instructor" }, "a.toml"));
  expect(live.ship()).toBe(1);
});
