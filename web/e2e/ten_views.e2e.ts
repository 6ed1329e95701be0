/**
 * Ten pages with the view open, drawn on the processor: the simulation begins no tick late. It runs alone, by
 * `npm run e2e:views`, because ten views keep any machine busy. `VIEWS_S` is the time that it measures (s).
 */
import { cpus, loadavg } from "node:os";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { type Browser, type Served, SOFTWARE_WEBGL, browse, open, serve } from "./browser";

const VIEWS = 10;
const MEASURED_S = Number(process.env.VIEWS_S ?? 60);
const ROLES = ["pilot", "observer", "tugmaster"];
const HARBOUR = new URL("../../scenarios/live/harbour.toml", import.meta.url).pathname;

const errors: string[] = [];
let served: Served;
let browser: Browser;
let instructor: Page;
const views: Page[] = [];

beforeAll(async () => {
  served = await serve([], HARBOUR);
  browser = await browse({ width: 1280, height: 720 }, false, SOFTWARE_WEBGL);
  instructor = await open(browser.context, served, "instructor", errors);
});
afterAll(async () => {
  await browser.close();
  await served.close();
});

/** How many ticks of the session began late, by more than half a time step, as the instructor's page says. */
async function lateTicks(): Promise<number> {
  const text = await instructor.getByText(/ late ticks/).textContent();
  const [, ticks] = /(\d+) late ticks/.exec(text ?? "") ?? [];
  if (ticks === undefined) throw new Error(`no late ticks in "${text}"`);
  return Number(ticks);
}

/** How often each view has drawn. */
const drawn = (): Promise<number[]> =>
  Promise.all(
    views.map(async (page) =>
      Number(await page.locator(".window canvas").getAttribute("data-drawn")),
    ),
  );

test(`no tick is late while ${VIEWS} views draw for ${MEASURED_S} s`, async () => {
  while (views.length < VIEWS) {
    const role = ROLES[views.length % ROLES.length] ?? "observer";
    const page = await open(browser.context, served, role, errors);
    await page.getByRole("button", { name: "View out of the window" }).click();
    await page.waitForFunction(
      () => document.querySelector<HTMLElement>(".window canvas")?.dataset.drawn !== undefined,
      undefined,
      { timeout: 120_000 },
    );
    views.push(page);
  }
  const [lateBefore, drawnBefore] = [await lateTicks(), await drawn()];
  await instructor.waitForTimeout(MEASURED_S * 1000);
  const [late, drawnAfter] = [(await lateTicks()) - lateBefore, await drawn()];
  const rates = drawnAfter.map((count, index) => (count - (drawnBefore[index] ?? 0)) / MEASURED_S);
  const load = (loadavg()[0] ?? 0).toFixed(1);
  console.log(`${late} late ticks in ${MEASURED_S} s; load ${load} on ${cpus().length} cores`);
  console.log(`drawings a second: ${rates.map((rate) => rate.toFixed(1)).join(", ")}`);
  for (const rate of rates) expect(rate, "each view draws").toBeGreaterThan(0);
  expect(late).toBe(0);
  expect(errors).toEqual([]);
}, 1_200_000);
