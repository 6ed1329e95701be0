/**
 * The gallery: the instructor opens every scenario from the page, and pilots see it at once; a saved session is opened
 * again.
 */
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { type Browser, type Served, SHOTS, browse, drawn, open, serve } from "./browser";
import { labels } from "./faults";

/** Titles, and whether there is a berth. */
const GALLERY: Record<string, { berth: boolean }> = {
  Berthing: { berth: true },
  Unberthing: { berth: true },
  "Tug escort": { berth: false },
  "Ship to ship": { berth: true },
  Moored: { berth: true },
};

const errors: string[] = [];
let served: Served;
let browser: Browser;
let instructor: Page;
let pilot: Page;

beforeAll(async () => {
  served = await serve();
  browser = await browse({ width: 1280, height: 800 });
  pilot = await open(browser.context, served, "pilot", errors);
  instructor = await open(browser.context, served, "instructor", errors);
});
afterAll(async () => {
  await browser.close();
  await served.close();
});

/** Opens the entry with a title; its button asks for confirmation. */
async function load(title: string): Promise<void> {
  await instructor.bringToFront();
  await instructor.getByRole("tab", { name: "Session" }).click();
  const button = instructor
    .locator(".gallery li", { has: instructor.locator("b", { hasText: title }) })
    .getByRole("button", { name: `Open ${title}` });
  await button.click();
  await instructor.getByRole("button", { name: "End this run" }).click();
  await instructor.locator(".run-state", { hasText: "PAUSED" }).waitFor();
}

for (const [begins, { berth }] of Object.entries(GALLERY)) {
  test(`${begins}: opened from the page, it runs`, async () => {
    await instructor.bringToFront();
    await instructor.getByRole("tab", { name: "Session" }).click();
    const title =
      (await instructor.locator(".gallery b", { hasText: begins }).first().textContent()) ?? "";
    await load(title);
    await instructor.locator("header", { hasText: title }).waitFor();
    await instructor.getByRole("button", { name: "Resume (K)" }).click();
    await instructor.waitForTimeout(2500);
    // A link is for a role, not for a scenario. A tugmaster's link needs a tug of the same name.
    await pilot.bringToFront();
    await pilot.locator("header", { hasText: title }).waitFor();
    await pilot.getByRole("tab", { name: "Docking" }).click();
    await drawn(pilot);
    // The text of the exercise covers neither heading nor speed.
    const hint = pilot.getByRole("status", { name: "Hint" });
    if (await hint.isVisible()) {
      const [own, figures] = [
        await hint.boundingBox(),
        await pilot.locator(".readout").boundingBox(),
      ];
      expect(own?.y).toBeGreaterThanOrEqual((figures?.y ?? 0) + (figures?.height ?? 0));
      await pilot.getByRole("button", { name: "No hints" }).click();
    }
    const off = () =>
      pilot.evaluate(
        () => document.querySelector<HTMLElement>('.end[aria-label="Bow"]')?.dataset.off ?? "none",
      );
    await expect.poll(async () => Number.isFinite(Number(await off()))).toBe(berth);
    await pilot.screenshot({
      path: join(SHOTS, `gallery-${begins.toLowerCase().replaceAll(" ", "-")}.png`),
    });
    await measureLabels(begins.toLowerCase().replaceAll(" ", "-"));
    expect(errors).toEqual([]);
  });
}

/** At three zooms, on a desk and on a phone. */
async function measureLabels(name: string): Promise<void> {
  for (const size of [
    { width: 1280, height: 800 },
    { width: 390, height: 844 },
  ]) {
    await pilot.setViewportSize(size);
    await pilot.keyboard.press("0");
    for (const zoom of [1, 2, 3]) {
      await drawn(pilot);
      const { faults, texts } = await labels(pilot);
      expect(faults, `${size.width} px, zoom ${zoom}`).toEqual([]);
      // Zoomed in, the ends of a long ship may be off the screen.
      if (zoom === 1) expect(texts.some((text) => text.endsWith("m/s"))).toBe(true);
      await pilot.screenshot({ path: join(SHOTS, `labels-${name}-${size.width}-${zoom}.png`) });
      for (let i = 0; i < 3; i++) await pilot.keyboard.press("+");
    }
  }
  await pilot.keyboard.press("0");
  await pilot.setViewportSize({ width: 1280, height: 800 });
}

test("a session is saved under a name, and continues where it ended when it is opened again", async () => {
  await instructor.bringToFront();
  await instructor.getByRole("button", { name: "Pause (K)" }).click();
  await instructor.locator(".run-state", { hasText: "PAUSED" }).waitFor();
  const timeline = instructor.getByRole("slider", { name: "Timeline" });
  const ended = Number(await timeline.inputValue());
  expect(ended).toBeGreaterThan(10);
  await instructor.getByRole("tab", { name: "Session" }).click();
  await instructor.getByRole("textbox", { name: "Name to save under" }).fill("kept.by.a.test");
  await instructor.getByRole("button", { name: "Save session" }).click();
  await instructor.getByText(/^Refused: .*letters, digits/).waitFor();
  await instructor.getByRole("textbox", { name: "Name to save under" }).fill("kept by a-test");
  await instructor.getByRole("button", { name: "Save session" }).click();
  await instructor.getByText("saved as kept_by_a-test", { exact: true }).waitFor();
  await load("Berthing: a bulk carrier with two ASD tugs");
  await expect.poll(async () => Number(await timeline.inputValue())).toBe(0);
  // The run that has just ended is among the recordings too: the saved one is opened.
  const kept = instructor
    .locator(".gallery li", { hasText: "Saved as kept_by_a-test." })
    .getByRole("button", { name: /^Open / });
  await kept.click();
  await instructor.getByRole("button", { name: "End this run" }).click();
  await expect.poll(async () => Number(await timeline.inputValue())).toBe(ended);
  await instructor.getByRole("button", { name: "Resume (K)" }).click();
  await expect.poll(async () => Number(await timeline.inputValue())).toBeGreaterThan(ended);
  expect(errors).toEqual([]);
});
