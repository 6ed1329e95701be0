/** The docking board is never green while the hull is on the quay, nor before that alarm is acknowledged. */
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { type Browser, type Served, SHOTS, browse, open, serve } from "./browser";

/** The ship starts 2 m inside a part of the quay without fenders, and is pressed out slowly. */
const ON_CONCRETE = [
  "body.ship.position=[-130, -13]",
  'body.ship.heading="0 deg"',
  'body.ship.velocity.surge="0 kn"',
  "body.forward_tug.position=[-90, -70]",
  "body.after_tug.position=[-210, -70]",
];

const errors: string[] = [];
let served: Served;
let browser: Browser;
let pilot: Page;
let observer: Page;

beforeAll(async () => {
  served = await serve(ON_CONCRETE);
  browser = await browse({ width: 1280, height: 800 });
  pilot = await open(browser.context, served, "pilot", errors);
  observer = await open(browser.context, served, "observer", errors);
});
afterAll(async () => {
  await browser.close();
  await served.close();
});

const lamp = (page: Page) => page.locator('.end[aria-label="Bow"] .lamp');
const end = (page: Page) => page.locator('.end[aria-label="Bow"]');

test("the board is red with the hull on the quay, and not green before the alarm is acknowledged", async () => {
  await pilot.getByRole("tab", { name: "Docking" }).click();
  await observer.getByRole("tab", { name: "Docking" }).click();
  await pilot.waitForFunction(
    () => document.querySelector('.end[aria-label="Bow"] .lamp')?.textContent === "STRUCTURE",
  );
  expect(await end(pilot).getAttribute("class")).toContain("alarm");
  await pilot.screenshot({ path: join(SHOTS, "board-structure.png") });
  // She is pressed off the concrete; every board still shows that it was touched.
  await pilot.waitForFunction(
    () => document.querySelector('.end[aria-label="Bow"] .lamp')?.textContent === "TOUCHED",
    undefined,
    { timeout: 120_000 },
  );
  expect(await end(pilot).getAttribute("class")).not.toContain("ok");
  await pilot.getByRole("tab", { name: "Alarms" }).click();
  await pilot.screenshot({ path: join(SHOTS, "board-alarms.png") });
  await pilot.getByRole("button", { name: /^Acknowledge ship touches quay/ }).click();
  await observer.waitForFunction(
    () =>
      !["TOUCHED", "STRUCTURE"].includes(
        document.querySelector('.end[aria-label="Bow"] .lamp')?.textContent ?? "",
      ),
  );
  expect(await lamp(observer).textContent()).not.toBe("STRUCTURE");
  await observer.screenshot({ path: join(SHOTS, "board-after.png") });
  expect(errors).toEqual([]);
}, 180_000);
