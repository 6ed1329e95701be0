// Starts the mock server of web/mock for development: `npm run mock [PORT]`, beside `npm run dev`.
import { runnerImport } from "vite";

const { module } = await runnerImport(new URL("../mock/server.ts", import.meta.url).pathname);
const server = await module.startMock({ port: Number(process.argv[2] ?? 8090), serveDist: true });
console.log(`mock server on ${server.url}`);
for (const [role, token] of Object.entries(server.tokens)) {
  console.log(`  ${role.padEnd(20)} ${server.url}/?token=${token}`);
}
