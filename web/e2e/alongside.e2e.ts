/**
 * The whole exercise: a pilot and two tugmasters, each with a page, bring the ship alongside and make her fast. They only read
 * the docking board and press buttons. The exercise ends by itself, and the instructor opens its report. Then the instructor
 * pauses, rewinds and branches. With `BY_VIEW=1` pilot and tugmasters close the plan, and look out of the window instead.
 */
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { type Browser, type Served, SHOTS, SOFTWARE_WEBGL, browse, open, serve } from "./browser";

/** The tugs with the end of the ship at which each works. */
const TUGS = { forward_tug: "bow", after_tug: "stern" } as const;

interface Master {
  page: Page;
  tug: string;
  end: "bow" | "stern";
}
const PACE = "4";
/** Pilot and tugmasters have the view in the plan's place, from before they take the helm until all is fast. */
const BY_VIEW = process.env.BY_VIEW === "1";
/** A busy machine gives orders less often, and the ship takes longer. */
const LONGEST_S = 400;

/** The ship starts at rest abreast of her berth. */
const ABREAST = [
  "body.ship.position=[0, -28]",
  'body.ship.heading="0 deg"',
  'body.ship.velocity.surge="0 kn"',
  "body.forward_tug.position=[40, -75]",
  "body.after_tug.position=[-80, -75]",
];

const errors: string[] = [];
let served: Served;
let browser: Browser;
/** The instructor's: one browser draws no page beside three with views that are drawn on the processor. */
let instructors: Browser;
let pilot: Page;
let masters: Master[];
let tug: Page;
let instructor: Page;

beforeAll(async () => {
  served = await serve(ABREAST);
  browser = await browse({ width: 1280, height: 800 }, false, BY_VIEW ? SOFTWARE_WEBGL : []);
  pilot = await open(browser.context, served, "pilot", errors);
  masters = [];
  for (const [name, end] of Object.entries(TUGS)) {
    const page = await open(browser.context, served, `master of ${name}`, errors);
    masters.push({ page, tug: name, end });
  }
  const [first] = masters;
  if (!first) throw new Error("there is no tugmaster");
  tug = first.page;
  instructors = BY_VIEW ? await browse({ width: 1280, height: 800 }) : browser;
  instructor = await open(instructors.context, served, "instructor", errors);
  if (BY_VIEW) for (const page of [pilot, ...masters.map((each) => each.page)]) await looks(page);
});
afterAll(async () => {
  await browser.close();
  if (BY_VIEW) await instructors.close();
  await served.close();
});

/** Opens the view in the plan's place. */
async function looks(page: Page): Promise<void> {
  // A browser that draws several views on the processor answers late.
  page.setDefaultTimeout(120_000);
  await page.bringToFront();
  await page.getByRole("button", { name: "View out of the window" }).click();
  await page.getByRole("img", { name: /^View / }).waitFor({ timeout: 60_000 });
  await planIsClosed(page);
}

const planIsClosed = async (page: Page) =>
  expect(await page.getByRole("img", { name: "Plan of ship" }).isVisible()).toBe(false);

/** Shows ship and berth in the plan, or from a camera of the view, for a picture. */
async function frame(page: Page, camera: string): Promise<void> {
  if (BY_VIEW) {
    await planIsClosed(page);
    await page.locator(".window-tools").getByText(camera, { exact: true }).click();
  } else await page.getByRole("button", { name: "Ship and berth (0)" }).click();
}

interface End {
  off: number;
  closing: number;
}

/** What the docking board shows. */
async function board(page: Page): Promise<{ bow: End; stern: End }> {
  return page.evaluate(() => {
    const end = (name: string) => {
      const root = document.querySelector<HTMLElement>(`.end[aria-label="${name}"]`);
      return { off: Number(root?.dataset.off), closing: Number(root?.dataset.closing) };
    };
    return { bow: end("Bow"), stern: end("Stern") };
  });
}

type Word = { order: "Push" | "Stop" | "Pull"; percent: 25 };

