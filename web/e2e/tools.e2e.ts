/** Measuring tools of the plan by mouse and by touch, and sounds with their mute state. */
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { type Browser, type Served, SHOTS, browse, drawn, open, serve } from "./browser";
import { labels } from "./faults";

const PATIENT = { timeout: 30_000 };
/** The pilot's ship in the scenario. */
const SHIP = "ship";

/** A docking log of a made-up berth and its mapping, without their endings. */
const MEASURED = new URL("../../examples/measured/laser", import.meta.url).pathname;

const errors: string[] = [];
let served: Served;
let browser: Browser;
let page: Page;

beforeAll(async () => {
  served = await serve([], undefined, [
    "--ghost",
    `${MEASURED}.csv`,
    "--ghost-mapping",
    `${MEASURED}.toml`,
    "--ghost-touch",
    "3600",
  ]);
  browser = await browse({ width: 1366, height: 768 }, true);
  page = await open(browser.context, served, "pilot", errors);
});
afterAll(async () => {
  await browser.close();
  await served.close();
});

/** The plan's canvas: its corner on the page, and pixels in a metre. */
async function plan(): Promise<{ x: number; y: number; scale: number }> {
  await drawn(page);
  const canvas = page.getByRole("img", { name: "Plan of ship" });
  const [box, view] = [await canvas.boundingBox(), await canvas.getAttribute("data-view")];
  return { x: box?.x ?? NaN, y: box?.y ?? NaN, scale: Number(view?.split(" ")[2]) };
}

const texts = async () => (await labels(page)).texts;

test("the plan shows the measured ship beside the simulated one, with the time to her touch", async () => {
  const shown = async () => (await texts()).find((text) => text.startsWith("measured "));
  await expect.poll(shown, PATIENT).toMatch(/^measured Made Up Star: begins in 0:5\d:\d\d$/);
});

test("two clicks, or two touches, measure bearing and distance; each tool is turned on and off", async () => {
  await page.getByRole("button", { name: "Measure: tools (I)" }).click();
  const tool = (name: string) => page.getByRole("button", { name: new RegExp(`^${name}: `) });
  await tool("2 points").click();
  const { x, y, scale } = await plan();
  for (const touches of [false, true]) {
    const press = (px: number, py: number) =>
      touches ? page.touchscreen.tap(x + px, y + py) : page.mouse.click(x + px, y + py);
    await press(300, 250);
    await press(500, 250);
    await drawn(page);
    // The plan follows the ship meanwhile: a few metres. The text begins with a bearing of three digits.
    const measured = (await texts()).find((text) => /^\d{3}\.\d° /.test(text)) ?? "";
    const m = Number(/° ([\d.]+) m/.exec(measured)?.[1]);
    expect(Math.abs(m - 200 / scale), measured).toBeLessThan(5);
  }
  await tool("Rings").click();
  await tool("Cursor").click();
  await tool("EBL").click();
  await page.mouse.move(x + 420, y + 200);
  await drawn(page);
  expect((await texts()).some((text) => /^\d+ m|NM$|cables\)$/.test(text))).toBe(true);
  expect((await texts()).some((text) => text.endsWith("relative"))).toBe(true);
  const cursor = page.getByRole("status", { name: "Cursor" });
  await cursor.getByText(/^N -?\d+ m, E -?\d+ m; from the ship \d{3}\.\d° /).waitFor();
  // The bearing line turns by its buttons.
  const line = async () =>
    Number.parseFloat((await texts()).find((t) => t.endsWith("relative")) ?? "");
  const before = await line();
  for (let i = 0; i < 3; i++) await page.getByRole("button", { name: "Bearing line +1°" }).click();
  await drawn(page);
  expect((await line()) - before).toBeCloseTo(3, 0);
  expect((await labels(page)).faults).toEqual([]);
  await page.screenshot({ path: join(SHOTS, "measuring.png") });
  for (const name of ["2 points", "Rings", "Cursor", "EBL"]) await tool(name).click();
  await drawn(page);
  expect((await texts()).some((text) => /relative$|^\d{3}\.\d° /.test(text))).toBe(false);
  await cursor.waitFor({ state: "hidden" });
  await page.getByRole("button", { name: "Measure: tools (I)" }).click();
  expect(errors).toEqual([]);
});

/** Messages that a program of the test has got, and the way to send it some. */
interface Program extends Window {
  socket: WebSocket;
  heard: { type: string; id?: number; text?: string; reason?: string }[];
}

