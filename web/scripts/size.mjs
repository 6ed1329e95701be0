// Weighs web/dist: what the first page loads, and everything. Fails where the first page has 500 kB or more.
import { readFileSync, readdirSync, statSync } from "node:fs";
import { join, relative } from "node:path";
import { gzipSync } from "node:zlib";

const FIRST_PAGE_BYTES = 500_000;
const dist = new URL("../dist/", import.meta.url).pathname;

const files = (folder) =>
  readdirSync(folder).flatMap((name) => {
    const path = join(folder, name);
    return statSync(path).isDirectory() ? files(path) : [path];
  });

const html = readFileSync(join(dist, "index.html"), "utf8");
// What the document names is loaded before anybody does anything; the rest on demand.
const named = [...html.matchAll(/(?:src|href)="\.\/([^"]+)"/g)].map((match) => match[1]);
const first = new Set(["index.html", ...named]);

const sum = { first: [0, 0], all: [0, 0] };
for (const path of files(dist).toSorted()) {
  const bytes = readFileSync(path);
  const gzip = gzipSync(bytes, { level: 9 }).length;
  const name = relative(dist, path);
  const isFirst = first.has(name);
  console.log(
    `${isFirst ? "first " : "later "} ${name.padEnd(44)} ${kb(bytes.length)} ${kb(gzip)} gzip`,
  );
  for (const key of isFirst ? ["first", "all"] : ["all"]) {
    sum[key][0] += bytes.length;
    sum[key][1] += gzip;
  }
}
console.log(
  `first page ${kb(sum.first[0])}, ${kb(sum.first[1])} gzip; everything ${kb(sum.all[0])}, ${kb(sum.all[1])} gzip`,
);
if (sum.first[0] >= FIRST_PAGE_BYTES) {
  console.error(`the first page has ${sum.first[0]} bytes; ${FIRST_PAGE_BYTES} is the limit`);
  process.exit(1);
}

function kb(bytes) {
  return `${(bytes / 1000).toFixed(1).padStart(7)} kB`;
}
