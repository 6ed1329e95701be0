/** A ship passes a moored one: pilot and instructor read how near and how hard, and the plan draws both. */
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { type Browser, type Served, SHOTS, browse, open, serve } from "./browser";

const SCENARIO = new URL("../../scenarios/live/moored_while_a_ship_passes.toml", import.meta.url)
  .pathname;

const errors: string[] = [];
let served: Served;
let browser: Browser;

beforeAll(async () => {
  // She is in reach from the start, and abreast after half a minute.
  served = await serve(['passing.kcs.time="30 s"'], SCENARIO);
  browser = await browse({ width: 1280, height: 800 });
});
afterAll(async () => {
  await browser.close();
  await served.close();
});

const labels = (page: Page) =>
  page.evaluate(() => {
    const plan = document.querySelector<
      HTMLCanvasElement & { labelled?: { placed: { label: { key: string; text: string } }[] } }
    >('canvas[aria-label^="Plan of ship"]');
    return Object.fromEntries(
      (plan?.labelled?.placed ?? []).map(({ label }) => [label.key, label.text]),
    );
  });

test("pilot and instructor see the gap and the force, and read them in the alarms", async () => {
  for (const role of ["pilot", "instructor"]) {
    const page = await open(browser.context, served, role, errors);
    await page.getByRole("tab", { name: "Alarms" }).click();
    await page
      .getByText(/Ship kcs passes ship \d+ m off at 12\.0 kn and pushes her \d+ kN/)
      .first()
      .waitFor({ timeout: 60_000 });
    await page.waitForFunction(() => {
      const plan = document.querySelector<
        HTMLCanvasElement & { labelled?: { placed: { label: { key: string } }[] } }
      >('canvas[aria-label^="Plan of ship"]');
      return plan?.labelled?.placed.some(({ label }) => label.key === "flow ship");
    });
    const drawn = await labels(page);
    expect(drawn["gap ship"]).toMatch(/^\d+ m clear$/);
    expect(drawn["flow ship"]).toMatch(/^flow .+ (ahead|astern), .+ to (port|starboard)$/);
    await page.screenshot({ path: join(SHOTS, `passage-${role}.png`) });
  }
  expect(errors).toEqual([]);
}, 180_000);
