/** Acknowledgements and notes by the page's own controls, over a reload, and the report that has them, opened from the page. */
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { type Browser, type Served, SHOTS, browse, open, serve } from "./browser";

const errors: string[] = [];
let served: Served;
let browser: Browser;
let instructor: Page;
let pilot: Page;

beforeAll(async () => {
  served = await serve();
  browser = await browse({ width: 1366, height: 768 });
  instructor = await open(browser.context, served, "instructor", errors);
  pilot = await open(browser.context, served, "pilot", errors);
});
afterAll(async () => {
  await browser.close();
  await served.close();
});

const seconds = async (page: Page) =>
  (await page.getByRole("timer", { name: "Simulated time" }).textContent()) ?? "";

test("an alarm is acknowledged, notes are dropped, and the report from the page has both", async () => {
  const [run, before] = [instructor, await seconds(instructor)];
  await run.bringToFront();
  await run.getByRole("tab", { name: "Weather, faults" }).click();
  await run
    .getByRole("button", { name: /rudder stuck/i })
    .first()
    .click();
  await run.getByLabel("Note for the debriefing").fill("late with the tug");
  await run.getByRole("button", { name: "Note", exact: true }).click();
  await run.locator(".said", { hasText: "Refused" }).waitFor({ state: "detached", timeout: 1000 });
  await expect.poll(() => run.getByLabel("Note for the debriefing").inputValue()).toBe("");
  await run.screenshot({ path: join(SHOTS, "debrief-note.png") });
  await pilot.bringToFront();
  await pilot.getByRole("tab", { name: "Alarms" }).click();
  await pilot.getByRole("button", { name: /^Acknowledge .*rudder stuck/ }).click();
  const list = (page: Page) => page.getByRole("list", { name: "Alarms" });
  await expect.poll(() => list(pilot).textContent()).toContain("✓");
  // A page that is loaded again finds it acknowledged.
  await pilot.reload();
  await pilot.getByRole("tab", { name: "Alarms" }).click();
  await expect.poll(() => list(pilot).textContent()).toContain("✓");
  await run.bringToFront();
  await run.reload();
  await run.getByRole("img", { name: "Plan of ship" }).waitFor();
  await expect.poll(() => seconds(run)).not.toBe(before);
  // Without a text field in focus the key drops a mark.
  await run.getByRole("tab", { name: "Alarms" }).click();
  await run.keyboard.press("n");
  await expect
    .poll(() => run.getByRole("list", { name: "Events" }).textContent())
    .toContain("marks this moment");
  await run.screenshot({ path: join(SHOTS, "debrief-alarms.png") });
  const tab = browser.context.waitForEvent("page");
  await run.getByRole("button", { name: /^Report of the session/ }).click();
  const report = await tab;
  await report.waitForURL(/\/report\?token=/);
  const log = report.getByRole("heading", { name: "Log of the session" });
  await log.waitFor();
  const text = (await report.locator("body").textContent()) ?? "";
  for (const words of ["late with the tug", "rudder stuck", "acknowledgement", "2 notes", "mark"])
    expect(text).toContain(words);
  await log.scrollIntoViewIfNeeded();
  await report.screenshot({ path: join(SHOTS, "debrief-report.png") });
  expect(errors).toEqual([]);
}, 120_000);
