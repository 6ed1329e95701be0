/** An alarm in each of its states on two pages of two roles, one of them loaded again in between: all agree, and the report has the times. */
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { type Browser, type Served, SHOTS, browse, open, serve } from "./browser";

/** A busy machine may take as long. */
const PATIENT = { timeout: 30_000 };

const errors: string[] = [];
let served: Served;
let browser: Browser;
let instructor: Page;
let pilot: Page;

beforeAll(async () => {
  served = await serve();
  browser = await browse({ width: 1366, height: 768 });
  instructor = await open(browser.context, served, "instructor", errors);
  pilot = await open(browser.context, served, "pilot", errors);
});
afterAll(async () => {
  await browser.close();
  await served.close();
});

/** The rows of a page: time, text, state of the acknowledgement. */
async function rows(page: Page): Promise<string[]> {
  const list = page.getByRole("list", { name: "Alarms" });
  const all = await list.locator("li").allTextContents();
  return all.filter((text) => /rudder stuck|thrusters? lost|engine lost/.test(text));
}

/** Waits until both pages show this many rows that have these words, one after the other, and the same rows. */
async function agree(...words: RegExp[]): Promise<string[]> {
  await expect
    .poll(async () => {
      const [one, other] = [await rows(instructor), await rows(pilot)];
      const are = one.length === words.length && words.every((word, i) => word.test(one[i] ?? ""));
      return are && JSON.stringify(one) === JSON.stringify(other) ? "agree" : [one, other];
    }, PATIENT)
    .toBe("agree");
  return rows(pilot);
}

async function show(page: Page, tab: string): Promise<void> {
  await page.bringToFront();
  await page.getByRole("tab", { name: tab, exact: true }).click();
}

/** The instructor presses a fault, on or off. */
async function fault(name: string): Promise<void> {
  await show(instructor, "Weather, faults");
  await instructor
    .getByRole("button", { name: new RegExp(name, "i") })
    .first()
    .click();
  await show(instructor, "Alarms");
}

async function acknowledge(page: Page, name: string): Promise<void> {
  await show(page, "Alarms");
  await page.getByRole("button", { name: new RegExp(`^Acknowledge .*${name}`) }).click();
}

async function reload(page: Page): Promise<void> {
  await page.bringToFront();
  await page.reload();
  await page.getByRole("img", { name: "Plan of ship" }).waitFor();
  await show(page, "Alarms");
}

test("pages of two roles and a page that was loaded again agree on every state of an alarm", async () => {
  await show(pilot, "Alarms");
  await fault("rudder stuck");
  await fault("engine lost");
  // Active, nobody has acknowledged either. The older one stands first, also after a reload.
  const both = [/rudder stuckAck$/, /engine lostAck$/];
  const before = await agree(...both);
  await reload(pilot);
  expect(await agree(...both)).toEqual(before);
  // One is acknowledged, by the pilot; the cause of the other ends.
  await acknowledge(pilot, "rudder stuck");
  await fault("engine lost");
  const waits = [/rudder stuck✓$/, /engine lost \(over; not acknowledged\)Ack$/];
  const then = await agree(...waits);
  await pilot.screenshot({ path: join(SHOTS, "alarms-pilot.png") });
  await reload(pilot);
  await reload(instructor);
  expect(await agree(...waits)).toEqual(then);
  await instructor.screenshot({ path: join(SHOTS, "alarms-instructor.png") });
  // Active again before anybody has acknowledged it: since its first beginning.
  await fault("engine lost");
  const again = await agree(/rudder stuck✓$/, /engine lostAck$/);
  expect(again).toEqual([then[0], before[1]]);
  // By the other role; then its cause ends, and it is gone. The first one as well.
  await acknowledge(instructor, "engine lost");
  await agree(/rudder stuck✓$/, /engine lost✓$/);
  await reload(pilot);
  await agree(/rudder stuck✓$/, /engine lost✓$/);
  await fault("engine lost");
  await agree(/rudder stuck✓$/);
  await fault("rudder stuck");
  await agree();
  const events = (page: Page) => page.getByRole("list", { name: "Events" }).textContent();
  for (const page of [instructor, pilot])
    for (const who of ["pilot", "instructor"])
      await expect
        .poll(() => events(page), PATIENT)
        .toMatch(new RegExp(`${who} \\d+ acknowledges`));
  // The log with its times is in the report.
  const tab = browser.context.waitForEvent("page");
  await instructor.bringToFront();
  await instructor.getByRole("button", { name: /^Report of the session/ }).click();
  const report = await tab;
  await report.waitForURL(/\/report\?token=/);
  const log = report.getByRole("heading", { name: "Log of the session" });
  await log.waitFor();
  const lines = await report
    .locator("tr", { hasText: /rudder stuck|engine lost/ })
    .allTextContents();
  console.log(`the log of the report:\n${lines.join("\n")}`);
  for (const words of [/rudder stuck.*pilot \d+/, /engine lost.*instructor \d+/])
    expect(
      lines.some((line) => words.test(line)),
      String(words),
    ).toBe(true);
  await log.scrollIntoViewIfNeeded();
  await report.screenshot({ path: join(SHOTS, "alarms-report.png") });
  expect(errors).toEqual([]);
}, 240_000);
