/** A new user: the hints alone lead to a ship that steers. And a page whose data stops says so. */
import { join } from "node:path";
import { afterAll, beforeAll, expect, test } from "vitest";
import { type Browser, type Served, SHOTS, browse, open, serve } from "./browser";

const errors: string[] = [];
let served: Served;
let browser: Browser;

beforeAll(async () => {
  served = await serve();
  browser = await browse({ width: 1024, height: 768 }, true);
});
afterAll(async () => {
  await browser.close();
  await served.close();
});

test("hints lead a newcomer to the helm, the rudder, the engine and a tug within a minute", async () => {
  const begun = Date.now();
  const page = await open(browser.context, served, "pilot", errors, true);
  const hint = page.getByRole("status", { name: "Hint" });
  await hint.getByText("A bulk carrier approaches her berth").waitFor();
  await page.screenshot({ path: join(SHOTS, "newcomer-0.png") });
  await page.getByRole("button", { name: "Next hint" }).tap();
  await hint.getByText("Start here").waitFor();
  await page.screenshot({ path: join(SHOTS, "newcomer-1.png") });
  await page.getByRole("button", { name: "Take the helm" }).tap();
  await hint.getByText("Steer:").waitFor();
  await page.screenshot({ path: join(SHOTS, "newcomer-2.png") });
  await page.getByRole("button", { name: "Rudder starboard 20", exact: true }).tap();
  await expect
    .poll(() => page.getByRole("status", { name: "Rudder now" }).textContent())
    .toMatch(/^S \d/);
  await hint.getByText("telegraph").waitFor();
  await page.getByRole("button", { name: "Slow ahead", exact: true }).tap();
  await hint.getByText("Tell a tug").waitFor();
  await page.screenshot({ path: join(SHOTS, "newcomer-3.png") });
  await page.getByRole("button", { name: "Tugs", exact: true }).tap();
  await page
    .getByRole("button", { name: / push$/ })
    .first()
    .tap();
  await hint.getByText("docking board").waitFor();
  await page.getByRole("tab", { name: "Docking" }).tap();
  await hint.waitFor({ state: "hidden" });
  expect(Date.now() - begun).toBeLessThan(60_000);
  await page.close();
});

test("a page whose data stops says so, and continues when data arrives again", async () => {
  const page = await browser.context.newPage();
  let [cut, dropped] = [false, 0];
  await page.routeWebSocket(/\/live/, (socket) => {
    const server = socket.connectToServer();
    server.onMessage((message) => (cut ? (dropped += 1) : socket.send(message)));
  });
  await page.goto(
    `${served.url}/?token=${encodeURIComponent(served.tokens.observer ?? served.tokens.pilot ?? "")}`,
  );
  await page.waitForFunction(
    () => (document.querySelector(".readout dd")?.textContent ?? "–") !== "–",
  );
  const alert = page.getByRole("alert");
  expect(await alert.isVisible()).toBe(false);
  cut = true;
  await alert.getByText("NO DATA FOR").waitFor();
  await page.screenshot({ path: join(SHOTS, "no-data.png") });
  cut = false;
  await alert.waitFor({ state: "hidden" });
  expect(dropped).toBeGreaterThan(5);
  await page.close();
});

test("a page with a bad token shows the server's reason, one without a token explains links", async () => {
  const page = await browser.context.newPage();
  await page.goto(`${served.url}/?token=nonsense`);
  await page
    .getByRole("alert")
    .getByText(/The server says: /)
    .waitFor();
  await page.goto(`${served.url}/`);
  await page.getByText("Ask the instructor for yours").waitFor();
  await page.close();
});
