import { defineConfig } from "vite";
import { openbridge } from "./scripts/openbridge.ts";

const file = (path: string) => new URL(path, import.meta.url).pathname;

/** The page without a server, from `run/` and the npm package that `cargo xtask npm` has built. */
export default defineConfig({
  root: file("run"),
  base: "./",
  plugins: [openbridge()],
  resolve: { alias: { fenderline: file("../crates/wasm/npm/dist/index.js") } },
  build: {
    target: "es2022",
    outDir: file("../target/page"),
    emptyOutDir: true,
    assetsInlineLimit: 0,
    reportCompressedSize: false,
  },
  worker: { format: "es" },
});
