/**
 * What a scenario says of the view: the user's models of ships, of which a good one stands in the place of the drawn hull and a broken
 * one is told in words; and an exercise without marks.
 */
import { mkdirSync, mkdtempSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { expect, test } from "vitest";
import { SHOTS, SOFTWARE_WEBGL, browse, open, serve } from "./browser";
import { box, red } from "./red_box";
import { glb } from "../test/glb";

/** A file whose header is right and whose content is not. */
function broken(): Uint8Array {
  const bytes = new Uint8Array(glb(box()));
  return bytes.map((byte, i) => (i >= 20 && i < 60 ? 0x7b : byte));
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
