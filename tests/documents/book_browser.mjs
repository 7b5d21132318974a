// The pages of the book in Chromium: node book_browser.mjs CHROMIUM ADDRESS_OF_A_PAGE PAGE…
//
// Each page is opened in light and dark, and at a phone's width. Prints text that has too little
// contrast (WCAG 2: 4.5 : 1, or 3 : 1 if it is large), controls and figures without a name for a
// screen reader, headings that skip a level, what moves though the reader wants less motion, pages
// that are wider than their window, errors on the console, requests to other hosts, more than 600 kB
// that a page loads (compressed, without pictures of scenes), a search without results, and a link to
// a page in another language that leads to another part of it. With
// AXE=axe.min.js, of axe-core, its findings too. With SHOTS=FOLDER, pictures of the pages are kept
// there, of which one is printed.
import { spawn } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { gzipSync } from "node:zlib";

const [browser, address, ...pages] = process.argv.slice(2);
const shots = process.env.SHOTS;
const axe = process.env.AXE && readFileSync(process.env.AXE, "utf8");
if (!axe) console.log("skipped: the checks of axe-core, which is not installed");
const profile = mkdtempSync(tmpdir() + "/book");
const chromium = spawn(browser, ["--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
  "--hide-scrollbars", "--user-data-dir=" + profile, "--remote-debugging-pipe"],
  { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] });

// ---- DevTools, through its pipe

const waiting = new Map();
const listeners = [];
let session, question = 0, received = "";
chromium.stdio[4].setEncoding("utf8").on("data", (piece) => {
  const messages = (received + piece).split("\0");
  received = messages.pop();
  for (const message of messages.map(JSON.parse)) {
    if (waiting.has(message.id)) waiting.get(message.id)(message);
    else for (const listener of listeners) listener(message);
  }
});

function ask(method, params = {}) {
  const id = ++question;
  chromium.stdio[3].write(JSON.stringify({ id, method, params, sessionId: session }) + "\0");
  return new Promise((done, fail) => waiting.set(id, (answer) => {
    waiting.delete(id);
    answer.error ? fail(new Error(method + ": " + answer.error.message)) : done(answer.result);
  }));
}

async function value(expression) {
  const { result, exceptionDetails } = await ask("Runtime.evaluate",
    { expression, returnByValue: true, awaitPromise: true });
  if (exceptionDetails) throw new Error(exceptionDetails.exception.description);
  return result.value;
}

// Removes a folder into which processes that outlive the browser may write for a moment.
async function remove(folder) {
  for (let tries = 0; ; ++tries) {
    try { return rmSync(folder, { recursive: true, force: true }); } catch (error) {
      if (tries === 100) throw error;
    }
    await new Promise((done) => setTimeout(done, 100));
  }
}

// ---- run in the page

function low_contrast() {
  const channels = (color) => color.match(/[\d.]+/g).map(Number);
  const over = ([r, g, b, a = 1], [R, G, B]) => [r * a + R * (1 - a), g * a + G * (1 - a), b * a + B * (1 - a)];
  const above = (element) => element.assignedSlot ?? element.parentElement ?? element.getRootNode().host;
  function background(element) {
    if (!element) return [255, 255, 255];
    const color = channels(getComputedStyle(element).backgroundColor);
    return color[3] === 0 ? background(above(element))
      : color.length < 4 ? color : over(color, background(above(element)));
  }
  const linear = (x) => (x /= 255) <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4;
  const luminance = ([r, g, b]) => 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
  const found = new Map();
  const shadows = [...document.querySelectorAll("*")].flatMap((element) => element.shadowRoot ?? []);
  const texts = [document.body, ...shadows].flatMap((root) => {
    const walker = document.createTreeWalker(root, NodeFilter.SHOW_TEXT), all = [];
    while (walker.nextNode()) all.push(walker.currentNode);
    return all;
  });
  for (const text of texts) {
    const element = text.parentElement;
    if (!text.data.trim() || !element?.checkVisibility({ visibilityProperty: true, opacityProperty: true })) continue;
    const style = getComputedStyle(element);
    const behind = background(element);
    const color = element instanceof SVGElement ? style.fill : style.color;
    const [low, high] = [luminance(over(channels(color), behind)), luminance(behind)].sort((a, b) => a - b);
    const size = parseFloat(style.fontSize);
    const needed = size >= 24 || (size >= 18.66 && style.fontWeight >= 700) ? 3 : 4.5;
    const ratio = (high + 0.05) / (low + 0.05);
    if (ratio < needed) found.set(element.tagName + "." + element.className, ratio.toFixed(2) + ": " + text.data.trim().slice(0, 30));
  }
  return [...found].map(([name, what]) => name + " " + what);
}

