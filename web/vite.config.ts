import { defineConfig } from "vitest/config";
import { openbridge } from "./scripts/openbridge.ts";

/**
 * In CI a test of a page in real time that fails is run once more: other programs may have kept the page from drawing. The gate
 * names each test that was run again.
 */
const retry = process.env.CI ? 1 : 0;

// The page asks the server that it came from; in development that is Vite, which hands the socket on to `fenderline serve`.
export default defineConfig({
  base: "./",
  plugins: [openbridge()],
  build: { target: "es2022", assetsInlineLimit: 0, reportCompressedSize: true },
  server: {
    host: "127.0.0.1",
    proxy: {
      "/live": { target: "ws://127.0.0.1:8090", ws: true },
      "/model": "http://127.0.0.1:8090",
    },
  },
  test: {
    projects: [
      {
        test: {
          name: "unit",
          // Nothing is decided by times: other programs may keep the processors busy.
          testTimeout: 60_000,
          include: ["test/**/*.test.ts"],
        },
      },
      {
        test: {
          name: "e2e",
          expect: { poll: { timeout: 20_000 } },
          include: ["e2e/**/*.e2e.ts"],
          exclude: [
            "e2e/speed.e2e.ts",
            "e2e/inbound.e2e.ts",
            "e2e/pictures.e2e.ts",
            "e2e/ten_views.e2e.ts",
          ],
          testTimeout: 450_000,
          hookTimeout: 60_000,
          retry,
          // Much of the time they wait for the ship; more at once would draw too slowly on two processors.
          maxWorkers: 2,
        },
      },
      {
        test: {
          name: "speed",
          include: ["e2e/speed.e2e.ts"],
          testTimeout: 450_000,
          hookTimeout: 60_000,
          sequence: { groupOrder: 1 },
        },
      },
      {
        // A whole passage takes seven minutes, a berthing by the view five: they run before a release.
        test: {
          name: "passage",
          env: { BY_VIEW: "1" },
          expect: { poll: { timeout: 20_000 } },
          include: ["e2e/inbound.e2e.ts", "e2e/alongside.e2e.ts"],
          fileParallelism: false,
          testTimeout: 600_000,
          hookTimeout: 240_000,
          sequence: { groupOrder: 3 },
        },
      },
      {
        // Pictures for the book: made and looked at by a person.
        test: {
          name: "pictures",
          expect: { poll: { timeout: 20_000 } },
          include: ["e2e/pictures.e2e.ts"],
          testTimeout: 900_000,
          sequence: { groupOrder: 4 },
        },
      },
      {
        // Ten views keep any machine busy: this test runs alone.
        test: {
          name: "views",
          include: ["e2e/ten_views.e2e.ts"],
          hookTimeout: 60_000,
          sequence: { groupOrder: 5 },
        },
      },
      {
        test: {
          name: "page",
          expect: { poll: { timeout: 20_000 } },
          include: ["e2e-page/**/*.e2e.ts"],
          testTimeout: 180_000,
          hookTimeout: 60_000,
          retry,
          fileParallelism: false,
          sequence: { groupOrder: 2 },
        },
      },
    ],
  },
});
