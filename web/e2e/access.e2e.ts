/**
 * Every role, tab and palette at three sizes of screen: axe-core finds nothing, all texts have a contrast of 4.5:1, what is
 * touched is 44 px, and nothing scrolls sideways.
 */
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { type Browser, type Served, browse, open, serve } from "./browser";
import { axe, sizes, withAxe } from "./faults";

const SIZES = [
  { width: 1366, height: 768 },
  { width: 1024, height: 768 },
  { width: 390, height: 844 },
];
/** The palette bright has the texts of day on lighter surfaces: it is tried where most of the page is seen. */
const PALETTES = ["day", "dusk", "night"];
/** In CI the contrast of dusk and night is tried at one size: colours do not depend on it. */
const palettesAt = (size: { width: number }) =>
  process.env.CI && size.width !== SIZES[0]?.width ? ["day"] : PALETTES;
/** In CI one role is read at each size: the others have the same elements. Sizes of what is touched are measured for all. */
const isRead = (role: string, size: { width: number }) =>
  !process.env.CI || role === "pilot" || size.width === SIZES[0]?.width;
const ROLES = ["pilot", "tugmaster", "instructor", "observer"];

const errors: string[] = [];
let served: Served;
let browser: Browser;

beforeAll(async () => {
  served = await serve();
  browser = await browse({ width: 1366, height: 768 }, true);
  await withAxe(browser.context);
  // With alarms of which one is acknowledged.
  const instructor = await open(browser.context, served, "instructor", errors);
  await instructor.getByRole("tab", { name: "Weather, faults" }).click();
  for (const fault of await instructor.locator(".fault-row").first().locator(".fault").all())
    await fault.click();
  await instructor.getByRole("tab", { name: "Alarms" }).click();
  await instructor.getByRole("button", { name: "Acknowledge ship" }).first().click();
  await instructor.locator(".alarms .rows li:not(.open)").first().waitFor();
  await instructor.close();
});
afterAll(async () => {
  await browser.close();
  await served.close();
});

async function palette(page: Page, name: string): Promise<void> {
  for (let i = 0; i < 4 && (await page.locator("html").getAttribute("data-palette")) !== name; i++)
    await page.keyboard.press("b");
}

/** The findings of a page in its present state, in each palette. */
async function inEachPalette(page: Page, within?: string, names = PALETTES): Promise<string[]> {
  const found: string[] = [];
  for (const [i, name] of names.entries()) {
    await palette(page, name);
    found.push(...(await axe(page, within, i === 0 ? undefined : ["color-contrast"])));
  }
  await palette(page, "day");
  return found;
}

for (const role of ROLES) {
  test(`${role}: no finding in any tab, palette and size`, async () => {
    const page = await open(browser.context, served, role, errors);
    const found = new Map<string, string>();
    const note = (where: string, faults: string[]) => {
      for (const fault of faults) if (!found.has(fault)) found.set(fault, where);
    };
    for (const size of SIZES) {
      await page.setViewportSize(size);
      const at = `${size.width}×${size.height}`;
      const groups = page.locator(".group-tabs button:visible");
      for (const group of await groups.all()) {
        await group.click();
        note(`${at} ${await group.textContent()}`, await sizes(page));
        if (isRead(role, size))
          note(`${at} ${await group.textContent()}`, await axe(page, ".controls"));
      }
      // All of the page once, then the panel, which alone changes.
      for (const [i, tab] of (await page.getByRole("tab").all()).entries()) {
        const name = (await tab.textContent()) ?? "";
        await tab.click();
        if (name === "Charts") await page.locator(".uplot").first().waitFor();
        note(`${at} ${name}`, await sizes(page));
        if (!isRead(role, size)) continue;
        const within = i === 0 ? undefined : ".panel";
        note(`${at} ${name}`, await inEachPalette(page, within, palettesAt(size)));
      }
    }
    expect([...found].map(([fault, where]) => `${where}: ${fault}`)).toEqual([]);
    await page.close();
    expect(errors).toEqual([]);
  });
}

test("hints, the help, the helm in hand and the measuring tools have no finding", async () => {
  const page = await open(browser.context, served, "pilot", errors, true);
  await page.getByRole("status", { name: "Hint" }).waitFor();
  const found = await inEachPalette(page, undefined, [...PALETTES, "bright"]);
  await page.getByRole("button", { name: "No hints" }).click();
  await page.keyboard.press("?");
  found.push(...(await inEachPalette(page, "dialog")));
  await page.keyboard.press("Escape");
  await page.getByRole("button", { name: "Take the helm" }).click();
  await page.getByRole("button", { name: "Release the helm" }).waitFor();
  await page.getByRole("button", { name: "Rudder port 10", exact: true }).click();
  found.push(...(await inEachPalette(page)));
  // With the measuring tools.
  await page.keyboard.press("i");
  for (const tool of [/^EBL: /, /^Cursor: /])
    await page.getByRole("button", { name: tool }).click();
  found.push(...(await inEachPalette(page, ".plan")));
  for (const size of SIZES) {
    await page.setViewportSize(size);
    found.push(...(await sizes(page)));
  }
  for (const tool of [/^EBL: /, /^Cursor: /])
    await page.getByRole("button", { name: tool }).click();
  expect(found).toEqual([]);
  await page.close();
  expect(errors).toEqual([]);
});

test("port and starboard are written, not only coloured", async () => {
  const page = await open(browser.context, served, "pilot", errors);
  const letters = await page
    .locator(".rudder-buttons button, .rudder .scale span")
    .evaluateAll((all) =>
      all.map((each) => [
        each.className,
        getComputedStyle(each, "::before").content.replace(/^"(.*?)".*$/, "$1"),
      ]),
    );
  expect(letters.length).toBeGreaterThan(12);
  for (const [side, letter] of letters)
    if (side === "port" || side === "starboard") expect(letter).toBe(side === "port" ? "P" : "S");
  await page.close();
});