function nameless() {
  const roots = [document, ...[...document.querySelectorAll("*")].flatMap((element) => element.shadowRoot ?? [])];
  const all = roots.flatMap((root) => [...root.querySelectorAll(
    "article a[href], button, input, textarea, summary, canvas, [role=slider], [role=group], [tabindex]")]);
  const is_named = (element) => [element.ariaLabel, element.title, element.textContent, element.querySelector("img")?.alt,
    ...Array.from(element.labels ?? [], (label) => label.textContent)].some((name) => name?.trim());
  const found = all.filter((element) => element.checkVisibility() && !is_named(element))
    .map((element) => `${element.tagName} ${element.className.baseVal ?? element.className} has no name`);
  const levels = Array.from(document.querySelectorAll("article :is(h1, h2, h3, h4, h5)"), (heading) => Number(heading.tagName[1]));
  if (levels[0] !== 1 || levels.filter((level) => level === 1).length !== 1) found.push("there is not one h1, at the beginning");
  if (levels.some((level, i) => level > levels[i - 1] + 1)) found.push("the headings skip a level: " + levels);
  if (!document.documentElement.lang) found.push("the language is not given");
  return found;
}

/// What axe-core finds: the rule, and the element. Browsers move the focus to what scrolls by
/// themselves, and it takes a formula in a header for nothing.
async function violations() {
  const runOnly = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"];
  const rules = { "scrollable-region-focusable": { enabled: false } };
  const found = (await axe.run("article", { runOnly, rules, elementRef: true, resultTypes: ["violations"] })).violations;
  return found.flatMap(({ id, nodes }) => nodes.filter(({ element }) => !element?.querySelector(".katex"))
    .map(({ target }) => `axe: ${id}: ${target.flat().join(" ")}`)).slice(0, 9);
}

function moving() {
  return [...document.getAnimations().map((animation) => `${animation.effect.target.className} moves`),
    ...Array.from(document.querySelectorAll("picture"), (picture) => picture.lastElementChild.currentSrc)
      .filter((source) => !source.includes("still")).map((source) => source + " moves")];
}

/// Until the figures run, of which one is a picture of a scene.
async function figures() {
  const all = [...document.querySelectorAll("article *")].filter((element) => element.localName.startsWith("rt-"));
  const pause = () => new Promise((done) => setTimeout(done, 10));
  for (const figure of all) {
    await customElements.whenDefined(figure.localName);
    if (figure.localName !== "rt-picture") while (!figure.table?.rows.length) await pause();
    else if (location.pathname.endsWith("step03_sphere.html")) {
      figure.shadowRoot.querySelector("button").click();
      while (!figure.finished) await pause();
    }
  }
}

function widest() {
  const ends = (element) => element.getBoundingClientRect().right;
  const all = [...document.querySelectorAll("article *")].filter((element) => !element.closest("pre, .katex, table"));
  const found = all.reduce((a, b) => ends(b) > ends(a) ? b : a);
  return found.tagName + " " + found.textContent.trim().slice(0, 40);
}

const compressed = {};  // the bytes of each file

async function download() {
  let all = 0;
  for (const url of requested) {
    if (/\.(png|webp)$|picture_double/.test(url)) continue;  // the latter when a reader asks for it
    compressed[url] ??= gzipSync(new Uint8Array(await (await fetch(url)).arrayBuffer())).length;
    all += compressed[url];
  }
  return all;
}

const switched = (scheme) => `document.body.setAttribute("data-md-color-scheme", "${scheme}")`;

async function shot(name) {
  if (!shots) return;
  const { data } = await ask("Page.captureScreenshot", { captureBeyondViewport: true });
  writeFileSync(`${shots}/${name}.png`, Buffer.from(data, "base64"));
}

