/**
 * Ships are placed before the start: dragged and turned with mouse and finger, or by numbers. A place in a hull or ashore is refused
 * with the reason.
 */
import { join } from "node:path";
import type { CDPSession, Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { type Browser, SHOTS, type Served, browse, drawn, open, serve } from "./browser";

const errors: string[] = [];
let served: Served;
let browser: Browser;
let page: Page;
let fingers: CDPSession;

beforeAll(async () => {
  served = await serve();
  browser = await browse({ width: 1366, height: 768 }, true);
  page = await open(browser.context, served, "instructor", errors);
  fingers = await browser.context.newCDPSession(page);
});
afterAll(async () => {
  await browser.close();
  await served.close();
});

const form = (ship: string) => page.getByRole("form", { name: `Place ${ship}` });
const number = async (ship: string, name: string) =>
  Number(await form(ship).getByLabel(name).inputValue());
const place = async (ship: string) => [await number(ship, "North"), await number(ship, "East")];
const plan = () => page.getByRole("img", { name: "Plan of ship" });

/** A place of the earth [m] on the page [px], with north up, in the view of the last press of a button. */
async function onPage(north: number, east: number): Promise<[number, number]> {
  await drawn(page);
  const box = await plan().boundingBox();
  const view = (await plan().getAttribute("data-view")) ?? "";
  const [atNorth = 0, atEast = 0, scale = 1] = view.split(" ").map(Number);
  if (!box) throw new Error("the plan is not shown");
  return [
    box.x + box.width / 2 + (east - atEast) * scale,
    box.y + box.height / 2 - (north - atNorth) * scale,
  ];
}

async function drag(from: [number, number], to: [number, number]): Promise<void> {
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move((from[0] + to[0]) / 2, (from[1] + to[1]) / 2);
  await page.mouse.move(...to);
  await page.mouse.up();
}

const near = async (ship: string, north: number, east: number) => {
  await expect
    .poll(async () => {
      const [atNorth = NaN, atEast = NaN] = await place(ship);
      return Math.hypot(atNorth - north, atEast - east);
    })
    .toBeLessThan(3);
};

test("a run that has begun goes back to its start as a new branch", async () => {
  await page.getByRole("tab", { name: "Place ships" }).click();
  await page.getByText("The run has begun").waitFor();
  await page.screenshot({ path: join(SHOTS, "place_begun.png") });
  await page.getByRole("button", { name: "Go back to the start" }).click();
  await form("Ship").waitFor();
  for (let i = 0; i < 3; i++) {
    if (await page.getByRole("button", { name: /^North up/ }).isVisible()) break;
    await page.keyboard.press("u");
  }
  // So that no ship is under the plan's buttons.
  for (let i = 0; i < 3; i++) await page.getByRole("button", { name: /^Zoom out/ }).click();
  await near("Ship", -180, -60);
});

test("a ship is dragged with the mouse, and turned by her knob; her tugs come along", async () => {
  const tug = await place("Forward tug");
  const [north, east] = await place("Ship");
  await drag(await onPage(north ?? 0, east ?? 0), await onPage(-230, -110));
  await near("Ship", -230, -110);
  await near("Forward tug", (tug[0] ?? 0) - 50, (tug[1] ?? 0) - 50);
  await page.screenshot({ path: join(SHOTS, "place_dragged.png") });
  // The knob is ahead of the bow, which is 92 m from her centre, on her heading of 2°.
  const scale = Number(((await plan().getAttribute("data-view")) ?? "").split(" ")[2]);
  const ahead = 92 + 44 / scale;
  const heading = (2 * Math.PI) / 180;
  await drag(
    await onPage(-230 + ahead * Math.cos(heading), -110 + ahead * Math.sin(heading)),
    await onPage(-230 + ahead * Math.cos(0.4), -110 + ahead * Math.sin(0.4)),
  );
  await expect.poll(() => number("Ship", "Heading")).toBeCloseTo((0.4 * 180) / Math.PI, 0);
});

test("a place in a hull or ashore is refused with the reason, and she stays", async () => {
  const before = await place("Ship");
  await drag(await onPage(before[0] ?? 0, before[1] ?? 0), await onPage(0, 10));
  await page.getByText("ship would be ashore on quay").first().waitFor();
  await page.screenshot({ path: join(SHOTS, "place_refused.png") });
  await near("Ship", before[0] ?? 0, before[1] ?? 0);
  const tug = await place("After tug");
  await drag(
    await onPage(tug[0] ?? 0, tug[1] ?? 0),
    await onPage((before[0] ?? 0) - 40, (before[1] ?? 0) - 20),
  );
  await page.getByText("the hull of after_tug would overlap that of ship").first().waitFor();
  await near("After tug", tug[0] ?? 0, tug[1] ?? 0);
});

test("a finger drags a tug", async () => {
  const before = await place("Forward tug");
  const [x, y] = await onPage(before[0] ?? 0, before[1] ?? 0);
  const to = await onPage((before[0] ?? 0) + 6, (before[1] ?? 0) - 8);
  const touch = (type: string, at: [number, number] | null) =>
    fingers.send("Input.dispatchTouchEvent", {
      type: type as "touchStart",
      touchPoints: at ? [{ x: at[0], y: at[1], id: 0 }] : [],
    });
  await touch("touchStart", [x, y]);
  await touch("touchMove", [(x + to[0]) / 2, (y + to[1]) / 2]);
  await touch("touchMove", to);
  await touch("touchEnd", null);
  await near("Forward tug", (before[0] ?? 0) + 6, (before[1] ?? 0) - 8);
});

test("numbers place her too, with a speed, and the run begins there", async () => {
  const ship = form("Ship");
  await ship.getByLabel("North").fill("-300");
  await ship.getByLabel("East").fill("-90");
  await ship.getByLabel("Heading").fill("5");
  await ship.getByLabel("Speed ahead").fill("3");
  await ship.getByRole("button", { name: "Place" }).click();
  await expect.poll(() => page.locator(".readout dd").first().textContent()).toBe("005.0°");
  await expect.poll(() => page.locator(".readout", { hasText: "3.00 kn" }).count()).toBe(1);
  await page.screenshot({ path: join(SHOTS, "place_numbers.png") });
  await page.getByRole("button", { name: "Resume" }).click();
  await page.getByText("The run has begun").waitFor();
  expect(errors).toEqual([]);
});