/**
 * A careful order to the tug at an end: push to a small speed, then let the wind do the rest. A pull is the last resort: she leaves
 * the side for it, and needs minutes to come back. At the fenders she holds the ship.
 */
function word({ off, closing }: End): Word {
  if (off < 0.2) return { order: "Push", percent: 25 };
  if (closing < 0.05) return { order: "Push", percent: 25 };
  if (closing > 0.2 && off > 3) return { order: "Pull", percent: 25 };
  return { order: "Stop", percent: 25 };
}

const said = new Map<string, string>();
/** Presses a button only if the order differs from the last one. */
async function once(key: string, order: string, press: () => Promise<void>): Promise<void> {
  if (said.get(key) === order) return;
  said.set(key, order);
  await press();
}

/** Tells the tug of a page, by its own master. */
async function tells({ page, tug, end }: Master, { order, percent }: Word): Promise<void> {
  const card = page.getByRole("region", { name: `Tug ${tug}` });
  await once(
    `${tug} place`,
    end,
    async () =>
      void (await card
        .getByRole("combobox")
        .selectOption({ label: end === "bow" ? "port shoulder" : "port quarter" })),
  );
  await once(`${tug} power`, String(percent), () =>
    card.getByRole("button", { name: `${tug} ${percent} %` }).click(),
  );
  await once(tug, order, () =>
    card.getByRole("button", { name: `${tug} ${order.toLowerCase()}`, exact: true }).click(),
  );
}

test("nobody commands before taking the helm, and two cannot hold it", async () => {
  expect(
    await pilot.getByRole("button", { name: "Rudder port 10", exact: true }).isDisabled(),
  ).toBe(true);
  await pilot.getByRole("button", { name: "Take the helm" }).click();
  await pilot.getByRole("button", { name: "Release the helm" }).waitFor();
  for (const { page } of masters) {
    await page.getByRole("button", { name: /^Take / }).click();
    await page.getByRole("button", { name: /^Release / }).waitFor();
  }
  const second = await open(browser.context, served, "pilot", errors);
  await second.getByText(/has the helm/).waitFor();
  await second.getByRole("button", { name: "Take the helm" }).click();
  await second.getByText(/^Refused: .*holds this control/).waitFor();
  await second.close();
});

test("two tugmasters bring her alongside, and the pilot watches the board", async () => {
  await instructor.getByRole("button", { name: `Pace ${PACE}`, exact: true }).click();
  if ((await instructor.locator(".run-state").textContent()) === "PAUSED")
    await instructor.getByRole("button", { name: "Resume (K)" }).click();
  await pilot.bringToFront();
  await pilot.getByRole("tab", { name: "Docking" }).click();
  await pilot.getByRole("button", { name: "Mid: rudder amidships (M)" }).click();
  const begun = Date.now();
  let [landing, settled] = [0, 0];
  while (Date.now() - begun < LONGEST_S * 1000) {
    const now = await board(pilot);
    // The end that is ahead of the other waits, so that the ship does not turn.
    const lead = now.bow.off - now.stern.off;
    const held = {
      bow: { ...now.bow, closing: now.bow.closing + Math.max(0, -lead) * 0.02 },
      stern: { ...now.stern, closing: now.stern.closing + Math.max(0, lead) * 0.02 },
    };
    for (const master of masters) await tells(master, word(held[master.end]));
    for (const end of [now.bow, now.stern])
      if (end.off < 0.4) landing = Math.max(landing, end.closing);
    const still = [now.bow, now.stern].every(
      (end) => end.off < 0.25 && Math.abs(end.closing) < 0.04,
    );
    settled = still ? settled + 1 : 0;
    if (settled > 6) break;
    await pilot.waitForTimeout(200);
  }
  const last = await board(pilot);
  const minutes = ((Date.now() - begun) / 60_000) * Number(PACE);
  console.log(
    `alongside after ${minutes.toFixed(1)} min of her time; landed at ${landing.toFixed(2)} m/s; bow ${last.bow.off} m, stern ${last.stern.off} m`,
  );
  expect(Math.max(last.bow.off, last.stern.off)).toBeLessThan(0.3);
  expect(landing).toBeLessThan(0.3);
  // Screenshots of the ship at her fenders, for a person to look at.
  await frame(pilot, "Stb");
  await pilot.waitForTimeout(3000);
  for (const tab of ["Docking", "Lines", "Alarms", "Charts", "Fenders"]) {
    await pilot.getByRole("tab", { name: tab }).click();
    await pilot.waitForTimeout(tab === "Charts" ? 1200 : 200);
    await pilot.screenshot({ path: join(SHOTS, `alongside-${tab.toLowerCase()}.png`) });
  }
  await tug.bringToFront();
  await tug.waitForTimeout(300);
  await tug.screenshot({ path: join(SHOTS, "alongside-tugmaster.png") });
  await pilot.bringToFront();
  if (!BY_VIEW)
    for (let i = 0; i < 2; i++) await pilot.getByRole("button", { name: "Zoom in (+)" }).click();
  await pilot.waitForTimeout(200);
  await pilot.screenshot({ path: join(SHOTS, "alongside-close.png") });
  expect(await pilot.locator(".fenders .summary").textContent()).toMatch(
    /touched so far · highest so far \d+ % of rated/,
  );
  expect(await pilot.locator(".fenders li.alarm").count()).toBe(0);
});

