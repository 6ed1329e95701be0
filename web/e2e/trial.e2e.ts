/** A trial manoeuvre through the page's own controls: composed, shown, and only then given. */
import { join } from "node:path";
import { afterAll, beforeAll, expect, test } from "vitest";
import { type Browser, type Served, SHOTS, browse, open, serve } from "./browser";

/** A busy machine may take as long; the time itself is printed. */
const GENEROUS_MS = 20_000;

const errors: string[] = [];
let browser: Browser;
let served: Served;

beforeAll(async () => {
  browser = await browse({ width: 1366, height: 768 });
  served = await serve();
});
afterAll(async () => {
  await served.close();
  await browser.close();
});

test("half astern is tried, drawn as a ghost, and given by a button", async () => {
  const page = await open(browser.context, served, "pilot", errors);
  await page.getByRole("button", { name: "Take the helm" }).click();
  await page.getByRole("button", { name: "Trial manoeuvre" }).click();
  await page.getByRole("button", { name: "Start or end a trial" }).click();
  const telegraph = page.locator(".telegraph");
  const pressed = telegraph.locator('[aria-pressed="true"]');
  const before = await pressed.allTextContents();
  // In the page itself, from the press to the end of the drawing that has the answer.
  const drawn_ms = page.evaluate(
    () =>
      new Promise<number>((done) => {
        let pressed = NaN;
        const press = () => (pressed = performance.now());
        document.querySelector(".telegraph")?.addEventListener("pointerdown", press, {
          capture: true,
          once: true,
        });
        const look = () => {
          const shown = document.querySelector(".trial .outcome")?.textContent ?? "";
          // The plan is drawn by a callback of the same frame; the next one comes when that frame is on the screen.
          if (shown.includes("min: heading"))
            requestAnimationFrame(() => done(performance.now() - pressed));
          else requestAnimationFrame(look);
        };
        requestAnimationFrame(look);
      }),
  );
  await telegraph.getByRole("button", { name: /half astern/i }).click();
  const outcome = page.locator(".trial .outcome");
  await expect
    .poll(() => outcome.textContent(), { timeout: GENEROUS_MS })
    .toContain("min: heading");
  console.log(`trial: from the press to the drawn ghost ${(await drawn_ms).toFixed(0)} ms`);
  const tried = page.getByRole("list", { name: "Orders of the trial" }).locator("li");
  await expect.poll(() => tried.count()).toBe(1);
  // Several at once: a tug beside the engine.
  await page.locator(".tugs .tug").first().getByRole("button", { name: "Push" }).click();
  await expect.poll(() => tried.count()).toBe(2);
  await expect.poll(() => outcome.textContent(), { timeout: GENEROUS_MS }).not.toContain("…");
  await page.screenshot({ path: join(SHOTS, "trial.png") });
  expect(await pressed.allTextContents(), "nothing is given").toEqual(before);
  await page.getByRole("button", { name: "Give these orders" }).click();
  await expect.poll(() => pressed.allTextContents()).not.toEqual(before);
  await expect.poll(() => page.locator(".controls.in-trial").count()).toBe(0);
  await page.screenshot({ path: join(SHOTS, "trial-given.png") });
  await page.close();
  expect(errors).toEqual([]);
});
