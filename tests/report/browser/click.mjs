// Opens reports from disk in headless Chromium, offline, and uses them as a person would: mouse, then keyboard.
// Run by `check`, which makes the reports.
import assert from "node:assert/strict";
import {execFileSync} from "node:child_process";
import {pathToFileURL} from "node:url";
import {resolve} from "node:path";
import {chromium} from "playwright-core";

const browser = await chromium.launch({executablePath: process.env.BROWSER, args: ["--no-sandbox", "--disable-gpu"]});

// A report's page, that must not ask for anything but its own files nor complain.
async function opened(folder, hash = "") {
  const context = await browser.newContext({offline: true, viewport: {width: 1600, height: 1000}});
  context.setDefaultTimeout(120_000);  // a busy machine is slow, not wrong
  const page = await context.newPage();
  page.on("request", (request) => assert.ok(request.url().startsWith("file:") || request.url().startsWith("data:"), request.url()));
  page.on("pageerror", (error) => assert.fail(`${folder}: ${error}`));
  page.on("console", (message) => assert.notEqual(message.type(), "error", message.text()));
  await page.goto(`${pathToFileURL(resolve(folder, "index.html"))}${hash}`);
  await page.waitForSelector("#timeline button");
  return page;
}

const heading = (page) => page.textContent("#name");
const selected_tab = (page) => page.getAttribute("#planes [aria-selected=true]", "data-plane");
const passes = (page) => page.locator("#timeline button");
const loaded = (page, selector) =>
  page.waitForFunction((s) => [...document.querySelectorAll(s)].every((i) => i.complete && i.naturalWidth > 0), selector);

// Shows the pixel's history by clicking it in the picture after the pass.
async function click_pixel(page, x, y, width, height) {
  const stage = page.locator(".stage[data-picture]").nth(1), box = await stage.boundingBox();
  await stage.click({position: {x: (x + 0.5) / width * box.width, y: (y + 0.5) / height * box.height}});
  await page.waitForFunction((text) => document.getElementById("history-note").textContent.includes(text), `${x}, ${y}`);
}

// As rows of words, without the pass.
const rows_shown = (page) => page.$$eval("#events tbody tr", (rows) => rows.map((row) =>
  [...row.children].slice(1).map((cell) => cell.textContent)));

function rows_of_gw(recording, x, y, keep = () => true) {
  const json = JSON.parse(execFileSync(process.env.GW, ["pixel", recording, String(x), String(y), "--json", "--quiet"]));
  const value = (v) => (Array.isArray(v) ? v.join(" ") : String(v));
  const change = (event, plane) => {
    const before = value(event.before[plane]), after = value(event.after[plane]);
    return before === after ? before : `${before} → ${after}`;
  };
  const accum = json.events.some((e) => [...e.before.accum, ...e.after.accum].some((sum) => sum !== 0));
  return json.events.filter(keep).map((e) => [
    e.fate === undefined ? e.command_name : e.fate === "written" ? "written" : `killed: ${e.fate}`,
    e.color ? value(e.color) : "–", value(e.depth ?? "–"),
    ...["color", "depth", "stencil", ...(accum ? ["accum"] : [])].map((plane) => change(e, plane)),
    String(e.command), value(e.draw ?? "–"), value(e.primitive ?? "–"), value(e.polygon ?? "–"),
  ]);
}

