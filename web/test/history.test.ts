import { expect, test, vi } from "vitest";
import { History } from "../src/history";
import { PastRequests } from "../src/past";
import type { Frame, Hello, Past } from "../src/protocol";

/** A frame of a run with one body and nothing else. */
const frame = (t_s: number, branch = 0) =>
  ({
    tick: Math.round(t_s * 10),
    t_s,
    run: { branch },
    bodies: [[0, 0, 0, 1, 0, 0]],
    vessels: [],
    fenders: [],
    lines: [],
    contacts: [],
  }) as unknown as Frame;
const hello = { exercise: null, vessels: [], lines: [] } as unknown as Hello;

/** A past from one second to another. */
function past(from_s: number, till_s: number): Past {
  const t_s = Array.from({ length: till_s - from_s + 1 }, (_, i) => from_s + i);
  const all = (value: number) => t_s.map(() => value);
  return {
    type: "history",
    vessel: 0,
    t_s,
    bow_mps: t_s.map(() => null),
    stern_mps: t_s.map(() => null),
    ahead_mps: all(0.514444),
    turn_radps: all(0),
    bow_m: all(5),
    stern_m: all(6),
    cross_track_m: all(-4),
    under_keel_m: all(2.5),
    of_energy: all(0.25),
    of_reaction: all(0),
    of_working: all(0),
    contact_n: all(2e6),
    events: [],
  };
}

test("what the server kept comes before the page's own values, each time once", () => {
  const history = new History();
  for (let t_s = 99.5; t_s <= 103; t_s += 0.5) history.add(frame(t_s), hello, 0, 0);
  history.restore(past(1, 101));
  const times = history.samples.map(({ t_s }) => t_s);
  expect(times).toEqual([...Array.from({ length: 101 }, (_, i) => i + 1), 101.5, 102, 102.5, 103]);
  expect(history.samples[0]).toMatchObject({
    bow_mps: null,
    bow_m: 5,
    under_keel_m: 2.5,
    of_energy: 25,
    contact_mn: 2,
  });
  expect(history.samples[0]?.ahead_kn).toBeCloseTo(1, 3);
});

test("the clearance under the keel has the limit of her exercise, or that of the cautions", () => {
  const history = new History();
  const vessels = [
    { name: "ship", under_keel_limit_m: 1.05 },
    { name: "tug", under_keel_limit_m: 0.5 },
  ];
  const limits = [{ key: "under_keel", bound: 2 }];
  const limitOf = (ship: number, exercise: unknown) => {
    history.add(frame(0), { exercise, vessels, lines: [] } as unknown as Hello, ship, 0);
    return history.under_keel_limit_m;
  };
  expect(limitOf(0, null)).toBe(1.05);
  expect(limitOf(0, { ship: "ship", limits })).toBe(2);
  expect(limitOf(1, { ship: "ship", limits })).toBe(0.5);
  expect(limitOf(2, null)).toBeNull();
});

test("the past is asked for after the first frame, a jump, and another branch; not while frames follow each other", async () => {
  vi.useFakeTimers();
  const request = vi.fn(() => Promise.resolve<string | null>(null));
  const requests = new PastRequests(request);
  const asks = async () => {
    await vi.advanceTimersByTimeAsync(2000);
    return request.mock.calls.length;
  };
  requests.frame(frame(10));
  expect(await asks()).toBe(1);
  for (let t_s = 10; t_s < 12; t_s += 0.1) requests.frame(frame(t_s));
  expect(await asks()).toBe(1);
  requests.frame(frame(5));
  requests.frame(frame(3));
  expect(await asks()).toBe(2);
  requests.frame(frame(3, 1));
  expect(await asks()).toBe(3);
  request.mockImplementation(() =>
    Promise.resolve("the past of the session was sent a moment ago"),
  );
  requests.forget();
  requests.frame(frame(4, 1));
  await vi.advanceTimersByTimeAsync(20_000);
  expect(request.mock.calls.length).toBe(6);
  vi.useRealTimers();
});
