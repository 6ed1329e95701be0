// The native programs that the tests compare with, and the repository's scenarios.
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";

const root = new URL("../../../../", import.meta.url).pathname;

const program = (name) => {
  const path = process.env[name];
  if (!path) throw new Error(`${name} names a program; \`cargo xtask npm\` sets it`);
  return path;
};

const output = (name, args) =>
  execFileSync(program(name), args, { cwd: root, encoding: "utf8", maxBuffer: 1 << 28 });

/** A scenario of the repository, with the tables of its folder. */
export const scenario = (name) => {
  const file = `scenarios/${name}.toml`;
  const folder = join(root, dirname(file));
  const tables = readdirSync(folder).filter((other) => other.endsWith(".csv"));
  const read = (other) => readFileSync(join(folder, other), "utf8");
  const files = Object.fromEntries(tables.map((other) => [other, read(other)]));
  return { file, text: readFileSync(join(root, file), "utf8"), files };
};

/** [hash, steps] of each scenario, natively. */
export const hashes = (steps, names) =>
  output("FENDERLINE_NATIVE", ["hash", String(steps), ...names.map((n) => scenario(n).file)])
    .trim()
    .split("\n")
    .map((line) => line.split(" "));

/** Nanoseconds of a step, natively. */
export const time = (name) => Number(output("FENDERLINE_NATIVE", ["time", scenario(name).file]));

/** Summary and report of `fenderline run`. */
export const ran = (name) => {
  const out = mkdtempSync(join(tmpdir(), "fenderline-npm-"));
  try {
    output("FENDERLINE_BIN", ["run", scenario(name).file, "--out", out, "--allow-failures"]);
    const read = (file) => readFileSync(join(out, file), "utf8");
    return { summary: JSON.parse(read("summary.json")), report: read("report.html") };
  } finally {
    rmSync(out, { recursive: true });
  }
};
