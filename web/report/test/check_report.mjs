// node check_report.mjs FILE.html [--screenshots DIR] [--expect-viewer]: checks a report in a browser; exit status 1 if one fails.

import { mkdirSync } from "node:fs";
import { parseArgs } from "node:util";
import { checkFile } from "./page_checks.mjs";

const { values, positionals } = parseArgs({
  allowPositionals: true,
  options: { screenshots: { type: "string", default: "" }, "expect-viewer": { type: "boolean", default: false } },
});
if (values.screenshots) mkdirSync(values.screenshots, { recursive: true });
try {
  for (const line of await checkFile(positionals[0], { screenshots: values.screenshots, expectViewer: values["expect-viewer"] }))
    console.log(`ok: ${line}`);
} catch (error) {
  console.log(`failed: ${error.message}`);
  process.exitCode = 1;
}
