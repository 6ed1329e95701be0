/**
 * What a new instructor and two pilots expect: a change of the wind says where it goes, a refused helm says who has it and how
 * it comes free, and a run that was ended can be opened again.
 */
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { type Browser, type Served, SHOTS, browse, open, serve } from "./browser";

const errors: string[] = [];
let served: Served;
let browser: Browser;
let instructor: Page;

beforeAll(async () => {
  served = await serve();
  browser = await browse({ width: 1280, height: 800 });
  instructor = await open(browser.context, served, "instructor", errors);
});
afterAll(async () => {
  await browser.close();
  await served.close();
});

test("a wind that is set but not sent says so, and one that changes slowly says where it goes", async () => {
  await instructor.getByRole("tab", { name: "Weather, faults" }).click();
  const wind = instructor.getByRole("region", { name: "Wind" });
  await instructor.getByLabel("weather changes over").selectOption("2");
  for (let i = 0; i < 5; i++) await wind.getByRole("button", { name: "More wind" }).click();
  await wind.getByText(/^not set yet; now /).waitFor();
  const wanted = (await wind.locator(".wanted").textContent()) ?? "";
  await wind.getByRole("button", { name: "Set the wind" }).click();
  await wind.getByText(`; goes to ${wanted} until 0:02:`).waitFor();
  await instructor.screenshot({ path: join(SHOTS, "wind-goes-to.png") });
  expect(errors).toEqual([]);
});

test("a second pilot reads how the helm comes free, and the first one that it is asked for", async () => {
  const first = await open(browser.context, served, "pilot", errors);
  const second = await open(browser.context, served, "pilot", errors);
  await first.bringToFront();
  await first.getByRole("button", { name: "Take the helm" }).click();
  await first.getByRole("button", { name: "Release the helm" }).waitFor();
  await second.bringToFront();
  await second.getByRole("button", { name: "Take the helm" }).click();
  await second
    .getByText(/^Refused: pilot \d+ holds this control, and must release it first/)
    .waitFor();
  await first.getByText(/^pilot \d+ asks for the control that you hold/).waitFor();
  await first.close();
  await second.close();
  expect(errors).toEqual([]);
});

test("a run that was ended is among the recorded sessions, the newest first, with its date", async () => {
  await instructor.bringToFront();
  await instructor.getByRole("tab", { name: "Session" }).click();
  const anew = instructor.getByRole("button", { name: /^Start anew/ });
  // The panel over the whole page would hide the plan of what is opened.
  await instructor.getByRole("button", { name: /^Panel over the whole page/ }).click();
  await anew.click();
  await instructor.getByRole("button", { name: "End this run" }).click();
  await instructor.locator(".run-state", { hasText: "PAUSED" }).waitFor();
  expect(await instructor.getByRole("img", { name: "Plan of ship" }).isVisible()).toBe(true);
  const recorded = instructor.locator(".gallery li", {
    hasText: "The session continues where it ended",
  });
  await recorded.first().waitFor();
  expect(await recorded.first().textContent()).toMatch(/\b20\d\d\b.*Saved as berthing-001\./);
  await instructor.screenshot({ path: join(SHOTS, "recorded-sessions.png") });
  expect(errors).toEqual([]);
});
