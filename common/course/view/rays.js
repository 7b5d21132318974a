"use strict";
// The outlines of a scene and the rays of one pixel, in three dimensions. All points and texts are
// those that the stage's program prints with --rays; here they are only turned, scaled and drawn.
// No perspective: parallel lines stay parallel, and lengths can be compared.
const space = (() => {
  const canvas = document.getElementById("rays");
  const list = document.getElementById("rays-list");
  const of = document.getElementById("rays-of");
  // Each kind differs in its dashes and its end too, not by its color alone.
  const kinds = {
    eye: {color: "--eye", dash: [], end: "disc", text: tr("from the eye, to what it hits")},
    mirrored: {color: "--mirrored", dash: [14, 4], end: "diamond", text: tr("mirrored")},
    missed: {color: "--mirrored", dash: [14, 4, 2, 4], end: "arrow", text: tr("eye or mirrored: hits nothing")},
    lit: {color: "--lit", dash: [2, 4], end: "ring", text: tr("shadow ray, reaches the light")},
    blocked: {color: "--blocked", dash: [7, 4], end: "cross", text: tr("shadow ray, blocked")}};
  const names = {eye: tr("eye"), mirrored: tr("mirrored"), shadow: tr("shadow")};
  let printed = [null, null];             // what mine and the reference's program print
  let drawing = null;
  let middle = [0, 0, 0], reach = 1;   // of the drawing
  let yaw = 0, pitch = 0.35, zoom = 1, shift = [0, 0];
  let chosen = [-1, -1];               // the first and last ray under the pointer, in the list
  let stageOfView = 0;

  const kindOf = ({kind, hits}) => kind === "shadow" ? (hits ? "blocked" : "lit")
    : hits ? kind : "missed";
  const color = (name) => getComputedStyle(document.documentElement).getPropertyValue(name);

  function prepare(context, width, height) {
    const ratio = devicePixelRatio || 1;
    Object.assign(context.canvas, {width: width * ratio, height: height * ratio});
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.lineCap = "butt";
    context.lineJoin = "round";
  }

  const pixelsOfUnit = () =>
    zoom * Math.min(canvas.clientWidth, 1.4 * canvas.clientHeight) / (2 * reach);

  /// Right, down, and toward the viewer, in pixels.
  function turned(x, y, z) {
    [x, y, z] = [x - middle[0], y - middle[1], z - middle[2]];
    const across = Math.cos(yaw) * x - Math.sin(yaw) * z;
    const toward = Math.sin(yaw) * x + Math.cos(yaw) * z;
    const up = Math.cos(pitch) * y - Math.sin(pitch) * toward;
    const scale = pixelsOfUnit();
    return [canvas.clientWidth / 2 + shift[0] + scale * across,
            canvas.clientHeight / 2 + shift[1] - scale * up,
            scale * (Math.sin(pitch) * y + Math.cos(pitch) * toward)];
  }

  function segments(context, numbers, style, width, alpha) {
    Object.assign(context, {strokeStyle: style, lineWidth: width, globalAlpha: alpha});
    context.beginPath();
    for (let i = 0; i + 5 < numbers.length; i += 6) {
      const [x0, y0] = turned(numbers[i], numbers[i + 1], numbers[i + 2]);
      const [x1, y1] = turned(numbers[i + 3], numbers[i + 4], numbers[i + 5]);
      context.moveTo(x0, y0);
      context.lineTo(x1, y1);
    }
    context.stroke();
    context.globalAlpha = 1;
  }

  /// A line of a kind of ray between two points of the canvas, with its end, on a border in the
  /// background's color.
  function way(context, [x0, y0], [x1, y1], kind, thick, background = "--paper") {
    const {dash, end} = kinds[kind];
    const style = color(kinds[kind].color);
    const [dx, dy] = [x1 - x0, y1 - y0];
    const length = Math.hypot(dx, dy) || 1;
    const [ux, uy] = [dx / length, dy / length];
    const line = () => { context.beginPath(); context.moveTo(x0, y0); context.lineTo(x1, y1);
                         context.stroke(); };
    context.setLineDash([]);
    Object.assign(context, {strokeStyle: color(background), lineWidth: thick + 3, globalAlpha: .75});
    line();
    Object.assign(context, {strokeStyle: style, fillStyle: style, lineWidth: thick, globalAlpha: 1});
    context.setLineDash(dash);
    line();
    context.setLineDash([]);
    const head = (x, y, size) => {
      context.beginPath();
      context.moveTo(x + size * ux, y + size * uy);
      context.lineTo(x - size * ux - size * uy, y - size * uy + size * ux);
      context.lineTo(x - size * ux + size * uy, y - size * uy - size * ux);
      context.fill();
    };
    if (length > 60 && thick > 1.2) head((x0 + x1) / 2, (y0 + y1) / 2, 2 + 1.5 * thick);
    context.beginPath();
    if (end === "disc") { context.arc(x1, y1, 4, 0, 7); context.fill(); }
    if (end === "ring") { context.arc(x1, y1, 4, 0, 7); context.stroke(); }
    if (end === "arrow") head(x1, y1, 6);
    if (end === "diamond") {
      for (const [x, y] of [[6, 0], [0, 6], [-6, 0], [0, -6]]) context.lineTo(x1 + x, y1 + y);
      context.fill();
    }
    if (end === "cross") {
      context.lineWidth = 2;
      for (const [x, y] of [[4, 4], [4, -4]]) {
        context.moveTo(x1 - x, y1 - y);
        context.lineTo(x1 + x, y1 + y);
      }
      context.stroke();
    }
  }

  function paintRay(context, ray, thick) {
    const [x0, y0, z0, x1, y1, z1] = ray.way;
    if (ray.way.includes(null)) return;
    if (ray.rest && thick > 1.5)
      segments(context, ray.rest, color("--blocked"), 1, .35);
    if (ray.normal && !ray.normal.includes(null))
      segments(context, ray.normal, color("--ink"), 1.5, .8);
    way(context, turned(x0, y0, z0), turned(x1, y1, z1), kindOf(ray), thick);
  }

  function paint() {
    if (!drawing) return;
    const context = canvas.getContext("2d");
    prepare(context, canvas.clientWidth, canvas.clientHeight);
    const {outlines, rays, lights, eye, frame} = drawing;
    const isPlane = ({shape}) => shape.startsWith("plane");
    for (const one of outlines)
      if (!one.hit) segments(context, one.segments, color("--outline"), 1, isPlane(one) ? .18 : .5);
    for (const one of outlines)
      if (one.hit) segments(context, one.segments, one.color, isPlane(one) ? 1 : 1.5,
                            isPlane(one) ? .5 : .9);
    // The camera: from its position through the picture's corners.
    const corners = [0, 3, 6, 9].map((i) => frame.slice(i, i + 3));
    const pyramid = corners.flatMap((corner, i) =>
      [...eye, ...corner, ...corner, ...corners[(i + 1) % 4]]);
    segments(context, pyramid, color("--ink"), 1.2, .9);
    context.font = "12px system-ui, sans-serif";
    for (const {at, radius} of lights) {
      const [x, y] = turned(...at);
      const size = Math.max(5, radius * pixelsOfUnit());
      Object.assign(context, {strokeStyle: color("--lit"), lineWidth: 1.5});
      context.beginPath();
      context.arc(x, y, size, 0, 7);
      for (let i = 0; i < 8; ++i) {
        const [c, s] = [Math.cos(i * Math.PI / 4), Math.sin(i * Math.PI / 4)];
        context.moveTo(x + (size + 3) * c, y + (size + 3) * s);
        context.lineTo(x + (size + 8) * c, y + (size + 8) * s);
      }
      context.stroke();
    }
    const shadows = rays.filter(({kind}) => kind === "shadow").length;
    const isChosen = (i) => chosen[0] <= i && i <= chosen[1];
    for (const bold of [false, true])
      rays.forEach((ray, i) => {
        const width = ray.kind === "shadow" ? (shadows > 6 ? 1 : 1.5) : 2.5;
        if (isChosen(i) === bold) paintRay(context, ray, width + (bold ? 1.5 : 0));
      });
    context.fillStyle = color("--ink");
    const [x, y] = turned(...eye);
    context.fillText(names.eye, x - 24, y + 4);
  }

  /// Zooms so that the whole box is on the canvas.
  function fit() {
    [zoom, shift] = [1, [0, 0]];
    const [x0, y0, z0, x1, y1, z1] = drawing.box;
    const corners = [x0, x1].flatMap((x) => [y0, y1].flatMap((y) => [z0, z1].map(
      (z) => turned(x, y, z))));
    const reaches = (axis, size) => Math.max(...corners.map((at) => Math.abs(at[axis] - size / 2))) /
      (size / 2);
    zoom = 0.94 / Math.max(reaches(0, canvas.clientWidth), reaches(1, canvas.clientHeight));
  }

  /// Looks along the camera, or from its right side.
  function face(aside) {
    const [x, y, z] = drawing.facing;
    yaw = Math.atan2(-x, -z) + (aside ? 0.95 : 0);
    pitch = aside ? 0.38 : Math.atan2(-y, Math.hypot(x, z));
    fit();
    paint();
  }

  function makeKinds() {
    document.getElementById("kinds").replaceChildren(...Object.entries(kinds).map(([kind, {text}]) => {
      const item = document.createElement("li");
      const sample = document.createElement("canvas");
      item.append(sample, text);
      const context = sample.getContext("2d");
      prepare(context, 64, 16);
      way(context, [2, 8], [54, 8], kind, 2, "--card");
      return item;
    }));
  }

  /// Successive rays with the same text, such as the shadow rays that reach a light.
  function groups(rays) {
    const all = [];
    rays.forEach((ray, index) => {
      const order = ray.kind === "mirrored" ? ` ${ray.bounces}` : "";
      const text = `${names[ray.kind]}${order}: ${ray.words}`;
      if (all.at(-1)?.text === text) all.at(-1).last = index;
      else all.push({ray, text, first: index, last: index});
    });
    return all;
  }

  function use() {
    const text = printed[+of.value] ?? "";
    const line = text.split("\n").findLast((each) => each.startsWith("{\"rays\":")) ?? "";
    try {
      drawing = JSON.parse(line);
    } catch {
      drawing = null;
    }
    const message = document.getElementById("rays-message");
    message.textContent = drawing
      ? (drawing.left_out ? tr("{number} more shapes are not drawn.", {number: drawing.left_out}) : "") : text.trim();
    document.getElementById("space-parts").hidden = !drawing;
    if (!drawing) return;
    const box = drawing.box;
    middle = [0, 1, 2].map((i) => (box[i] + box[i + 3]) / 2);
    reach = Math.hypot(...[0, 1, 2].map((i) => (box[i + 3] - box[i]) / 2)) || 1;
    chosen = [-1, -1];
    list.replaceChildren(...groups(drawing.rays).map(({ray, text, first, last}) => {
      const item = document.createElement("li");
      item.textContent = (last > first ? `${last - first + 1} × ` : "") + text;
      item.style.borderLeftColor = color(kinds[kindOf(ray)].color);
      item.onmouseenter = () => { chosen = [first, last]; paint(); };
      item.onmouseleave = () => { chosen = [-1, -1]; paint(); };
      return item;
    }));
    makeKinds();
    if (stageOfView === stage) return paint();
    stageOfView = stage;
    face(true);
  }

  async function show(parameters, isCurrent) {
    const answer = await fetch("rays?" + parameters).catch(() => null);
    if (!isCurrent() || !answer || answer.status === 409) return;
    document.getElementById("space").hidden = false;
    printed = answer.ok ? await answer.json() : [await answer.text(), ""];
    use();
  }

  function turn(right, down) {
    yaw -= right;
    pitch = Math.min(Math.max(pitch + down, -Math.PI / 2), Math.PI / 2);
    paint();
  }
  function nearer(factor) {
    zoom = Math.min(Math.max(zoom * factor, 0.2), 50);
    shift = shift.map((pixels) => pixels * factor);
    paint();
  }

  canvas.onpointerdown = (event) => canvas.setPointerCapture(event.pointerId);
  canvas.onpointermove = (event) => {
    if (!canvas.hasPointerCapture(event.pointerId)) return;
    if (event.shiftKey) {
      shift = [shift[0] + event.movementX, shift[1] + event.movementY];
      paint();
    } else {
      turn(event.movementX / 150, event.movementY / 150);
    }
  };
  canvas.onwheel = (event) => {
    event.preventDefault();
    nearer(Math.exp(-event.deltaY / 500));
  };
  const keys = {ArrowLeft: () => turn(-0.1, 0), ArrowRight: () => turn(0.1, 0),
                ArrowUp: () => turn(0, 0.1), ArrowDown: () => turn(0, -0.1),
                "+": () => nearer(1.25), "-": () => nearer(0.8), "0": () => face(true)};
  canvas.onkeydown = (event) => {
    if (!keys[event.key]) return;
    event.preventDefault();
    keys[event.key]();
  };
  document.getElementById("face").onclick = () => face(false);
  document.getElementById("turn-back").onclick = () => face(true);
  of.onchange = use;
  addEventListener("resize", paint);
  matchMedia("(prefers-color-scheme: dark)").onchange = () => { if (drawing) use(); };
  return {show, turned: () => [yaw, pitch, zoom], drawn: () => drawing};
})();
