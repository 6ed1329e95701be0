/** Anchors through the page's own controls: let go, reported, drawn, hove in; and what cannot be done is answered with the reason. */
import { join } from "node:path";
import { afterAll, beforeAll, expect, test } from "vitest";
import { type Browser, type Served, SHOTS, browse, open, serve } from "./browser";
import { axe, sizes, withAxe } from "./faults";

const HARBOUR = new URL("../../scenarios/live/harbour.toml", import.meta.url).pathname;
const PALETTES = ["day", "dusk", "night"];

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
    if (i === PALETTES.length - 1)
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
