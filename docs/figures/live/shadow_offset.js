// Stage 10: a fixed epsilon in scenes of every size: acne on one side, lost contact on the other,
// and the stage's own shadow ray. Change the size and the epsilon.
import { Figure, add, color, define, minus, times } from "./drawing.js";

const power = (x) => `10${[...String(Math.round(2 * Math.log10(x)) / 2)].map((letter) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[letter] ?? { "-": "⁻", ".": "·" }[letter]).join("")}`;
const named = (x) => (x === 1 ? "1" : power(x));

define("shadow_offset", class extends Figure {
  static height = 452;
  grid = { place: [206, 128], scale: 27 };  // three sizes of the scene, in three ways
  pair = { place: [165, 300], scale: 52 };  // the reference's way, and a fixed epsilon
  view = { ...this.grid };

  setup() {
    this.light = this.handle("light", undefined, { fill: color.amber, keep: ([x, y]) => [x, Math.max(y, 2.2), 0] });
    this.epsilon = this.slider("epsilon", { min: -12, max: 0, step: 0.5, value: -3, power: true });
    this.size = this.slider("size of the scene", { min: -8, max: 8, step: 0.5, value: -3, power: true });
    const light = [-2, 2.6, 0];
    this.cases({ "ε too large": { light, epsilon: 1e-3, size: 1e-8 }, "ε too small": { light, epsilon: 1e-10, size: 1e8 }, "ε right": { light, epsilon: 1e-3, size: 1 } }, undefined, true);
  }

  /// What is seen of a point: "lit" or "dark", by the ball; or "own", blocked by its own shape.
  async fate(way, ball, ground, own) {
    const by_ball = (await this.ask(3, "intersect", way.ray, ball, way.interval)) !== null;
    const by_ground = (await this.ask(4, "intersect", way.ray, ground, way.interval)) !== null;
    return (own === "ball" ? by_ball : by_ground) ? "own" : by_ball || by_ground ? "dark" : "lit";
  }

  /// Points of a scene of this size: their places, and their fates by `shadow_ray` and by a fixed epsilon.
  async points(size) {
    const all = [], shown = this.together ? 45 : 90;  // of each kind
    const surfaces = ((this.surfaces ??= {})[`${this.engine.precision} ${size} ${shown}`] ??= []);  // which the light does not change
    const light = times(size, [this.light.place[0], this.light.place[1], 0.3]);
    const ball = { center: times(size, [0.1, 1, 0]), radius: size }, ground = { point: [0, 0, 0], normal: [0.02, 1, 0.01] };
    for (let i = 0; i < 2 * shown; ++i) {
      const own = i % 2 ? "ball" : "ground", share = (i + 0.5) / (2 * shown);
      const angle = 2 * Math.PI * share, x = 5.2 * share - 2.5;
      const origin = times(size, own === "ball" ? [0.1 + 3 * Math.cos(angle), 1 + 3 * Math.sin(angle), 0.11] : [x, 0.9, 2.7]);
      const target = times(size, own === "ball" ? [0.1, 1, 0.11] : [x, 0, 0]);
      const surface = (surfaces[i] ??= await this.ask(0, "shade", { origin, direction: minus(target, origin) }, own === "ball" ? ball : ground));
      if (surface === null) continue;
      // Points that face away from the light are dark without a shadow ray.
      const facing = surface.geometric_normal.reduce((sum, value, k) => sum + value * (light[k] - surface.point[k]), 0) > 0;
      const fate = async (way) => this.fate(way, ball, ground, own);
      const right = facing ? await fate(await this.ask(10, "shadow_ray", surface, light)) : "dark";
      const with_epsilon = async (epsilon) => (facing ? fate(await this.ask(0, "printed_shadow_ray", surface, light, epsilon)) : right);
      all.push({ place: own === "ball" ? [0.1 + Math.cos(angle), 1 + Math.sin(angle), 0] : [x, 0, 0], right, with_epsilon });
    }
    return all;
  }

  /// The scene at a place of the page: with the fixed epsilon, or without one with `shadow_ray`.
  async draw_scene(sketch, [across, down], { epsilon, size }, all) {
    const { scale } = sketch.view, moved = [across / scale, -down / scale, 0];
    const points = { lit: [], dark: [], own: [], lost: [] };
    sketch.circle(add(moved, [0.1, 1, 0]), 1, { width: 1 });
    sketch.line(add(moved, [-2.6, 0, 0]), add(moved, [2.8, 0, 0]), { width: 1 });
    sketch.circle(add(this.light.place, moved), 0.16, { fill: color.pale_amber, stroke: color.amber });
    for (const { place, right, with_epsilon } of all) {
      const fate = epsilon ? await with_epsilon(epsilon) : right;
      points[fate === "lit" && right === "dark" ? "lost" : fate].push(sketch.screen(add(place, moved)));
    }
    // Disks with a gray rim, as one shape.
    const wide = this.together ? 5 : 8;
    for (const [fate, stroke, width] of [["dark", color.gray, wide], ["lit", color.gray, wide], ["lit", color.pale_amber, wide - 1]])
      sketch.pixels("path", { d: points[fate].map((place) => `M${place.join(" ")}h0`).join(""), stroke_linecap: "round" }, { stroke, width });
    sketch.cells([...points.own, ...points.lost].map(([left, top]) => [left - wide / 2, top - wide / 2, wide, wide]), { fill: color.purple });
    // Within this distance of a point, hits do not count.
    if (epsilon && !this.together) sketch.circle(add(moved, [1.6, 0, 0]), Math.min(99, epsilon / size), { fill: "none", stroke: color.gray, width: 1, dashes: "5 4" });
    const wrong = points.own.length ? "wrong: acne" : points.lost.length ? "wrong: no shadow" : "right";
    sketch.label(add(moved, [0.1, 0, 0]), [0, 20], wrong, wrong === "right" ? color.ink : color.purple);
    return `${points.own.length} points with acne, ${points.lost.length} with lost shadow, of ${all.length}`;
  }

  async draw(sketch) {
    const { "ε too large": { epsilon: large, size: tiny }, "ε too small": { epsilon: small, size: huge } } = this.all, rows = [];
    Object.assign(sketch.view, this.together ? this.grid : this.pair);
    const draw = async (place, title, scene, points) => rows.push([`${title}, scene of size ${named(scene.size)}`, await this.draw_scene(sketch, place, scene, points)]);
    if (this.together) {
      for (const [i, size] of [tiny, 1, huge].entries()) {
        const points = await this.points(size);
        sketch.write([206 + 166 * i, 24], `size ${named(size)}`, color.ink, "middle");
        for (const [j, epsilon] of [large, small, undefined].entries()) await draw([166 * i, 128 * j], epsilon ? `ε = ${power(epsilon)}` : "shadow_ray", { epsilon, size }, points);
      }
      [[`ε = ${power(large)}`], [`ε = ${power(small)}`], ["by the error", "of the point"]].forEach((lines, j) => lines.forEach((line, k) => sketch.write([14, 100 + 128 * j + 20 * (k - (lines.length - 1) / 2)], line)));
    } else {
      const epsilon = this.epsilon.value, size = this.size.value, points = await this.points(size);
      for (const [i, title] of ["ε by the point's error", `fixed ε = ${power(epsilon)}`].entries()) {
        sketch.write([170 + 310 * i, 60], title, color.ink, "middle");
        await draw([310 * i, 0], title, { epsilon: i ? epsilon : undefined, size }, points);
      }
      sketch.write([325, 24], `size ${named(size)}`, color.ink, "middle");
    }
    sketch.write([320, 440], "purple: wrongly lit, or wrongly in its own shadow", color.purple, "middle");
    return rows;
  }
});
