// node check_ticks.mjs TABLE.json: compares the ticks of legends with the table that the program's own are compared with.

import assert from "node:assert";
import { readFileSync } from "node:fs";
import { roundedTicks } from "../src/numbers.js";

const table = JSON.parse(readFileSync(process.argv[2], "utf8"));
assert.ok(table.length > 5);
for (const { low, high, ticks } of table) {
  const found = roundedTicks(low, high);
  assert.equal(found.length, ticks.length, `${low} to ${high}: ${found}`);
  const range = ticks[ticks.length - 1] - ticks[0];
  for (const [i, tick] of ticks.entries()) assert.ok(Math.abs(found[i] - tick) <= 1e-12 * range, `${low} to ${high}: ${found}`);
}
