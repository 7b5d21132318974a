// Stage 10: a fixed epsilon in scenes of every size: acne on one side, lost contact on the other,
// and the stage's own shadow ray. Change the size and the epsilon.
import { Figure, add, color, define, minus, short, times } from "./drawing.js";

const shown = 90;  // points of each kind

define("shadow_offset", class extends Figure {
  static height = 282;
  view = { place: [106, 160], scale: 36 };

  setup() {
    this.light = this.handle("light", undefined, { fill: color.amber, keep: ([x, y]) => [x, Math.max(y, 2.2), 0] });
    this.epsilon = this.slider("epsilon", { min: -12, max: 0, step: 0.5, value: -3, power: true });
    this.size = this.slider("size of the scene", { min: -6, max: 6, step: 0.5, value: -3, power: true });
    const light = [-2, 3.6, 0];
    this.cases({ "ε too large": { light, epsilon: 1e-3, size: 10 ** -3.5 }, "ε too small": { light, epsilon: 1e-10, size: 1e6 }, "ε right": { light, epsilon: 1e-3, size: 1 } }, undefined, true);
  }

  /// What is seen of a point: "lit" or "dark", by the ball; or "own", blocked by its own shape.
  async fate(way, ball, ground, own) {
    const hits = async (stage, shape) => (await this.ask(stage, "intersect", way.ray, shape, way.interval)) !== null;
    const by_ball = await hits(3, ball), by_ground = await hits(4, ground);
    return (own === "ball" ? by_ball : by_ground) ? "own" : by_ball || by_ground ? "dark" : "lit";
  }

  /// A scene of this size, so far to the right: with the fixed epsilon, or without one with `shadow_ray`.
  async draw_scene(sketch, side, { title, epsilon, size }) {
    const light = times(size, [this.light.place[0], this.light.place[1], 0.3]);
    const ball = { center: times(size, [0.1, 1, 0]), radius: size }, ground = { point: [0, 0, 0], normal: [0.02, 1, 0.01] };
    const points = { lit: [], dark: [], own: [], lost: [] };
    sketch.circle([0.1 + side, 1, 0], 1, { width: 1 });
    sketch.line([side - 2.6, 0, 0], [side + 2.8, 0, 0], { width: 1 });
    sketch.circle(add(this.light.place, [side, 0, 0]), 0.16, { fill: color.pale_amber, stroke: color.amber });
    for (let i = 0; i < 2 * shown; ++i) {
      const own = i % 2 ? "ball" : "ground", share = (i + 0.5) / (2 * shown);
      const angle = 2 * Math.PI * share, x = 5.2 * share - 2.5;
      const origin = times(size, own === "ball" ? [0.1 + 3 * Math.cos(angle), 1 + 3 * Math.sin(angle), 0.11] : [x, 0.9, 2.7]);
      const target = times(size, own === "ball" ? [0.1, 1, 0.11] : [x, 0, 0]);
      const surface = await this.ask(0, "shade", { origin, direction: minus(target, origin) }, own === "ball" ? ball : ground);
      if (surface === null) continue;
      // Points that face away from the light are dark without a shadow ray.
      const facing = surface.geometric_normal.reduce((sum, value, k) => sum + value * (light[k] - surface.point[k]), 0) > 0;
      const right = facing ? await this.fate(await this.ask(10, "shadow_ray", surface, light), ball, ground, own) : "dark";
      const fate = facing && epsilon ? await this.fate(await this.ask(0, "printed_shadow_ray", surface, light, epsilon), ball, ground, own) : right;
      const [x_page, y_page] = sketch.screen(own === "ball" ? [0.1 + Math.cos(angle) + side, 1 + Math.sin(angle), 0] : [x + side, 0, 0]);
      points[fate === "lit" && right === "dark" ? "lost" : fate].push([x_page, y_page]);
    }
    // Disks with a gray rim, as one shape.
    for (const [fate, stroke, width] of [["dark", color.gray, 5.5], ["lit", color.gray, 5.5], ["lit", color.pale_amber, 4.5]])
      sketch.pixels("path", { d: points[fate].map((place) => `M${place.join(" ")}h0`).join(""), stroke_linecap: "round" }, { stroke, width });
    for (const [fate, fill] of [["own", color.red], ["lost", color.amber]]) sketch.cells(points[fate].map(([left, top]) => [left - 3, top - 3, 6, 6]), { fill });
    // Within this distance of a point, hits do not count.
    if (epsilon && !this.together) sketch.circle([side + 1.6, 0, 0], Math.min(99, epsilon / size), { fill: "none", stroke: color.gray, width: 1, dashes: "5 4" });
    [title, epsilon ? `ε = ${epsilon.toExponential()}` : "ε by the point's error", `size ${short(size, 1)}`].forEach((text, i) => sketch.label([side + 0.1, 0, 0], [0, 24 + 19 * i], text, i ? color.gray : color.ink));
    return `${points.own.length} points with acne, ${points.lost.length} with lost shadow, of ${2 * shown}`;
  }

  async draw(sketch) {
    const size = this.size.value, epsilon = this.epsilon.value, { "ε too large": large, "ε too small": small } = this.all;
    const scenes = this.together ? [{ size: 1 }, { title: "ε too large", ...large }, { title: "ε too small", ...small }] : [{ size }, { title: "fixed ε", epsilon, size }];
    const rows = [];
    for (const [i, scene] of scenes.entries()) {
      const { title = "shadow_ray" } = scene;
      rows.push([`${title}, scene of size ${short(scene.size, 1)}`, await this.draw_scene(sketch, i * (this.together ? 5.95 : 8), { ...scene, title })]);
    }
    sketch.write([320, 246], "red: acne, a point shadows itself", color.red, "middle");
    sketch.write([320, 268], "amber: light where the ball stands in the way", color.amber, "middle");
    return rows;
  }
});
