/**
 * What a scenario says of the view: the user's models of ships, of which a good one stands in the place of the drawn hull and a broken
 * one is told in words; and an exercise without marks.
 */
import { mkdirSync, mkdtempSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { expect, test } from "vitest";
import { SHOTS, SOFTWARE_WEBGL, browse, open, serve } from "./browser";
import { glb } from "../test/glb";

/** Corners of a box, in the axes of glTF [m]: 30 m wide, from 2 m below the water to 25 m above it, 180 m long. */
function box(): number[] {
  const [x, y, z] = [
    [-15, 15],
    [-2, 25],
    [-90, 90],
  ] as const;
  const at = (i: number, j: number, k: number) => [x[i] ?? 0, y[j] ?? 0, z[k] ?? 0];
  const quad = (a: number[], b: number[], c: number[], d: number[]) => [a, b, c, a, c, d].flat();
  return [
    quad(at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0)),
    quad(at(1, 0, 1), at(0, 0, 1), at(0, 1, 1), at(1, 1, 1)),
    quad(at(1, 0, 0), at(1, 0, 1), at(1, 1, 1), at(1, 1, 0)),
    quad(at(0, 0, 1), at(0, 0, 0), at(0, 1, 0), at(0, 1, 1)),
    quad(at(0, 1, 0), at(1, 1, 0), at(1, 1, 1), at(0, 1, 1)),
  ].flat();
}

/** A file whose header is right and whose content is not. */
function broken(): Uint8Array {
  const bytes = new Uint8Array(glb(box()));
  return bytes.map((byte, i) => (i >= 20 && i < 60 ? 0x7b : byte));
}

/** Share of the picture that is as red as the box. */
async function red(page: Page): Promise<number> {
  const png = (await page.getByRole("img", { name: /^View / }).screenshot()).toString("base64");
  return page.evaluate(async (png) => {
    const image = new Image();
    image.src = `data:image/png;base64,${png}`;
    await image.decode();
    const area = new OffscreenCanvas(image.width, image.height).getContext("2d");
    if (!area) throw new Error("a browser has a canvas");
    area.drawImage(image, 0, 0);
    const { data } = area.getImageData(0, 0, image.width, image.height);
    let count = 0;
    for (let i = 0; i < data.length; i += 4)
      if ((data[i] ?? 0) > 90 && (data[i] ?? 0) > 2 * Math.max(data[i + 1] ?? 0, data[i + 2] ?? 0))
        count += 1;
    return count / (data.length / 4);
  }, png);
}

test("a ship's own model is drawn in her place, and a broken model is told while her hull is drawn", async () => {
  mkdirSync(SHOTS, { recursive: true });
  const folder = mkdtempSync(join(tmpdir(), "fenderline-model-"));
  writeFileSync(join(folder, "box.glb"), new Uint8Array(glb(box())));
  writeFileSync(join(folder, "torn.glb"), broken());
  const file = join(folder, "models.toml");
  writeFileSync(
    file,
    `[time]\nstep = "0.1 s"\nduration = "1 h"
[vessel.boxed]\nfrom = "bulk-carrier"\nmodel = "box.glb"
[vessel.torn]\nfrom = "bulk-carrier"\nmodel = "torn.glb"
[body.first]\nvessel = "boxed"\nposition = [0, 0]
[body.second]\nvessel = "torn"\nposition = [0, 400]\n`,
  );
  const errors: string[] = [];
  const served = await serve([], file);
  const { context, close } = await browse({ width: 1280, height: 720 }, false, SOFTWARE_WEBGL);
  const page = await open(context, served, "pilot", errors);
  await page.getByRole("button", { name: "View out of the window" }).click();
  const caption = page.locator(".window-caption");
  await page.locator(".window-tools").getByText("Free", { exact: true }).click();
  await expect.poll(() => caption.textContent()).toMatch(/; torn\.glb cannot be drawn \(.+\)$/);
  expect(await caption.textContent()).not.toContain("box.glb");
  await expect.poll(() => red(page)).toBeGreaterThan(0.02);
  await page.screenshot({ path: join(SHOTS, "window-model.png") });
  await close();
  await served.close();
  expect(errors).toEqual([]);
});

test("an exercise without marks has them on the instructor's page alone", async () => {
  const errors: string[] = [];
  const served = await serve(["exercise.view_marks=false"]);
  const { context, close } = await browse({ width: 1280, height: 720 }, false, SOFTWARE_WEBGL);
  for (const role of ["pilot", "instructor"]) {
    const page = await open(context, served, role, errors);
    await page.getByRole("button", { name: "View out of the window" }).click();
    const picture = page.getByRole("img", { name: /^View / });
    await expect.poll(() => picture.getAttribute("data-drawn")).not.toBeNull();
    const marks = page.getByRole("button", { name: /^Marks: / });
    expect(await marks.isVisible()).toBe(role === "instructor");
    await picture.focus();
    await page.keyboard.press("m");
    if (role === "pilot") await page.getByText("This exercise has no marks in the view.").waitFor();
    else await expect.poll(() => marks.getAttribute("aria-pressed")).toBe("true");
    await page.close();
  }
  await close();
  await served.close();
  expect(errors).toEqual([]);
});
