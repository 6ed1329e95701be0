/** A web server that knows nothing but files, and counts what is asked of it. */
import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import type { AddressInfo } from "node:net";
import { extname, join, normalize } from "node:path";
import { type Page } from "playwright-core";
import { type Browser, browse } from "../e2e/browser";

const FOLDER = new URL("../../target/page/", import.meta.url).pathname;
const TYPES: Record<string, string> = {
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript",
  ".css": "text/css",
  ".wasm": "application/wasm",
};

export interface Files {
  url: string;
  /** Paths that were asked for. */
  asked: string[];
  close(): void;
}

export async function files(): Promise<Files> {
  const asked: string[] = [];
  const server = createServer((request, answer) => {
    const path = new URL(request.url ?? "/", "http://page").pathname;
    asked.push(path);
    const name = normalize(path === "/" ? "/index.html" : path);
    readFile(join(FOLDER, name)).then(
      (bytes) => {
        answer.setHeader("content-type", TYPES[extname(name)] ?? "application/octet-stream");
        answer.end(bytes);
      },
      () => answer.writeHead(404).end(),
    );
  });
  await new Promise<void>((ready) => server.listen(0, "127.0.0.1", ready));
  const { port } = server.address() as AddressInfo;
  return { url: `http://127.0.0.1:${port}/`, asked, close: () => void server.close() };
}

export interface Opened extends Browser {
  page: Page;
  served: Files;
  /** Errors of the page. */
  errors: string[];
}

/** Opens the page and waits for its first run. */
export async function opened(
  size = { width: 1600, height: 900 },
  touch = false,
  flags: string[] = [],
): Promise<Opened> {
  const served = await files();
  const { context, close } = await browse(size, touch, flags);
  const page = await context.newPage();
  const errors: string[] = [];
  page.on("pageerror", (error) => errors.push(error.message));
  page.on("console", (message) => message.type() === "error" && errors.push(message.text()));
  await page.goto(served.url);
  await ended(page);
  return {
    context,
    page,
    served,
    errors,
    close: async () => {
      await close();
      served.close();
    },
  };
}

/** Waits until the page's run is at its end. */
export async function ended(page: Page): Promise<void> {
  await page.waitForFunction(
    () => /^(done|stopped|mistake)/.test(document.querySelector(".run-state")?.textContent ?? ""),
    undefined,
    { timeout: 90_000 },
  );
}

/** Waits until a run begins after `act`, and for its end. */
export async function reran(page: Page, act: () => Promise<unknown>): Promise<void> {
  await page.evaluate(() => {
    const state = document.querySelector(".run-state");
    if (state) state.textContent = "";
  });
  await act();
  await ended(page);
}
