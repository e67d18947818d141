// The report's page: what is shown is decided by `view`, which also stands in the address after '#'.
// Reads no files: data.js calls gw_report, and history.js knows the pixels' histories.
"use strict";

const view = {pass: 0, plane: "color", pixel: null, language: "en"};
let report = null;

const by_id = (id) => document.getElementById(id);

function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes))
    if (name.startsWith("on")) made.addEventListener(name.slice(2), value);
    else if (value !== null) made.setAttribute(name, value);
  made.append(...children);
  return made;
}

// ---- words and numbers

function word(key, ...values) {
  return gw_words[view.language][key].replace(/\{(\d)\}/g, (_, i) => values[i]);
}

const number = (value) => value.toLocaleString(view.language);

function time_text(seconds) {
  if (seconds >= 0.9995) return `${seconds.toPrecision(3)} s`;
  if (seconds >= 0.9995e-3) return `${(seconds * 1e3).toPrecision(3)} ms`;
  return `${(seconds * 1e6).toPrecision(3)} µs`;
}

// ---- passes

const shown_pass = () => report.passes.find((pass) => pass.pass === view.pass);
const planes_of = (pass) => Object.keys(pass.planes);  // in the order of their keys
const changed = (pass, plane) => pass.planes[plane].change !== undefined;
// What a pass is about: identifiers where it writes them, else the first plane that it changed.
const telling_plane = (pass) => pass.identifiers && changed(pass, "identifiers") ? "identifiers"
  : planes_of(pass).find((plane) => changed(pass, plane)) ?? "color";
const picture = (name) => `pictures/${name}.png`;
const small_picture = (name) => picture(report.small ? `${name}_small` : name);

function thumb(name, label) {
  if (name === undefined) return element("span", {class: "same", title: label}, "=");
  return element("img", {src: small_picture(name), alt: label, loading: "lazy", title: label});
}

function timeline_entry(pass, slowest) {
  const plane = telling_plane(pass), files = pass.planes[plane];
  const bar = element("span", {class: "bar", "aria-hidden": "true"});
  bar.style.setProperty("--share", slowest > 0 ? pass.estimated_seconds / slowest : 0);
  return element("li", {}, element("button", {
    type: "button", "data-pass": pass.pass, onclick: () => show({pass: pass.pass, plane: view.plane}),
  },
    element("span", {class: "number"}, String(pass.pass)),
    element("span", {class: "label"}, pass.name,
      element("small", {}, plane === "color" ? "" : ` ${word(plane)}`)),
    element("span", {class: "time"}, time_text(pass.estimated_seconds)),
    bar,
    element("span", {class: "thumbs"},
      thumb(files.before, word("before")), thumb(files.after, word("after")),
      thumb(files.change, word(changed(pass, plane) ? "change" : "unchanged")))));
}

function build_timeline() {
  const slowest = Math.max(...report.passes.map((pass) => pass.estimated_seconds));
  by_id("timeline").replaceChildren(...report.passes.map((pass) => timeline_entry(pass, slowest)));
}

// Of a list of buttons one is reached by Tab; the arrow keys move among them.
function mark(buttons, current, attribute) {
  for (const button of buttons) {
    button.setAttribute(attribute, button === current ? "true" : "false");
    button.tabIndex = button === current ? 0 : -1;
  }
}

// Scrolls the list, not the page.
function keep_in_sight(item, list) {
  const box = item.getBoundingClientRect(), frame = list.getBoundingClientRect();
  const margin = 8, bottom = Math.min(frame.bottom, innerHeight) - margin, right = Math.min(frame.right, innerWidth);
  list.scrollBy(Math.min(0, box.left - frame.left) + Math.max(0, box.right - right),
    Math.min(0, box.top - frame.top) + Math.max(0, box.bottom - bottom));
}

function mark_timeline() {
  const buttons = [...by_id("timeline").querySelectorAll("button")];
  const current = buttons.find((button) => Number(button.dataset.pass) === view.pass);
  mark(buttons, current, "aria-current");
  keep_in_sight(current, document.querySelector("nav"));
  if (buttons.includes(document.activeElement)) current.focus();
}

// The parameter set, what is 0 or none in it less loud.
function set_parts(set) {
  return set.split(/([^(), ]+=[^,)]*)/).filter((part) => part !== "").map((part) =>
    /=(0|none)$/.test(part) ? element("span", {class: "off"}, part)
      : part.includes("=") ? element("b", {}, part) : part);
}

