/** The page without a server, in a real browser. */
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { afterAll, beforeAll, expect, test } from "vitest";
import { underTest } from "../e2e/browser";
import { type Opened, ended, opened, reran } from "./served";

const ROOT = new URL("../../", import.meta.url).pathname;
const CONES = "scenarios/berth/eight_cones_at_5_deg.toml";
const PAPER = "scenarios/paper/experiment_2_4kn.toml";
const text = (file: string): string => readFileSync(join(ROOT, file), "utf8");
const folder = mkdtempSync(join(tmpdir(), "fenderline-page-"));

let at: Opened;
beforeAll(async () => {
  at = await opened();
});
afterAll(async () => {
  await at.close();
});

const state = () => at.page.locator(".run-state").textContent();
const editor = () => at.page.getByRole("textbox", { name: "Scenario" });
const tab = (name: string) => at.page.getByRole("tab", { name }).click();
const write = (scenario: string) => reran(at.page, () => editor().fill(scenario));

/** The summary that the page saves. */
async function summary(): Promise<Record<string, unknown>> {
  await tab("Report");
  const [saved] = await Promise.all([
    at.page.waitForEvent("download"),
    at.page.getByRole("button", { name: "Save summary" }).click(),
  ]);
  return JSON.parse(readFileSync(await saved.path(), "utf8")) as Record<string, unknown>;
}

/** The summary of `fenderline run`. */
function native(file: string): Record<string, unknown> {
  const out = join(folder, "out");
  execFileSync(underTest(), ["run", file, "--out", out, "--allow-failures"], { cwd: ROOT });
  return JSON.parse(readFileSync(join(out, "summary.json"), "utf8")) as Record<string, unknown>;
}

/** Without the list of written files, which the page does not write. */
const comparable = (of: Record<string, unknown>) => ({ ...of, files: [] });

test("once loaded it asks no server for anything, and works with the network gone", async () => {
  const { page, served, context, errors } = at;
  expect(served.asked).toContain("/");
  served.asked.length = 0;
  const requests: string[] = [];
  page.on("request", (request) => {
    if (!/^(blob|data):/.test(request.url())) requests.push(request.url());
  });
  await context.setOffline(true);
  for (const name of ["Charts", "Verdict", "Report", "Fenders"]) await tab(name);
  const choose = page.getByRole("combobox", { name: "Scenario" });
  await reran(page, () => choose.selectOption({ index: 6 }));
  await expect(state()).resolves.toMatch(/^done/);
  // The instruments were loaded with the page.
  await tab("Conning");
  await page.locator(".conning obc-rudder svg").first().waitFor();
  await tab("Fenders");
  await reran(page, () => choose.selectOption({ index: 0 }));
  await context.setOffline(false);
  expect(served.asked.filter((path) => path !== "/favicon.ico")).toEqual([]);
  expect(requests).toEqual([]);
  expect(errors).toEqual([]);
});

test("eight fenders and the paper's case at 4 kn have the summaries of `fenderline run`", async () => {
  for (const [index, file] of [
    [0, CONES],
    [7, PAPER],
  ] as const) {
    const choose = at.page.getByRole("combobox", { name: "Scenario" });
    await reran(at.page, () => choose.selectOption({ index }));
    expect(comparable(await summary())).toEqual(comparable(native(file)));
  }
});

test("a mistake is marked with line and column while one types, and its mending runs at once", async () => {
  const { page } = at;
  const lines = text(CONES).split("\n");
  const line = lines.findIndex((each) => each.startsWith("gyradius"));
  const broken = lines.with(line, 'gyradiu = "74.5 m"').join("\n");
  await write(broken);
  expect(await state()).toBe(`mistake in line ${line + 1}`);
  expect(await page.locator(".backdrop mark").textContent()).toBe("gyradiu");
  const problem = page.locator(".problem");
  await expect(problem.textContent()).resolves.toMatch(
    /`body\.ship\.gyradiu` is not a key.*gyradius/,
  );
  // The line and the column lead to the place.
  await problem.getByRole("button").click();
  const cursor = await editor().evaluate((area: HTMLTextAreaElement) => area.selectionEnd);
  expect(broken.slice(cursor, cursor + 7)).toBe("gyradiu");
  await write(text(CONES));
  expect(await state()).toMatch(/^done/);
  expect(await problem.isVisible()).toBe(false);
});