/** Each line of the ship and the bollard that leads it well. */
const BOLLARDS = {
  head: "b11",
  stern: "b1",
  "fore breast": "b9",
  "aft breast": "b3",
  "fore spring": "b7",
  "aft spring": "b5",
};

test("the pilot makes her fast with six lines", async () => {
  await instructor.bringToFront();
  await instructor.getByRole("button", { name: "Pace 8", exact: true }).click();
  await pilot.bringToFront();
  await pilot.getByRole("tab", { name: "Lines" }).click();
  const row = (line: string) =>
    pilot.locator(".lines li").filter({ hasText: new RegExp(`^${line}`) });
  for (const [line, bollard] of Object.entries(BOLLARDS)) {
    await pilot.getByLabel(`Bollard for ${line}`).selectOption(bollard);
    await pilot.getByRole("button", { name: `Send ${line} ashore` }).click();
    await row(line).locator(".state", { hasText: bollard }).waitFor();
  }
  await pilot.screenshot({ path: join(SHOTS, "lines-under-way.png") });
  for (const [line, bollard] of Object.entries(BOLLARDS))
    await row(line).getByText(`fast at ${bollard}`).waitFor({ timeout: 120_000 });
  // One line after the other: six winches that heave at once surge the ship, and load one line far beyond where its winch
  // stalls.
  for (const line of Object.keys(BOLLARDS)) {
    const name = line.replace(" ", "_");
    await pilot.getByRole("button", { name: `Heave ${name}` }).click();
    // Tight: 5 % of the break load and more.
    await row(line)
      .getByText(/\b([5-9]|[1-9]\d) % of/)
      .waitFor({ timeout: 60_000 });
    await pilot.getByRole("button", { name: `Hold ${name}` }).click();
  }
  await pilot.getByText("All fast: 6 lines.").waitFor();
  await frame(pilot, "Free");
  await pilot.waitForTimeout(2000);
  await pilot.screenshot({ path: join(SHOTS, "all-fast.png") });
  expect(await pilot.locator(".lines li.alarm").count()).toBe(0);
});

