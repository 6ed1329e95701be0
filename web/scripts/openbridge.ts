/**
 * Takes from OpenBridge's style sheet the custom properties that this page uses: those that the imported components name, and
 * those that our own styles and palettes name. The whole style sheet has 680 kB, most of it for components that no page has.
 */
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, join } from "node:path";
import type { Plugin } from "vite";

const PACKAGE = "@oicl/openbridge-webcomponents/dist/";
const SHEET = /openbridge-webcomponents\/dist\/openbridge\.css$/;
const WATCH = /openbridge-webcomponents\/dist\/navigation-instruments\/watch\/watch\.js$/;
/**
 * In 1.0.1 the dials with an arc (rudder, rate of turn, speed) round an arc of radius 0, which gives no number and an error in
 * the browser's log. A radius as that of the rounding gives a number; the arc bounds only dots that this page does not show.
 */
const NO_NUMBER = { wrong: "r: 0,", right: "r: 8," };
/** Where this page names components and custom properties. */
const OURS = [
  "../src/instruments/components.ts",
  "../src/palette.ts",
  "../src/style/openbridge.css",
];
/** Sizes of components: the page has one. */
const SIZE = ".obc-component-size-regular";

export interface Rule {
  selector: string;
  /** Custom properties with their values. */
  properties: [name: string, value: string][];
}

/** The package's file of that name. */
export const packaged = (name: string): string =>
  createRequire(import.meta.url).resolve(PACKAGE + name);

/** Splits CSS at a character that is outside of quotes and brackets. */
function split(text: string, at: string): string[] {
  const parts: string[] = [];
  let [from, depth, quote] = [0, 0, ""];
  for (let i = 0; i < text.length; i++) {
    const c = text[i] ?? "";
    if (quote !== "") quote = c === quote ? "" : quote;
    else if (c === "'" || c === '"') quote = c;
    else if (c === "(") depth += 1;
    else if (c === ")") depth -= 1;
    else if (c === at && depth === 0) {
      parts.push(text.slice(from, i));
      from = i + 1;
    }
  }
  parts.push(text.slice(from));
  return parts;
}

/** The rules at the top of a style sheet that set custom properties: sizes, constants and palettes. */
export function rules(css: string): Rule[] {
  const wanted = new Set([SIZE, "*", ":root"]);
  return [...css.matchAll(/^([^\s}@][^{}]*)\{\n([\s\S]*?)^\}/gm)].flatMap(([, head, body]) => {
    const selector = (head ?? "").trim().replace(/\s+/g, "");
    if (!wanted.has(selector) && !selector.includes("[data-obc-theme=")) return [];
    const properties = split(body ?? "", ";").flatMap((each): Rule["properties"] => {
      const found = /^\s*(--[\w-]+)\s*:\s*([\s\S]+)$/.exec(each);
      return found ? [[found[1] ?? "", (found[2] ?? "").replace(/\s+/g, " ").trim()]] : [];
    });
    return properties.length > 0 ? [{ selector, properties }] : [];
  });
}

/** Custom properties that a text names. */
const named = (text: string): string[] =>
  [...text.matchAll(/--[a-z][\w-]*/g)].map(([name]) => name);

/** Custom properties that a module and the modules that it imports name. */
function namedBy(file: string, seen: Set<string>): string[] {
  if (seen.has(file)) return [];
  seen.add(file);
  const code = readFileSync(file, "utf8");
  const imports = [...code.matchAll(/(?:from|import)\s*\(?\s*"([^"]+)"/g)].flatMap(
    ([, name = ""]) => {
      if (name.startsWith(PACKAGE) && name.endsWith(".js"))
        return [packaged(name.slice(PACKAGE.length))];
      return name.startsWith(".") && name.endsWith(".js") ? [join(dirname(file), name)] : [];
    },
  );
  return [...named(code), ...imports.flatMap((each) => namedBy(each, seen))];
}

/** The style sheet with the custom properties that are named, and those that these need. */
export function pruned(css: string, names: Iterable<string>): string {
  const all = rules(css);
  const needs = new Map<string, string[]>();
  for (const { properties } of all)
    for (const [name, value] of properties)
      needs.set(name, [...(needs.get(name) ?? []), ...named(value)]);
  const kept = new Set<string>();
  const add = (name: string): void => {
    if (kept.has(name)) return;
    kept.add(name);
    for (const other of needs.get(name) ?? []) add(other);
  };
  for (const name of names) add(name);
  return all
    .map(({ selector, properties }) => {
      const here = properties.filter(([name]) => kept.has(name));
      // On the root alone: nothing in this page changes sizes within itself.
      const at = selector === SIZE || selector === "*" ? ":root" : selector;
      return here.length === 0
        ? ""
        : `${at}{${here.map(([name, value]) => `${name}:${value}`).join(";")}}`;
    })
    .join("\n");
}

/** Custom properties that this page and its components name. */
export function used(): string[] {
  const seen = new Set<string>();
  return OURS.flatMap((name) => namedBy(new URL(name, import.meta.url).pathname, seen));
}

function mended(code: string): string {
  const parts = code.split(NO_NUMBER.wrong);
  if (parts.length !== 2) throw new Error("OpenBridge's watch.js is another: look at NO_NUMBER");
  return parts.join(NO_NUMBER.right);
}

/** The plugin of Vite for all pages. */
export function openbridge(): Plugin {
  return {
    name: "openbridge",
    enforce: "pre",
    // Vite's own bundle of packages, in development, would not come by here.
    config: () => ({ optimizeDeps: { exclude: ["@oicl/openbridge-webcomponents"] } }),
    transform(code, id) {
      const [file = ""] = id.split("?");
      if (WATCH.test(file)) return { code: mended(code), map: null };
      if (!SHEET.test(file)) return null;
      return { code: pruned(code, used()), map: null };
    },
  };
}