test("a person takes the helm back from a program by one press, and the program is told", async () => {
  // A small client of the protocol, which says by its address that it is a program.
  const program = await browser.context.newPage();
  await program.goto(`${served.url}/?token=${encodeURIComponent(served.tokens.observer ?? "")}`);
  await program.evaluate((token) => {
    const own = window as unknown as Program;
    own.heard = [];
    own.socket = new WebSocket(
      `${location.origin.replace("http", "ws")}/live?token=${encodeURIComponent(token)}&program=1`,
    );
    own.socket.addEventListener("message", ({ data }) => {
      const message = JSON.parse(String(data)) as Program["heard"][number];
      if (["ack", "refused", "notice"].includes(message.type)) own.heard.push(message);
    });
    return new Promise((opened) => own.socket.addEventListener("open", () => opened(null)));
  }, served.tokens.pilot ?? "");
  const command = (id: number, action: object) =>
    program.evaluate(
      ([id, action]) =>
        (window as unknown as Program).socket.send(JSON.stringify({ type: "command", id, action })),
      [id, action] as const,
    );
  const heard = () => program.evaluate(() => (window as unknown as Program).heard);
  const answer = async (id: number) => (await heard()).find((of) => of.id === id)?.type;
  await command(1, { do: "name", name: "autopilot" });
  await command(2, { do: "rudder", vessel: SHIP, angle_rad: 0.1 });
  await expect.poll(() => answer(2), PATIENT).toBe("ack");
  const helm = page.getByRole("group", { name: /^Helm of / });
  const holder = helm.getByText("autopilot (pilot, program) has the helm");
  await holder.waitFor(PATIENT);
  // One press: the person has the helm, and the program is told and obeyed no more.
  await page.bringToFront();
  await page.getByRole("button", { name: "Take the helm" }).click();
  await page
    .getByRole("button", { name: /^Release/ })
    .first()
    .waitFor(PATIENT);
  await holder.waitFor({ state: "hidden", ...PATIENT });
  const told = async () =>
    (await heard()).some((of) => /has taken the control from you/.test(JSON.stringify(of)));
  await expect.poll(told, PATIENT).toBe(true);
  await command(3, { do: "rudder", vessel: SHIP, angle_rad: -0.3 });
  await expect.poll(() => answer(3), PATIENT).toBe("refused");
  await page.getByRole("button", { name: "Mid: rudder amidships (M)" }).click();
  await program.close();
  await page
    .getByRole("button", { name: /^Release/ })
    .first()
    .click();
  expect(errors).toEqual([]);
}, 120_000);

test("sound waits for the first touch, answers engine orders, repeats alarms, and says when it is muted", async () => {
  await page.reload();
  const state = page.locator(".sound-state");
  const count = async (kind: string) => Number((await state.getAttribute(`data-${kind}`)) ?? 0);
  await state.getByText("waits").waitFor();
  await page.getByRole("button", { name: "Take the helm" }).click();
  await state.getByText("on", { exact: false }).waitFor();
  await page.getByRole("button", { name: "Slow ahead", exact: true }).click();
  await expect.poll(() => count("engine")).toBe(1);
  // An alarm, until it is acknowledged.
  const instructor = await open(browser.context, served, "instructor", errors);
  await instructor.getByRole("tab", { name: "Weather, faults" }).click();
  await instructor.getByRole("button", { name: "Rudder stuck" }).first().click();
  await expect.poll(() => count("alarms"), { timeout: 10_000 }).toBeGreaterThan(1);
  await page.bringToFront();
  await page.getByRole("tab", { name: "Alarms" }).click();
  await page.getByRole("button", { name: /^Acknowledge .*rudder stuck/ }).click();
  await page.waitForTimeout(500);
  const rung = await count("alarms");
  await page.waitForTimeout(2500);
  expect(await count("alarms")).toBe(rung);
  // Muted, one kind and all; kept over a reload.
  await page.getByRole("button", { name: "Engine sound on" }).click();
  await state.getByText("alarms only").waitFor();
  await page.getByRole("button", { name: "Half ahead", exact: true }).click();
  await page.waitForTimeout(500);
  expect(await count("engine")).toBe(1);
  await state.click();
  await state.getByText("muted").waitFor();
  await page.reload();
  await state.getByText("muted").waitFor();
  expect(errors).toEqual([]);
});
