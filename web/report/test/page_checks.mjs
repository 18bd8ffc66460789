// Checks of a report in a real browser: headless Chromium with a software implementation of WebGL.

import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import puppeteer from "puppeteer-core";

const require = createRequire(import.meta.url);
const AXE = readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");
const CHROMIUM = process.env.CHROMIUM ?? "/usr/bin/chromium";
const WITH_WEBGL = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"];
const WITHOUT_WEBGL = ["--disable-gpu", "--disable-3d-apis"];
const LONGEST = 600_000; // milliseconds, until a hang is certain on a busy machine too
const LEAST_CHANGE = 200; // pixels
const MOST_NOISE = 0.002; // of the pixels, between two pictures of the same state

export async function withBrowser(webgl, action) {
  const browser = await puppeteer.launch({
    executablePath: CHROMIUM, headless: true, timeout: LONGEST, protocolTimeout: LONGEST,
    args: ["--no-sandbox", "--disable-dev-shm-usage", "--hide-scrollbars", ...(webgl ? WITH_WEBGL : WITHOUT_WEBGL)],
  });
  try {
    return await action(browser);
  } finally {
    await browser.close();
  }
}

// A page that is loaded, with what it complained of.
export async function open(browser, file, { width = 1280, height = 900, script = true } = {}) {
  const page = await browser.newPage();
  page.setDefaultTimeout(LONGEST);
  const complaints = [];
  page.on("console", (message) => ["error", "warn"].includes(message.type()) && complaints.push(message.text()));
  page.on("pageerror", (error) => complaints.push(String(error)));
  page.on("request", (request) => /^(https?|ws):/.test(request.url()) && complaints.push(`network: ${request.url()}`));
  await page.setViewport({ width, height });
  await page.setJavaScriptEnabled(script);
  await page.goto(pathToFileURL(file).href, { waitUntil: "load" });
  return { page, complaints };
}

export async function viewersReady(page) {
  const n = await page.$$eval(".viewer[data-scene]", (all) => all.length);
  for (let i = 0; i < n; i++) {
    await page.evaluate((k) => document.querySelectorAll(".viewer[data-scene]")[k].scrollIntoView(), i);
    await page.waitForFunction((k) => document.querySelectorAll(".viewer[data-scene]")[k].dataset.state === "ready", {}, i);
  }
  return n;
}

const settled = (page) =>
  page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 60)))));

// The pixels of the first view, as bytes of RGBA.
export async function pixels(page) {
  await settled(page);
  const canvas = await page.$(".viewer canvas");
  const png = await canvas.screenshot({ encoding: "base64" });
  const bytes = await page.evaluate(async (data) => {
    const bytes = Uint8Array.from(atob(data), (c) => c.charCodeAt(0));
    const image = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
    const copy = new OffscreenCanvas(image.width, image.height).getContext("2d");
    copy.drawImage(image, 0, 0);
    const blob = new Blob([copy.getImageData(0, 0, image.width, image.height).data]);
    const reader = new FileReader(); // numbers one by one take a second per picture
    return new Promise((done) => {
      reader.onload = () => done(reader.result.split(",")[1]);
      reader.readAsDataURL(blob);
    });
  }, png);
  return Buffer.from(bytes, "base64");
}

export function changed(before, after) {
  let count = 0;
  for (let i = 0; i < before.length; i += 4)
    if (Math.abs(before[i] - after[i]) + Math.abs(before[i + 1] - after[i + 1]) + Math.abs(before[i + 2] - after[i + 2]) > 24)
      count++;
  return count;
}

const set = (page, selector, value, event) =>
  page.$eval(selector, (control, wanted, name) => {
    control.value = wanted;
    control.dispatchEvent(new Event(name, { bubbles: true }));
  }, value, event);

// Selectors of the controls of the first view, by their labels.
async function labels(page) {
  return page.$eval(".viewer", (viewer) =>
    Object.fromEntries([...viewer.querySelectorAll(".control")].flatMap((one) => {
      const label = one.querySelector("label, legend"), control = one.querySelector("select, input");
      return label && control ? [[label.textContent, `#${control.id}`]] : [];
    })));
}

