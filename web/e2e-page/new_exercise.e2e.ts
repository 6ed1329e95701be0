/**
 * A new exercise in the page without a server: from berth, ship, tugs and weather, and at the berth of another scenario. It opens and runs in
 * the page, and its file runs by `fenderline run` and `fenderline serve`.
 */
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { afterAll, beforeAll, expect, test } from "vitest";
import { SHOTS, open, serve, underTest } from "../e2e/browser";
import { type Opened, opened } from "./served";

const folder = mkdtempSync(join(tmpdir(), "fenderline-made-"));
const made = join(folder, "first_try.toml");

let at: Opened;
beforeAll(async () => {
  at = await opened({ width: 1366, height: 768 });
  await at.page.getByRole("tab", { name: "New exercise" }).click();
});
afterAll(async () => {
  await at.close();
});

const form = () => at.page.getByRole("tabpanel", { name: "New exercise" });
const field = (name: string) => form().getByLabel(name, { exact: true });
const make = () => form().getByRole("button", { name: "Make exercise" }).click();
const said = (text: string) =>
  form().getByRole("status", { name: "Saved" }).filter({ hasText: text }).waitFor();
/** The scenario of the page: on this width it is a tab of its own. */
const scenario = async (): Promise<string> => {
  await at.page.getByRole("tab", { name: "Scenario" }).click();
  const text = await at.page.getByRole("textbox", { name: "Scenario" }).inputValue();
  await at.page.getByRole("tab", { name: "New exercise" }).click();
  return text;
};

test("an exercise is made from nothing, opens and runs", async () => {
  const { page, errors, served, context } = at;
  await field("Ship").waitFor();
  // Made in the page alone.
  served.asked.length = 0;
  await context.setOffline(true);
  await make();
  await said("title and a file name");
  await field("Title").fill("Container ship at a new berth");
  await field("Ship").selectOption("container-ship");
  await field("Berths with her").selectOption("port");
  await field("Length of the quay").fill("420");
  await field("Fenders").selectOption("pneumatic");
  await field("Size").selectOption("3300x6500 50kPa");
  await field("Number of fenders").fill("8");
  await field("Distance between fenders").fill("40");
  await field("Number of tugs").selectOption("3");
  await field("Current").fill("0.5");
  await field("File name").fill("../outside");
  await make();
  await said("letters, digits, - and _");
  await field("File name").fill("first_try");
  await field("Number of fenders").fill("60");
  await make();
  await said("longer than the quay of 420 m");
  await field("Number of fenders").fill("8");
  await make();
  await said("first_try.toml is the scenario of this page now");
  await page.screenshot({ path: join(SHOTS, "page-new-exercise.png") });
  const text = await scenario();
  expect(text).toContain('title = "Container ship at a new berth"');
  await page.waitForFunction(() => document.title.startsWith("Container ship at a new berth"));
  await page.waitForFunction(() =>
    /^[1-9]\d* %/.test(document.querySelector(".run-state")?.textContent ?? ""),
  );
  await page.getByRole("button", { name: "Stop" }).click();
  await page.locator(".run-state", { hasText: /^stopped/ }).waitFor();
  const [saved] = await Promise.all([
    page.waitForEvent("download"),
    form().getByRole("button", { name: "Save the exercise as a file" }).click(),
  ]);
  expect(saved.suggestedFilename()).toBe("first_try.toml");
  await saved.saveAs(made);
  expect(readFileSync(made, "utf8")).toBe(text);
  await page.screenshot({ path: join(SHOTS, "page-new-exercise-run.png") });
  await context.setOffline(false);
  expect(served.asked.filter((path) => path !== "/favicon.ico")).toEqual([]);
  expect(errors).toEqual([]);
});

test("its file runs by `fenderline run` and by `fenderline serve`", async () => {
  const out = mkdtempSync(join(tmpdir(), "fenderline-run-"));
  const short = ["--set", 'time.duration="20 s"', "--out", out];
  const words = execFileSync(underTest(), ["run", made, ...short], { encoding: "utf8" });
  expect(words).toContain("No fender was touched");
  expect(readdirSync(out)).toContain("report.html");
  const own = await serve([], made);
  const pilot = await open(at.context, own, "pilot", at.errors);
  await pilot.locator("header", { hasText: "Container ship at a new berth" }).waitFor();
  await pilot.close();
  await own.close();
});

test("it takes the berth of another scenario, with the chart that this one names", async () => {
  const { page } = at;
  await page.bringToFront();
  await field("Title").fill("A tanker in the harbour");
  await field("File name").fill("in_the_harbour");
  await field("Berth").selectOption("harbour.toml");
  expect(await field("Length of the quay").isVisible()).toBe(false);
  await make();
  await said("in_the_harbour.toml is the scenario");
  const text = await scenario();
  expect(text).toContain("the berth of harbour.toml");
  expect(text).toContain('files = ["harbour.geojson"]');
  await page.waitForFunction(() => document.title.startsWith("A tanker in the harbour"));
  await page.getByRole("button", { name: "Stop" }).click();
  await page.locator(".run-state", { hasText: /^stopped/ }).waitFor();
  await page.screenshot({ path: join(SHOTS, "page-new-exercise-harbour.png") });
  expect(at.errors).toEqual([]);
});
