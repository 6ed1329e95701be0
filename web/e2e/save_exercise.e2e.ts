/**
 * The present state saved as an exercise from the page: it runs by `fenderline run` and by `serve`, opens from the page, has what
 * was planned, and takes the place of another only after a question.
 */
import { execFileSync } from "node:child_process";
import { copyFileSync, mkdtempSync, readFileSync, readdirSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { type Browser, SHOTS, type Served, browse, open, serve, underTest } from "./browser";

const BERTHING = new URL("../../scenarios/live/berthing.toml", import.meta.url).pathname;
const folder = mkdtempSync(join(tmpdir(), "fenderline-saved-"));
const made = join(folder, "halfway.toml");

const errors: string[] = [];
let served: Served;
let browser: Browser;
let instructor: Page;

beforeAll(async () => {
  copyFileSync(BERTHING, join(folder, "berthing.toml"));
  served = await serve([], join(folder, "berthing.toml"));
  browser = await browse({ width: 1366, height: 768 });
  instructor = await open(browser.context, served, "instructor", errors);
});
afterAll(async () => {
  await browser.close();
  await served.close();
});

const field = (name: string) => instructor.getByLabel(name, { exact: true });
const saved = () => instructor.getByRole("status", { name: "Exercise saved" });
const save = () => instructor.getByRole("button", { name: "Save as exercise" }).click();

test("the instructor saves the present state with what is planned", async () => {
  await instructor.getByRole("tab", { name: "Weather, faults" }).click();
  await instructor.getByRole("button", { name: "ship: Engine lost" }).click();
  await instructor.getByLabel("Changes happen in").selectOption("10");
  await instructor.getByLabel("weather changes over").selectOption("5");
  await instructor.getByRole("button", { name: "Visibility 200 m" }).click();
  await instructor
    .getByRole("button", { name: "forward_tug: Port unit trips", exact: true })
    .click();
  await instructor.locator(".planned", { hasText: "visibility 200 m over 5 min" }).waitFor();
  await instructor.getByRole("button", { name: "Pause" }).click();
  await instructor.screenshot({ path: join(SHOTS, "save_exercise_planned.png") });
  await instructor.getByRole("tab", { name: "Session" }).click();
  await save();
  await saved().filter({ hasText: "title and a file name" }).waitFor();
  await field("Title of the exercise").fill("Half-way in");
  await field("File name of the exercise").fill("halfway");
  await save();
  await saved().filter({ hasText: "Saved as halfway.toml" }).waitFor();
  await saved().scrollIntoViewIfNeeded();
  await instructor.screenshot({ path: join(SHOTS, "save_exercise.png") });
  expect(readdirSync(folder).toSorted()).toEqual(["berthing.toml", "halfway.toml"]);
  const text = readFileSync(made, "utf8");
  expect(text).toContain('title = "Half-way in"');
  expect(text).toMatch(/fault = "engine_lost"/);
  expect(text).toMatch(/thruster_out = "port"/);
  expect(text).toMatch(/visibility = \{ distance = 200.*over = 300 \}/);
});

test("it runs by `fenderline run` and by `serve`", async () => {
  const out = mkdtempSync(join(tmpdir(), "fenderline-run-"));
  execFileSync(underTest(), ["run", made, "--set", 'time.duration="20 s"', "--out", out]);
  expect(readdirSync(out)).toContain("report.html");
  const own = await serve([], made);
  const other = await open(browser.context, own, "instructor", errors);
  await other.locator("header", { hasText: "Half-way in" }).waitFor();
  await other.getByRole("tab", { name: "Weather, faults" }).click();
  await other.locator(".planned", { hasText: "forward tug: thruster port trips" }).waitFor();
  await other.locator('.fault[aria-pressed="true"]', { hasText: "Engine lost" }).waitFor();
  await other.close();
  await own.close();
});

test("it takes the place of another only after a question, and opens from the page", async () => {
  const before = readFileSync(made, "utf8");
  await instructor.bringToFront();
  await field("Title of the exercise").fill("Another");
  await save();
  await saved().filter({ hasText: "Nothing was changed" }).waitFor();
  expect(readFileSync(made, "utf8")).toBe(before);
  await instructor.getByRole("button", { name: "Replace the exercise" }).click();
  await saved().filter({ hasText: "Saved as" }).waitFor();
  expect(readFileSync(made, "utf8")).toContain('title = "Another"');
  const now = instructor.getByRole("button", { name: "Open it now: the saved exercise" });
  await now.click();
  await instructor.getByRole("button", { name: "End this run" }).click();
  await instructor.locator("header", { hasText: "Another" }).waitFor();
  expect(errors).toEqual([]);
});
