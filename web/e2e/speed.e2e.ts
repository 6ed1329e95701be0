/**
 * The page's speed: drawings a second on a processor six times slower, memory over a long session, and the charts of what was
 * before a reload. The figures are printed. In CI, where other programs run beside, times decide nothing; memory does.
 * `HOUR=1` measures the memory over a whole simulated hour instead of five minutes; CI measures over two minutes.
 */
import type { CDPSession, Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { type Browser, type Served, browse, open, serve } from "./browser";

const SLOWER = 6;
const LEAST_FPS = 30;
/**
 * Growth over an hour, and over the short form: in the first half hour the charts fill, so that the short form does not tell
 * the hour.
 */
const MOST_MB = process.env.HOUR ? 5 : process.env.CI ? 1 : 1.5;
const MEASURED_S = process.env.HOUR ? 3600 : process.env.CI ? 120 : 300;
/** Ours is 1 s. */
const RELOAD_MS = 3000;
/** A machine of CI is shared: what it draws in a second says little of the page. */
const TIMES_DECIDE = !process.env.CI;
/** Seconds in which drawings are counted, at most. */
const MOST_TRIES = TIMES_DECIDE ? 10 : 3;

const errors: string[] = [];
let served: Served;
let browser: Browser;
let pilot: Page;
let instructor: Page;
let devtools: CDPSession;

beforeAll(async () => {
  served = await serve();
  browser = await browse({ width: 1366, height: 768 }, false, [], true);
  instructor = await open(browser.context, served, "instructor", errors);
  pilot = await open(browser.context, served, "pilot", errors);
  devtools = await browser.context.newCDPSession(pilot);
});
afterAll(async () => {
  await browser.close();
  await served.close();
});

/** Drawings a second within some time. */
const drawings = (page: Page, ms: number): Promise<number> =>
  page.evaluate(
    (ms) =>
      new Promise<number>((done) => {
        let count = 0;
        const begun = performance.now();
        const draw = (now: number) => {
          if (now - begun >= ms) return done((count * 1000) / (now - begun));
          count += 1;
          requestAnimationFrame(draw);
        };
        requestAnimationFrame(draw);
      }),
    ms,
  );

/** Memory that is in use after a collection [MB]. */
async function heap(): Promise<number> {
  await devtools.send("HeapProfiler.collectGarbage");
  const { usedSize } = await devtools.send("Runtime.getHeapUsage");
  return usedSize / 1e6;
}

const simulated_s = async (page: Page): Promise<number> => {
  const [h = 0, m = 0, s = 0] = ((await page.locator(".time").textContent()) ?? "")
    .split(":")
    .map(Number);
  return (h * 60 + m) * 60 + s;
};

test(`a processor ${SLOWER} times slower draws ${LEAST_FPS} times a second`, async () => {
  await pilot.bringToFront();
  for (const tab of ["Docking", "Conning", "Charts"]) {
    await pilot.getByRole("tab", { name: tab }).click();
    await pilot.waitForTimeout(1000);
    await devtools.send("Emulation.setCPUThrottlingRate", { rate: SLOWER });
    const found: number[] = [];
    // Other programs only make it slower: the best is nearest to what the page needs.
    while (found.length < 3 || (found.length < MOST_TRIES && Math.max(...found) < LEAST_FPS))
      found.push(await drawings(pilot, 1000));
    await devtools.send("Emulation.setCPUThrottlingRate", { rate: 1 });
    const best = Math.max(...found);
    console.log(`${tab}: ${found.map((fps) => fps.toFixed(0)).join(", ")} drawings a second`);
    if (TIMES_DECIDE) expect(best, tab).toBeGreaterThanOrEqual(LEAST_FPS);
  }
  expect(errors).toEqual([]);
});

test(`the page's memory grows by at most ${MOST_MB} MB in ${MEASURED_S} s`, async () => {
  await instructor.bringToFront();
  await instructor.getByRole("textbox", { name: "Note" }).fill("before the reload");
  await instructor.getByRole("button", { name: "Note", exact: true }).click();
  await instructor
    .getByRole("button", { name: /^Pace / })
    .last()
    .click();
  await pilot.bringToFront();
  await pilot.getByRole("tab", { name: "Charts" }).click();
  await pilot.waitForTimeout(3000);
  const [from_s, before] = [await simulated_s(pilot), await heap()];
  await expect
    .poll(() => simulated_s(pilot), { timeout: 600_000, interval: 500 })
    .toBeGreaterThan(from_s + MEASURED_S);
  const [till_s, after] = [await simulated_s(pilot), await heap()];
  console.log(
    `${before.toFixed(2)} MB, ${(till_s - from_s).toFixed(0)} s later ${after.toFixed(2)} MB`,
  );
  expect(after - before).toBeLessThan(MOST_MB);
  expect(errors).toEqual([]);
}, 700_000);

test("a page that is loaded again shows charts and log from before within a second", async () => {
  await pilot.getByRole("button", { name: "30 min" }).click();
  const till_s = await simulated_s(pilot);
  expect(till_s).toBeGreaterThan(MEASURED_S);
  const begun = Date.now();
  await pilot.reload();
  await pilot.waitForFunction(
    (before) => {
      const since = document.querySelector<HTMLElement>(".strips")?.dataset.since;
      return since !== undefined && since !== "" && Number(since) <= before;
    },
    Math.max(2, till_s - 1800 + 60),
  );
  const took_ms = Date.now() - begun;
  console.log(
    `charts of ${Math.min(1800, till_s)} s, ${took_ms} ms after the page was loaded again`,
  );
  if (TIMES_DECIDE) expect(took_ms).toBeLessThan(RELOAD_MS);
  await pilot.getByRole("tab", { name: "Alarms" }).click();
  await pilot.getByRole("list", { name: "Events" }).getByText("before the reload").waitFor();
  expect(errors).toEqual([]);
});
