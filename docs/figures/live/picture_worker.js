// Draws pictures for picture.js in a thread of its own: a long drawing leaves the page alive, which
// can end it. The engine is docs/figures/engine/picture.cpp. After an error, a new copy of it goes on.

import { content } from "./content.js";

const limit = "the scene needs more memory, or deeper recursion, than a page has";
const meshes = new Map();  // of the course: their files' content

class Engine {
  static async open(module) {
    const engine = new Engine();
    // What is thrown in C++, and what a program without files calls of its system and does not get.
    const thrown = (place, size) => { throw Error(engine.text(place, size)); };
    const ends = () => { throw new RangeError("the engine has ended"); };
    const system = new Proxy({}, { get: (_, name) => (name === "proc_exit" ? ends : () => 52) });
    engine.calls = (await WebAssembly.instantiate(module, { page: { thrown }, wasi_snapshot_preview1: system, env: system })).exports;
    engine.calls._initialize();
    return engine;
  }

  bytes(place, size) {
    return new Uint8Array(this.calls.memory.buffer, place, size);
  }
  text(place, size) {
    return new TextDecoder().decode(this.bytes(place, size).slice());
  }
  result(size) {
    return this.bytes(this.calls.picture_result(), size);
  }
  put(text) {
    const given = new TextEncoder().encode(text);
    this.bytes(this.calls.picture_room(given.length), given.length).set(given);
  }

  /// Reads a scene, with its meshes; returns the warnings.
  async read(stage, scene) {
    for (const [, name, file] of scene.matchAll(/^\s*mesh\s+((?:\.\.\/)?(meshes\/\w+\.off))\s/gm)) {
      if (!meshes.has(name)) meshes.set(name, new TextDecoder().decode(await content(`scenes/${file}`)));
      this.put(name + meshes.get(name));
      this.calls.picture_mesh(name.length);
    }
    this.put(scene);
    return new TextDecoder().decode(this.result(this.calls.picture_read(stage)).slice());
  }

  /// The scene with another line of its camera; what stands behind it stays.
  turned(scene, turn) {
    const size = this.calls.picture_camera(...turn);
    const line = new TextDecoder().decode(this.result(size).slice());
    return scene.replace(/^[ \t]*[Cc][ \t][^#\n]*?(?=\s*(#|$))/m, line);
  }
}

let engine = null;

async function drawn({ module, stage, scene, turn, width }) {
  engine ??= await Engine.open(module);
  let warnings = await engine.read(stage, scene);
  if (turn.some((angle) => angle !== 0)) {
    scene = engine.turned(scene, turn);
    warnings = await engine.read(stage, scene);
  }
  const begin = performance.now();
  const pixels = Uint8ClampedArray.from(engine.result(engine.calls.picture_draw(width)));
  return { scene, warnings, pixels, milliseconds: performance.now() - begin };
}

onmessage = async ({ data }) => {
  try {
    postMessage(await drawn(data));
  } catch (error) {
    engine = null;
    postMessage({ error: error instanceof RangeError || error instanceof WebAssembly.RuntimeError ? limit : error.message });
  }
};
