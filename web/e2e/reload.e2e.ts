/** A reload of a page: it keeps what it held, and no other page gets that. */
import { afterAll, beforeAll, expect, test } from "vitest";
import { type Browser, type Served, browse, open, serve } from "./browser";

/** Longer than a page with a copied seat tries to get it [ms]. */
const TRIES_MS = 3000;

const errors: string[] = [];
let served: Served;
let browser: Browser;

beforeAll(async () => {
  served = await serve();
  browser = await browse({ width: 1366, height: 768 });
});
afterAll(async () => {
  await browser.close();
  await served.close();
});

test("a pilot without a name has the helm after a reload, and a copy of her page does not get it", async () => {
  const pilot = await open(browser.context, served, "pilot", errors);
  await pilot.getByRole("button", { name: "Take the helm" }).click();
  const release = pilot.getByRole("button", { name: "Release the helm" });
  await release.waitFor();
  for (let reloads = 0; reloads < 2; reloads += 1) {
    await pilot.reload();
    await release.waitFor();
  }
  const seat = () => sessionStorage.getItem("seat");
  const own = await pilot.evaluate(seat);
  expect(own).toMatch(/^[0-9a-f]{32}$/);

  const copy = await browser.context.newPage();
  await copy.addInitScript((key) => sessionStorage.setItem("seat", key), own ?? "");
  await copy.goto(pilot.url());
  await copy.getByRole("button", { name: "Take the helm" }).waitFor();
  await copy.waitForTimeout(TRIES_MS);
  expect(await copy.evaluate(seat)).not.toBe(own);
  expect(await copy.getByRole("button", { name: "Release the helm" }).count()).toBe(0);
  expect(await release.isVisible()).toBe(true);
  await copy.close();
  await pilot.close();
  expect(errors).toEqual([]);
});
