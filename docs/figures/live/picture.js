// The picture of a page, drawn from its scene, which can be edited; the camera turns with the mouse.
// <rt-picture stage="3" scene="step03_sphere.rt"> has the picture of the page inside until then.
import { content } from "./content.js";
import { color } from "./drawing.js";
import { tr } from "./words.js";

const degrees_a_pixel = 0.2;
const turns = [["turn right", 180], ["tilt up", 90], ["around the middle", 180]];

const style = `
  :host { display: block; margin: 1em 0; font: 14px sans-serif; color: ${color.ink}; }
  canvas { display: block; width: 100%; max-width: 640px; touch-action: pan-y; cursor: grab; }
  form, output { display: block; max-width: 640px; }
  form { display: flex; flex-wrap: wrap; gap: .3em 1.2em; align-items: center; margin: .5em 0; }
  input { accent-color: ${color.blue}; }
  label { display: inline-flex; align-items: center; gap: .4em; }
  input[type=range] { width: 9em; }
  button { font: inherit; padding: .3em .8em; color: inherit; background: ${color.tint}; border: 1px solid ${color.gray}; border-radius: .3em; cursor: pointer; }
  textarea { box-sizing: border-box; width: 100%; max-width: 640px; height: 14em; resize: vertical; font: 13px/1.4 monospace; white-space: pre; color: inherit; background: ${color.tint}; border: 1px solid ${color.gray}; }
  output { min-height: 1.5em; margin: .3em 0; font: 13px/1.5 monospace; white-space: pre-wrap; overflow-wrap: anywhere; }
  .wrong { color: ${color.red}; font-weight: bold; }
  canvas:has(+ .wrong) { opacity: .4; }
  [hidden] { display: none !important; }
  @media print { slot[hidden] { display: contents !important; } .drawn, button { display: none; } }`;

const page = `
  <slot></slot><button type="button">${tr("Draw it here: edit the scene, turn the camera")}</button>
  <div class="drawn" hidden>
    <canvas tabindex="0" role="img"></canvas>
    <output></output>
    <form><button type="button" hidden>${tr("Show the line")}</button><button type="reset">${tr("The first scene again")}</button></form>
    <textarea aria-label="${tr("the scene, in the format .rt")}" spellcheck="false" autocapitalize="off"></textarea>
  </div>`;

let module = null;  // compiled once for all pictures

const compiled = async () => WebAssembly.compile(await content("picture_double.wasm"));

class Picture extends HTMLElement {
  static widths = [160, 320, 640];  // each is drawn after the one before, if there is time
  static patience = 3000;  // the next one is begun if it takes no longer, in milliseconds
  static longest = 20000;  // then a drawing is ended

