/**
 * Pictures of the view for looking at, for the README and for the book: cameras by day, at dusk, at night and in fog, of ships,
 * tugs and berths. `npm run pictures` writes them as JPEG into the folder of the screenshots; `ONLY=fog` makes those with the
 * word in their name.
 */
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { expect, test } from "vitest";
import { SHOTS, SOFTWARE_WEBGL, browse, open, serve } from "./browser";

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

const LIVE = "live/harbour.toml";
const SHOTS_OF: Shot[] = [
  { name: "bridge-day", scenario: LIVE, camera: "Bridge", at_s: 60 },
  { name: "tug-day", scenario: LIVE, camera: "Tug", at_s: 60, keys: ["ArrowRight", "ArrowRight"] },
  { name: "free-day", scenario: LIVE, camera: "Free", at_s: 40 },
  {
    name: "wing-day-marks",
    scenario: "live/berthing.toml",
    camera: "Stb",
    at_s: 100,
    marks: true,
  },
  {
    name: "berth-free-marks",
    scenario: "live/moored_in_a_squall.toml",
    camera: "Free",
    at_s: 90,
    marks: true,
  },
  {
    name: "berth-wing-dusk",
    scenario: "live/moored_in_a_squall.toml",
    camera: "Stb",
    at_s: 60,
    palette: "dusk",
  },
  {
    name: "berth-bollard-night",
    scenario: "live/moored_in_a_squall.toml",
    camera: "Bollard",
    at_s: 30,
    palette: "night",
  },
  { name: "bridge-night", scenario: LIVE, camera: "Bridge", at_s: 60, palette: "night" },
  {
    name: "bridge-fog",
    scenario: LIVE,
    set: ['environment.visibility="500 m"'],
    camera: "Bridge",
    at_s: 60,
  },
  {
    name: "free-sunset-waves",
    scenario: LIVE,
    set: [
      'environment.start_time="2026-06-21T21:30+02:00"',
      'environment.waves={ height = "1.5 m", period = "7 s", from = "300 deg", spreading = 2, seed = 1 }',
    ],
    camera: "Free",
    at_s: 40,
  },
  { name: "ship-to-ship-wing", scenario: "live/ship_to_ship.toml", camera: "Port", at_s: 30 },
  { name: "bow-day", scenario: "live/berthing.toml", camera: "Bow", at_s: 100 },
];
/** Size of the browser's window, and largest size of a file. */
const SIZE = { width: 1600, height: 900 };
const MOST_BYTES = 150_000;

/** A picture of the view as JPEG, no larger than a page of the book may have. */
async function asJpeg(page: Page, png: Buffer): Promise<Buffer> {
  for (const quality of [0.85, 0.75, 0.65, 0.55]) {
    const text = await page.evaluate(
      async ([png, quality]) => {
        const image = new Image();
        image.src = `data:image/png;base64,${png}`;
        await image.decode();
        const area = document.createElement("canvas");
        [area.width, area.height] = [1280, Math.round((1280 * image.height) / image.width)];
        area.getContext("2d")?.drawImage(image, 0, 0, area.width, area.height);
        return area.toDataURL("image/jpeg", quality).split(",")[1] ?? "";
      },
      [png.toString("base64"), quality] as const,
    );
    const jpeg = Buffer.from(text, "base64");
    if (jpeg.length <= MOST_BYTES) return jpeg;
  }
  throw new Error("the picture is too large at every quality");
}

test("pictures for looking at", async () => {
  mkdirSync(SHOTS, { recursive: true });
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
    // A mark's words are over the picture, not in it: with marks the page itself is the picture.
    const png = shot.marks
      ? await page.locator(".window").screenshot()
      : await (async () => {
          const saved = page.waitForEvent("download");
          await page.getByRole("button", { name: "Picture: save this view" }).click();
          return readFileSync(await (await saved).path());
        })();
    writeFileSync(join(SHOTS, `picture-${shot.name}.jpg`), await asJpeg(page, png));
    await close();
    await served.close();
  }
  expect(errors).toEqual([]);
});