// Each check throws if it fails; the result is a list of sentences.
export async function checkInteraction(page) {
  const done = [];
  const expectChange = async (what, action) => {
    const before = await pixels(page);
    await action();
    const count = changed(before, await pixels(page));
    if (count < LEAST_CHANGE) throw new Error(`${what} changes ${count} pixels only`);
    done.push(`${what} changes the picture (${count} pixels)`);
  };
  const seen = new Set((await pixels(page)).filter((_, i) => i % 4 === 0));
  if (seen.size < 8) throw new Error("the picture is empty");
  const at = await labels(page);
  const first = await pixels(page);
  const fields = await page.$$eval(`${at.Quantity} option`, (all) => all.map((one) => one.textContent));
  const times = Number(await page.$eval(at.Time, (slider) => slider.max)) + 1;
  if (times > 1) {
    await set(page, at.Colours, "all", "change");
    await expectChange("the time slider", () => set(page, at.Time, 0, "input"));
    await set(page, at.Time, times - 1, "input");
  }
  if (fields.length > 1) await expectChange("the quantity", () => set(page, at.Quantity, 1, "change"));
  await set(page, at.Quantity, 0, "change");
  const factors = await page.$$eval(`${at.Deformation} option`, (all) => all.map((one) => one.value));
  if (factors.length > 2) {
    await expectChange("the deformation", () => set(page, at.Deformation, factors[factors.length - 1], "change"));
    await set(page, at.Deformation, 0, "change");
  }
  await expectChange("the section", () => set(page, at.Section, "x", "change"));
  await expectChange("the place of the section", () => set(page, at["Place of the section"], 150, "input"));
  await set(page, at.Section, "", "change");
  const factor = await page.$eval(at.Deformation, (one) => [...one.options].find((option) => option.defaultSelected)?.value ?? "0");
  await set(page, at.Deformation, factor, "change");
  await set(page, at.Colours, "now", "change");
  const again = changed(first, await pixels(page));
  if (again > (MOST_NOISE * first.length) / 4) throw new Error(`the same state gives another picture: ${again} pixels differ`);
  done.push(`the same state gives the same picture (${again} pixels differ)`);
  await page.focus(".viewer canvas");
  await expectChange("an arrow key", async () => {
    for (let i = 0; i < 3; i++) await page.keyboard.press("ArrowRight");
  });
  await expectChange("the plus key", () => page.keyboard.press("+"));
  await page.keyboard.press("0");
  const box = await (await page.$(".viewer canvas")).boundingBox();
  let reading = "";
  for (const [across, down] of [[0.5, 0.5], [0.4, 0.5], [0.5, 0.4], [0.6, 0.6], [0.3, 0.6], [0.7, 0.4], [0.2, 0.7], [0.8, 0.3]]) {
    await page.mouse.click(box.x + across * box.width, box.y + down * box.height);
    reading = await page.$eval(".viewer .reading", (one) => one.textContent);
    if (!reading.startsWith("There is no body")) break;
  }
  if (reading.startsWith("There is no body") || !/\d/.test(reading)) throw new Error(`no value is read: ${reading}`);
  done.push(`a click reads: ${reading}`);
  return done;
}

export async function checkAccessibility(page) {
  await page.evaluate(AXE);
  const result = await page.evaluate(() => globalThis.axe.run(document, { resultTypes: ["violations"] }));
  const found = result.violations.map((one) =>
    `${one.id}: ${one.help} (${one.nodes.slice(0, 3).map((node) => node.html.slice(0, 120)).join(" | ")})`);
  if (found.length) throw new Error(`axe-core: ${found.join("; ")}`);
  return [`axe-core finds nothing in ${result.passes?.length ?? 0} rules`];
}

// Nothing is wider than the window.
export async function checkWidth(page) {
  const [wide, window] = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
  if (wide > window + 1) throw new Error(`the page is ${wide} pixels wide in a window of ${window}`);
  return [`nothing is wider than ${window} pixels`];
}

// The PDF has the still pictures and every row of every table whole on one page.
export async function checkPrint(page, file) {
  await page.emulateMediaType("print");
  const { views, stills, rows } = await page.evaluate(() => {
    const shown = (one) => one.getClientRects().length > 0;
    return {
      views: [...document.querySelectorAll(".viewer")].filter(shown).length,
      stills: [...document.querySelectorAll(".still img")].filter(shown).length,
      rows: [...document.querySelectorAll("tr")].filter((row) => getComputedStyle(row).breakInside !== "avoid").length,
    };
  });
  const pdf = await page.pdf({ path: file, format: "A4", printBackground: true, preferCSSPageSize: true });
  await page.emulateMediaType("screen");
  if (views) throw new Error(`${views} interactive views are printed`);
  if (rows) throw new Error(`${rows} rows of tables may be cut by the end of a page`);
  return [`prints to ${(pdf.length / 1e6).toFixed(1)} MB of PDF with ${stills} still pictures`];
}

export async function checkFile(file, { screenshots = "", expectViewer = false } = {}) {
  const done = [];
  await withBrowser(true, async (browser) => {
    const { page, complaints } = await open(browser, file);
    const n = await viewersReady(page);
    if (expectViewer && !n) throw new Error("there is no interactive view");
    done.push(`${n} interactive views are ready`);
    if (screenshots && n) {
      await page.evaluate(() => document.querySelector(".viewer").scrollIntoView());
      await settled(page);
      await page.screenshot({ path: join(screenshots, "view.png") });
    }
    if (n) done.push(...(await checkInteraction(page)));
    done.push(...(await checkAccessibility(page)), ...(await checkWidth(page)));
    done.push(...(await checkPrint(page, screenshots ? join(screenshots, "report.pdf") : undefined)));
    if (screenshots) {
      await page.evaluate(() => scrollTo(0, 0));
      await page.screenshot({ path: join(screenshots, "wide.png"), fullPage: true });
    }
    await page.setViewport({ width: 390, height: 844 });
    await settled(page);
    done.push(...(await checkWidth(page)));
    if (screenshots) await page.screenshot({ path: join(screenshots, "narrow.png"), fullPage: true });
    if (complaints.length) throw new Error(`the browser complains: ${complaints.join("; ")}`);
    done.push("the browser has no complaints and asks for nothing from a network");
  });
  for (const [name, webgl, script] of [["WebGL", false, true], ["script", true, false]])
    await withBrowser(webgl, async (browser) => {
      const { page } = await open(browser, file, { script });
      for (const figure of await page.$$(".fields")) {
        await figure.scrollIntoView();
        if (script) await page.waitForFunction(() => document.querySelector(".viewer").dataset.state === "failed");
      }
      for (const image of await page.$$(".still img"))
        if (!(await image.boundingBox())) throw new Error(`without ${name} the still pictures are not shown`);
      done.push(`without ${name} the still pictures are shown`);
    });
  return done;
}
