/** Anchors through the page's own controls: let go, reported, drawn, hove in; and what cannot be done is answered with the reason. */
import { join } from "node:path";
import { afterAll, beforeAll, expect, test } from "vitest";
import { type Browser, type Served, SHOTS, browse, open, serve } from "./browser";
import { axe, sizes, withAxe } from "./faults";

const HARBOUR = new URL("../../scenarios/live/harbour.toml", import.meta.url).pathname;
const PALETTES = ["day", "dusk", "night", "bright"];

const errors: string[] = [];
let browser: Browser;
let served: Served;

beforeAll(async () => {
  browser = await browse({ width: 1366, height: 768 }, true);
  await withAxe(browser.context);
  served = await serve([], HARBOUR);
});
afterAll(async () => {
  await served.close();
  await browser.close();
});

test("the port anchor is let go, reported, drawn and hove in, and a windlass without power is told", async () => {
  const page = await open(browser.context, served, "pilot", errors);
  await page.getByRole("tab", { name: "Anchors" }).click();
  const port = page.locator(".anchors li").first();
  const report = port.locator(".report");
  await expect.poll(() => report.textContent()).toBe("home");
  await port.getByRole("combobox").selectOption({ label: "2 shackles" });
  const letGo = port.getByRole("button", { name: "Let go" });
  await letGo.click();
  await letGo.click();
  await expect.poll(() => report.textContent(), { timeout: 60_000 }).toMatch(/^2 shackles out/);
  await page.screenshot({ path: join(SHOTS, "anchor-down.png") });
  const found: string[] = [];
  for (let i = 0; i < PALETTES.length; i++) {
    found.push(...(await axe(page, ".panel")), ...(await sizes(page)));
    if (PALETTES[i] === "night")
      await page.screenshot({ path: join(SHOTS, "anchor-down-night.png") });
    await page.keyboard.press("b");
  }
  expect(found).toEqual([]);
  const instructor = await open(browser.context, served, "instructor", errors);
  await instructor.getByRole("tab", { name: "Weather, faults" }).click();
  await instructor.getByRole("button", { name: "Anchor port: Windlass fails" }).click();
  await expect
    .poll(() => port.locator(".state").textContent(), { timeout: 20_000 })
    .toContain("windlass has no power");
  await port.getByRole("combobox").selectOption({ label: "home" });
  await port.getByRole("button", { name: "Heave in" }).click();
  await page.getByText("has no power: the anchor can only be let go").first().waitFor();
  await instructor.getByRole("button", { name: "Anchor port: Windlass fails" }).click();
  await expect
    .poll(() => port.locator(".state").textContent(), { timeout: 20_000 })
    .toContain("on the brake");
  await port.getByRole("button", { name: "Heave in" }).click();
  await expect
    .poll(() => port.locator(".state").textContent(), { timeout: 20_000 })
    .toContain("heaving to home");
  await instructor.screenshot({ path: join(SHOTS, "anchor-faults.png") });
  await page.close();
  await instructor.close();
  expect(errors).toEqual([]);
});

/** With anchors there is a tab more, and the instructor has most of all. */
test.each([
  { width: 1366, height: 768 },
  { width: 1024, height: 768 },
  { width: 390, height: 844 },
])(
  "the row of tabs stays one line at $width × $height, and its arrows reach every tab",
  async (size) => {
    for (const role of ["pilot", "instructor"]) {
      const page = await open(browser.context, served, role, errors);
      await page.setViewportSize(size);
      await page.getByRole("tab", { name: "Anchors" }).waitFor();
      const tabs = await page.getByRole("tab").all();
      expect(tabs.length).toBeGreaterThan(role === "pilot" ? 7 : 11);
      const tops = new Set<number>();
      const heights = new Set<number>();
      for (const tab of tabs) {
        const box = await tab.boundingBox();
        if (!box) continue;
        tops.add(Math.round(box.y));
        heights.add(Math.round(box.height));
      }
      expect(tops.size, `${role}: one line`).toBe(1);
      expect(heights.size, `${role}: no tab has two lines of text`).toBe(1);
      expect([...heights][0]).toBeGreaterThanOrEqual(44);
      // The tab at the far end is reached by the arrow, and stays in view when it is chosen.
      const more = page.locator('.tab-row [aria-label="More tabs"]');
      const last = tabs.at(-1);
      if (!last) throw new Error("there are tabs");
      // The arrow is gone where the row ends; it scrolls smoothly, so each click waits for its scrolling.
      const isEnded = () => more.evaluate((arrow) => !arrow.matches(":not(.hidden, .ended)"));
      const scrolled = () => page.locator(".tab-list").evaluate((list) => list.scrollLeft);
      for (let i = 0; i < 10 && !(await isEnded()); i++) {
        await more.click();
        let before = -1;
        await expect
          .poll(async () => {
            const [was, now] = [before, await scrolled()];
            before = now;
            return now - was;
          })
          .toBe(0);
      }
      await last.click();
      const [box, list] = [await last.boundingBox(), await page.locator(".tab-list").boundingBox()];
      if (!box || !list) throw new Error("it is shown");
      expect(box.x).toBeGreaterThanOrEqual(list.x - 1);
      expect(box.x + box.width).toBeLessThanOrEqual(list.x + list.width + 1);
      await page.getByRole("tab", { name: "Anchors" }).click();
      expect(await sizes(page)).toEqual([]);
      await page.screenshot({ path: join(SHOTS, `anchor-tabs-${role}-${size.width}.png`) });
      await page.close();
    }
    expect(errors).toEqual([]);
  },
);
