/**
 * Screenshots of every view in the four palettes, for a person to look at: `npm run e2e` writes them to `screenshots/`
 * (or `SCREENSHOTS`). Also tested: nothing extends beyond the page, and touch targets are 44 px or more.
 */
import { mkdirSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { type Served, SHOTS, browse, open, serve } from "./browser";
import { sizes } from "./faults";

const SIZES = {
  desk: { width: 1280, height: 800 },
  landscape: { width: 1024, height: 768 },
  portrait: { width: 768, height: 1024 },
};
/** In CI nobody looks at the pictures: the sizes are measured in one palette. */
const PALETTES = process.env.CI ? ["day"] : ["day", "dusk", "night", "bright"];
const TABS = ["Docking", "Conning", "Fenders", "Lines", "Charts", "Alarms", "Verdict"];
const errors: string[] = [];
let served: Served;

beforeAll(async () => {
  mkdirSync(SHOTS, { recursive: true });
  served = await serve();
  await underWay();
});
afterAll(() => served.close());

/** Sets the ship in motion with engine, rudder and tugs, so that the views have something to show. */
async function underWay(): Promise<void> {
  const { context, close } = await browse(SIZES.desk);
  const pilot = await open(context, served, "pilot", errors);
  await pilot.getByRole("button", { name: "Take the helm" }).click();
  await pilot.getByRole("button", { name: "Rudder port 10", exact: true }).click();
  await pilot.getByRole("button", { name: "Dead slow ahead", exact: true }).click();
  for (const card of await pilot.getByRole("region", { name: /^Tug / }).all()) {
    await card.getByRole("button", { name: /push$/ }).click();
    await card.getByRole("button", { name: / 50 %$/ }).click();
  }
  await pilot.waitForTimeout(2500);
  await pilot.getByRole("button", { name: "Stop engine (S)" }).click();
  await pilot.waitForTimeout(500);
  await close();
}

async function picture(page: Page, name: string): Promise<void> {
  if (!process.env.CI) await page.screenshot({ path: join(SHOTS, `${name}.png`) });
}

async function palette(page: Page, name: string): Promise<void> {
  for (let i = 0; i < 4 && (await page.locator("html").getAttribute("data-palette")) !== name; i++)
    await page.keyboard.press("b");
  await page.waitForTimeout(150);
}

for (const [size, viewport] of Object.entries(SIZES)) {
  test(`every view at ${size}, ${viewport.width} × ${viewport.height}`, async () => {
    const { context, close } = await browse(viewport, size !== "desk");
    for (const role of ["pilot", "tugmaster", "instructor", "observer"].filter(
      (r) => served.tokens[r] !== undefined,
    )) {
      const page = await open(context, served, role, errors);
      await page.waitForTimeout(1300);
      const tabs =
        role === "instructor"
          ? ["Session", "Weather, faults"]
          : role === "pilot"
            ? TABS
            : ["Docking"];
      for (const tab of tabs) {
        await page.getByRole("tab", { name: tab, exact: true }).click();
        await page.waitForTimeout(tab === "Charts" ? 1200 : 200);
        // Once a second view stood below the chosen one.
        expect(await page.locator(".view:visible").count()).toBe(1);
        for (const name of size === "desk" || tab === "Docking" ? PALETTES : ["day"]) {
          await palette(page, name);
          await picture(page, `${size}-${role}-${tab.split(",")[0]?.toLowerCase() ?? ""}-${name}`);
        }
        await palette(page, "day");
        expect(await sizes(page)).toEqual([]);
      }
      if (role === "pilot") {
        for (const group of await page.locator(".group-tabs button").all()) {
          if (!(await group.isVisible())) continue;
          await group.click();
          const text = (await group.textContent())?.toLowerCase() ?? "";
          await picture(page, `${size}-pilot-controls-${text}-day`);
          expect(await sizes(page)).toEqual([]);
        }
        for (const tab of ["Docking", "Conning", "Charts"]) {
          await page.getByRole("tab", { name: tab, exact: true }).click();
          await page.keyboard.press("x");
          await page.waitForTimeout(700);
          await picture(page, `${size}-wide-${tab.toLowerCase()}-day`);
          await page.keyboard.press("x");
        }
        await page.keyboard.press("?");
        await picture(page, `${size}-help-day`);
        await page.keyboard.press("Escape");
      }
      await page.close();
    }
    await close();
    expect(errors).toEqual([]);
  });
}
