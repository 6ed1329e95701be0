/**
 * A new exercise by the page's controls alone: the instructor chooses berth, ship, tugs and weather, and saves it; it runs by
 * `fenderline run` and by `serve`, and from the gallery. A second one of that name asks first. In fog the pilot does not
 * get what lies beyond it.
 */
import { execFileSync } from "node:child_process";
import { copyFileSync, mkdtempSync, readFileSync, readdirSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { type Browser, SHOTS, type Served, browse, open, serve, underTest } from "./browser";

const BERTHING = new URL("../../scenarios/live/berthing.toml", import.meta.url).pathname;
/** A folder of its own, so that nothing is saved in the repository. */
const folder = mkdtempSync(join(tmpdir(), "fenderline-gallery-"));
const made = join(folder, "first_try.toml");

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

const form = () => instructor.getByRole("tabpanel", { name: "New exercise" });
const field = (name: string) => form().getByLabel(name, { exact: true });
const saved = () => instructor.getByRole("status", { name: "Saved" });
const save = () => instructor.getByRole("button", { name: "Save exercise" }).click();

test("the instructor makes an exercise from nothing and saves it", async () => {
  await instructor.getByRole("tab", { name: "New exercise" }).click();
  await save();
  await saved().filter({ hasText: "title and a file name" }).waitFor();
  await field("Title").fill("Container ship at a new berth");
  expect(await field("File name").inputValue()).toBe("Container_ship_at_a_new_berth");
  await field("Ship").selectOption("container-ship");
  await field("Berths with her").selectOption("port");
  await field("Length of the quay").fill("420");
  await field("Fenders").selectOption("pneumatic");
  await field("Size").selectOption("3300x6500 50kPa");
  await field("Number of fenders").fill("8");
  await field("Distance between fenders").fill("40");
  await field("Number of tugs").selectOption("3");
  await field("Wind").fill("15");
  await field("Wind from").fill("240");
  await field("Current").fill("0.5");
  await field("Visibility").selectOption("1000");
  await field("File name").fill("../outside");
  await save();
  await saved().filter({ hasText: "Not saved" }).waitFor();
  await field("File name").fill("first_try");
  await instructor.screenshot({ path: join(SHOTS, "new_exercise.png") });
  await save();
  await saved().filter({ hasText: "Saved as first_try.toml" }).waitFor();
  // The form stays where it was scrolled to, with what comes next in sight.
  expect(await form().evaluate((view) => view.scrollTop)).toBeGreaterThan(0);
  const next = await instructor.getByRole("button", { name: /^Open it now/ }).boundingBox();
  const panel = await form().boundingBox();
  expect(next?.y).toBeGreaterThan(panel?.y ?? Infinity);
  expect((next?.y ?? Infinity) + (next?.height ?? 0)).toBeLessThan(
    (panel?.y ?? 0) + (panel?.height ?? 0),
  );
  expect(readdirSync(folder).toSorted()).toEqual(["berthing.toml", "first_try.toml"]);
});

test("it runs by `fenderline run`", () => {
  const out = mkdtempSync(join(tmpdir(), "fenderline-run-"));
  const said = execFileSync(
    underTest(),
    ["run", made, "--set", 'time.duration="20 s"', "--out", out],
    { encoding: "utf8" },
  );
  expect(said).toContain("No fender was touched");
  expect(readdirSync(out)).toContain("report.html");
});

test("it runs by `fenderline serve`", async () => {
  const own = await serve([], made);
  const pilot = await open(browser.context, own, "pilot", errors);
  await pilot.locator("header", { hasText: "Container ship at a new berth" }).waitFor();
  await pilot.screenshot({ path: join(SHOTS, "new_exercise_served.png") });
  await pilot.close();
  await own.close();
});

test("an exercise is saved over another only after a question", async () => {
  const before = readFileSync(made, "utf8");
  await instructor.bringToFront();
  await field("Title").fill("Second try");
  await save();
  await saved().filter({ hasText: "Nothing was changed" }).waitFor();
  expect(readFileSync(made, "utf8")).toBe(before);
  await instructor.getByRole("button", { name: "Replace it" }).click();
  await saved().filter({ hasText: "Saved as" }).waitFor();
  expect(readFileSync(made, "utf8")).toContain('title = "Second try"');
});

test("it takes the berth of another scenario", async () => {
  await instructor.bringToFront();
  await field("Title").fill("A tanker at the berth of the bulk carrier");
  await field("File name").fill("same_berth");
  await field("Berth").selectOption("berthing.toml");
  expect(await field("Length of the quay").isVisible()).toBe(false);
  await instructor.screenshot({ path: join(SHOTS, "new_exercise_berth.png") });
  await save();
  await saved().filter({ hasText: "Saved as same_berth.toml" }).waitFor();
  const text = readFileSync(join(folder, "same_berth.toml"), "utf8");
  expect(text).toContain("the berth of berthing.toml");
  expect(text).toContain("[body.quay]");
  expect(text).not.toContain("forward_tug");
  await field("Berth").selectOption("");
});

test("it opens from the gallery, and fog hides its tugs from the pilot alone", async () => {
  await instructor.getByRole("tab", { name: "Session" }).click();
  const load = instructor.getByRole("button", { name: "Open Second try", exact: true });
  await load.click();
  await instructor.getByRole("button", { name: "End this run" }).click();
  await instructor.locator("header", { hasText: "Second try" }).waitFor();
  const pilot = await open(browser.context, served, "pilot", errors);
  const hidden = (page: Page) =>
    page.evaluate(
      () => document.querySelector<HTMLElement>(".plan canvas")?.dataset.hidden ?? "none",
    );
  await expect.poll(() => hidden(pilot)).toBe("0");
  await instructor.bringToFront();
  await instructor.getByRole("tab", { name: "Weather, faults" }).click();
  await instructor.getByRole("button", { name: "Visibility 100 m" }).click();
  await instructor.getByText("do not see ships beyond 100 m").waitFor();
  await instructor.screenshot({ path: join(SHOTS, "visibility_instructor.png") });
  expect(await hidden(instructor)).toBe("0");
  await pilot.bringToFront();
  await pilot.waitForFunction(
    () => document.querySelector<HTMLElement>(".plan canvas")?.dataset.hidden === "2",
  );
  await pilot.screenshot({ path: join(SHOTS, "visibility_pilot.png") });
  expect(errors).toEqual([]);
});