  connectedCallback() {
    const root = this.attachShadow({ mode: "open" });
    root.innerHTML = `<style>${style}</style>${page}`;
    const find = (selector) => root.querySelector(selector);
    [this.slotted, this.drawn, this.canvas, this.status] = ["slot", ".drawn", "canvas", "output"].map(find);
    [this.form, this.editor, this.line] = ["form", "textarea", "form button"].map(find);
    this.canvas.ariaLabel = this.querySelector("img").alt;
    this.turns = turns.map((turn) => this.#slider(...turn));
    const begin = find("button");
    begin.addEventListener("click", () => (begin.remove(), this.begin()));
  }

  async begin() {
    this.slotted.hidden = true;
    this.drawn.hidden = false;
    this.first = await (await fetch(new URL(`scenes/${this.getAttribute("scene")}`, import.meta.url))).text();
    this.editor.value = this.scene = this.first;
    this.editor.addEventListener("input", () => this.#edited(this.editor.value));
    this.form.addEventListener("reset", () => setTimeout(() => this.#edited(this.editor.value = this.first)));
    this.form.addEventListener("input", () => this.draw());
    this.form.addEventListener("submit", (event) => event.preventDefault());
    this.line.addEventListener("click", () => this.#select_line());
    this.canvas.addEventListener("pointerdown", (event) => this.canvas.setPointerCapture(event.pointerId));
    this.canvas.addEventListener("pointermove", (event) => {
      // What is held follows the mouse.
      if (this.canvas.hasPointerCapture(event.pointerId)) this.turn(-degrees_a_pixel * event.movementX, degrees_a_pixel * event.movementY);
    });
    this.canvas.addEventListener("keydown", (event) => {
      const way = { ArrowLeft: [-5, 0], ArrowRight: [5, 0], ArrowUp: [0, 5], ArrowDown: [0, -5] }[event.key];
      if (way) event.preventDefault(), this.turn(...way);
    });
    this.draw();
  }

  #slider(name, most) {
    const input = Object.assign(document.createElement("input"), { type: "range", min: -most, max: most, step: 0.2, value: 0, defaultValue: 0 });
    const label = document.createElement("label");
    label.append(tr(name), input);
    this.form.prepend(...this.form.querySelectorAll("label:has([type=range])"), label);
    return input;
  }

  turn(right, up) {
    this.turns[0].value = ((this.turns[0].valueAsNumber + right + 540) % 360) - 180;
    this.turns[1].value = this.turns[1].valueAsNumber + up;
    this.draw();
  }

  #edited(scene) {
    this.scene = scene;
    for (const slider of this.turns) slider.value = 0;
    this.draw();
  }

  #select_line() {
    const lines = this.editor.value.split("\n");
    const start = lines.slice(0, this.wrong - 1).join("\n").length + (this.wrong > 1);
    this.editor.focus();
    this.editor.setSelectionRange(start, start + lines[this.wrong - 1].length);
  }

  // ---- drawing: the coarsest picture at once, finer ones while nothing changes

  draw() {
    if (this.busy && this.width === Picture.widths[0]) this.changed = true;
    else this.#ask(Picture.widths[0]);
  }

  async #ask(width) {
    if (this.busy) this.#end();
    [this.busy, this.changed, this.finished, this.width] = [true, false, false, width];
    module ??= await compiled();
    if (!this.worker) {
      this.worker = new Worker(new URL("picture_worker.js", import.meta.url), { type: "module" });
      this.worker.addEventListener("message", ({ data }) => this.#show(data));
    }
    this.timer = setTimeout(() => (this.#end(), this.#show({ error: `no picture within ${Picture.longest / 1000} s: ./course run has several threads` })), Picture.longest);
    this.asked = { stage: Number(this.getAttribute("stage")), scene: this.scene, turn: this.turns.map((slider) => slider.valueAsNumber), width };
    this.worker.postMessage({ module, ...this.asked });
  }

  #end() {
    this.worker?.terminate();
    clearTimeout(this.timer);
    [this.worker, this.busy] = [null, false];
  }

  #show({ error, scene, warnings, pixels, milliseconds }) {
    clearTimeout(this.timer);
    this.busy = false;
    this.status.className = error ? "wrong" : "";
    this.wrong = Number(/^scene\.rt:(\d+):/.exec(error)?.[1] ?? 0);
    this.line.hidden = this.wrong === 0;
    if (error) this.status.textContent = tr(error);
    else {
      const { width } = this, image = new ImageData(pixels, width);
      Object.assign(this.canvas, { width, height: image.height });
      this.canvas.getContext("2d").putImageData(image, 0, 0);
      this.status.textContent = [`${width} × ${image.height} pixels, ${(milliseconds / 1000).toFixed(2)} s`, ...warnings.split("\n")].map((line) => tr(line)).join("\n");
      if (this.asked.scene === this.scene && this.editor.value !== scene) this.editor.value = scene;
    }
    const next = Picture.widths[Picture.widths.indexOf(this.width) + 1];
    if (this.changed) this.draw();
    else if (!error && next && milliseconds * (next / this.width) ** 2 < Picture.patience) this.#ask(next);
    else this.finished = true;
  }
}

customElements.define("rt-picture", Picture);
