/** Touch on the plan: one finger moves it, two zoom it about their middle. */
import type { CDPSession, Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { type Browser, type Served, browse, drawn, open, serve } from "./browser";

const errors: string[] = [];
let served: Served;
let browser: Browser;
let page: Page;
let fingers: CDPSession;

beforeAll(async () => {
  served = await serve();
  browser = await browse({ width: 768, height: 1024 }, true);
  page = await open(browser.context, served, "observer", errors);
  fingers = await browser.context.newCDPSession(page);
});
afterAll(async () => {
  await browser.close();
  await served.close();
});

type Place = [number, number];

/** Puts fingers down at the first positions, moves them through the others, and lifts them. */
async function touch(...places: Place[][]): Promise<void> {
  const points = (at: Place[]) => at.map(([x, y], id) => ({ x, y, id }));
  for (const [i, at] of places.entries()) {
    await fingers.send("Input.dispatchTouchEvent", {
      type: i === 0 ? "touchStart" : "touchMove",
      touchPoints: points(at),
    });
  }
  await fingers.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  await drawn(page);
}

async function view(): Promise<{ north: number; east: number; scale: number }> {
  const text =
    (await page.getByRole("img", { name: "Plan of ship" }).getAttribute("data-view")) ?? "";
  const [north = NaN, east = NaN, scale = NaN] = text.split(" ").map(Number);
  return { north, east, scale };
}

test("a pinch zooms the plan in and out, a finger moves it", async () => {
  const box = await page.getByRole("img", { name: "Plan of ship" }).boundingBox();
  if (!box) throw new Error("the plan is not shown");
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  const pair = (half: number): Place[] => [
    [x - half, y],
    [x + half, y],
  ];
  const before = await view();
  await touch(pair(40), pair(60), pair(80));
  const wide = await view();
  expect(wide.scale / before.scale).toBeCloseTo(2, 1);
  await touch(pair(80), pair(60), pair(40));
  expect((await view()).scale / before.scale).toBeCloseTo(1, 1);
  const still = await view();
  await touch([[x, y]], [[x + 30, y]], [[x + 60, y]]);
  const moved = await view();
  // 60 pixels in metres. The plan follows the ship, which moves a little meanwhile.
  expect(
    Math.hypot(moved.north - still.north, moved.east - still.east) * moved.scale,
  ).toBeGreaterThan(50);
  expect(errors).toEqual([]);
});
