/** What a newcomer stumbled over: a question too short to read, words, tabs and a bar that did not fit. */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { afterAll, beforeAll, expect, test } from "vitest";
import { type Browser, SHOTS, type Served, browse, drawn, open, serve } from "./browser";
import { axe, sizes, withAxe } from "./faults";

/** Longer than the question stood before [ms]. */
const READ_MS = 7000;

const errors: string[] = [];
let served: Served;
let browser: Browser;

beforeAll(async () => {
  served = await serve();
  browser = await browse({ width: 1366, height: 768 }, true);
  await withAxe(browser.context);
});
afterAll(async () => {
  await browser.close();
  await served.close();
});

test("End this run? stays until it is answered, and Escape keeps the run", async () => {
  const page = await open(browser.context, served, "instructor", errors);
  await page.getByRole("tab", { name: "Session" }).click();
  const anew = page.getByRole("button", { name: /^Start anew/ });
  const question = page.getByRole("dialog", { name: "End this run?" });
  await anew.click();
  await page.waitForTimeout(READ_MS);
  expect(await question.isVisible()).toBe(true);
  for (const size of [
    { width: 390, height: 844 },
    { width: 1024, height: 768 },
    { width: 1366, height: 768 },
  ]) {
    await page.setViewportSize(size);
    expect(await sizes(page)).toEqual([]);
    await page.screenshot({ path: join(SHOTS, `question-${size.width}.png`) });
  }
  await page.keyboard.press("Escape");
  await question.waitFor({ state: "detached" });
  for (const palette of ["dusk", "night", "bright", "day"]) {
    await page.keyboard.press("b");
    expect(await page.locator("html").getAttribute("data-palette")).toBe(palette);
    await anew.click();
    expect(await axe(page, "dialog")).toEqual([]);
    await page.keyboard.press("Escape");
    await question.waitFor({ state: "detached" });
  }
  const ticked = () => page.evaluate(() => document.querySelector(".top .time")?.textContent ?? "");
  expect(await ticked()).not.toMatch(/^0:00:0[0-3]/);
  await anew.click();
  await question.getByRole("button", { name: "Go on with it" }).click();
  await question.waitFor({ state: "detached" });
  expect(await ticked()).not.toMatch(/^0:00:0[0-3]/);
  await anew.click();
  await question.getByRole("button", { name: "End this run" }).click();
  await page.locator(".run-state", { hasText: "PAUSED" }).waitFor();
  await expect.poll(ticked).toBe("0:00:00");
  await page.close();
  expect(errors).toEqual([]);
});

test("the board and the strip have words of the field in place of signs", async () => {
  const page = await open(browser.context, served, "pilot", errors);
  await page.getByRole("tab", { name: "Docking" }).click();
  await page.getByText(/^At most 0\.15 m\/s at the fenders; at this distance 0\.\d\d$/).waitFor();
  await page
    .getByRole("button", { name: "forward_tug leads square to the side; change" })
    .waitFor();
  await page.locator(".lamp", { hasText: "BEYOND FENDERS" }).first().waitFor();
  const text = await page.locator("body").innerText();
  for (const sign of ["⊥", "PAST END", "limit here"]) expect(text).not.toContain(sign);
  await page.close();
  expect(errors).toEqual([]);
});

test("the arrows of the tabs go when the page becomes wide enough for all of them", async () => {
  const arrows = ".tab-row .more";
  for (const role of ["pilot", "tugmaster", "observer"]) {
    const page = await open(browser.context, served, role, errors);
    const shown = async (width: number) => {
      await page.setViewportSize({ width, height: 768 });
      await drawn(page);
      return page
        .locator(arrows)
        .evaluateAll((all) => all.map((each) => getComputedStyle(each).display !== "none"));
    };
    for (const width of [1366, 1100, 1024, 900, 820]) {
      const fresh = (await shown(1900), await shown(width));
      expect(await shown(390)).toEqual([true, true]);
      expect([role, width, await shown(width)]).toEqual([role, width, fresh]);
    }
    await page.close();
  }
  expect(errors).toEqual([]);
});

test("with the helm and a long name the buttons at the right of the bar stay on the page", async () => {
  const page = await open(browser.context, served, "pilot", errors);
  await page.getByRole("button", { name: "Take the helm" }).click();
  await page.getByRole("button", { name: "Release the helm" }).waitFor();
  await page.locator(".name-badge").click();
  expect(await axe(page, "dialog")).toEqual([]);
  await page.locator("#person-name").fill("Captain Maximilian Meier");
  await page.getByRole("button", { name: "Use this name" }).click();
  await page.locator(".name-badge", { hasText: "Meier" }).waitFor();
  for (const width of [1366, 1280, 1024]) {
    await page.setViewportSize({ width, height: 768 });
    const right = await page
      .locator(".top > button")
      .evaluateAll((all) => Math.max(...all.map((each) => each.getBoundingClientRect().right)));
    expect(right).toBeLessThanOrEqual(width);
    await page.screenshot({ path: join(SHOTS, `bar-${width}.png`) });
    expect(await sizes(page)).toEqual([]);
  }
  await page.close();
  expect(errors).toEqual([]);
});

/** The timeline of the page without a server, with its styles: that page itself is built by `cargo xtask page`. */
test("the clock of the page without a server is not cut at 1366 px in a run of hours", async () => {
  const page = await browser.context.newPage();
  const sheet = (name: string) => readFileSync(new URL(`../${name}`, import.meta.url), "utf8");
  const styles = ["src/style/base.css", "src/style/layout.css", "run/style/page.css"].map(sheet);
  await page.setContent(
    `<style>${styles.join("")}</style>
    <footer class="controls timeline-bar"><div class="row"><button>▶</button><button>Peak</button>
    <input type="range"><output class="at">1:06:40 of 10:00:00</output></div></footer>`,
  );
  for (const width of [1366, 1024, 390]) {
    await page.setViewportSize({ width, height: 768 });
    const [right, text, box] = await page
      .locator(".at")
      .evaluate((at) => [at.getBoundingClientRect().right, at.scrollWidth, at.clientWidth]);
    expect(right).toBeLessThanOrEqual(width);
    expect(text).toBeLessThanOrEqual(box ?? 0);
  }
  await page.close();
});
