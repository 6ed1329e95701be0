/**
 * The verdict on the pages: for cases of the table of `crates/app/tests/verdict`, the words and sentences of
 * `summary.json`, on the pilot's and the instructor's page, at the end of the exercise and in the debriefing.
 */
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { spokenFinding } from "../src/units";
import { type Browser, SHOTS, browse, open, serve, underTest } from "./browser";

interface Case {
  name: string;
  scenario: string;
  set: Record<string, string>;
  text: string;
}

interface Summary {
  steps: number;
  verdict: { text: string; findings: { text: string }[] };
}

const TABLE = new URL("../../crates/app/tests/verdict/", import.meta.url).pathname;
const { cases } = JSON.parse(readFileSync(join(TABLE, "cases.json"), "utf8")) as { cases: Case[] };
/** Those with a vessel, which a server needs; the Rust test compares the frames of all cases. */
const ALL = cases.filter(({ scenario }) => scenario === "moored.toml");
/** In CI the first and the last. */
const SHOWN = process.env.CI ? ALL.filter((_, i) => i === 0 || i === ALL.length - 1) : ALL;
/** Shorter, so that the test is; the verdict is the same. */
const DURATION = "time.duration=100";

const errors: string[] = [];
let browser: Browser;

beforeAll(async () => {
  browser = await browse({ width: 1280, height: 800 });
});
afterAll(() => browser.close());

/** The summary of `fenderline run`. */
function summary(scenario: string, set: string[]): Summary {
  const out = join(mkdtempSync(join(tmpdir(), "fenderline-verdict-")), "out");
  const keys = set.flatMap((key) => ["--set", key]);
  spawnSync(underTest(), ["run", scenario, "--out", out, ...keys]);
  return JSON.parse(readFileSync(join(out, "summary.json"), "utf8")) as Summary;
}

const shownOn = async (page: Page) => ({
  inBar: await page.locator(".verdict-button").textContent(),
  text: await page.locator("p.verdict").textContent(),
  findings: (
    await Promise.all(
      ["Findings", "Notes"].map((name) =>
        page.locator(`ul[aria-label="${name}"] li`).allTextContents(),
      ),
    )
  ).flat(),
});

for (const [index, { name, scenario, set, text }] of SHOWN.entries()) {
  test(`${name}: ${text}`, async () => {
    const path = join(TABLE, scenario);
    const keys = [DURATION, ...Object.entries(set).map(([key, value]) => `${key}=${value}`)];
    const { steps, verdict } = summary(path, keys);
    expect(verdict.text).toBe(text);
    const served = await serve(keys, path);
    const instructor = await open(browser.context, served, "instructor", errors);
    const pilot = await open(browser.context, served, "pilot", errors);
    await instructor.bringToFront();
    await instructor.getByRole("button", { name: "Pace 8", exact: true }).click();
    const timeline = instructor.getByRole("slider", { name: "Timeline" });
    await expect
      .poll(async () => Number(await timeline.getAttribute("max")), { timeout: 120_000 })
      .toBeGreaterThan(steps);
    await instructor.getByRole("button", { name: "Pause (K)" }).click();
    await instructor.locator(".run-state", { hasText: "PAUSED" }).waitFor();
    // Back to the tick at which `fenderline run` ends.
    await timeline.evaluate((slider: HTMLInputElement, tick) => {
      slider.value = String(tick);
      slider.dispatchEvent(new Event("input"));
    }, steps);
    await instructor.locator(".run-state", { hasText: "REWOUND" }).waitFor();
    await expect.poll(() => timeline.inputValue()).toBe(String(steps));
    const said = {
      inBar: text,
      text,
      findings: verdict.findings.map((finding) => `${spokenFinding(finding.text)}.`),
    };
    for (const page of [instructor, pilot]) {
      await page.bringToFront();
      await page.getByRole("button", { name: `Verdict: ${text}` }).click();
      await expect.poll(() => shownOn(page)).toEqual(said);
      const role = page === pilot ? "pilot" : "instructor";
      await page.screenshot({ path: join(SHOTS, `verdict-${index}-${role}.png`) });
      await page.close();
    }
    await served.close();
    expect(errors).toEqual([]);
  });
}
