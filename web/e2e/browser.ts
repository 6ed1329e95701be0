/** A headless browser, and the server under test: the mock, or the one that the environment names. */
import { spawn } from "node:child_process";
import { mkdtempSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { type BrowserContext, type Page, chromium } from "playwright-core";
import { startMock } from "../mock/server";

const FLAGS = [
  "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
  "--disable-background-networking", "--disable-component-update", "--disable-sync",
];

export interface Served {
  url: string;
  /** By role: `instructor`, `pilot`, `tugmaster`, `observer`. */
  tokens: Record<string, string>;
  mock: boolean;
  close(): Promise<void>;
}

/**
 * The server under test: the mock, or what the environment names.
 *
 * - `FENDERLINE_BIN`: the program; it is started on a free port with `FENDERLINE_SCENARIO`, the pages of `dist`, and
 *   recordings in a folder of its own, and ended after the tests of a file.
 * - `FENDERLINE_URL`: a server that runs, with `FENDERLINE_TOKENS` as JSON by role:
 *   `{"instructor": "…", "pilot": "…", "tugmaster": "…", "observer": "…"}`.
 */
export async function serve(): Promise<Served> {
  const { FENDERLINE_BIN: program, FENDERLINE_URL: url } = process.env;
  if (program) return started(program);
  if (url) {
    const tokens = JSON.parse(process.env.FENDERLINE_TOKENS ?? "{}") as Record<string, string>;
    return { url, tokens, mock: false, close: async () => {} };
  }
  const mock = await startMock({ port: 0, serveDist: true });
  const { "tugmaster-alpha": tugmaster, ...rest } = mock.tokens;
  return { url: mock.url, tokens: { ...rest, tugmaster: tugmaster ?? "" }, mock: true, close: () => mock.close() };
}

const SCENARIO = new URL("../../scenarios/berth/asd_tugs_push_alongside.toml", import.meta.url).pathname;
const DIST = new URL("../dist/", import.meta.url).pathname;
const STARTS_MS = 30_000;

/** Starts the program and reads the links that it prints. The tugmaster is of the first tug. */
async function started(program: string): Promise<Served> {
  const sessions = mkdtempSync(join(tmpdir(), "fenderline-sessions-"));
  const server = spawn(program, ["serve", process.env.FENDERLINE_SCENARIO ?? SCENARIO, "--port", "0", "--page", DIST, "--sessions", sessions]);
  const tokens: Record<string, string> = {};
  let [url, said] = ["", ""];
  await new Promise<void>((ready, failed) => {
    const timer = setTimeout(() => failed(new Error(`it printed no links: ${said}`)), STARTS_MS);
    const hear = (data: Buffer) => {
      said += String(data);
      for (const [, role, tug, base, token] of said.matchAll(/^ +(instructor|pilot|observer|master of (\S+)) +(http:\S+?)\/\?token=(\S+)\s/gm)) {
        if (role === undefined || base === undefined || token === undefined) continue;
        url = base;
        tokens[tug === undefined ? role : "tugmaster"] ??= token;
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
  return { url, tokens, mock: false, close };
}

export interface Browser {
  context: BrowserContext;
  close(): Promise<void>;
}

export async function browse(size: { width: number; height: number }, touch = false): Promise<Browser> {
  const context = await chromium.launchPersistentContext(mkdtempSync(join(tmpdir(), "fenderline-e2e-")), {
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    headless: true,
    args: FLAGS,
    viewport: size,
    hasTouch: touch,
  });
  return { context, close: () => context.close() };
}

/** Opens the page of a role and waits until it has data. What goes wrong in the page fails the test. */
export async function open(context: BrowserContext, served: Served, role: string, errors: string[], hints = false): Promise<Page> {
  const page = await context.newPage();
  page.on("pageerror", (error) => errors.push(`${role}: ${error.message}`));
  page.on("console", (message) => message.type() === "error" && errors.push(`${role}: ${message.text()}`));
  if (!hints) {
    await page.addInitScript(() => {
      for (const name of ["pilot", "tugmaster", "instructor", "observer"]) localStorage.setItem(`hints seen ${name}`, "yes");
    });
  }
  const token = served.tokens[role];
  if (token === undefined) throw new Error(`there is no token for ${role}`);
  await page.goto(`${served.url}/?token=${encodeURIComponent(token)}`);
  await page.getByRole("img", { name: "Plan of ship" }).waitFor();
  await page.waitForFunction(() => (document.querySelector(".readout dd")?.textContent ?? "–") !== "–");
  return page;
}