test("the exercise ends by itself, and its report opens from the page", async () => {
  await pilot.getByRole("tab", { name: "Exercise" }).click();
  const finished = (page: Page) =>
    page.getByText(/^Exercise finished: goal reached at/).waitFor({ timeout: 60_000 });
  await finished(pilot);
  await pilot.locator(".run-state", { hasText: "PAUSED" }).waitFor();
  await pilot.screenshot({ path: join(SHOTS, "exercise-pilot.png") });
  // The score is the instructor's.
  expect(await pilot.getByLabel("Score").isVisible()).toBe(false);
  await instructor.bringToFront();
  await instructor.getByRole("tab", { name: "Exercise", exact: true }).click();
  await finished(instructor);
  const score = /^(\d+) of 100, (not )?passed$/.exec(
    (await instructor.getByLabel("Score").textContent()) ?? "",
  );
  expect(score).not.toBeNull();
  await instructor.screenshot({ path: join(SHOTS, "exercise-instructor.png") });
  const opened = instructors.context.waitForEvent("page");
  await instructor.getByRole("button", { name: "Report of the exercise" }).click();
  const report = await opened;
  await report.waitForURL(/\/report\?token=/, { timeout: 60_000 });
  await report.getByRole("heading", { name: "Exercise", exact: true }).waitFor();
  const text = (await report.locator("body").textContent()) ?? "";
  for (const words of [
    `score ${score?.[1]} of 100`,
    "Goal reached at",
    "6 lines fast, 6 of 6 with the required tension, winch on hold",
    "Speed towards the berth",
    "The exercise has ended: its goal is reached",
    "head: send",
  ])
    expect(text).toContain(words);
  expect(text).not.toContain("not fulfilled");
  await report.screenshot({ path: join(SHOTS, "exercise-report.png") });
  await report
    .getByRole("heading", { name: "Exercise", exact: true })
    .evaluate((heading) => heading.scrollIntoView());
  await report.screenshot({ path: join(SHOTS, "exercise-report-limits.png") });
  await report.close();
  await instructor.getByRole("button", { name: "Resume (K)" }).click();
});

test("the instructor pauses, steps, rewinds and branches", async () => {
  await instructor.bringToFront();
  await instructor.getByRole("button", { name: "Pace 1", exact: true }).click();
  await instructor.getByRole("button", { name: "Pause (K)" }).click();
  await instructor.locator(".run-state", { hasText: "PAUSED" }).waitFor();
  // The others see it too.
  await pilot.bringToFront();
  await pilot.locator(".run-state", { hasText: "PAUSED" }).waitFor();
  await instructor.bringToFront();
  const slider = instructor.getByRole("slider", { name: "Timeline" });
  const before = Number(await slider.inputValue());
  await instructor.getByRole("button", { name: "Single step (.)" }).click();
  await expect.poll(async () => Number(await slider.inputValue())).toBe(before + 1);
  await instructor.getByRole("button", { name: "Back ten seconds" }).click();
  await instructor.locator(".run-state", { hasText: "REWOUND" }).waitFor();
  const lanes = instructor.getByRole("group", { name: "Branches" }).getByRole("button");
  const branches = await lanes.count();
  await instructor.getByRole("button", { name: "Go on from here as a new branch" }).click();
  await expect.poll(() => lanes.count()).toBe(branches + 1);
  await instructor.locator(".run-state", { hasText: "PAUSED" }).waitFor();
  await instructor.getByRole("button", { name: "Resume (K)" }).click();
  await instructor.locator(".run-state", { hasText: "1×" }).waitFor();
  await expect.poll(async () => Number(await slider.inputValue())).toBeGreaterThan(before - 100);
  await instructor.screenshot({ path: join(SHOTS, "instructor-branches.png") });
  await lanes.first().click();
  await expect.poll(() => lanes.first().getAttribute("aria-pressed")).toBe("true");
});

test("frames are on the page within 100 ms, and it draws smoothly", async () => {
  await instructor.bringToFront();
  await instructor.getByRole("button", { name: "To the end of the branch" }).click();
  await instructor.getByRole("button", { name: "Resume (K)" }).click();
  // A browser draws only the page in front.
  await instructor.waitForTimeout(12_000);
  const { median, p99, fps } = await instructor
    .locator(".link-state")
    .evaluate((each: HTMLElement) => ({ ...each.dataset }));
  console.log(
    `tick to drawing: median ${median} ms, 99 of 100 within ${p99} ms; ${fps} drawings a second`,
  );
  expect(Number(median)).toBeLessThan(100);
  expect(errors).toEqual([]);
});