function build_heading(pass) {
  by_id("name").replaceChildren(element("span", {class: "number"}, String(pass.pass)), ` ${pass.name}`);
  by_id("set").className = pass.set ? "" : "none";
  by_id("set").replaceChildren(...(pass.set ? set_parts(pass.set) : [word("no_set")]));
}

// ---- planes

function build_planes(pass) {
  const planes = planes_of(pass);
  const tabs = planes.map((plane, i) => element("button", {
    type: "button", role: "tab", id: `tab-${plane}`, "data-plane": plane, "aria-controls": "pictures",
    class: changed(pass, plane) ? "changed" : "", onclick: () => show({plane}),
  }, element("span", {class: "key", "aria-hidden": "true"}, String(i + 1)), word(plane),
    element("small", {}, changed(pass, plane) ? word("changed_pixels", number(pass.planes[plane].pixels))
      : word("not_changed"))));
  const focused = document.activeElement?.parentElement === by_id("planes");
  by_id("planes").replaceChildren(...tabs);
  const current = tabs[planes.indexOf(view.plane)];
  mark(tabs, current, "aria-selected");
  if (focused) current.focus();
}

function pixel_of(event, stage) {
  const box = stage.getBoundingClientRect();
  const place = (at, from, size, pixels) =>
    Math.min(pixels - 1, Math.max(0, Math.floor((at - from) / size * pixels)));
  return [place(event.clientX, box.left, box.width, report.width),
    place(event.clientY, box.top, box.height, report.height)];
}

function stage_with(file, label) {
  if (file === undefined) return element("div", {class: "stage same"}, word("unchanged"));
  const stage = element("div", {class: "stage", "data-picture": file},
    element("img", {src: picture(file), alt: label, width: report.width, height: report.height, draggable: "false"}),
    element("span", {class: "marker", hidden: ""}));
  stage.addEventListener("click", (event) => show({pixel: pixel_of(event, stage)}));
  return stage;
}

function figure(file, label) {
  return element("figure", {}, element("figcaption", {}, label), stage_with(file, label));
}

function build_pictures(pass) {
  const files = pass.planes[view.plane];
  const change = files.times > 1 ? word("change_times", files.times) : word("change");
  by_id("pictures").replaceChildren(
    figure(files.before, word("before")), figure(files.after, word("after")), figure(files.change, change));
  by_id("pictures").setAttribute("aria-labelledby", `tab-${view.plane}`);
  by_id("legend").textContent = word(`legend_${view.plane}`);
}

function mark_pixel() {
  for (const marker of document.querySelectorAll(".marker")) {
    marker.hidden = view.pixel === null;
    if (view.pixel === null) continue;
    marker.style.left = `${100 * (view.pixel[0] + 0.5) / report.width}%`;
    marker.style.top = `${100 * (view.pixel[1] + 0.5) / report.height}%`;
  }
}

// ---- tables

const row = (cells, tag = "td") =>
  element("tr", {}, ...cells.map((cell) => cell instanceof Node && cell.tagName === "TD" ? cell : element(tag, {}, cell)));

function table(id, head, rows) {
  by_id(id).replaceChildren(
    ...(head ? [element("thead", {}, row(head, "th"))] : []), element("tbody", {}, ...rows));
}

function named_row(name, value, kind) {
  return element("tr", {class: kind ?? null}, element("th", {scope: "row"}, name), element("td", {}, value));
}

function build_counters(pass) {
  const counted = Object.entries(pass.counters).filter(([, count]) => count > 0);
  table("counters", null, [...counted.map(([name, count]) => named_row(name, number(count))),
    named_row(word("estimated"), time_text(pass.estimated_seconds), "sum")]);
}

function build_state(pass) {
  table("state", null, pass.state.length
    ? pass.state.map(([name, value]) => named_row(name, value)) : [row([word("state_same")])]);
}

// ---- the history of a pixel

function swatch(color) {
  const most = 2 ** report.profile.color_bits - 1;
  const box = element("i", {class: "swatch", "aria-hidden": "true"});
  box.style.background = `rgb(${color.slice(0, 3).map((c) => 255 * c / most).join(" ")})`;
  return box;
}

function value_cell(plane, value) {
  return plane === "color" ? [swatch(value), value.join(" ")] : [Array.isArray(value) ? value.join(" ") : String(value)];
}

