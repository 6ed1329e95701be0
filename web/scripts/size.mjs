// Weighs a folder of pages: what the first page loads, and everything, as they are and compressed as servers send them.
// Fails where the first page is too large: `size.mjs [FOLDER] [BYTES]`. Without BYTES, 500 kB as they are, of web/dist; with
// them, the bytes that a server sends of the whole folder, compressed with gzip. The view out of the window and the
// instruments, which are loaded after the page has drawn, are weighed apart.
import { readFileSync, readdirSync, statSync } from "node:fs";
import { join, relative } from "node:path";
import { brotliCompressSync, gzipSync } from "node:zlib";

const FIRST_PAGE_BYTES = 500_000;
/** Limit of the view out of the window and of the page without the view, compressed with gzip. */
const VIEW_BYTES = 300_000;
/** Limit of OpenBridge's instruments, compressed with gzip. */
const INSTRUMENTS_BYTES = 110_000;
const WITHOUT_VIEW_BYTES = 350_000;
const [folder = "dist", limit] = process.argv.slice(2);
const dist = new URL(`../${folder}/`, import.meta.url).pathname;

const files = (folder) =>
  readdirSync(folder).flatMap((name) => {
    const path = join(folder, name);
    return statSync(path).isDirectory() ? files(path) : [path];
  });

const html = readFileSync(join(dist, "index.html"), "utf8");
// What the document names is loaded before anybody does anything; the rest on demand.
const named = [...html.matchAll(/(?:src|href)="\.\/([^"]+)"/g)].map((match) => match[1]);
const first = new Set(["index.html", ...named]);

const sum = { first: [0, 0, 0], all: [0, 0, 0], view: [0, 0, 0], instruments: [0, 0, 0] };
for (const path of files(dist).toSorted()) {
  const bytes = readFileSync(path);
  const sizes = [
    bytes.length,
    gzipSync(bytes, { level: 9 }).length,
    brotliCompressSync(bytes).length,
  ];
  const name = relative(dist, path);
  // With the reader of models.
  const isView = /(^|\/)(picture|model)-[^/]*\.js$/.test(name);
  const isInstruments = /(^|\/)components-[^/]*\.js$/.test(name);
  const isFirst = !isView && !isInstruments && (limit !== undefined || first.has(name));
  const kind = isView ? "view" : isInstruments ? "instruments" : isFirst ? "first" : "later";
  console.log(`${kind.padEnd(11)} ${name.padEnd(44)} ${written(sizes)}`);
  for (const key of kind === "later" ? ["all"] : [kind, "all"])
    sizes.forEach((size, i) => (sum[key][i] += size));
}
console.log(
  `first page ${written(sum.first)}; view ${written(sum.view)}; instruments ${written(sum.instruments)}; everything ${written(sum.all)}`,
);
// A page that works without a server loads everything at once; the bytes on the line count.
const [weighed, most] =
  limit === undefined ? [sum.first[0], FIRST_PAGE_BYTES] : [sum.first[1], Number(limit)];
if (weighed >= most) {
  console.error(`the first page has ${weighed} bytes; ${most} is the limit`);
  process.exit(1);
}
const script = sum.all[1] - sum.view[1];
if (sum.view[1] === 0 || sum.view[1] >= VIEW_BYTES) {
  console.error(`the view has ${sum.view[1]} bytes; ${VIEW_BYTES} is the limit`);
  process.exit(1);
}
if (sum.instruments[1] === 0 || sum.instruments[1] >= INSTRUMENTS_BYTES) {
  console.error(
    `the instruments have ${sum.instruments[1]} bytes; ${INSTRUMENTS_BYTES} is the limit`,
  );
  process.exit(1);
}
if (limit === undefined && script >= WITHOUT_VIEW_BYTES) {
  console.error(
    `the page without the view has ${script} bytes; ${WITHOUT_VIEW_BYTES} is the limit`,
  );
  process.exit(1);
}

function written([plain, gzip, brotli]) {
  return `${kb(plain)} ${kb(gzip)} gzip ${kb(brotli)} brotli`;
}

function kb(bytes) {
  return `${(bytes / 1000).toFixed(1).padStart(7)} kB`;
}
