// Compresses the built pages with gzip into web/packed, from where the program takes them: a program with compressed pages is
// smaller. Equal pages give equal files: gzip's head has no time.
import { mkdirSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { gzipSync } from "node:zlib";

const web = new URL("..", import.meta.url).pathname;

function pack(from, to) {
  mkdirSync(to, { recursive: true });
  for (const name of readdirSync(from)) {
    const path = join(from, name);
    if (statSync(path).isDirectory()) pack(path, join(to, name));
    else writeFileSync(join(to, `${name}.gz`), gzipSync(readFileSync(path), { level: 9 }));
  }
}

rmSync(join(web, "packed"), { recursive: true, force: true });
pack(join(web, "dist"), join(web, "packed"));