function change_cell(plane, event) {
  const before = event.before[plane], after = event.after[plane];
  const same = String(before) === String(after);
  return element("td", {class: same ? "still" : "moved"},
    ...value_cell(plane, before), ...(same ? [] : [" → ", ...value_cell(plane, after)]));
}

const pass_of_command = (command) =>
  report.passes.find((pass) => command >= pass.first && command < pass.end);

// The call of the program that made the event: report_json.cpp has the rows. "" if it is unknown.
function call_of(event, first) {
  const place = Math.max(event.fragment?.polygon ?? 0, 0);
  const run = (report.calls[event.command - first] ?? []).filter((r) => r[0] <= place).pop();
  if (!run) return "";
  const [begin, before, number, step, after, primitive, ordinal] = run;
  const named = `${before}${number + step * (place - begin)}${after}`;
  return event.fragment && primitive ? `${named}, ${primitive} ${ordinal + place - begin}` : named;
}

function event_row(event, columns) {
  const f = event.fragment, pass = pass_of_command(event.command);
  const first = report.passes.find((p) => p.pass === report.history.first).first;
  const name = report.commands[event.command - first];
  const or_dash = (value) => (value === undefined || value === -1 ? "–" : String(value));
  return element("tr", {class: f ? (f.fate === 3 ? "written" : "killed") : "command",
    "data-pass": pass.pass, "aria-current": pass.pass === view.pass ? "true" : null},
  element("td", {}, element("button", {type: "button", class: "link", onclick: () => show({pass: pass.pass})},
    `${pass.pass} ${pass.name}`)),
  element("td", {class: "outcome"}, f ? word(`fate_${f.fate}`) : name),
  element("td", {}, ...(f ? value_cell("color", f.color) : ["–"])),
  element("td", {}, or_dash(f?.depth)),
  ...columns.map((plane) => change_cell(plane, event)),
  ...[event.command, f?.draw, f?.primitive, f?.polygon].map((value) => element("td", {class: "count"}, or_dash(value))),
  ...(report.calls.length > 0 ? [element("td", {}, call_of(event, first))] : []));
}

function build_events(events) {
  const in_sight = by_id("only").checked
    ? events.filter((event) => pass_of_command(event.command).pass === view.pass) : events;
  const used = (plane) => events.some((event) => event.before[plane].concat(event.after[plane]).some((v) => v !== 0));
  const columns = ["color", "depth", "stencil", ...["back", "accum"].filter(used)];
  const named = (...names) => names.map((name) => word(`column_${name}`));
  table("events", [...named("pass", "outcome", "fragment", "fragment_depth"), ...columns.map((plane) => word(plane)),
    ...named("command", "draw", "primitive", "polygon", ...(report.calls.length > 0 ? ["call"] : []))],
  in_sight.map((event) => event_row(event, columns)));
  note(word("history_count", ...view.pixel, number(in_sight.length), report.history.first, report.history.last));
}

function note(text) {
  by_id("history-note").textContent = text;
}

async function build_history() {
  by_id("events").replaceChildren();
  mark_pixel();
  if (!report.history) return note(word("history_none"));
  if (!view.pixel) return note(`${word("history_ask")} ${word("history_range", report.history.first, report.history.last)}`);
  const [x, y] = view.pixel;
  by_id("x").value = x;
  by_id("y").value = y;
  try {
    const events = await pixel_history(report, x, y);
    if (String(view.pixel) === String([x, y])) build_events(events);
  } catch (error) {
    note(word("history_missing", error.message));
  }
}

// ---- the page as a whole

function build_words() {
  document.documentElement.lang = view.language;
  for (const place of document.querySelectorAll("[data-word]")) place.textContent = word(place.dataset.word);
  for (const place of document.querySelectorAll("[data-label]"))
    place.setAttribute("aria-label", word(place.dataset.label));
  for (const button of document.querySelectorAll("[data-language]"))
    button.setAttribute("aria-pressed", String(button.dataset.language === view.language));
  const seconds = report.passes.reduce((sum, pass) => sum + pass.estimated_seconds, 0);
  const scene = report.scene || report.file;
  document.title = word("title", scene);
  by_id("title").textContent = word("title", scene);
  const whole = report.passes.length === report.passes_of_recording;
  by_id("facts").textContent = word(whole ? "facts" : "facts_part", report.passes.length, report.width, report.height,
    report.profile.name, report.renderer, time_text(seconds), report.passes_of_recording);
  by_id("keys").textContent = word("keys", Math.max(...report.passes.map((pass) => planes_of(pass).length)));
  by_id("machine").textContent = report.time.machine;
  by_id("command").textContent = report.command;
  table("prices", ["count", "stage", "nanoseconds", "source"].map((name) => word(`price_${name}`)),
    report.time.prices.map((price) => row([price.count, price.stage, String(price.nanoseconds),
      (price.estimate ? word("price_estimate") : "") + price.source])));
}

