/** Several ships with pilots: the instructor goes from ship to ship, and each page has the charts of its ship after a reload. */
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { type Browser, type Served, SHOTS, browse, open, serve } from "./browser";

const SCENARIO = new URL("../../scenarios/live/two_pilots_in_a_fairway.toml", import.meta.url)
  .pathname;
const PATIENT = { timeout: 30_000 };

const errors: string[] = [];
let served: Served;
let browser: Browser;

beforeAll(async () => {
  served = await serve([], SCENARIO);
  browser = await browse({ width: 1366, height: 768 });
});
afterAll(async () => {
  await browser.close();
  await served.close();
});

const helm = (page: Page, ship: string) =>
  page.getByRole("group", { name: new RegExp(`^Helm of .*${ship}`, "i") });

test("the instructor takes the helm of one ship and of the other", async () => {
  const page = await open(browser.context, served, "instructor", errors);
  await page.getByRole("button", { name: "Helm", exact: true }).click();
  await helm(page, "bulker").waitFor();
  const speed = async () => (await page.locator(".readout").textContent()) ?? "";
  const of_bulker = await speed();
  await page.getByRole("button", { name: "Ship: bulker; go to the next ship" }).click();
  await helm(page, "coaster").waitFor();
  await expect.poll(speed, PATIENT).not.toBe(of_bulker);
  // An order to her, from her own strip of controls.
  await page.locator(".telegraph").getByRole("button", { name: "Slow ahead", exact: true }).click();
  const pressed = page.locator(".telegraph").locator('[aria-pressed="true"]');
  await expect.poll(() => pressed.textContent(), PATIENT).toMatch(/slow/i);
  await page.screenshot({ path: join(SHOTS, "ships-coaster.png") });
  await page.getByRole("tab", { name: "Charts" }).click();
  await page.waitForTimeout(2500);
  await page.screenshot({ path: join(SHOTS, "ships-coaster-charts.png") });
  await page.getByRole("button", { name: "Ship: coaster; go to the next ship" }).click();
  await helm(page, "bulker").waitFor();
  await expect.poll(() => pressed.allTextContents(), PATIENT).not.toContain("Slow");
  await page.close();
  expect(errors).toEqual([]);
}, 120_000);

test("a page of another version says so and is not silent about it", async () => {
  const page = await browser.context.newPage();
  // The server's greeting with another number: what a page gets that was open while the program was replaced.
  await page.routeWebSocket(/\/live/, (socket) => {
    const server = socket.connectToServer();
    server.onMessage((message) =>
      socket.send(String(message).replace(/"protocol":\d+/, '"protocol":999')),
    );
  });
  await page.goto(`${served.url}/?token=${encodeURIComponent(served.tokens.observer ?? "")}`);
  await page.getByText("THIS PAGE HAS ANOTHER VERSION THAN THE PROGRAM").waitFor(PATIENT);
  await page.screenshot({ path: join(SHOTS, "another-version.png") });
  await page.close();
}, 60_000);