const size = (width, height) =>
  ask("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: 1, mobile: width < 500 });

// ---- all pages

let failed = 0, largest = 0;
let page;
const requested = new Set();  // by the page
const fail = (what) => { failed = 1; console.log(`${page}: ${what}`); };
const origin = new URL(address).origin;
listeners.push(({ method, params }) => {
  if (method === "Network.requestWillBeSent" && params.request.url.startsWith(origin)) requested.add(params.request.url);
  if (method === "Network.requestWillBeSent" && !/^(data|blob):/.test(params.request.url) &&
      new URL(params.request.url).origin !== origin) fail("requests " + params.request.url);
  if (method === "Runtime.exceptionThrown") fail("error: " + params.exceptionDetails.text);
  if (method === "Log.entryAdded" && params.entry.level === "error")
    fail(`error: ${params.entry.text} ${params.entry.url ?? ""}`);
});

try {
  const { targetId } = await ask("Target.createTarget", { url: "about:blank" });
  ({ sessionId: session } = await ask("Target.attachToTarget", { targetId, flatten: true }));
  for (const domain of ["Page", "Network", "Runtime", "Log"]) await ask(domain + ".enable");
  await ask("Emulation.setEmulatedMedia", { features: [{ name: "prefers-reduced-motion", value: "reduce" }] });
  for (page of pages) {
    const name = page.replace(/\W/g, "_");
    requested.clear();
    await size(1280, 1600);
    const loaded = new Promise((done) => listeners.unshift(({ method }) => method === "Page.loadEventFired" && done()));
    await ask("Page.navigate", { url: new URL(page, address).href });
    await loaded;
    listeners.shift();
    await value(`document.querySelectorAll("details").forEach((folded) => folded.open = true);
      document.head.append(Object.assign(document.createElement("style"), {textContent: "* { transition: none !important }"}));
      document.fonts.ready.then(() => 0)`);
    await value(`(${figures})()`);
    for (const lack of await value(`(${nameless})()`)) fail(lack);
    for (const what of await value(`(${moving})()`)) fail(what);
    if (axe) await value(axe + "; 0");
    if (axe) for (const what of await value(`(${violations})()`)) fail(what);
    for (const scheme of ["default", "slate"]) {
      await value(switched(scheme));
      for (const low of await value(`(${low_contrast})()`)) fail(`${scheme}: ${low}`);
      await shot(`${name}_${scheme}`);
    }
    await value(switched("default"));
    await size(400, 1600);
    const width = await value("document.documentElement.scrollWidth");
    if (width > 400) fail(`is ${width} pixels wide in a window of 400: ` + await value(`(${widest})()`));
    await shot(`${name}_400`);
    const bytes = await download();
    if (bytes > 600e3) fail(`loads ${bytes} bytes, compressed`);
    largest = Math.max(largest, bytes);
  }
  if (shots) {
    const { data } = await ask("Page.printToPDF", { printBackground: true });
    writeFileSync(`${shots}/printed.pdf`, Buffer.from(data, "base64"));
  }
  page = "all pages";
  if (await value("document.cookie") !== "") fail("a cookie is set");
  const becomes_true = async (condition, what) => {
    for (let tries = 0; !await value(condition).catch(() => false); ++tries) {  // while a page is loaded
      if (tries === 200) return fail(what);
      await new Promise((done) => setTimeout(done, 100));
    }
  };
  for (const [place, word] of [["", "penumbra"], ...(pages.some((each) => each.includes("fr/")) ? [["fr/", "réfléchi"]] : [])]) {
    await ask("Page.navigate", { url: new URL(`${place}index.html?q=${word}`, address).href });
    await becomes_true("document.querySelectorAll('.md-search-result__item').length > 1",
      `the search for ${word} finds nothing`);
  }
  if (pages.some((each) => each.includes("fr/"))) {
    const part = "step05_triangle.html#what-goes-wrong";
    await ask("Page.navigate", { url: new URL("fr/" + part, address).href });
    for (const [from, to] of [["fr", "en"], ["en", "fr"]]) {
      await becomes_true(`document.documentElement.lang === "${from}" && document.readyState === "complete" &&
        document.getElementById("what-goes-wrong").getBoundingClientRect().top < 150`, `${from}: ${part} is not shown`);
      await value(`location.hash = ""; document.getElementById("what-goes-wrong").scrollIntoView();
        document.querySelector(".md-header a[hreflang=${to}]").click()`);
    }
    await becomes_true(`document.documentElement.lang === "fr" && location.href.endsWith("fr/${part}")`,
      "the links between the languages lead to another place");
    await becomes_true(`(document.querySelector("rt-triangle_areas")?.shadowRoot?.querySelector("summary")?.textContent ??
      "Tous les chiffres") === "Tous les chiffres"`, "a figure in a French page is English");
  }
} finally {
  chromium.kill();
  await new Promise((done) => chromium.on("exit", done));
  await remove(profile);
}
console.log(`the largest page loads ${largest} bytes, compressed`);
process.exit(failed);
