/**
 * Recordings and saved exercises are renamed and deleted from the page: a delete asks first, and can be undone at once or after a
 * reload. What the lists have now is large enough to touch, readable and no wider than the page, on a desktop and a phone.
 */
import { copyFileSync, mkdtempSync, readdirSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { type Browser, SHOTS, type Served, browse, open, serve } from "./browser";
import { axe, sizes, withAxe } from "./faults";

const BERTHING = new URL("../../scenarios/live/berthing.toml", import.meta.url).pathname;
const SIZES = [
  { width: 1366, height: 768 },
  { width: 390, height: 844 },
];
const folder = mkdtempSync(join(tmpdir(), "fenderline-files-"));

const errors: string[] = [];
let served: Served;
let browser: Browser;
let page: Page;

beforeAll(async () => {
  copyFileSync(BERTHING, join(folder, "berthing.toml"));
  served = await serve([], join(folder, "berthing.toml"));
  browser = await browse({ width: 1366, height: 768 }, true);
  await withAxe(browser.context);
  page = await open(browser.context, served, "instructor", errors);
  await page.getByRole("button", { name: "Pause" }).click();
  await page.getByRole("tab", { name: "Session" }).click();
});
afterAll(async () => {
  await browser.close();
  await served.close();
});

const button = (name: string) => page.getByRole("button", { name, exact: true });
const said = () => page.getByRole("status", { name: "Recordings and exercises" });
const recordings = () => readdirSync(served.sessions).filter((file) => !/berthing-\d/.test(file));

/** What is wrong with the tab as it is now, at each size; with a picture of each. */
async function faults(state: string): Promise<string[]> {
  const found: string[] = [];
  for (const size of SIZES) {
    await page.setViewportSize(size);
    const shown = page.locator(".file-note");
    await shown.evaluate((note) => note.scrollIntoView());
    await page.screenshot({ path: join(SHOTS, `files_${state}_${size.width}.png`) });
    found.push(...(await faultsOf(".panel")));
  }
  await page.setViewportSize(SIZES[0] ?? { width: 1366, height: 768 });
  return found;
}

const faultsOf = async (part: string) => [...(await sizes(page)), ...(await axe(page, part))];

test("a recording gets another name, which is never one that is taken", async () => {
  for (const name of ["first_try", "other"]) {
    await page.getByLabel("Name to save under").fill(name);
    await button("Save session").click();
    await button(`Rename ${name}`).waitFor();
  }
  await button("Rename first_try").click();
  const field = page.getByLabel("New name of first_try");
  await expect.poll(() => field.evaluate((own) => own === document.activeElement)).toBe(true);
  expect(await faults("rename")).toEqual([]);
  await field.fill("other");
  await field.press("Enter");
  await page.getByText("Refused: there is a file other.session.jsonl already").waitFor();
  await field.fill("second try");
  await button("Save name of first_try").click();
  await button("Rename second_try").waitFor();
  expect(await said().textContent()).toBe("first_try is named second_try now.");
  expect(recordings().toSorted()).toEqual(["other.session.jsonl", "second_try.session.jsonl"]);
});

test("an exercise is deleted after a question only, and Undo brings it back", async () => {
  await page.getByLabel("Title of the exercise").fill("Half-way in");
  await page.getByLabel("File name of the exercise").fill("halfway");
  await button("Save as exercise").click();
  await button("Delete halfway").click();
  const question = page.getByRole("dialog", { name: "Delete halfway?" });
  await page.screenshot({ path: join(SHOTS, "files_question.png") });
  await button("Keep it").click();
  await question.waitFor({ state: "detached" });
  await button("Delete halfway").click();
  expect(await faultsOf(".question")).toEqual([]);
  expect(readdirSync(folder)).toContain("halfway.toml");
  await button("Delete it").click();
  await said().filter({ hasText: "halfway is deleted." }).waitFor();
  expect(readdirSync(folder)).not.toContain("halfway.toml");
  expect(readdirSync(join(folder, "deleted"))).toEqual(["halfway.toml"]);
  expect(await button("Rename halfway").count()).toBe(0);
  await expect
    .poll(() => button("Undo").evaluate((own) => own === document.activeElement))
    .toBe(true);
  expect(await faults("deleted")).toEqual([]);
  await button("Undo").click();
  await said().filter({ hasText: "halfway is back." }).waitFor();
  await button("Rename halfway").waitFor();
  expect(await button("Undo").isVisible()).toBe(false);
  expect(readdirSync(folder)).toContain("halfway.toml");
});

test("what was deleted can be put back after a reload", async () => {
  await button("Delete second_try").click();
  await button("Delete it").click();
  await said().filter({ hasText: "second_try is deleted." }).waitFor();
  await page.reload();
  await page.getByRole("tab", { name: "Session" }).click();
  const list = page.getByRole("list", { name: "Deleted" });
  await list.scrollIntoViewIfNeeded();
  await page.screenshot({ path: join(SHOTS, "files_list_1366.png") });
  await button("Put back second_try").click();
  await button("Rename second_try").waitFor();
  expect(await list.count()).toBe(0);
  expect(recordings().toSorted()).toEqual([
    "deleted",
    "other.session.jsonl",
    "second_try.session.jsonl",
  ]);
});

test("neither what runs nor what was written by hand, and for the instructor alone", async () => {
  expect(await button("Rename berthing").count()).toBe(0);
  expect(await button("Delete berthing").count()).toBe(0);
  const pilot = await open(browser.context, served, "pilot", errors);
  expect(await pilot.getByRole("tab", { name: "Session" }).count()).toBe(0);
  await pilot.close();
  expect(errors).toEqual([]);
});
