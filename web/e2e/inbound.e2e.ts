/**
 * A pilot's passage with one page alone: from the sea buoy along the passage plan through the bend, to a stop off the berth, and
 * with two tugs to the quay, until she is all fast. The pilot reads what the page shows and presses its buttons.
 */
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { type Browser, type Served, SHOTS, browse, open, serve } from "./browser";

const SCENARIO = new URL("../../scenarios/harbours/inbound.toml", import.meta.url).pathname;
const PACE = "8";
const LONGEST_S = 420;
/** Cross-track distance, from the track to the edge of the corridor. */
const CORRIDOR_M = 40;

const errors: string[] = [];
let served: Served;
let browser: Browser;
let instructor: Page;
let pilot: Page;

beforeAll(async () => {
  served = await serve([], SCENARIO);
  browser = await browse({ width: 1280, height: 800 });
  instructor = await open(browser.context, served, "instructor", errors);
  pilot = await open(browser.context, served, "pilot", errors);
});
afterAll(async () => {
  await browser.close();
  await served.close();
});

/** What the pilot reads: the values over the plan, the ordered course and speed, and the docking board. */
const read = (page: Page) =>
  page.evaluate(() => {
    const text = (selector: string) => document.querySelector(selector)?.textContent ?? "";
    const values: Record<string, string> = {};
    for (const cell of document.querySelectorAll(".readout > div, .on-plan > div"))
      values[cell.querySelector("dt")?.textContent ?? ""] =
        cell.querySelector("dd")?.textContent ?? "";
    const end = (name: string) => {
      const root = document.querySelector<HTMLElement>(`.end[aria-label="${name}"]`);
      return { off: Number(root?.dataset.off), closing: Number(root?.dataset.closing) };
    };
    return {
      values,
      time: text(".time"),
      course: Number.parseFloat(text('[aria-label="Course to keep"]')),
      speed: Number.parseFloat(text('[aria-label="Speed to keep"]')),
      along:
        Number.parseFloat(text('[aria-label="Speed along the berth"]')) *
        (document.querySelector(".under section:nth-child(2) .way")?.textContent === "astern"
          ? -1
          : 1),
      bow: end("Bow"),
      stern: end("Stern"),
      toGo: Number(document.querySelector<HTMLElement>(".mark")?.dataset.toGo ?? 0),
    };
  });

/** Metres of a distance in metres or miles; `null` for none. */
const metres = (text = "–"): number | null =>
  text === "–" ? null : Number.parseFloat(text) * (text.includes("NM") ? 1852 : 1);

const press = (name: string) => pilot.getByRole("button", { name, exact: true }).click();

const DEG = Math.PI / 180;
/** The turn from one direction to another [deg], positive to starboard. */
const turn = (from: number, to: number): number => ((to - from + 540) % 360) - 180;

/** Sets the course to keep, by its buttons. */
async function steer(wanted: number): Promise<void> {
  let { course } = await read(pilot);
  for (;;) {
    const rest = ((wanted - course + 540) % 360) - 180;
    const by = Math.abs(rest) >= 5 ? 5 : 1;
    if (Math.abs(rest) < 0.5) return;
    await press(`Course ${by} to ${rest > 0 ? "starboard" : "port"}`);
    course += Math.sign(rest) * by;
  }
}

/** Sets the speed to keep, by its buttons. */
async function go(wanted_kn: number): Promise<void> {
  let { speed } = await read(pilot);
  while (Math.abs(wanted_kn - speed) > 0.3) {
    const faster = wanted_kn > speed;
    await press(faster ? "Faster by half a knot, +½" : "Slower by half a knot, −½");
    speed += faster ? 0.5 : -0.5;
  }
}

