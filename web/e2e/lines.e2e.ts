/** The list of bollards for a line on board. */
import { join } from "node:path";
import { afterAll, beforeAll, expect, test } from "vitest";
import { type Browser, SHOTS, type Served, browse, open, serve } from "./browser";
import { axe, sizes, withAxe } from "./faults";

const errors: string[] = [];
let served: Served;
let browser: Browser;

beforeAll(async () => {
  // Forty metres off the berth, a heaving line of 30 m reaches no bollard.
  served = await serve(["line_handling.boat=false"]);
  browser = await browse({ width: 1366, height: 768 }, true);
  await withAxe(browser.context);
});
afterAll(async () => {
  await browser.close();
  await served.close();
});

test("a bollard out of reach is marked in the list, with the reason, and the server refuses it", async () => {
  const page = await open(browser.context, served, "pilot", errors);
  await page.getByRole("tab", { name: "Lines" }).click();
  const aboard = page.locator(".sending:not([hidden])");
  const row = page.locator(".lines .rows > li", { has: aboard }).first();
  const options = row.locator("option");
  await options.first().waitFor({ state: "attached" });
  const texts = await options.allTextContents();
  expect(texts.length).toBeGreaterThan(5);
  for (const text of texts) expect(text).toMatch(/ · \d+ m · too far$/);
  const reason = row.getByText(
    / is \d+ m away; a heaving line reaches 30 m, and there is no boat\.$/,
  );
  await reason.waitFor();
  for (const size of [
    { width: 1366, height: 768 },
    { width: 1024, height: 768 },
    { width: 390, height: 844 },
  ]) {
    await page.setViewportSize(size);
    await page.screenshot({ path: join(SHOTS, `bollards-${size.width}.png`) });
    expect(await sizes(page)).toEqual([]);
    expect(await axe(page, ".panel")).toEqual([]);
  }
  await row.getByRole("button", { name: /^Send / }).click();
  await page.getByText(/^Refused: .*a heaving line reaches 30 m/).waitFor();
  expect(errors).toEqual([]);
});
