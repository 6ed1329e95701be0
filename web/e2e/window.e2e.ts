/**
 * The view out of the window in a browser that draws on the processor: each camera draws something and throws nothing; drawings
 * a second and script a drawing are printed. Without WebGL, and when the graphics stop, the page says so and stays usable. Where
 * other programs run beside, as in CI, times decide nothing.
 */
import { existsSync, mkdirSync, mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { cpus, loadavg, tmpdir } from "node:os";
import { join } from "node:path";
import type { BrowserContext, Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { type Served, SHOTS, SOFTWARE_WEBGL, browse, open, serve } from "./browser";
import { axe, sizes, withAxe } from "./faults";
import { apart, signature } from "./signature";
import type { Head } from "../src/bridge/headset";
import type { Shown } from "../src/bridge/picture";
import type { Frame } from "../src/protocol";
import { tonnes } from "../src/units";

const SIZE = { width: 1280, height: 720 };
const CAMERAS = ["Bridge", "Port", "Stb", "Bow", "Stern", "Tug", "Bollard", "Free"];
const PALETTES = ["day", "dusk", "night"];
/** Cameras and palettes in CI, where the kept pictures have all cameras by day. */
const SOME_CAMERAS = ["Bridge", "Free"];
const SOME_PALETTES = ["dusk", "night"];
const MOST_SCRIPT_MS = 4;
const LEAST_FPS = 8;
/** Times decide where nothing else keeps the processors busy: the browser itself keeps about two of them. */
const timesDecide = (): boolean => !process.env.CI && (loadavg()[0] ?? 0) < cpus().length + 2;

/** Tests that draw for minutes where the processors are busy, as in CI: they run before a release. */
const outsideCi = test.skipIf(process.env.CI);

const HARBOUR = new URL("../../scenarios/live/harbour.toml", import.meta.url).pathname;
const MOORED = new URL("../../scenarios/live/moored_in_a_squall.toml", import.meta.url).pathname;
const SHIP_TO_SHIP = new URL("../../scenarios/live/ship_to_ship.toml", import.meta.url).pathname;
const errors: string[] = [];
let served: Served;

beforeAll(async () => {
  mkdirSync(SHOTS, { recursive: true });
  served = await serve([], HARBOUR);
});
afterAll(() => served.close());

const canvas = (page: Page) => page.getByRole("img", { name: /^View / });

/** Opens the view and waits for its first drawing. */
async function look(page: Page): Promise<void> {
  await page.getByRole("button", { name: "View out of the window" }).click();
  await page.waitForFunction(
    () => document.querySelector<HTMLElement>(".window canvas")?.dataset.script !== undefined,
    undefined,
    { timeout: 60_000 },
  );
}

/** Waits for some drawings, so that what is seen is what was asked for, however slow the machine is. */
async function redrawn(page: Page, times = 2): Promise<void> {
  const drawn = async () => Number(await canvas(page).getAttribute("data-drawn"));
  const before = await drawn();
  await expect.poll(drawn, { timeout: 60_000, interval: 100 }).toBeGreaterThan(before + times);
}

/** How many colours the picture of the canvas has, in steps of 16, and how far their brightness spreads. */
async function colours(page: Page): Promise<{ count: number; spread: number }> {
  const png = (await canvas(page).screenshot()).toString("base64");
  return page.evaluate(async (png) => {
    const image = new Image();
    image.src = `data:image/png;base64,${png}`;
    await image.decode();
    const area = document.createElement("canvas");
    [area.width, area.height] = [image.width, image.height];
    const to = area.getContext("2d");
    if (!to) throw new Error("a browser has a canvas");
    to.drawImage(image, 0, 0);
    const { data } = to.getImageData(0, 0, area.width, area.height);
    const seen = new Set<number>();
    let [sum, squares] = [0, 0];
    for (let i = 0; i < data.length; i += 4) {
      const [r = 0, g = 0, b = 0] = data.slice(i, i + 3);
      seen.add(((r >> 4) << 8) | ((g >> 4) << 4) | (b >> 4));
      const bright = (r + g + b) / 3;
      sum += bright;
      squares += bright * bright;
    }
    const count = data.length / 4;
    return { count: seen.size, spread: Math.sqrt(squares / count - (sum / count) ** 2) };
  }, png);
}

async function figures(page: Page): Promise<{ script: number; interval: number }> {
  const read = (name: string) => canvas(page).getAttribute(`data-${name}`);
  return { script: Number(await read("script")), interval: Number(await read("interval")) };
}

test("each camera draws a picture, by day, at dusk and at night", async () => {
  const { context, close } = await browse(SIZE, false, SOFTWARE_WEBGL);
  await withAxe(context);
  const page = await open(context, served, "pilot", errors);
  expect(
    await page.evaluate(
      () =>
        performance.getEntriesByType("resource").filter(({ name }) => name.includes("picture"))
          .length,
    ),
  ).toBe(0);
  await look(page);
  expect(await sizes(page)).toEqual([]);
  expect(await axe(page, ".window")).toEqual([]);
  // Other programs only make it slower: the best is nearest to what the view needs.
  const best = { script: Number.POSITIVE_INFINITY, interval: Number.POSITIVE_INFINITY };
  for (const palette of process.env.CI ? SOME_PALETTES : PALETTES) {
    for (
      let i = 0;
      i < 4 && (await page.locator("html").getAttribute("data-palette")) !== palette;
      i++
    )
      await page.keyboard.press("b");
    for (const camera of process.env.CI ? SOME_CAMERAS : CAMERAS) {
      await page.locator(".window-tools").getByText(camera, { exact: true }).click();
      await redrawn(page);
      const { count, spread } = await colours(page);
      const { script, interval } = await figures(page);
      best.script = Math.min(best.script, script);
      best.interval = Math.min(best.interval, interval);
      expect(count, `${camera}, ${palette}: colours`).toBeGreaterThan(palette === "night" ? 8 : 40);
      expect(spread, `${camera}, ${palette}: brightness`).toBeGreaterThan(
        palette === "night" ? 1.5 : 8,
      );
      await page.screenshot({
        path: join(SHOTS, `window-${camera.toLowerCase().replaceAll(" ", "-")}-${palette}.png`),
      });
    }
  }
  console.log(
    `${(1000 / best.interval).toFixed(1)} drawings a second on the processor, ${best.script.toFixed(2)} ms of script a drawing`,
  );
  if (timesDecide()) {
    expect(best.script).toBeLessThan(MOST_SCRIPT_MS);
    expect(1000 / best.interval).toBeGreaterThan(LEAST_FPS);
  }
  await close();
  expect(errors).toEqual([]);
});

test("one looks around by drag, wheel and keys, which steer no rudder", async () => {
  const { context, close } = await browse(SIZE, false, SOFTWARE_WEBGL);
  const page = await open(context, served, "pilot", errors);
  await page.getByRole("button", { name: "Take the helm" }).click();
  await look(page);
  const caption = page.locator(".window-caption");
  await expect.poll(() => caption.textContent()).toMatch(/\d{3}° \(ahead\)/);
  const box = (await canvas(page).boundingBox()) ?? { x: 0, y: 0, width: 0, height: 0 };
  // The picture goes with the pointer: a drag to the left looks to starboard.
  await page.mouse.move(box.x + 400, box.y + 150);
  await page.mouse.down();
  await page.mouse.move(box.x + 200, box.y + 150, { steps: 4 });
  await page.mouse.up();
  await expect.poll(() => caption.textContent()).toMatch(/\(S \d+°\)/);
  await page.keyboard.press("Home");
  await canvas(page).focus();
  await page.keyboard.press("Home");
  await expect.poll(() => caption.textContent()).toContain("(ahead)");
  await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("ArrowLeft");
  await expect.poll(() => caption.textContent()).toMatch(/\(P \d+°\)/);
  // A button of the view that was pressed leaves the keys to the view: once `2` gave a tug half power then.
  await page.locator(".window-tools").getByText("Stb", { exact: true }).click();
  await expect.poll(() => caption.textContent()).toContain("Starboard bridge wing");
  await page.keyboard.press("2");
  await expect.poll(() => caption.textContent()).toContain("Port bridge wing");
  await page.mouse.move(box.x + 300, box.y + 100);
  await page.mouse.wheel(0, -600);
  await expect
    .poll(async () => Number(/view (\d+)/.exec((await caption.textContent()) ?? "")?.[1]))
    .toBeLessThan(30);
  const rudder = await page.evaluate(
    () => document.querySelector(".helm [data-order]")?.getAttribute("data-order") ?? "0",
  );
  expect(Number(rudder)).toBe(0);
  await page.getByRole("button", { name: /^Both: plan below/ }).click();
  await page.getByRole("img", { name: "Plan of ship" }).waitFor();
  await canvas(page).waitFor();
  await page.getByRole("button", { name: /^Plan: close the view/ }).click();
  expect(await canvas(page).isVisible()).toBe(false);
  await close();
  expect(errors).toEqual([]);
});

test("when the graphics stop the page says so, and draws again when they are back", async () => {
  const { context, close } = await browse(SIZE, false, SOFTWARE_WEBGL);
  const page = await open(context, served, "pilot", errors);
  await look(page);
  await page.evaluate(() => {
    const gl = document.querySelector<HTMLCanvasElement>(".window canvas")?.getContext("webgl2");
    const stop = gl?.getExtension("WEBGL_lose_context");
    stop?.loseContext();
    setTimeout(() => stop?.restoreContext(), 2500);
  });
  await page.getByText("The graphics of this machine stopped").waitFor();
  await page.getByRole("tab", { name: "Conning" }).click();
  await page.getByText("The graphics of this machine stopped").waitFor({ state: "hidden" });
  await page.waitForTimeout(2500);
  expect((await colours(page)).count).toBeGreaterThan(40);
  await close();
  expect(errors.filter((text) => !/context lost/i.test(text))).toEqual([]);
});

test("without WebGL the page says so, and the plan is back at a press", async () => {
  const { context, close } = await browse(SIZE, false, ["--disable-3d-apis"]);
  const unheard: string[] = [];
  const page = await open(context, served, "observer", unheard);
  await page.getByRole("button", { name: "View out of the window" }).click();
  await page.getByText("This browser draws no view").waitFor();
  await page.getByRole("button", { name: /^Plan: close the view/ }).click();
  await page.getByRole("img", { name: "Plan of ship" }).waitFor();
  // The report says why it has no picture.
  const moored = await serve([], MOORED);
  const instructor = await open(context, moored, "instructor", unheard);
  await instructor.getByRole("button", { name: "Pace 8" }).click();
  await expect
    .poll(() => instructor.getByRole("timer").first().textContent())
    .toMatch(/0:00:[1-9]\d/);
  const tab = context.waitForEvent("page");
  await instructor.getByRole("button", { name: /^Report of the session/ }).click();
  const report = await tab;
  await report
    .getByText("There is no picture of the largest fender load: this browser has no WebGL")
    .waitFor({ timeout: 60_000 });
  await close();
  await moored.close();
});

test("an address opens one of several windows that make a panorama", async () => {
  const { context, close } = await browse(SIZE, false, SOFTWARE_WEBGL);
  const page = await context.newPage();
  page.on("pageerror", (error) => errors.push(error.message));
  const token = encodeURIComponent(served.tokens.pilot ?? "");
  await page.goto(`${served.url}/?token=${token}&view=bridge&bearing=-60&fov=60`);
  await page.waitForFunction(
    () => document.querySelector<HTMLElement>(".window canvas")?.dataset.script !== undefined,
    undefined,
    { timeout: 60_000 },
  );
  const box = await canvas(page).boundingBox();
  expect([box?.width, box?.height]).toEqual([SIZE.width, SIZE.height]);
  // 60° to port of her heading, which was 20° at the start.
  const label = (await canvas(page).getAttribute("aria-label")) ?? "";
  const bearing = Number(/towards (\d+)/.exec(label)?.[1]);
  expect(Math.abs(bearing - 320)).toBeLessThan(30);
  await close();
  expect(errors.filter((text) => !/context lost/i.test(text))).toEqual([]);
});

test("marks are in the picture on request: figures, path, forces and loads", async () => {
  const { context, close } = await browse(SIZE, false, SOFTWARE_WEBGL);
  const page = await open(context, served, "pilot", errors);
  await look(page);
  const figures = page.locator(".window-figures");
  expect(await figures.isVisible()).toBe(false);
  // This browser has no headset.
  expect(await page.getByRole("button", { name: /^Headset: / }).isVisible()).toBe(false);
  await page.getByRole("button", { name: /^Marks: / }).click();
  // She is on her way to the berth: its bearing and distance are in the picture. Her motion is in the row above.
  await expect
    .poll(() => figures.textContent())
    .toMatch(/^Berth bears \d{3}°, .* off, .* m\/s closing$/);
  await expect.poll(() => page.locator(".window .motion").textContent()).toMatch(/SOG\d/);
  await page.screenshot({ path: join(SHOTS, "window-marks.png") });
  // The saved picture has the figures too: at their edge it has the colour of their ground.
  const saved = page.waitForEvent("download");
  await page.getByRole("button", { name: "Picture: save this view" }).click();
  const png = readFileSync(await (await saved).path()).toString("base64");
  const [ground, found] = await page.evaluate(async (png) => {
    const image = new Image();
    image.src = `data:image/png;base64,${png}`;
    await image.decode();
    const words = document.querySelector(".window-figures");
    const over = document.querySelector(".window canvas")?.getBoundingClientRect();
    const area = new OffscreenCanvas(image.width, image.height).getContext("2d");
    if (!words || !over || !area) throw new Error("there are figures over a canvas");
    area.drawImage(image, 0, 0);
    const { left, top, height } = words.getBoundingClientRect();
    const scale = image.width / over.width;
    const [x, y] = [(left + 4 - over.left) * scale, (top + height / 2 - over.top) * scale];
    const numbers = getComputedStyle(words).backgroundColor.match(/[\d.]+/g) ?? [];
    return [numbers.slice(0, 3).map(Number), Array.from(area.getImageData(x, y, 1, 1).data)];
  }, png);
  for (const i of [0, 1, 2])
    expect(
      Math.abs((found?.[i] ?? 999) - (ground?.[i] ?? 0)),
      `${found} on ${ground}`,
    ).toBeLessThan(20);
  // The eye goes up by its key, and says so.
  await canvas(page).focus();
  await page.keyboard.press("PageUp");
  await expect
    .poll(() => page.locator(".window-caption").textContent())
    .toContain("eye 1.9 m above the deck");
  await page.keyboard.press("m");
  await expect.poll(() => figures.isVisible()).toBe(false);
  await close();
  expect(errors).toEqual([]);
});

/** How many pixels of the canvas a lamp's red has, and how many the blue of a mark on a line. */
async function lit(page: Page): Promise<{ red: number; blue: number }> {
  const png = (await canvas(page).screenshot()).toString("base64");
  return page.evaluate(async (png) => {
    const image = new Image();
    image.src = `data:image/png;base64,${png}`;
    await image.decode();
    const area = document.createElement("canvas");
    [area.width, area.height] = [image.width, image.height];
    const to = area.getContext("2d");
    if (!to) throw new Error("a browser has a canvas");
    to.drawImage(image, 0, 0);
    const { data } = to.getImageData(0, 0, area.width, area.height);
    let [red, blue] = [0, 0];
    for (let i = 0; i < data.length; i += 4) {
      const [r = 0, g = 0, b = 0] = data.slice(i, i + 3);
      // Red, or red beside the white of a masthead light; not the amber of words.
      if (r > 110 && g < 0.8 * r && b > 0.8 * g) red += 1;
      if (b > 130 && b > g + 15 && g > r + 15) blue += 1;
    }
    return { red, blue };
  }, png);
}

outsideCi("a ship hides lights and marks behind her", async () => {
  const file = join(mkdtempSync(join(tmpdir(), "fenderline-behind-")), "behind.toml");
  // A container ship lies across the way; behind her a tug looks this way and has a line to her.
  const ships = [
    'vessel = "bulk-carrier"\nposition = [0, 0]',
    'vessel = "container-ship"\nposition = [1000, 40]\nheading = "90 deg"',
    'vessel = "asd-tug"\nposition = [1150, 150]\nheading = "200 deg"',
  ];
  writeFileSync(
    file,
    `[time]\nstep = "0.1 s"\nduration = "1 h"\n${ships.map((ship, i) => `[body.ship_${i}]\n${ship}\n`).join("")}
[line.towline]\nfrom = "ship_1"\nfairlead = [-60, -20]\nfairlead_height = "6 m"\nto = "ship_2"\nbollard = [12, 0]
bollard_height = "4 m"\nrope = "hmpe"\nbreak_load = "1200 kN"\npretension = "60 kN"\n`,
  );
  const of = await serve([], file);
  const { context, close } = await browse(SIZE, false, SOFTWARE_WEBGL);
  const page = await open(context, of, "instructor", errors);
  await page.getByRole("button", { name: "Pause (K)" }).click();
  await look(page);
  await page.getByRole("button", { name: /^Marks: / }).click();
  for (
    let i = 0;
    i < 4 && (await page.locator("html").getAttribute("data-palette")) !== "night";
    i++
  )
    await page.keyboard.press("b");
  await redrawn(page);
  await page.screenshot({ path: join(SHOTS, "window-behind.png") });
  expect(await lit(page)).toEqual({ red: 0, blue: 0 });
  expect(await page.locator(".window-labels span:visible").count()).toBe(0);
  // From far off on the other side both are seen: the test finds what it looks for.
  await page.locator(".window-tools").getByText("Free", { exact: true }).click();
  await canvas(page).focus();
  for (let i = 0; i < 9; i++) await page.keyboard.press("-");
  for (let i = 0; i < 14; i++) await page.keyboard.press("ArrowLeft");
  await redrawn(page);
  await page.screenshot({ path: join(SHOTS, "window-behind-seen.png") });
  const seen = await lit(page);
  expect(seen.red).toBeGreaterThan(0);
  expect(seen.blue).toBeGreaterThan(0);
  await close();
  await of.close();
  expect(errors).toEqual([]);
});

/** Goes to 20 s of the run, and gives what the view shows then. */
async function shownAt20s(page: Page): Promise<Shown> {
  await page.getByRole("button", { name: "Rewind to the start" }).click();
  const time = () => page.getByRole("timer").first().textContent();
  for (const till of ["0:00:10", "0:00:20"]) {
    await page.getByRole("button", { name: "On ten seconds" }).click();
    await expect.poll(time).toContain(till);
  }
  const shown = async () =>
    JSON.parse((await canvas(page).getAttribute("data-shown")) ?? "{}") as Partial<Shown>;
  await expect.poll(async () => (await shown()).tick, { timeout: 60_000 }).toBe(200);
  return (await shown()) as Shown;
}

/** What the view shows is what the frame of its tick says: her place, her heading, each fender, the loads of lines. */
function agrees(shown: Shown, frame: Frame | undefined): void {
  const ship = frame?.bodies[0];
  if (!frame || !ship) throw new Error("there is no frame of the ship");
  expect(shown.tick).toBe(frame.tick);
  expect(Math.abs((shown.north_m ?? 0) - ship[0])).toBeLessThan(0.01);
  expect(Math.abs((shown.east_m ?? 0) - ship[1])).toBeLessThan(0.01);
  expect(Math.abs((shown.heading_rad ?? 0) - ship[2])).toBeLessThan(1e-4);
  expect(shown.pressed_m.length).toBe(frame.fenders.length);
  expect(Math.max(...frame.fenders.map(({ deflection_m }) => deflection_m))).toBeGreaterThan(0.001);
  frame.fenders.forEach(({ deflection_m }, i) =>
    expect(Math.abs((shown.pressed_m[i] ?? -1) - deflection_m)).toBeLessThan(0.001),
  );
  const fast = frame.lines.filter(({ state, tension_n }) => state === "fast" && tension_n > 1000);
  expect(fast.length).toBeGreaterThan(3);
  for (const { tension_n } of fast) expect(shown.labels).toContain(tonnes(tension_n));
}

/** Meta's emulator of headsets in place of the browser's WebXR. */
async function withHeadset(context: BrowserContext): Promise<void> {
  await context.addInitScript({
    path: new URL("../node_modules/iwer/build/iwer.min.js", import.meta.url).pathname,
  });
  await context.addInitScript(() => {
    const { IWER } = window as unknown as { IWER: typeof import("iwer") };
    const device = new IWER.XRDevice(IWER.metaQuest3);
    device.installRuntime({ forceInstall: true });
    Object.assign(window, { device });
  });
}

/** In a headset: the head begins at the eye's place, a metre is a metre, and turning the head turns the view. */
async function wear(page: Page): Promise<void> {
  const head = async () =>
    JSON.parse((await canvas(page).getAttribute("data-head")) ?? "null") as Head | null;
  const shown = async () =>
    JSON.parse((await canvas(page).getAttribute("data-shown")) ?? "{}") as Shown;
  const off = (a: readonly number[], b: readonly number[]) =>
    Math.hypot(...a.map((v, i) => v - (b[i] ?? 0)));
  await page.locator(".window-tools").getByText("Bridge", { exact: true }).click();
  await redrawn(page);
  const { eye } = await shown();
  const button = page.getByRole("button", { name: /^Headset: / });
  await button.click();
  await expect.poll(() => button.getAttribute("aria-pressed")).toBe("true");
  await expect.poll(async () => off((await head())?.at ?? [0, 0, 0], eye)).toBeLessThan(0.01);
  const before = await head();
  if (!before) throw new Error("the headset has drawn");
  await page.evaluate(() => {
    const { device } = window as unknown as { device: import("iwer").XRDevice };
    device.position.x += 0.5;
    // A quarter turn to port.
    device.quaternion.set(0, Math.SQRT1_2, 0, Math.SQRT1_2);
  });
  await expect
    .poll(async () => off((await head())?.at ?? [0, 0, 0], before.at))
    .toBeCloseTo(0.5, 2);
  const after = await head();
  // To port of north is west, along −x.
  const [x, , z] = before.ahead;
  expect(off(after?.ahead ?? [], [z, 0, -x])).toBeLessThan(0.05);
  // The emulator lays the picture over the page, and leaves the picture there.
  const press = () => button.evaluate((each) => (each as HTMLElement).click());
  await press();
  await expect.poll(() => button.getAttribute("aria-pressed")).toBe("false");
  await redrawn(page);
  expect(off((await shown()).eye, eye)).toBeLessThan(0.01);
  // A headset that does not start is said in words.
  await page.evaluate(() => {
    const { xr } = navigator as unknown as { xr: { requestSession: unknown } };
    xr.requestSession = () => Promise.reject(new DOMException("", "NotSupportedError"));
  });
  await press();
  await page.getByText("The headset did not start: the browser found no headset").waitFor();
}

test("the view follows the timeline, films, and finds the largest fender load", async () => {
  const moored = await serve([], MOORED);
  const { context, close } = await browse(SIZE, false, SOFTWARE_WEBGL);
  await withHeadset(context);
  const frames = new Map<number, Frame>();
  context.on("page", (page) =>
    page.on("websocket", (socket) =>
      socket.on("framereceived", ({ payload }) => {
        const message = JSON.parse(String(payload)) as { type: string };
        if (message.type === "frame") frames.set((message as Frame).tick, message as Frame);
      }),
    ),
  );
  const page = await open(context, moored, "instructor", errors);
  await look(page);
  await page.locator(".window-tools").getByText("Free", { exact: true }).click();
  await page.getByRole("button", { name: "Film: record this view" }).click();
  await page.getByRole("button", { name: "Pace 8" }).click();
  await page.waitForTimeout(2500);
  const filmed = page.waitForEvent("download");
  await page.getByRole("button", { name: "Film: record this view" }).click();
  const film = await filmed;
  expect(film.suggestedFilename()).toMatch(/free-film-\d+s\.webm$/);
  expect(readFileSync(await film.path()).length).toBeGreaterThan(5000);
  // A branch that begins ten seconds before the end has its 20 s too, however fast the film was saved.
  const time = () => page.getByRole("timer").first().textContent();
  await expect.poll(time, { timeout: 60_000 }).toMatch(/0:00:[45]\d|0:0[1-9]:/);
  // The same moment looks the same again, from the free eye too.
  await page.getByRole("button", { name: "Rewind to the start" }).click();
  await expect.poll(time).toContain("0:00:00");
  await redrawn(page);
  const first = await signature(page, canvas(page));
  // A view in which nothing moves is not drawn for nothing.
  const drawn = async () => Number(await canvas(page).getAttribute("data-drawn"));
  await page.waitForTimeout(1500);
  const resting = await drawn();
  await page.waitForTimeout(3000);
  expect((await drawn()) - resting).toBeLessThan(6);
  await page.getByRole("button", { name: "To the end of the branch" }).click();
  await expect.poll(time).not.toContain("0:00:00");
  await page.getByRole("button", { name: "Rewind to the start" }).click();
  await expect.poll(time).toContain("0:00:00");
  await redrawn(page);
  expect(apart(first, await signature(page, canvas(page))).mean).toBeLessThan(TOLERANCE.mean);
  await page.getByRole("button", { name: "To the end of the branch" }).click();
  // A branch goes on from there, and the view with it. Its lane makes the view lower: its pictures are not compared.
  await page.getByRole("button", { name: "Back ten seconds" }).click();
  await page.getByRole("button", { name: "Go on from here as a new branch" }).click();
  await redrawn(page);
  expect((await colours(page)).count).toBeGreaterThan(40);
  await page.getByRole("tab", { name: "Verdict" }).click();
  const saved = page.waitForEvent("download");
  await page.getByRole("button", { name: "Picture of the largest fender load" }).click();
  const picture = await saved;
  expect(picture.suggestedFilename()).toMatch(/-cone.*s\.png$/);
  await picture.saveAs(join(SHOTS, "window-largest-load.png"));
  // The report has the picture, and so has the file that is saved from it.
  const tab = context.waitForEvent("page");
  await page.getByRole("button", { name: /^Report of the session/ }).click();
  const report = await tab;
  const figure = report.locator("figure.view-picture");
  await figure.locator("img").waitFor({ timeout: 60_000 });
  expect(await figure.textContent()).toMatch(
    /s: fender cone.*; reaction \d+ kN, \d+ % of the rated; energy .*; deflection 0\.\d\d m/,
  );
  const [wide] = await figure
    .locator("img")
    .evaluate((image: HTMLImageElement) => [image.naturalWidth]);
  expect(wide).toBe(1120);
  await figure.scrollIntoViewIfNeeded();
  await report.screenshot({ path: join(SHOTS, "window-report.png") });
  const kept = report.waitForEvent("download");
  await report.getByRole("link", { name: "Save this report with the picture" }).click();
  const html = readFileSync(await (await kept).path(), "utf8");
  expect(html).toContain("<h2>Fenders</h2><figure");
  expect(html).toContain('src="data:image/jpeg;base64,');
  expect(html.length).toBeLessThan(1_000_000);
  await report.close();
  // A recorded session shows what it recorded.
  await page.getByRole("button", { name: /^Marks: / }).click();
  const before = await shownAt20s(page);
  const recorded = frames.get(200);
  agrees(before, recorded);
  await page.getByRole("tab", { name: "Session" }).click();
  await page.getByLabel("Name to save under").fill("squall");
  await page.getByRole("button", { name: "Save session" }).click();
  frames.clear();
  const row = page.locator(".gallery li", { hasText: "Saved as squall." });
  await row.getByRole("button", { name: /^Open / }).click();
  await page.getByRole("button", { name: "End this run" }).click();
  // It opens at its end.
  await expect.poll(() => [...frames.keys()].some((tick) => tick > 200)).toBe(true);
  const again = await shownAt20s(page);
  agrees(again, recorded);
  expect({ ...again, labels: again.labels.toSorted() }).toEqual({
    ...before,
    labels: before.labels.toSorted(),
  });
  if (!process.env.CI) await wear(page);
  await close();
  await moored.close();
  expect(errors).toEqual([]);
});

outsideCi("a narrow page and a slow machine keep view, panel and controls usable", async () => {
  const { context, close } = await browse({ width: 400, height: 800 }, true, SOFTWARE_WEBGL);
  await withAxe(context);
  const page = await open(context, served, "pilot", errors);
  const devtools = await context.newCDPSession(page);
  await devtools.send("Emulation.setCPUThrottlingRate", { rate: 6 });
  await look(page);
  const wide = await page.evaluate(() => document.documentElement.scrollWidth);
  expect(wide).toBeLessThanOrEqual(400);
  const box = await canvas(page).boundingBox();
  expect(box?.width ?? 0).toBeGreaterThan(390);
  expect(await axe(page, ".window")).toEqual([]);
  await expect
    .poll(() => page.locator(".window-caption").textContent(), { timeout: 20_000 })
    .toContain("coarse");
  const begun = Date.now();
  await page.getByRole("tab", { name: "Fenders" }).click();
  await page.getByText(/fenders, none touched yet/).waitFor();
  if (timesDecide()) expect(Date.now() - begun).toBeLessThan(8000);
  await page.screenshot({ path: join(SHOTS, "window-narrow.png") });
  await close();
  expect(errors).toEqual([]);
});

outsideCi(
  "ten ships, without a berth or a chart, are drawn from every camera that there is",
  async () => {
    const folder = mkdtempSync(join(tmpdir(), "fenderline-ten-"));
    const file = join(folder, "ten.toml");
    const kinds = ["container-ship", "bulk-carrier", "asd-tug"];
    const ships = Array.from({ length: 10 }, (_, i) => {
      const [north, east] = [700 * Math.floor(i / 2), 260 * (i % 2)];
      return `[body.ship_${i}]\nvessel = "${kinds[i % 3] ?? ""}"\nposition = [${north}, ${east}]\nheading = "${36 * i} deg"\n`;
    });
    writeFileSync(
      file,
      `[time]\nstep = "0.1 s"\nduration = "1 h"\n[environment]\ntide = { level = "2 m" }\n${ships.join("")}`,
    );
    const ten = await serve([], file);
    const { context, close } = await browse(SIZE, false, SOFTWARE_WEBGL);
    const page = await open(context, ten, "pilot", errors);
    await look(page);
    // No bollard: its camera is not offered.
    expect(await page.getByRole("button", { name: /^Bollard: / }).isVisible()).toBe(false);
    await page.getByRole("button", { name: /^Marks: / }).click();
    for (const camera of ["Stb", "Free"]) {
      await page.locator(".window-tools").getByText(camera, { exact: true }).click();
      await redrawn(page);
      expect((await colours(page)).count, camera).toBeGreaterThan(20);
    }
    await page.screenshot({ path: join(SHOTS, "window-ten-ships.png") });
    await close();
    await ten.close();
    expect(errors).toEqual([]);
  },
);

/** References of the pictures: `BLESS=1` writes them anew. */
const KEPT = new URL("window_pictures.json", import.meta.url).pathname;
/**
 * How far a picture may be from its reference, of 255: on the mean, and in one field of the grid. On one machine pictures differ by
 * 0.6 and 5, because a slow machine draws fewer points.
 */
const TOLERANCE = { mean: 1.5, most: 15 };

/** In CI the first scenario has all cameras, and the others have one on board and one off the ship. */
const camerasOf = (file: string): string[] =>
  process.env.CI && file !== HARBOUR ? SOME_CAMERAS : CAMERAS;

test("pictures of three scenarios from each camera are as the kept ones", async () => {
  const bless = process.env.BLESS === "1";
  const kept: Record<string, string> =
    existsSync(KEPT) && !bless ? JSON.parse(readFileSync(KEPT, "utf8")) : {};
  const found: Record<string, string> = {};
  const worst = { mean: 0, most: 0 };
  for (const file of [HARBOUR, MOORED, SHIP_TO_SHIP]) {
    const of = await serve([], file);
    const { context, close } = await browse(SIZE, false, SOFTWARE_WEBGL, true);
    const instructor = await open(context, of, "instructor", errors);
    await instructor.getByRole("button", { name: "Rewind to the start" }).click();
    await expect
      .poll(() => instructor.getByRole("timer").first().textContent())
      .toContain("0:00:00");
    const page = await context.newPage();
    page.setDefaultTimeout(60_000);
    // It stays paused; two pages would draw for one.
    await instructor.close();
    page.on("pageerror", (error) => errors.push(error.message));
    const token = encodeURIComponent(of.tokens.observer ?? "");
    // The whole window is the view.
    await page.goto(`${of.url}/?token=${token}&view=bridge&bearing=0&fov=70`);
    await page.waitForFunction(
      () => document.querySelector<HTMLElement>(".window canvas")?.dataset.script !== undefined,
      undefined,
      { timeout: 60_000 },
    );
    await canvas(page).focus();
    for (const camera of camerasOf(file)) {
      await page.keyboard.press(String(CAMERAS.indexOf(camera) + 1));
      await redrawn(page);
      const name = `${file.split("/").at(-1)?.replace(".toml", "") ?? ""} ${camera}`;
      found[name] = await signature(page, canvas(page));
      const off = apart(kept[name] ?? "", found[name]);
      worst.mean = Math.max(worst.mean, off.mean);
      worst.most = Math.max(worst.most, off.most);
      if (!bless && (off.mean > TOLERANCE.mean || off.most > TOLERANCE.most))
        await page.screenshot({ path: join(SHOTS, `window-differs-${name}.png`) });
      if (!bless)
        expect(off, `${name}: mean and largest difference; BLESS=1 writes references`).toSatisfy(
          ({ mean, most }: typeof off) => mean <= TOLERANCE.mean && most <= TOLERANCE.most,
        );
    }
    await close();
    await of.close();
  }
  console.log(
    `largest differences from the kept pictures: ${worst.mean.toFixed(2)} on the mean, ${worst.most} in a field`,
  );
  if (bless) writeFileSync(KEPT, `${JSON.stringify(found, null, 2)}\n`);
  expect(errors.filter((text) => !/context lost/i.test(text))).toEqual([]);
});