const tests = {
  async "passes are listed with their pictures, and a click shows one"() {
    const page = await opened("rings");
    assert.equal(await passes(page).count(), 8);
    await loaded(page, ".stage img");
    await passes(page).nth(3).click();
    assert.equal(await heading(page), "3 ambient key");
    assert.match(await page.textContent("#set"), /\(Ka=object, Kd=0, Ks=0, Ke=0, Map=ambient map\)/);
    assert.equal(await page.getAttribute("#timeline [aria-current=true]", "data-pass"), "3");
    await loaded(page, ".stage img");
    assert.equal(await page.locator(".stage[data-picture]").count(), 3);
    assert.match(await page.textContent("#counters"), /fragments/);
    assert.match(await page.textContent("#counters .sum"), /estimated time on a VGX[\d.]+ (ms|µs|s)/);
    assert.match(await page.textContent("#state"), /color_source/);
  },

  async "every plane has its picture, before, after and difference"() {
    const page = await opened("rings", "#pass=0&plane=color");
    assert.equal(await page.locator("#planes button").count(), 5);
    for (const plane of ["color", "depth", "stencil", "accum", "polygons"]) {
      await page.click(`#tab-${plane}`);
      assert.equal(await selected_tab(page), plane);
      await loaded(page, ".stage img");
      assert.ok((await page.textContent("#legend")).length > 10);
    }
    await page.click("#tab-depth");
    assert.match(await page.getAttribute(".stage >> nth=1", "data-picture"), /^0000_depth$/);
    assert.match(await page.textContent("#tab-depth small"), /[\d,]+ pixels changed/);
    await page.click("#tab-accum");
    assert.equal(await page.locator(".stage.same").count(), 1);
  },

  async "a click on a pixel shows the history that gw pixel prints"() {
    const page = await opened("rings", "#pass=3&plane=color");
    for (const [x, y] of [[48, 36], [10, 60], [95, 0], [0, 71], [64, 7]]) {
      await click_pixel(page, x, y, 96, 72);
      assert.deepEqual(await rows_shown(page), rows_of_gw("rings.gwt", x, y), `pixel ${x} ${y}`);
      assert.equal(await page.inputValue("#x"), String(x));
    }
    await click_pixel(page, 60, 39, 96, 72);
    await page.check("#only");
    const here = (event) => event.pass === 3;
    assert.deepEqual(await rows_shown(page), rows_of_gw("rings.gwt", 60, 39, here));
    await page.uncheck("#only");
    await page.locator("#events .link").last().click();
    assert.equal(await heading(page), "7 specular fill");
  },

  async "the language is switched, and stays with the address"() {
    const page = await opened("rings", "#pass=3&plane=stencil");
    assert.equal(await page.getAttribute("html", "lang"), "en");
    await page.click("[data-language=ja]");
    assert.equal(await page.getAttribute("html", "lang"), "ja");
    assert.match(await page.textContent("#tab-stencil"), /ステンシル/);
    assert.match(await page.textContent("#facts"), /推定時間/);
    assert.equal(await heading(page), "3 ambient key");
    assert.match(page.url(), /lang=ja/);
    const left = await page.$$eval("[data-word]", (all) => all.filter((e) => e.textContent === "").length);
    assert.equal(left, 0);
    await page.reload();
    assert.equal(await page.getAttribute("html", "lang"), "ja");
    assert.equal(await page.evaluate(() => Object.keys(gw_words.en).join() === Object.keys(gw_words.ja).join()), true);
  },

  async "the keyboard reaches everything"() {
    const page = await opened("rings", "#pass=0&plane=color");
    const key = (name) => page.keyboard.press(name);
    await key("ArrowRight");
    assert.equal(await heading(page), "1 count winners");
    await key("End");
    assert.equal(await heading(page), "7 specular fill");
    assert.equal(await page.evaluate(() => scrollY), 0);
    const seen = await page.evaluate(() => document.querySelector("#timeline [aria-current=true]").getBoundingClientRect().bottom <= innerHeight);
    assert.ok(seen, "the pass is in sight in the list");
    await key("ArrowRight");
    assert.equal(await heading(page), "7 specular fill");
    await key("Home");
    assert.equal(await heading(page), "0 depth");
    await key("2");
    assert.equal(await selected_tab(page), "depth");
    await key("l");
    assert.equal(await page.getAttribute("html", "lang"), "ja");
    await key("l");
    // Tab: skip link, languages, the one pass that is shown, then the planes.
    const focused = () => page.evaluate(() => document.activeElement.dataset.language
      ?? document.activeElement.dataset.pass ?? document.activeElement.dataset.plane ?? document.activeElement.id ?? "");
    await page.evaluate(() => document.activeElement.blur());
    const order = [];
    for (let i = 0; i < 7; ++i) {
      await key("Tab");
      order.push(await focused());
      const outline = await page.evaluate(() => getComputedStyle(document.activeElement).outlineStyle);
      assert.notEqual(outline, "none", order.join());
    }
    assert.deepEqual(order.slice(1), ["en", "ja", "0", "depth", "pictures", "x"]);
    await page.fill("#x", "48");
    await page.fill("#y", "36");
    await key("Enter");
    await page.waitForSelector("#events tbody tr");
    assert.deepEqual(await rows_shown(page), rows_of_gw("rings.gwt", 48, 36));
    await page.focus("#timeline [aria-current=true]");
    await key("ArrowDown");
    assert.equal(await focused(), "1");
    await page.focus("#planes [aria-selected=true]");
    await key("ArrowRight");
    assert.equal(await selected_tab(page), "stencil");
    assert.equal(await focused(), "stencil");
    assert.equal(await heading(page), "1 count winners");
  },

  async "part of a recording: its passes, its histories, its language"() {
    const page = await opened("part");
    assert.equal(await page.getAttribute("html", "lang"), "ja");
    assert.equal(await passes(page).count(), 4);
    assert.equal(await heading(page), "2 count pixels");
    await page.click("[data-language=en]");
    assert.match(await page.textContent("#history-note"), /passes 3 to 4/);
    await page.keyboard.press("1");
    await click_pixel(page, 48, 36, 96, 72);
    const kept = (event) => event.pass === 3 || event.pass === 4;
    assert.deepEqual(await rows_shown(page), rows_of_gw("rings.gwt", 48, 36, kept));
  },

  async "a run of a hidden-surface algorithm shows its identifiers"() {
    const page = await opened("newell");
    await loaded(page, ".stage img");
    assert.equal(await selected_tab(page), "identifiers");
    await page.keyboard.press("6");
    assert.equal(await selected_tab(page), "identifiers");
    await page.keyboard.press("1");
    await click_pixel(page, 32, 24, 64, 48);
    assert.deepEqual(await rows_shown(page), rows_of_gw("newell.gwt", 32, 24));
  },

  async "the page fits screens and walls without a horizontal bar"() {
    const page = await opened("rings", "#pass=3&plane=color");
    for (const [width, height] of [[640, 800], [1024, 768], [1280, 800], [1920, 1080], [3840, 2160]]) {
      await page.setViewportSize({width, height});
      const over = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
      assert.ok(over <= 0, `${width} x ${height}: ${over} too wide`);
    }
    const size = await page.evaluate(() => parseFloat(getComputedStyle(document.body).fontSize));
    assert.ok(size >= 26, `${size} pixels at 3840`);
  },
};

let failed = 0;
for (const [name, test] of Object.entries(tests)) {
  try {
    await test();
    console.log(`ok: ${name}`);
  } catch (error) {
    ++failed;
    console.log(`FAILED: ${name}\n${error.stack}`);
  }
}
await browser.close();
process.exit(failed ? 1 : 0);
