// node check_model.mjs FILE.html OUT.toml [--screenshots DIR]: checks the page of a model in a browser, and writes what it exports.

import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { parseArgs } from "node:util";
import { changed, checkAccessibility, checkWidth, open, pixels, viewersReady, withBrowser } from "./page_checks.mjs";

const LEAST_CHANGE = 200; // pixels

const { values, positionals } = parseArgs({ allowPositionals: true, options: { screenshots: { type: "string", default: "" } } });
const [file, output] = positionals;

function demand(holds, what) {
  if (!holds) throw new Error(what);
  console.log(`ok: ${what}`);
}

const text = (page, selector) => page.$eval(selector, (one) => one.textContent);
const chosen = (page) => page.$eval(".viewer", (one) => one.dataset.faces ?? "");

async function choose(page, number) {
  await page.$eval(".viewer .panel select", (list, wanted) => {
    for (const option of list.options) option.selected = option.value === wanted;
    list.dispatchEvent(new Event("change", { bubbles: true }));
  }, String(number));
}

async function give(page, name) {
  await page.focus(".viewer .names input");
  await page.$eval(".viewer .names input", (one) => (one.value = ""));
  await page.keyboard.type(name);
  await page.keyboard.press("Enter");
}

async function checkPicture() {
  await withBrowser(true, async (browser) => {
    const { page, complaints } = await open(browser, file);
    await viewersReady(page);
    const before = await pixels(page);
    const box = await (await page.$(".viewer canvas")).boundingBox();
    let number = "";
    // The faces of a section are its lines: the middle of the picture may have none.
    for (let part = 0; !number && part < 1; part += 1 / 256) {
      await page.mouse.click(box.x + box.width * part, box.y + box.height / 2);
      number = await chosen(page);
    }
    demand(/^\d+$/.test(number), `a click picks face ${number}`);
    const facts = await text(page, ".viewer .facts");
    demand(facts.includes("body") && /area|length/.test(facts), "the facts of the face are shown");
    demand(changed(before, await pixels(page)) > LEAST_CHANGE, "the face is marked in the picture");
    await give(page, "picked");
    const first = await page.$eval(".viewer .panel select option", (one) => one.value);
    await page.focus(".viewer .panel select"); // by keys alone
    await page.keyboard.press("Home");
    demand((await chosen(page)) === first, `the keyboard chooses face ${first}`);
    await give(page, 'a "quoted" name');
    const toml = await page.$eval(".viewer textarea", (one) => one.value);
    demand(toml.includes("[surfaces.picked]") && toml.includes(`faces = [${number}]`), "the names are written as TOML");
    writeFileSync(output, toml);
    const count = (selector) => page.$$eval(selector, (all) => all.length);
    const all = await count(".viewer .panel select:first-of-type option");
    await page.focus(".viewer input[type=search]");
    await page.keyboard.type(`${number}:`);
    const few = await page.$$eval(".viewer .panel select", ([list]) => list.options.length);
    demand(few > 0 && few < all, `words list ${few} of ${all} faces`);
    await page.$eval(".viewer input[type=search]", (one) => { one.value = ""; one.dispatchEvent(new Event("input")); });
    await give(page, "");
    demand((await text(page, ".viewer .complaint")).includes("name"), "a missing name is said");
    const bodies = await page.$$(".viewer .controls fieldset input");
    const shown = await pixels(page);
    await bodies[0].click();
    demand(changed(shown, await pixels(page)) > LEAST_CHANGE, "a body is switched off");
    await bodies[0].click();
    const groups = await page.$$(".viewer .panel select");
    if (groups.length > 1) {
      await groups[1].focus();
      await page.keyboard.press("Home");
      await page.keyboard.press("ArrowDown");
      demand(typeof (await chosen(page)) === "string", "a group is chosen by the keyboard");
    }
    for (const line of [...(await checkAccessibility(page)), ...(await checkWidth(page))]) console.log(`ok: ${line}`);
    if (values.screenshots) await page.screenshot({ path: join(values.screenshots, "model.png"), fullPage: true });
    await page.setViewport({ width: 390, height: 844 });
    for (const line of await checkWidth(page)) console.log(`ok: ${line}`);
    if (values.screenshots) await page.screenshot({ path: join(values.screenshots, "narrow.png"), fullPage: true });
    demand(!complaints.length, `the browser has no complaints and asks for nothing from a network ${complaints.join("; ")}`);
  });
}

async function checkWithoutPicture() {
  await withBrowser(false, async (browser) => {
    const { page } = await open(browser, file);
    await page.waitForFunction(() => document.querySelector(".viewer").dataset.state === "failed");
    const first = await page.$eval(".viewer .panel select option", (one) => one.value);
    await choose(page, first);
    await give(page, "without");
    const toml = await page.$eval(".viewer textarea", (one) => one.value);
    demand(toml.includes("[surfaces.without]"), "without WebGL the lists give names");
  });
}

try {
  await checkPicture();
  await checkWithoutPicture();
} catch (error) {
  console.log(`failed: ${error.message}`);
  process.exitCode = 1;
}
