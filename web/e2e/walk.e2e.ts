/**
 * A newcomer as instructor, through the page alone: a new exercise, a run with a fault, and its debrief, within ten minutes. The times are
 * printed, and each step leaves a picture.
 */
import { copyFileSync, mkdtempSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { type Browser, SHOTS, type Served, browse, open, serve } from "./browser";

const BERTHING = new URL("../../scenarios/live/berthing.toml", import.meta.url).pathname;
const folder = mkdtempSync(join(tmpdir(), "fenderline-walk-"));

const errors: string[] = [];
let served: Served;
let browser: Browser;
let page: Page;

beforeAll(async () => {
  copyFileSync(BERTHING, join(folder, "berthing.toml"));
  served = await serve([], join(folder, "berthing.toml"));
  browser = await browse({ width: 1366, height: 768 });
});
afterAll(async () => {
  await browser.close();
  await served.close();
});

let step = 0;
const times: string[] = [];
const shot = async (what: string, begun: number) => {
  step += 1;
  times.push(`${((Date.now() - begun) / 1000).toFixed(0)} s ${what}`);
  await page.screenshot({ path: join(SHOTS, `walk-${step}-${what.replaceAll(" ", "-")}.png`) });
};

test("an instructor who has never seen it makes, runs and debriefs an exercise within ten minutes", async () => {
  const begun = Date.now();
  page = await open(browser.context, served, "instructor", errors, true);
  await page.getByRole("status", { name: "Hint" }).waitFor();
  await shot("first look", begun);

  // A new exercise at the berth that is there.
  await page.getByRole("tab", { name: "New exercise" }).click();
  const form = page.getByRole("tabpanel", { name: "New exercise" });
  const field = (name: string) => form.getByLabel(name, { exact: true });
  await field("Title").fill("My first exercise");
  await field("Berth").selectOption("berthing.toml");
  await field("Number of tugs").selectOption("2");
  await field("Wind").fill("8");
  await field("File name").fill("first");
  await shot("new exercise", begun);
  await page.getByRole("button", { name: "Save exercise" }).click();
  const now = form.getByRole("button", { name: "Open it now: the saved exercise" });
  await now.click();
  await page.getByRole("button", { name: "End this run" }).click();
  await page.locator("header", { hasText: "My first exercise" }).waitFor();
  await shot("opened", begun);

  // She begins nearer, and the run begins.
  await page.getByRole("tab", { name: "Place ships" }).click();
  const ship = page.getByRole("form", { name: "Place Ship" });
  await ship.getByLabel("North").fill("-120");
  await ship.getByRole("button", { name: "Place", exact: true }).click();
  await shot("placed", begun);
  await page.getByRole("button", { name: "Resume" }).click();
  await page.getByRole("button", { name: "Pace 4" }).click();

  // A fault, planned and at once; a note for the debriefing.
  await page.getByRole("tab", { name: "Weather, faults" }).click();
  await page.getByLabel("Changes happen in").selectOption("1");
  await page.getByRole("button", { name: "ship: Rudder stuck" }).click();
  await page.getByText("ship: rudder stuck", { exact: false }).first().waitFor();
  await page.getByLabel("Changes happen in").selectOption("0");
  await page.getByRole("button", { name: "ship: Engine lost" }).click();
  await page.locator(".fault[aria-pressed=true]", { hasText: "Engine lost" }).waitFor();
  await page.getByLabel("Note for the debriefing").fill("Engine lost: what does she do?");
  await page.getByRole("button", { name: "Note", exact: true }).click();
  await shot("fault", begun);
  await page.locator(".planned .state", { hasText: "has happened" }).waitFor({ timeout: 60_000 });

  // Once more from before the fault, as another branch.
  await page.getByRole("button", { name: "Rewind to the start" }).click();
  await page.getByRole("button", { name: "Go on from here as a new branch" }).click();
  await page.getByRole("button", { name: "Resume" }).click();
  await expect
    .poll(() => page.getByRole("timer").textContent(), { timeout: 60_000 })
    .toMatch(/0:[2-9]\d$/);
  await page.getByRole("button", { name: "Pause" }).click();
  await shot("branch", begun);

  // The debrief, of the run with the faults.
  await page.getByRole("button", { name: /^First run/ }).click();
  await page.locator(".lane[aria-pressed=true]", { hasText: "First run" }).waitFor();
  const [report] = await Promise.all([
    browser.context.waitForEvent("page"),
    page.getByRole("button", { name: /^Report of the session/ }).click(),
  ]);
  await report
    .getByRole("heading", { name: "Branches side by side" })
    .waitFor({ timeout: 120_000 });
  await report.getByRole("heading", { name: "Log of the session" }).waitFor();
  const text = (await report.locator("body").textContent()) ?? "";
  for (const said of ["Engine lost: what does she do?", "engine lost", "rudder stuck"])
    expect(text).toContain(said);
  times.push(`${((Date.now() - begun) / 1000).toFixed(0)} s debrief`);
  await report.setViewportSize({ width: 1100, height: 1400 });
  await report.getByRole("heading", { name: "Branches side by side" }).scrollIntoViewIfNeeded();
  await report.screenshot({ path: join(SHOTS, "walk-8-debrief.png") });
  console.log(`walk of a new instructor: ${times.join(", ")}`);
  expect(Date.now() - begun).toBeLessThan(600_000);
  expect(errors).toEqual([]);
});