test("she goes from the sea buoy through the bend to a stop off the berth, inside her corridor", async () => {
  await instructor.bringToFront();
  await instructor.getByRole("button", { name: `Pace ${PACE}`, exact: true }).click();
  await pilot.bringToFront();
  await pilot.waitForTimeout(500);
  await pilot.screenshot({ path: join(SHOTS, "inbound-first-view.png") });
  await press("Take the helm");
  await pilot.getByRole("button", { name: "Release the helm" }).waitFor();
  await press("Keep course");
  await press("Keep speed");
  const begun = Date.now();
  let [worst, wheel, turningAt, atBend] = [0, Infinity, "", false];
  let stopping = false;
  for (;;) {
    expect(Date.now() - begun, "she is too slow").toBeLessThan(LONGEST_S * 1000);
    const { values } = await read(pilot);
    // After the end of the plan there is none.
    const off = (Number.parseFloat(values.XTD ?? "") || 0) * (values.XTD?.endsWith("P") ? -1 : 1);
    worst = Math.max(worst, Math.abs(off));
    const [next = "", left] = [values.NEXT, metres(values.DIST)];
    // The wheel goes over when its distance has run out: then that of a later turn is shown, or none.
    const now = metres(values.WHEEL) ?? Infinity;
    if (wheel < 150 && now > wheel) turningAt = next;
    wheel = now;
    const leg = Number.parseFloat((turningAt === next && values.THEN) || values.LEG || "");
    // The stream that the page shows sets her across the channel: she heads up against it.
    const [rate = 0, to = 0] = (values.CURR?.match(/[\d.]+/g) ?? []).map(Number);
    const across =
      (rate * Math.sin(turn(leg, to) * DEG)) / Math.max(2, Number.parseFloat(values.SOG ?? ""));
    const drift = Math.asin(across) / DEG;
    const back = Math.max(-12, Math.min(12, -0.3 * off));
    // The course keeper gives a degree of rudder for a degree of error: she holds her heading in a shear or at a bank only
    // with a course ordered beyond it.
    const wanted = leg + back - drift;
    const beyond = Math.max(-15, Math.min(15, turn(Number.parseFloat(values.HDG ?? ""), wanted)));
    if (!stopping) await steer((Math.round(wanted + beyond) + 360) % 360);
    if (next === "Basin" && !atBend) {
      atBend = true;
      await pilot.screenshot({ path: join(SHOTS, "inbound-bend.png") });
    }
    if (next === "end of plan" || (next === "Off the berth" && (left ?? 0) < 130)) stopping = true;
    const planned = Number.parseFloat(values.PLAN ?? "");
    // She needs a mile to slow down: before the plan's next speed.
    const early = next === "Basin" && (left ?? Infinity) < 700;
    // She slows down by a knot at a time: without the propeller's race her rudder holds no heading.
    const slower = Math.ceil(2 * (Number.parseFloat(values.SOG ?? "") - 1)) / 2;
    await go(stopping ? 0 : Math.max(slower, early ? 3 : planned));
    if (stopping && Number.parseFloat(values.SOG ?? "") < 0.3) break;
    await pilot.waitForTimeout(300);
  }
  const last = await read(pilot);
  console.log(
    `stopped off the berth at ${last.time}; largest cross-track distance ${worst} m; bow ${last.bow.off} m, stern ${last.stern.off} m off`,
  );
  expect(worst).toBeLessThan(CORRIDOR_M);
  expect(Math.max(last.bow.off, last.stern.off)).toBeLessThan(260);
  expect(await pilot.locator(".alarm-button").textContent()).toBe("Alarms 0");
  await pilot.screenshot({ path: join(SHOTS, "inbound-stopped.png") });
});

const TUGS = { forward_tug: "bow", after_tug: "stern" } as const;
const PLACES = { bow: "starboard shoulder", stern: "starboard quarter" } as const;
const [AHEAD, ASTERN] = ["Dead slow ahead", "Dead slow astern"];
const STOP = "Stop engine (S)";
const said = new Map<string, string>();

/** Gives an order to a tug unless she has it. */
async function tells(tug: keyof typeof TUGS, order: string, percent: number): Promise<void> {
  const card = pilot.getByRole("region", { name: `Tug ${tug}` });
  const once = async (key: string, value: string, act: () => Promise<unknown>) => {
    if (said.get(`${tug} ${key}`) === value) return;
    said.set(`${tug} ${key}`, value);
    await act();
  };
  const place = PLACES[TUGS[tug]];
  await once("place", place, () => card.getByRole("combobox").selectOption({ label: place }));
  await once("power", String(percent), () =>
    card.getByRole("button", { name: `${tug} ${percent} %` }).click(),
  );
  await once("order", order, () =>
    card.getByRole("button", { name: `${tug} ${order}`, exact: true }).click(),
  );
}

