"use strict";
const $ = (id) => document.getElementById(id);
const both = ["mine", "reference"];
const page = Math.floor(Math.random() * 1e9);
const sliders = {  // name, range on either side of 0 or of the scene's value, step
  x: ["x", 10, 0.05], y: ["y", 10, 0.05], z: ["z", 10, 0.05],
  yaw: [tr("turn right"), 180, 1], pitch: [tr("tilt up"), 90, 1], fov: [tr("field of view"), 0, 1]};

let stage = 0;
let size = {width: 640, height: 480};
let camera = null;                          // the sliders' camera
let moved = false;                          // different from the scene's camera
let programs = "";                          // the programs of the pictures
let broken = "";                            // the compiler's error
let order = 0;                              // of renderings; only the last one is shown
let asked = 0;                              // the number of explanations that were requested
let drafting = false, draftAgain = false;   // while a slider is dragged
let pixel = null;
let images = {};                            // mine and reference: ImageData

const figure = (of) => document.querySelector(`figure[data-of=${of}]`);
const say = (text) => { $("status").textContent = text; };

function parameters(more) {
  const all = {page, stage, moved: +moved, shrink: 1, precision: $("precision").value,
               shade: $("shade").value, term: $("term").value, ...(moved ? camera : {}), ...more};
  return new URLSearchParams(all);
}

// ---- pictures

/// The bytes of a percent-encoded text.
function decode(text) {
  const bytes = (text.match(/%..|./g) ?? []).map(
    (byte) => byte.length > 1 ? parseInt(byte.slice(1), 16) : byte.charCodeAt(0));
  return new TextDecoder().decode(Uint8Array.from(bytes));
}

async function fetchPicture(whose, shrink, mine, range = {}) {
  const query = parameters({order: mine, shrink, whose: both.indexOf(whose), ...range});
  const answer = await fetch("picture?" + query).catch(() => null);
  if (mine !== order || !answer || answer.status === 409) return;
  if (!answer.ok) return showError(whose, await answer.text());
  const report = decode(answer.headers.get("X-Report") ?? "");
  const bitmap = await createImageBitmap(await answer.blob());
  if (mine !== order) return;
  const canvas = $(whose);
  Object.assign(canvas, {width: bitmap.width, height: bitmap.height});
  const context = canvas.getContext("2d", {willReadFrequently: true});
  context.drawImage(bitmap, 0, 0);
  images[whose] = context.getImageData(0, 0, bitmap.width, bitmap.height);
  canvas.classList.toggle("draft", shrink > 1);
  canvas.classList.remove("old");
  figure(whose).querySelector("pre").hidden = true;
  const lines = report.trim().split("\n");
  const legend = lines.findIndex((line) => /^  [a-z]+: /.test(line));
  figure(whose).querySelector("figcaption").textContent =
    (legend < 0 ? lines : lines.slice(0, legend)).join("\n");
  compare();
  return legend < 0 ? null : showLegend(lines.slice(legend).map((line) => line.trim()));
}

