/** Frozen instruments: the pilot's page keeps the old values and says nothing, the instructor's shows the truth. */
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { type Browser, SHOTS, type Served, browse, open, serve } from "./browser";

const errors: string[] = [];
let served: Served;
let browser: Browser;
let pilot: Page;
let instructor: Page;

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

const read = async (page: Page, name: string) =>
  (await page
    .locator(".readout div", { has: page.getByTitle(name) })
    .locator("dd")
    .textContent()) ?? "";

test("a frozen heading and speed stay on the pilot's page alone", async () => {
  await pilot.getByRole("button", { name: "Take the helm" }).click();
  await pilot.getByRole("button", { name: "Rudder starboard 35", exact: true }).click();
  await pilot.getByRole("button", { name: "Half ahead", exact: true }).click();
  await instructor.bringToFront();
  await instructor.getByRole("tab", { name: "Weather, faults" }).click();
  await instructor.getByRole("button", { name: "ship: Heading frozen" }).click();
  await instructor.getByRole("button", { name: "ship: Speeds frozen" }).click();
  await instructor.locator('.fault[aria-pressed="true"]', { hasText: "Speeds frozen" }).waitFor();
  await instructor.screenshot({ path: join(SHOTS, "frozen_instructor.png") });
  await pilot.bringToFront();
  await pilot.waitForTimeout(500);
  const shown = [await read(pilot, "Heading"), await read(pilot, "Speed over ground")];
  await instructor.bringToFront();
  await instructor.getByRole("button", { name: "Pace 8" }).click();
  await expect
    .poll(async () => (await read(instructor, "Heading")) !== shown[0], { timeout: 60_000 })
    .toBe(true);
  await expect
    .poll(async () => (await read(instructor, "Speed over ground")) !== shown[1], {
      timeout: 60_000,
    })
    .toBe(true);
  await pilot.bringToFront();
  expect([await read(pilot, "Heading"), await read(pilot, "Speed over ground")]).toEqual(shown);
  expect(await pilot.getByText(/frozen/i).count()).toBe(0);
  await pilot.screenshot({ path: join(SHOTS, "frozen_pilot.png") });
  await instructor.bringToFront();
  await instructor.getByRole("button", { name: "ship: Heading frozen" }).click();
  await instructor.getByRole("button", { name: "ship: Speeds frozen" }).click();
  await pilot.bringToFront();
  await expect.poll(() => read(pilot, "Heading")).not.toBe(shown[0]);
  expect(errors).toEqual([]);
});
