/** Measuring tools of the plan by mouse and by touch, and sounds with their mute state. */
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { type Browser, type Served, SHOTS, browse, open, serve } from "./browser";
import { labels } from "./faults";

const errors: string[] = [];
let served: Served;
let browser: Browser;
let page: Page;

beforeAll(async () => {
  served = await serve();
  browser = await browse({ width: 1366, height: 768 }, true);
  page = await open(browser.context, served, "pilot", errors);
});
afterAll(async () => {
  await browser.close();
  await served.close();
});

/** The plan's canvas: its corner on the page, and pixels in a metre. */
async function plan(): Promise<{ x: number; y: number; scale: number }> {
  const canvas = page.getByRole("img", { name: "Plan of ship" });
  const [box, view] = [await canvas.boundingBox(), await canvas.getAttribute("data-view")];
  return { x: box?.x ?? NaN, y: box?.y ?? NaN, scale: Number(view?.split(" ")[2]) };
}

const texts = async () => (await labels(page)).texts;

test("two clicks, or two touches, measure bearing and distance; each tool is turned on and off", async () => {
  await page.getByRole("button", { name: "Measure: tools (I)" }).click();
  const tool = (name: string) => page.getByRole("button", { name: new RegExp(`^${name}: `) });
  await tool("2 points").click();
  const { x, y, scale } = await plan();
  for (const touches of [false, true]) {
    const press = (px: number, py: number) =>
      touches ? page.touchscreen.tap(x + px, y + py) : page.mouse.click(x + px, y + py);
    await press(300, 250);
    await press(500, 250);
    await page.waitForTimeout(200);
    // The plan follows the ship meanwhile: a few metres. The text begins with a bearing of three digits.
    const measured = (await texts()).find((text) => /^\d{3}\.\d° /.test(text)) ?? "";
    const m = Number(/° ([\d.]+) m/.exec(measured)?.[1]);
    expect(Math.abs(m - 200 / scale), measured).toBeLessThan(5);
  }
  await tool("Rings").click();
  await tool("Cursor").click();
  await tool("EBL").click();
  await page.mouse.move(x + 420, y + 200);
  await page.waitForTimeout(300);
  expect((await texts()).some((text) => /^\d+ m|NM$|cables\)$/.test(text))).toBe(true);
  expect((await texts()).some((text) => text.endsWith("relative"))).toBe(true);
  const cursor = page.getByRole("status", { name: "Cursor" });
  await cursor.getByText(/^N -?\d+ m, E -?\d+ m; from the ship \d{3}\.\d° /).waitFor();
  // The bearing line turns by its buttons.
  const line = async () =>
    Number.parseFloat((await texts()).find((t) => t.endsWith("relative")) ?? "");
  const before = await line();
  for (let i = 0; i < 3; i++) await page.getByRole("button", { name: "Bearing line +1°" }).click();
  await page.waitForTimeout(200);
  expect((await line()) - before).toBeCloseTo(3, 0);
  expect((await labels(page)).faults).toEqual([]);
  await page.screenshot({ path: join(SHOTS, "measuring.png") });
  for (const name of ["2 points", "Rings", "Cursor", "EBL"]) await tool(name).click();
  await page.waitForTimeout(200);
  expect((await texts()).some((text) => /relative$|^\d{3}\.\d° /.test(text))).toBe(false);
  await cursor.waitFor({ state: "hidden" });
  await page.getByRole("button", { name: "Measure: tools (I)" }).click();
  expect(errors).toEqual([]);
});

test("sound waits for the first touch, answers engine orders, repeats alarms, and says when it is muted", async () => {
  await page.reload();
  const state = page.locator(".sound-state");
  const count = async (kind: string) => Number((await state.getAttribute(`data-${kind}`)) ?? 0);
  await state.getByText("waits").waitFor();
  await page.getByRole("button", { name: "Take the helm" }).click();
  await state.getByText("on", { exact: false }).waitFor();
  await page.getByRole("button", { name: "Slow ahead", exact: true }).click();
  await expect.poll(() => count("engine")).toBe(1);
  // An alarm, until it is acknowledged.
  const instructor = await open(browser.context, served, "instructor", errors);
  await instructor.getByRole("tab", { name: "Weather, faults" }).click();
  await instructor.getByRole("button", { name: "Rudder stuck" }).first().click();
  await expect.poll(() => count("alarms"), { timeout: 10_000 }).toBeGreaterThan(1);
  await page.bringToFront();
  await page.getByRole("tab", { name: "Alarms" }).click();
  await page.getByRole("button", { name: /^Acknowledge .*rudder stuck/ }).click();
  await page.waitForTimeout(500);
  const rung = await count("alarms");
  await page.waitForTimeout(2500);
  expect(await count("alarms")).toBe(rung);
  // Muted, one kind and all; kept over a reload.
  await page.getByRole("button", { name: "Engine sound on" }).click();
  await state.getByText("alarms only").waitFor();
  await page.getByRole("button", { name: "Half ahead", exact: true }).click();
  await page.waitForTimeout(500);
  expect(await count("engine")).toBe(1);
  await state.click();
  await state.getByText("muted").waitFor();
  await page.reload();
  await state.getByText("muted").waitFor();
  expect(errors).toEqual([]);
});
