/** A headless browser, and the program under test. */
import { spawn } from "node:child_process";
import { mkdtempSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { type BrowserContext, type Page, chromium } from "playwright-core";

const FLAGS = [
  "--headless",
  "--no-sandbox",
  "--disable-gpu",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];

/** Draws three-dimensional pictures on the processor, where there is no graphics card. */
export const SOFTWARE_WEBGL = [
  "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader",
  "--ignore-gpu-blocklist",
];

/** Where screenshots go. */
export const SHOTS =
  process.env.SCREENSHOTS ?? new URL("../screenshots/", import.meta.url).pathname;

export interface Served {
  url: string;
  /** By role: `instructor`, `pilot`, `observer`, `master of NAME`; `tugmaster` is the first of those. */
  tokens: Record<string, string>;
  /** The folder of its recordings. */
  sessions: string;
  close(): Promise<void>;
}

const SCENARIO = new URL("../../scenarios/live/berthing.toml", import.meta.url).pathname;
const DIST = new URL("../dist/", import.meta.url).pathname;
const STARTS_MS = 30_000;

/** The program that `FENDERLINE_BIN` names. */
export function underTest(): string {
  const program = process.env.FENDERLINE_BIN;
  if (!program)
    throw new Error(
      "FENDERLINE_BIN names no program to test; `cargo xtask pages` builds and names it",
    );
  return program;
}

/**
 * Starts the program that `FENDERLINE_BIN` names on a free port, with the pages of `dist` and recordings in a new folder,
 * and reads the links that it prints. The tugmaster's link is that of the first tug. `set`: keys of the scenario to
 * override.
 */
export async function serve(
  set: string[] = [],
  scenario = SCENARIO,
  /** More options of the command. */
  more: string[] = [],
): Promise<Served> {
  const program = underTest();
  const sessions = mkdtempSync(join(tmpdir(), "fenderline-sessions-"));
  const server = spawn(program, [
    "serve",
    scenario,
    ...set.flatMap((key) => ["--set", key]),
    ...more,
    "--port",
    "0",
    "--page",
    DIST,
    "--sessions",
    sessions,
  ]);
  const tokens: Record<string, string> = {};
  let [url, said] = ["", ""];
  await new Promise<void>((ready, failed) => {
    const timer = setTimeout(() => failed(new Error(`it printed no links: ${said}`)), STARTS_MS);
    const hear = (data: Buffer) => {
      said += String(data);
      for (const [, role, tug, base, token] of said.matchAll(
        /^ +(instructor|pilot|observer|master of (\S+)) +(http:\S+?)\/\?token=(\S+)\s/gm,
      )) {
        if (role === undefined || base === undefined || token === undefined) continue;
        url = base;
        tokens[tug === undefined ? role : "tugmaster"] ??= token;
        if (tug !== undefined) tokens[role] = token;
      }
      if (tokens.observer === undefined) return;
      clearTimeout(timer);
      ready();
    };
    server.stdout.on("data", hear);
    server.stderr.on("data", hear);
    server.on("exit", (code) => failed(new Error(`it ended with ${code}: ${said}`)));
  });
  const close = async () => {
    server.removeAllListeners("exit");
    const ended = new Promise((done) => server.on("exit", done));
    server.kill("SIGINT");
    await ended;
  };
  return { url, tokens, sessions, close };
}

export interface Browser {
  context: BrowserContext;
  close(): Promise<void>;
}

/**
 * Time between two drawings in CI (ms), of a page and of a page with a view that the processor draws. A page that draws as often as
 * it can would keep a processor busy, and a view all of them.
 */
const PAGE_EACH_MS = 100;
const VIEW_EACH_MS = 200;

/** Runs in a page before the page's own scripts: lets the page draw at most once in `each_ms`. */
function drawSeldom(each_ms: number): void {
  const [request, cancel] = [requestAnimationFrame.bind(window), cancelAnimationFrame.bind(window)];
  /** By the number of a request: the timer before the browser's own request, or this request. */
  const waiting = new Map<number, { timer?: number; frame?: number }>();
  let last = 0;
  window.requestAnimationFrame = (callback) => {
    const id = ++last;
    const draw = (now: number) => {
      waiting.delete(id);
      callback(now);
    };
    const timer = window.setTimeout(() => waiting.set(id, { frame: request(draw) }), each_ms);
    waiting.set(id, { timer });
    return id;
  };
  window.cancelAnimationFrame = (id) => {
    const { timer, frame } = waiting.get(id) ?? {};
    if (timer !== undefined) window.clearTimeout(timer);
    if (frame !== undefined) cancel(frame);
    waiting.delete(id);
  };
}

export async function browse(
  size: { width: number; height: number },
  touch = false,
  /** More flags of the browser. Those of `SOFTWARE_WEBGL` stand in place of `--disable-gpu`. */
  flags: string[] = [],
  /** Whether pages draw as often as they can. A view that draws seldom makes its picture coarser. */
  drawsOften = !process.env.CI,
): Promise<Browser> {
  const context = await chromium.launchPersistentContext(
    mkdtempSync(join(tmpdir(), "fenderline-e2e-")),
    {
      executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
      headless: true,
      args: [
        ...FLAGS.filter((flag) => flag !== "--disable-gpu" || flags !== SOFTWARE_WEBGL),
        ...flags,
      ],
      viewport: size,
      hasTouch: touch,
    },
  );
  const each_ms = flags === SOFTWARE_WEBGL ? VIEW_EACH_MS : PAGE_EACH_MS;
  if (!drawsOften) await context.addInitScript(drawSeldom, each_ms);
  return { context, close: () => context.close() };
}

/** Waits until the page, which is in front, has drawn what it knows now, however slow the machine is. */
export const drawn = (page: Page): Promise<void> =>
  page.evaluate(async () => {
    for (let times = 0; times < 2; times++) await new Promise(requestAnimationFrame);
  });

/** Opens the page of a role and waits until it has data. Errors in the page fail the test. */
export async function open(
  context: BrowserContext,
  served: Served,
  role: string,
  errors: string[],
  hints = false,
): Promise<Page> {
  const page = await context.newPage();
  page.on("pageerror", (error) => errors.push(`${role}: ${error.message}`));
  page.on(
    "console",
    (message) => message.type() === "error" && errors.push(`${role}: ${message.text()}`),
  );
  const token = served.tokens[role];
  if (token === undefined) throw new Error(`there is no token for ${role}`);
  await page.goto(`${served.url}/?token=${encodeURIComponent(token)}`);
  await page.getByRole("img", { name: "Plan of ship" }).waitFor();
  await page.waitForFunction(
    () => (document.querySelector(".readout dd")?.textContent ?? "–") !== "–",
  );
  if (!hints) await page.getByRole("button", { name: "No hints" }).click();
  return page;
}