function build_pass() {
  const pass = shown_pass();
  if (!planes_of(pass).includes(view.plane)) view.plane = telling_plane(pass);
  mark_timeline();
  build_heading(pass);
  build_planes(pass);
  build_pictures(pass);
  build_counters(pass);
  build_state(pass);
}

function build_all() {
  build_words();
  build_timeline();
  build_pass();
  build_history();
}

function address() {
  const pixel = view.pixel ? `&pixel=${view.pixel}` : "";
  return `#pass=${view.pass}&plane=${view.plane}&lang=${view.language}${pixel}`;
}

// What the address asks for, as far as there is such a thing.
function view_from(text) {
  const asked = new URLSearchParams(text.slice(1)), wanted = {};
  const pass = Number(asked.get("pass") ?? NaN), pixel = (asked.get("pixel") ?? "").split(",").map(Number);
  if (report.passes.some((p) => p.pass === pass)) wanted.pass = pass;
  if (gw_words.en[asked.get("plane")] !== undefined) wanted.plane = asked.get("plane");
  if (asked.get("lang") in gw_words) wanted.language = asked.get("lang");
  if (pixel.length === 2 && inside(...pixel)) wanted.pixel = pixel;
  return wanted;
}

const inside = (x, y) => Number.isInteger(x) && Number.isInteger(y)
  && x >= 0 && x < report.width && y >= 0 && y < report.height;

// Changes the view, and what depends on it.
function show(wanted) {
  const language = wanted.language ?? view.language;
  const other_words = language !== view.language, other_pixel = wanted.pixel !== undefined;
  Object.assign(view, wanted);
  history.replaceState(null, "", address());
  if (other_words) return build_all();
  if (wanted.pass !== undefined || wanted.plane !== undefined) build_pass();
  if (other_pixel || wanted.pass !== undefined) build_history();
  else mark_pixel();
}

// ---- keys

function step(list, current, key) {
  const at = list.indexOf(current);
  const to = {ArrowLeft: at - 1, ArrowUp: at - 1, ArrowRight: at + 1, ArrowDown: at + 1, Home: 0, End: list.length - 1}[key];
  return to === undefined ? undefined : list[Math.min(list.length - 1, Math.max(0, to))];
}

function key_pressed(event) {
  if (event.altKey || event.ctrlKey || event.metaKey || event.target.closest("input, .scroll")) return;
  const vertical = event.key === "ArrowUp" || event.key === "ArrowDown";
  const in_tabs = event.target.closest("#planes"), in_timeline = event.target.closest("#timeline");
  const planes = planes_of(shown_pass()), plane = planes[Number(event.key) - 1];
  const pass = step(report.passes.map((p) => p.pass), view.pass, event.key);
  if (plane) show({plane});
  else if (event.key === "l" || event.key === "L") show({language: view.language === "en" ? "ja" : "en"});
  else if (in_tabs && step(planes, view.plane, event.key)) show({plane: step(planes, view.plane, event.key)});
  else if (pass !== undefined && (!vertical || in_timeline)) show({pass});
  else return;
  event.preventDefault();
}

function gw_report(data) {
  report = data;
  Object.assign(view, {pass: report.passes[0].pass, plane: telling_plane(report.passes[0]), language: report.language},
    view_from(location.hash));
  for (const input of [by_id("x"), by_id("y")]) input.max = (input.id === "x" ? report.width : report.height) - 1;
  document.documentElement.style.setProperty("--shape", `${report.width} / ${report.height}`);
  document.addEventListener("keydown", key_pressed);
  window.addEventListener("hashchange", () => {
    Object.assign(view, view_from(location.hash));
    build_all();
  });
  for (const button of document.querySelectorAll("[data-language]"))
    button.addEventListener("click", () => show({language: button.dataset.language}));
  by_id("only").addEventListener("change", build_history);
  by_id("pixel").addEventListener("submit", (event) => {
    event.preventDefault();
    show({pixel: [Number(by_id("x").value), Number(by_id("y").value)]});
  });
  build_all();
}