test("a mistake far from the cursor is shown when the typing ends, a near one at once", async () => {
  const { page } = at;
  const lines = text(CONES).split("\n");
  const line = lines.findIndex((each) => each.startsWith("gyradius"));
  const seen = () =>
    editor().evaluate((area: HTMLTextAreaElement, index: number) => {
      const height = area.scrollHeight / area.value.split("\n").length;
      const [top, bottom] = [index * height, (index + 1) * height];
      return top >= area.scrollTop - 1 && bottom <= area.scrollTop + area.clientHeight + 1;
    }, line);
  // The cursor and the view are behind the last line, far from the mistake.
  const broken = lines.with(line, 'gyradiu = "74.5 m"').join("\n");
  const more = "# more\n".repeat(200);
  await write(text(CONES) + more);
  await editor().evaluate((area: HTMLTextAreaElement) => {
    area.setSelectionRange(area.value.length, area.value.length);
    area.scrollTop = area.scrollHeight;
  });
  await write(broken + more);
  expect(await seen()).toBe(false);
  await editor().blur();
  expect(await seen()).toBe(true);
  // With the cursor two lines below it, from a view that ends above.
  await reran(page, () =>
    editor().evaluate((area: HTMLTextAreaElement, index: number) => {
      const at = area.value
        .split("\n")
        .slice(0, index + 2)
        .join("\n").length;
      area.focus();
      area.setSelectionRange(at, at);
      area.scrollTop = 0;
      area.dispatchEvent(new Event("input"));
    }, line),
  );
  expect(await seen()).toBe(true);
  await write(text(CONES));
  expect(await state()).toMatch(/^done/);
});

test("the report is that of the run, and is shown", async () => {
  const { page } = at;
  await write(text(CONES));
  await tab("Report");
  const report = page.frameLocator("iframe");
  await expect(report.locator("h1").first().textContent()).resolves.toContain("eight cone fenders");
  expect(await report.locator("svg").count()).toBeGreaterThan(5);
});

test("a number is changed by a button, and the result follows", async () => {
  const { page } = at;
  await write(text(CONES));
  const before = (await summary()).berthing as { speed_mps: number };
  const place = text(CONES).indexOf("0.1494 m/s");
  await editor().evaluate((area: HTMLTextAreaElement, to: number) => {
    area.focus();
    area.setSelectionRange(to, to);
  }, place);
  await reran(page, () => page.getByRole("button", { name: "Greater number" }).click());
  expect(await editor().inputValue()).toContain("0.1594 m/s");
  const after = (await summary()).berthing as { speed_mps: number };
  expect(after.speed_mps).toBeGreaterThan(before.speed_mps + 0.005);
});

test("a dropped file of 100 MB, one that is no text, and a broken one are refused; the page stays alive", async () => {
  const { page, errors } = at;
  const drop = (files: { name: string; bytes: number; byte: number }[]) =>
    page.evaluate((all) => {
      const data = new DataTransfer();
      for (const { name, bytes, byte } of all)
        data.items.add(new File([new Uint8Array(bytes).fill(byte)], name));
      window.dispatchEvent(new DragEvent("drop", { dataTransfer: data, cancelable: true }));
    }, files);
  const banner = page.locator(".banner");
  await drop([{ name: "large.toml", bytes: 100e6, byte: 35 }]);
  await expect(banner.textContent()).resolves.toMatch(/large\.toml has 100 MB/);
  await drop([{ name: "photo.toml", bytes: 1000, byte: 255 }]);
  await page.waitForFunction(() =>
    /not UTF-8/.test(document.querySelector(".banner")?.textContent ?? ""),
  );
  await reran(page, () => drop([{ name: "bad.toml", bytes: 1000, byte: 91 }]));
  expect(await state()).toBe("mistake in line 1");
  // A whole scenario through the file chooser.
  const own = join(folder, "own.toml");
  writeFileSync(own, text(PAPER));
  await reran(page, () => page.locator("input[type=file]").setInputFiles(own));
  expect(await state()).toMatch(/^done/);
  expect(await page.getByRole("combobox").locator("option:checked").textContent()).toBe("own.toml");
  expect(errors).toEqual([]);
});

test("an endless run shows its progress, lets the page live, and is stopped with the results so far", async () => {
  const { page } = at;
  const endless = text(CONES).replace('duration = "6 min"', 'duration = "9000000 s"');
  expect(endless).not.toBe(text(CONES));
  await editor().fill(endless);
  await page.waitForFunction(() =>
    document.querySelector(".run-state")?.textContent?.endsWith("left"),
  );
  // The page answers while the worker works.
  await tab("Charts");
  await tab("Fenders");
  await page.getByRole("button", { name: "Stop" }).click();
  await ended(page);
  expect(await state()).toMatch(/^stopped after/);
  expect((await summary()).interrupted).toBe(true);
  await write(text(CONES));
  expect(await state()).toMatch(/^done/);
});

test("the timeline shows any time of the run", async () => {
  const { page } = at;
  await write(text(CONES));
  await tab("Fenders");
  const timeline = page.getByRole("slider", { name: "Time of the run" });
  await timeline.evaluate((range: HTMLInputElement) => {
    range.value = "0";
    range.dispatchEvent(new Event("input"));
  });
  expect(await page.locator(".timeline-bar .at").textContent()).toMatch(/^0 of 360 s/);
  expect(await page.locator(".fenders .summary").textContent()).toMatch(/none touched yet/);
  await page.getByRole("button", { name: "Go to the largest" }).click();
  expect(await page.locator(".fenders li .state").allTextContents()).toContain("in contact");
  await timeline.evaluate((range: HTMLInputElement) => {
    range.value = "0";
    range.dispatchEvent(new Event("input"));
  });
  await page.getByRole("button", { name: "Play" }).click();
  await page.waitForFunction(
    () => !/none/.test(document.querySelector(".fenders .summary")?.textContent ?? "none"),
  );
});