test("two tugs take her to the quay, by the pilot's orders", async () => {
  await pilot.getByRole("tab", { name: "Docking" }).click();
  await press("Stop engine (S)");
  await press("Mid: rudder amidships (M)");
  await pilot.getByRole("button", { name: "Fit: ship and berth (0)" }).click();
  const begun = Date.now();
  let [landing, settled, engine] = [0, 0, ""];
  while (settled < 6) {
    expect(Date.now() - begun, "she is too slow").toBeLessThan(LONGEST_S * 1000);
    const { bow, stern, along, toGo } = await read(pilot);
    const ends = { bow, stern };
    // The wind drives her along the quay: a touch of the engine brings her bow to its mark and holds it there.
    const ahead = Math.max(-0.1, Math.min(0.1, 0.004 * toGo));
    const wanted = along > ahead + 0.04 ? ASTERN : along < ahead - 0.04 ? AHEAD : STOP;
    if (wanted !== engine) await press(wanted);
    engine = wanted;
    // The end that is farther off goes faster, so that she comes parallel.
    const lead = bow.off - stern.off;
    for (const tug of ["forward_tug", "after_tug"] as const) {
      const end = TUGS[tug];
      const { off, closing } = ends[end];
      const behind = end === "bow" ? lead : -lead;
      const most = off > 60 ? 0.24 : off > 20 ? 0.14 : 0.08;
      const speed = Math.max(0.03, Math.min(0.3, most + 0.006 * behind));
      if (off < 0.3) await tells(tug, "push", 25);
      else if (closing < speed - 0.03) await tells(tug, "push", off > 60 ? 50 : 25);
      else if (closing > speed + 0.06 && off > 2) await tells(tug, "pull", 25);
      else if (closing > speed) await tells(tug, "stop", 25);
      if (off < 0.4) landing = Math.max(landing, closing);
    }
    const still = [bow, stern].every((end) => end.off < 0.3 && Math.abs(end.closing) < 0.04);
    settled = still ? settled + 1 : 0;
    await pilot.waitForTimeout(250);
  }
  const last = await read(pilot);
  console.log(`alongside at ${last.time}; landed at ${landing.toFixed(2)} m/s`);
  expect(landing).toBeLessThan(0.3);
  await pilot.getByRole("button", { name: "Fit: ship and berth (0)" }).click();
  await pilot.waitForTimeout(500);
  await pilot.screenshot({ path: join(SHOTS, "inbound-alongside.png") });
  const struck = await pilot.locator(".verdict-button").textContent();
  expect(struck).not.toMatch(/struck|over its rating|failed/i);
});

const BOLLARDS = {
  head: "b_11",
  stern: "b_1",
  "fore breast": "b_9",
  "aft breast": "b_3",
  "fore spring": "b_7",
  "aft spring": "b_5",
};

test("she is made fast, the exercise is reached, and the report has the plan", async () => {
  await pilot.getByRole("tab", { name: "Lines" }).click();
  const row = (line: string) =>
    pilot.locator(".lines li").filter({ hasText: new RegExp(`^${line}`) });
  for (const [line, bollard] of Object.entries(BOLLARDS)) {
    await pilot.getByLabel(`Bollard for ${line}`).selectOption(bollard);
    await pilot.getByRole("button", { name: `Send ${line} ashore` }).click();
  }
  for (const [line, bollard] of Object.entries(BOLLARDS))
    await row(line)
      .getByText(`fast at ${bollard.replaceAll("_", " ")}`)
      .waitFor({ timeout: 150_000 });
  await pilot.getByRole("tab", { name: "Exercise" }).click();
  await pilot.getByText(/^Exercise finished: goal reached at/).waitFor({ timeout: 90_000 });
  await pilot.screenshot({ path: join(SHOTS, "inbound-all-fast.png") });
  await instructor.bringToFront();
  await instructor.getByRole("tab", { name: "Exercise", exact: true }).click();
  const opened = browser.context.waitForEvent("page");
  await instructor.getByRole("button", { name: "Report of the exercise" }).click();
  const report = await opened;
  await report.waitForURL(/\/report\?token=/, { timeout: 60_000 });
  const heading = report.getByRole("heading", { name: "Passage plan inbound, ship" });
  await heading.waitFor();
  await heading.evaluate((each) => each.scrollIntoView());
  await report.screenshot({ path: join(SHOTS, "inbound-report.png") });
  const text = (await report.locator("body").textContent()) ?? "";
  expect(text).toContain("Cross-track distance along the plan");
  expect(text).not.toContain("left the corridor");
  await report.close();
  expect(errors).toEqual([]);
});
