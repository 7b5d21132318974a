// The stages' functions, as figures call them. Arguments and answers go as the bytes of
// common/contract to an engine: the references as WebAssembly, or the student's file, in a worker
// behind ./course book. The engine itself lists its functions and their types (describe.hpp).
import { content } from "./content.js";
import { files, mine } from "./mine.js";

const numbers = Object.fromEntries(Object.entries({ f32: [4, "Float32"], f64: [8, "Float64"], u8: [1, "Uint8"], i32: [4, "Int32"], u32: [4, "Uint32"], bool: [1, "Uint8"] })
  .map(([type, [size, kind]]) => [type, [size, `set${kind}`, `get${kind}`]]));

const room = new DataView(new ArrayBuffer(4096));  // for one question

function put(to, type, value) {
  if (type === "f64") return to.view.setFloat64((to.place += 8) - 8, value, true);
  if (typeof type === "string") {
    const [size, set] = numbers[type];
    to.view[set](to.place, value, true);
    to.place += size;
  } else if (type.parts) value.forEach((part) => put(to, type.parts[1], part));
  else if (type.record) for (const [name, part] of type.record) put(to, part, value[name]);
  else if (type.list) put(to, "u32", value.length), value.forEach((part) => put(to, type.list, part));
  else if (put(to, "bool", value === null ? 0 : 1), value !== null) put(to, type.optional, value);
}

function list(from, length, type) {
  const all = [];
  while (all.length < length) all.push(get(from, type));
  return all;
}

function get(from, type) {
  if (type === "f64") return from.view.getFloat64((from.place += 8) - 8, true);
  if (type === "text") {
    const length = get(from, "u32");
    from.place += length;
    return new TextDecoder().decode(new Uint8Array(from.view.buffer, from.view.byteOffset + from.place - length, length));
  }
  if (typeof type === "string") {
    const [size, , get] = numbers[type];
    from.place += size;
    const value = from.view[get](from.place - size, true);
    return type === "bool" ? value === 1 : value;
  }
  if (type.parts) return list(from, ...type.parts);
  if (type.record) {
    const record = {};
    for (const [name, part] of type.record) record[name] = get(from, part);
    return record;
  }
  if (type.list === "u8") return new Uint8Array(from.view.buffer, (from.place += 4) + from.view.byteOffset, from.view.getUint32(from.place - 4, true));  // a picture, at the end
  if (type.list) return list(from, get(from, "u32"), type.list);
  return get(from, "bool") ? get(from, type.optional) : null;
}

/// True if a value may be an argument of this type: overloads differ by the fields of a record.
const fits = (type, value) => !type.record || (value !== null && typeof value === "object" && type.record.every(([name]) => name in value) && type.record.length === Object.keys(value).length);

class Engine {
  static #opened = {};

  /// The engine of a precision, "double" or "float": loaded once.
  static open(precision) {
    return (Engine.#opened[precision] ??= Engine.#load(precision));
  }

  static async #load(precision) {
    const ends = () => { throw Error("the engine has ended"); };
    // What a program without files calls of its system, and does not get.
    const system = new Proxy({}, { get: (_, name) => (name === "proc_exit" ? ends : () => 52) });
    const { instance } = await WebAssembly.instantiate(await content(`engine_${precision}.wasm`), { page: { thrown: ends }, wasi_snapshot_preview1: system, env: system });
    instance.exports._initialize();
    return new Engine(precision, instance.exports);
  }

  constructor(precision, exports) {
    this.precision = precision;
    this.exports = exports;
    this.functions = {};  // of each stage by their names
    for (const [stage, place, name, ...types] of JSON.parse(new TextDecoder().decode(this.#result(exports.engine_describe()))))
      ((this.functions[stage] ??= {})[name] ??= []).push([place, ...types]);
  }

  #result(size) {
    return new Uint8Array(this.exports.memory.buffer, this.exports.engine_result(), size);
  }

  /// A question as bytes, until the next one, and the type of its answer.
  question(stage, name, values) {
    const all = this.functions[stage][name];
    const [place, parameters, answer] = all.length === 1 ? all[0] : all.find(([, types]) => types.length === values.length && types.every((type, i) => fits(type, values[i])));
    const to = { view: room, place: 0 };
    put(to, "u8", stage);
    put(to, "u8", place);
    parameters.forEach((type, i) => put(to, type, values[i]));
    return [new Uint8Array(room.buffer, 0, to.place), answer];
  }

  /// The reference's answer, as bytes, until the next one.
  reference(bytes) {
    const room = this.exports.engine_room(bytes.length);
    new Uint8Array(this.exports.memory.buffer, room, bytes.length).set(bytes);
    return this.#result(this.exports.engine_ask(bytes.length));
  }

  /// The answer of the student's file, as bytes. Throws the message of `check` if there is none.
  async mine(bytes) {
    const hex = Array.from(bytes, (byte) => byte.toString(16).padStart(2, "0")).join("");
    const reply = await fetch(new URL(`${mine}?precision=${this.precision === "float" ? 1 : 0}&stage=${bytes[0]}&question=${hex}`, import.meta.url));
    if (!reply.ok) throw Error(await reply.text());
    return new Uint8Array(await reply.arrayBuffer());
  }

  read(bytes, type) {
    return get({ view: new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength), place: 0 }, type);
  }
}

/// Reports when a file of the student's is saved, by the event "saved".
async function watch() {
  const state = async () => (await fetch(new URL(files, import.meta.url))).text();
  for (let last = await state(), now; ; last = now) {
    await new Promise((done) => setTimeout(done, 500));
    now = await state();
    if (now !== last) dispatchEvent(new Event("saved"));
  }
}

export const has_mine = mine !== null;
if (has_mine) watch().catch(() => {});  // the server has ended
export const open = (precision) => Engine.open(precision);
open("double").catch(() => {});  // the head of a page begins with it; without it, the drawn figures stay
