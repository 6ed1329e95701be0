/** The view out of the window in the page without a server, with the network gone. */
import { mkdirSync, mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { afterAll, beforeAll, expect, test } from "vitest";
import { SHOTS, SOFTWARE_WEBGL } from "../e2e/browser";
import { type Opened, opened, reran } from "./served";
import { box, red } from "../e2e/red_box";
import { glb } from "../test/glb";

let at: Opened;
beforeAll(async () => {
  mkdirSync(SHOTS, { recursive: true });
  at = await opened({ width: 1600, height: 900 }, false, SOFTWARE_WEBGL);
});
afterAll(() => at.close());

test("the view opens with the network gone, beside the plan and in its place", async () => {
  const { page, context, errors } = at;
  await page.waitForLoadState("networkidle");
  await context.setOffline(true);
  await page.getByRole("button", { name: "View out of the window" }).click();
  await page.waitForFunction(
    () => document.querySelector<HTMLElement>(".window canvas")?.dataset.script !== undefined,
    undefined,
    { timeout: 60_000 },
  );
  const canvas = page.getByRole("img", { name: /^View / });
  await page.getByRole("button", { name: /^Both/ }).click();
  await page.getByRole("img", { name: "Plan of ship" }).waitFor();
  const [view, plan] = [
    await canvas.boundingBox(),
    await page.getByRole("img", { name: "Plan of ship" }).boundingBox(),
  ];
  expect((view?.y ?? 0) + (view?.height ?? 0)).toBeLessThanOrEqual((plan?.y ?? 0) + 1);
  await page.waitForTimeout(1500);
  await page.screenshot({ path: join(SHOTS, "page-window.png") });
  await page.getByRole("button", { name: /^Plan: close/ }).click();
  expect(await canvas.isVisible()).toBe(false);
  expect(errors).toEqual([]);
});

test("the report has a picture of the largest fender load, and so has the saved report", async () => {
  const { page, errors } = at;
  await page.getByRole("tab", { name: "Report" }).click();
  const figure = page.frameLocator("iframe[title=Report]").locator("figure.view-picture");
  await figure.locator("img").waitFor({ timeout: 60_000 });
  expect(await figure.textContent()).toMatch(/ s: fender .*; reaction .*; deflection \d\.\d\d m/);
  await figure.scrollIntoViewIfNeeded();
  await page.screenshot({ path: join(SHOTS, "page-report-picture.png") });
  const saved = page.waitForEvent("download");
  await page.getByRole("button", { name: "Save report" }).click();
  const html = readFileSync(await (await saved).path(), "utf8");
  expect(html).toContain("<h2>Fenders</h2><figure");
  expect(html).toContain('src="data:image/jpeg;base64,');
  expect(errors).toEqual([]);
});

test("a model of a ship among the opened files is drawn in her place", async () => {
  const { page, errors } = at;
  const folder = mkdtempSync(join(tmpdir(), "fenderline-page-model-"));
  const [toml, model] = [join(folder, "boxed.toml"), join(folder, "box.glb")];
  writeFileSync(model, new Uint8Array(glb(box())));
  writeFileSync(
    toml,
    `[time]\nstep = "0.1 s"\nduration = "5 s"
[vessel.boxed]\nfrom = "bulk-carrier"\nmodel = "box.glb"\n[body.ship]\nvessel = "boxed"\nposition = [0, 0]\n`,
  );
  await reran(page, () => page.locator("input[type=file]").setInputFiles([toml, model]));
  expect(await page.locator(".run-state").textContent()).toMatch(/^done/);
  await page.getByRole("button", { name: "View out of the window" }).click();
  await page.locator(".window-tools").getByText("Free", { exact: true }).click();
  await expect.poll(() => red(page)).toBeGreaterThan(0.02);
  expect(errors).toEqual([]);
});
