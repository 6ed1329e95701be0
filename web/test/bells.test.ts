import { expect, test } from "vitest";
import { Bells } from "../src/bells";

/** The times at which an alarm rings within ten seconds of frames at 10 Hz. */
function rung(bells: Bells, level: "alarm" | "caution" | null, from_ms: number): number[] {
  const times = Array.from({ length: 100 }, (_, i) => from_ms + i * 100);
  return times.filter((now_ms) => bells.alarm(level, now_ms) !== null);
}

test("an alarm rings at once, and every two seconds until it is acknowledged", () => {
  const bells = new Bells();
  expect(rung(bells, "alarm", 0)).toEqual([0, 2000, 4000, 6000, 8000]);
  expect(rung(bells, null, 10_000)).toEqual([]);
});

test("a caution rings seldom, and an alarm that comes to it rings at once", () => {
  const bells = new Bells();
  expect(rung(bells, "caution", 0)).toEqual([0, 8000]);
  expect(rung(bells, "alarm", 10_000)[0]).toBe(10_000);
});

test("an engine order is answered once; those of the first frame and of a speed pilot are not", () => {
  const bells = new Bells();
  expect(bells.engine(0.5, true, 0)).toBeNull();
  expect(bells.engine(-0.5, true, 1000)).not.toBeNull();
  expect(bells.engine(-0.5, true, 1100)).toBeNull();
  for (let i = 0; i < 50; i++) expect(bells.engine(i / 50, false, 2000 + i * 100)).toBeNull();
  bells.forget();
  expect(bells.engine(0.2, true, 9000)).toBeNull();
  expect(bells.engine(0.4, true, 9500)).not.toBeNull();
});