/// Shows the legend that a program printed. Returns the ends of its scale, if it has one.
function showLegend([title, ...lines]) {
  const parts = lines.map((line) => /^(#[0-9a-f]{6}) +(?:(\d+) % +)?(.*)$/.exec(line));
  const isScale = parts.some((part) => part?.[2]);
  const bar = $("legend").querySelector("div");
  $("legend").hidden = false;
  $("legend").querySelector("p").textContent = title;
  bar.className = isScale ? "scale" : "";
  bar.style.background = isScale && parts.length > 1 ? "linear-gradient(in oklab to right, " +
    parts.map(([, color, share]) => `${color} ${share}%`).join(", ") + ")" : "";
  bar.replaceChildren(...parts.map((part, index) => {
    const label = document.createElement("span");
    label.textContent = part ? part[3] : lines[index];
    if (isScale) label.style.left = part[2] + "%";
    const patch = document.createElement("i");
    patch.style.background = part?.[1] ?? "none";
    if (!isScale && part) label.prepend(patch);
    return label;
  }));
  return isScale && parts.length > 1 ? {low: parseFloat(parts[0][3]), high: parseFloat(parts.at(-1)[3])} : null;
}

function showError(whose, text) {
  const error = figure(whose).querySelector("pre");
  error.hidden = false;
  error.textContent = text;
  figure(whose).querySelector("figcaption").textContent = "";
  delete images[whose];
  compare();
}

async function draw(shrink = 1) {
  const mine = ++order;
  if (shrink === 1) { say(tr("drawing…")); if (pixel) tell(); }
  $("legend").hidden = true;
  const reference = fetchPicture("reference", shrink, mine);
  // Both pictures have one scale of colors, that of the reference's.
  const range = +$("shade").value > 1 ? await reference : null;
  await Promise.all([reference, broken ? showError("mine", broken)
                                       : fetchPicture("mine", shrink, mine, range ?? {})]);
  if (mine === order && shrink === 1) say(broken ? tr("it does not build") : "");
}

/// Small pictures, one after the other, while a slider is dragged.
async function draft() {
  draftAgain = true;
  if (drafting) return;
  drafting = true;
  while (draftAgain) { draftAgain = false; await draw(3); }
  drafting = false;
}

// ---- the camera

function makeSliders() {
  $("camera").replaceChildren();
  if (!camera) { $("camera").textContent = tr("The scene has no camera."); return; }
  for (const [name, [label, reach, step]] of Object.entries(sliders)) {
    if (stage === 1 && name !== "fov") continue;  // its camera cannot turn yet
    const row = document.createElement("label");
    const slider = document.createElement("input");
    const value = document.createElement("output");
    const middle = "xyz".includes(name) ? camera[name] : 0;
    const [min, max] = name === "fov" ? [5, 150] : [middle - reach, middle + reach];
    row.className = "row";
    Object.assign(slider, {type: "range", id: name, min, max, step, value: camera[name]});
    value.textContent = camera[name].toFixed(step < 1 ? 2 : 0) + (step < 1 ? "" : "°");
    slider.oninput = () => {
      camera[name] = +slider.value;
      value.textContent = camera[name].toFixed(step < 1 ? 2 : 0) + (step < 1 ? "" : "°");
      moved = true;
      $("reset").hidden = false;
      draft();
    };
    slider.onchange = () => { draftAgain = false; draw(); };
    row.append(label, slider, value);
    $("camera").append(row);
  }
}

// ---- the explanation of a pixel

function choose(row, column) {
  pixel = {row: Math.min(Math.max(row, 0), size.height - 1),
           column: Math.min(Math.max(column, 0), size.width - 1)};
  $("row").value = pixel.row;
  $("column").value = pixel.column;
  for (const mark of document.querySelectorAll(".mark")) {
    mark.hidden = false;
    mark.style.left = (pixel.column + 0.5) / size.width * 100 + "%";
    mark.style.top = (pixel.row + 0.5) / size.height * 100 + "%";
  }
  tell();
}

async function tell() {
  const mine = ++asked;
  const query = parameters({order: mine, ...pixel});
  if (stage >= 3) space.show(query, () => mine === asked);
  const answer = await fetch("story?" + query).catch(() => null);
  if (mine !== asked || !answer || answer.status === 409) return;
  if (!answer.ok) { $("explanation").textContent = await answer.text(); return; }
  const {rows, first, unwritten} = await answer.json();
  $("story").hidden = false;
  const firstRow = rows.findIndex(([, , differs]) => differs);
  $("story").replaceChildren(...rows.map(([mine, reference, differs], index) => {
    const line = document.createElement("li");
    line.className = !differs ? "same" : index === firstRow ? "differs first" : "differs";
    for (const [whose, text] of differs ? [["mine", mine], ["reference", reference]]
                                        : [["", mine]]) {
      const cell = document.createElement("span");
      cell.className = whose;
      cell.textContent = text ?? "";
      line.append(cell);
    }
    return line;
  }));
  $("explanation").className = first ? "differ" : "";
  $("explanation").textContent = first ? tr("The first difference: {first}.", {first})
    : tr("Nothing differs.");
  for (const message of unwritten) $("explanation").textContent += `\n${message}`;
  if (broken) $("explanation").textContent += "\n" + tr("Yours is from the last program that was built.");
  let heading = Math.max(firstRow, 0);  // of the first section that differs
  while (heading > 0 && (rows[heading][0] ?? rows[heading][1]).startsWith(" ")) --heading;
  const line = $("story").children[heading];
  $("story").scrollTop = line.offsetTop - $("story").offsetTop;
}

// ---- the stage

/// A sentence about whose files draw the picture.
function parts(started) {
  const used = started.filter((other) => other <= Math.max(stage, 2));  // scenes need stage 2
  const all = Array.from({length: stage}, (_, index) => index + 1);
  const others = all.filter((other) => !used.includes(other));
  if (used.length === 0) return tr("Mine is drawn with the references of all stages.");
  const lists = {used: used.join(", "), others: others.join(", "), stage};
  return (others.length ? tr("Mine is drawn with these stages of yours: {used}, and with the references of: {others}.", lists)
                        : tr("Mine is drawn with your own files of all its stages.")) +
    (used.some((other) => other !== stage)
      ? " " + tr("./course check, compare and explain take the references of all but stage {stage}.", lists) : "");
}

function showNews(news) {
  const sameScene = size.scene === news.programs.split("_")[2];
  size = {width: news.width, height: news.height, scene: news.programs.split("_")[2]};
  $("pictures").style.setProperty("--shape", `${size.width} / ${size.height}`);
  if (!sameScene) {
    camera = news.camera;
    moved = false;
    $("reset").hidden = true;
    $("reset").onclick = () => { size.scene = ""; showNews(news); draw(); };
    makeSliders();
  }
  [...$("stages").children].forEach((chip, index) => {
    chip.lastChild.className = news.started.includes(index + 1) ? "started" : "";
  });
  $("parts").textContent = parts(news.started);
  $("whose-mine").textContent = news.started.includes(stage) ? tr("Mine")
    : tr("Mine ({stage} is not started)", {stage});
  if (news.building) return say(tr("building…"));
  if (programs === news.programs && broken === news.error) return say("");
  [programs, broken] = [news.programs, news.error];
  draw();
}

async function follow(chosen) {
  stage = chosen;
  [programs, broken, pixel, images, size.scene] = ["", "", null, {}, ""];
  ++order;
  ++asked;
  let seen = "";
  document.title = $("title").textContent = `${stage} · ${$("stages").children[stage - 1].title}`;
  for (const whose of both) $(whose).classList.add("old");
  history.replaceState(null, "", "#" + stage);
  for (const row of document.querySelectorAll("[data-from]")) {
    row.hidden = stage < +row.dataset.from;
    if (!row.hidden) continue;
    if (row.tagName !== "OPTION") row.querySelector("select").value = 0;
    else if (row.selected) row.parentElement.value = 0;
  }
  for (const mark of document.querySelectorAll(".mark")) mark.hidden = true;
  $("story").hidden = $("space").hidden = true;
  while (stage === chosen) {
    const news = await fetch(`news?page=${page}&stage=${chosen}&seen=${seen}`)
      .then((answer) => answer.json()).catch(() => null);
    if (stage !== chosen) return;
    if (news) { seen = news.seen; showNews(news); continue; }
    say(tr("./course view was stopped"));
    programs = "";
    await new Promise((done) => setTimeout(done, 2000));
  }
}

async function start() {
  const {first, stages} = await (await fetch("stages")).json();
  stages.forEach((name, index) => {
    const chip = document.createElement("label");
    const radio = document.createElement("input");
    const number = document.createElement("span");
    chip.title = name.slice(7).replaceAll("_", " ");
    Object.assign(radio, {type: "radio", name: "stage", value: index + 1, ariaLabel: chip.title});
    radio.onchange = () => follow(index + 1);
    number.textContent = index + 1;
    chip.append(radio, number);
    $("stages").append(chip);
  });
  const wanted = +location.hash.slice(1);
  const chosen = stages[wanted - 1] ? wanted : first;
  $("stages").querySelector(`[value="${chosen}"]`).checked = true;
  follow(chosen);
}

const moves = {ArrowUp: [-1, 0], ArrowDown: [1, 0], ArrowLeft: [0, -1], ArrowRight: [0, 1]};
for (const canvas of document.querySelectorAll(".picture canvas")) {
  canvas.setAttribute("aria-label", tr("{picture}: arrow keys choose a pixel",
    {picture: canvas.closest("figure").querySelector("h2").textContent.trim().split("\n")[0]}));
  canvas.onclick = (event) => {
    const box = canvas.getBoundingClientRect();
    choose(Math.floor((event.clientY - box.top) / box.height * size.height),
           Math.floor((event.clientX - box.left) / box.width * size.width));
  };
  canvas.onkeydown = (event) => {
    const move = moves[event.key];
    if (!move) return;
    event.preventDefault();
    const step = event.shiftKey ? 10 : 1;
    const from = pixel ?? {row: size.height >> 1, column: size.width >> 1};
    choose(from.row + step * move[0], from.column + step * move[1]);
  };
}
for (const id of ["precision", "shade", "term"]) $(id).onchange = () => draw();
$("gain").onchange = compare;
$("split").oninput = swipe;
$("flip").onclick = flip;
addEventListener("keydown", (event) => {
  if (event.key === "f" && !event.ctrlKey && !event.metaKey && !figure("over").hidden) flip();
});
for (const radio of document.getElementsByName("mode"))
  radio.onchange = () => {
    const over = radio.value === "over";
    $("pictures").classList.toggle("over", over);
    for (const of of [...both, "over"]) figure(of).hidden = over !== (of === "over");
  };
$("pixel").onsubmit = (event) => {
  event.preventDefault();
  choose(+$("row").value, +$("column").value);
};
start();
