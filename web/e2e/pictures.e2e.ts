/**
 * The pictures of the view in the README and in the book, for looking at too: by day, at dusk, at night and in fog, of a ship, a
 * tug and a berth. `npm run pictures` writes all into the folder of the book's pictures, `ONLY=fog` those with the word in their
 * name; with `SCREENSHOTS` they go into that folder.
 */
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { expect, test } from "vitest";
import { SOFTWARE_WEBGL, browse, open, serve } from "./browser";

interface Shot {
  name: string;
  scenario: string;
  set?: string[];
  camera: string;
  /** Presses of the camera's button after the first, for the next tug or bollard. */
  again?: number;
  /** Time of the run that the picture shows [s]. */
  at_s?: number;
  palette?: "day" | "dusk" | "night";
  marks?: boolean;
  /** Keys in the view, such as ArrowLeft. */
  keys?: string[];
}

const HARBOUR = "live/harbour.toml";
const MOORED = "live/moored_in_a_squall.toml";
const BERTHING = "live/berthing.toml";
const fog = (visibility: string) => [`environment.visibility="${visibility}"`];

const SHOTS_OF: Shot[] = [
  { name: "day-ship", scenario: HARBOUR, camera: "Bridge", at_s: 60 },
  {
    name: "day-tug",
    scenario: HARBOUR,
    camera: "Tug",
    at_s: 60,
    keys: ["ArrowRight", "ArrowRight"],
  },
  { name: "day-berth", scenario: MOORED, camera: "Free", at_s: 90, marks: true },
  {
    name: "dusk-ship",
    scenario: HARBOUR,
    set: [
      'environment.start_time="2026-06-21T21:30+02:00"',
      'environment.waves={ height = "1.5 m", period = "7 s", from = "300 deg", spreading = 2, seed = 1 }',
    ],
    camera: "Free",
    at_s: 40,
  },
  { name: "dusk-tug", scenario: BERTHING, camera: "Tug", at_s: 60, palette: "dusk" },
  { name: "dusk-berth", scenario: MOORED, camera: "Stb", at_s: 60, palette: "dusk" },
  { name: "night-ship", scenario: HARBOUR, camera: "Bridge", at_s: 60, palette: "night" },
  { name: "night-tug", scenario: HARBOUR, camera: "Port", at_s: 60, palette: "night" },
  { name: "night-berth", scenario: BERTHING, camera: "Bollard", at_s: 90, palette: "night" },
  { name: "fog-ship", scenario: HARBOUR, set: fog("500 m"), camera: "Bridge", at_s: 60 },
  {
    name: "fog-tug",
    scenario: HARBOUR,
    set: fog("300 m"),
    camera: "Tug",
    at_s: 60,
    keys: ["ArrowRight", "ArrowRight"],
  },
  { name: "fog-berth", scenario: BERTHING, set: fog("300 m"), camera: "Bow", at_s: 100 },
];
/** Where they go. */
const FOLDER =
  process.env.SCREENSHOTS ?? new URL("../../docs/_static/view/", import.meta.url).pathname;
/** Size of the browser's window, width of a picture [px], and largest size of a file: twelve have less than 600 kB. */
const SIZE = { width: 1600, height: 900 };
const WIDE_PX = 1120;
const MOST_BYTES = 49_000;

/** A picture of the view as JPEG, no larger than a page of the book may have. */
async function asJpeg(page: Page, png: Buffer): Promise<Buffer> {
  for (const quality of [0.85, 0.75, 0.65, 0.55, 0.45, 0.35]) {
    const text = await page.evaluate(
      async ([png, quality, wide]) => {
        const image = new Image();
        image.src = `data:image/png;base64,${png}`;
        await image.decode();
        const area = document.createElement("canvas");
        [area.width, area.height] = [wide, Math.round((wide * image.height) / image.width)];
        const to = area.getContext("2d");
        if (!to) throw new Error("a browser has a canvas");
        to.drawImage(image, 0, 0, area.width, area.height);
        return area.toDataURL("image/jpeg", quality).split(",")[1] ?? "";
      },
      [png.toString("base64"), quality, WIDE_PX] as const,
    );
    const jpeg = Buffer.from(text, "base64");
    if (jpeg.length <= MOST_BYTES) return jpeg;
  }
  throw new Error("the picture is too large at every quality");
}

test("pictures for looking at", async () => {
  mkdirSync(FOLDER, { recursive: true });
  const errors: string[] = [];
  for (const shot of SHOTS_OF.filter(({ name }) => name.includes(process.env.ONLY ?? ""))) {
    const scenario = new URL(`../../scenarios/${shot.scenario}`, import.meta.url).pathname;
    const served = await serve(shot.set ?? [], scenario);
    const { context, close } = await browse(SIZE, false, SOFTWARE_WEBGL);
    const page = await open(context, served, "instructor", errors);
    page.setDefaultTimeout(120_000);
    const seconds = async () => {
      const text = (await page.getByRole("timer").first().textContent()) ?? "";
      return text
        .split(" ")[0]
        ?.split(":")
        .reduce((sum, part) => 60 * sum + Number(part), 0);
    };
    if (shot.at_s) {
      await page.getByRole("button", { name: "Pace 8" }).click();
      await expect.poll(seconds, { timeout: 120_000, interval: 200 }).toBeGreaterThan(shot.at_s);
    }
    await page.getByRole("button", { name: "Pause (K)" }).click();
    for (let i = 0; i < 3; i++)
      if ((await page.locator("html").getAttribute("data-palette")) !== (shot.palette ?? "day"))
        await page.getByRole("button", { name: /^Palette/ }).click();
    await page.getByRole("button", { name: "View out of the window" }).click();
    await page.waitForFunction(
      () => document.querySelector<HTMLElement>(".window canvas")?.dataset.script !== undefined,
      undefined,
      { timeout: 60_000 },
    );
    const eye = page.locator(".window-tools").getByText(shot.camera, { exact: true });
    for (let i = 0; i <= (shot.again ?? 0); i++) await eye.click();
    if (shot.marks) await page.getByRole("button", { name: /^Marks: / }).click();
    await page.getByRole("img", { name: /^View / }).focus();
    for (const key of shot.keys ?? []) await page.keyboard.press(key);
    await page.waitForTimeout(1000);
    const saved = page.waitForEvent("download");
    await page.getByRole("button", { name: "Picture: save this view" }).click();
    const png = readFileSync(await (await saved).path());
    writeFileSync(join(FOLDER, `${shot.name}.jpg`), await asJpeg(page, png));
    await close();
    await served.close();
  }
  expect(errors).toEqual([]);
});
