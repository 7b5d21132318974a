// Stage 10: a fixed epsilon in scenes of every size: acne on one side, lost contact on the other,
// and the stage's own shadow ray. Change the size and the epsilon.
import { Figure, color, define, times } from "./drawing.js";

const shown = 90;  // points of each kind

define("shadow_offset", class extends Figure {
  static height = 350;
  view = { place: [165, 245], scale: 52 };

  setup() {
    this.light = this.handle("light", undefined, { fill: color.amber, keep: ([x, y]) => [x, Math.max(y, 2.2), 0] });
    this.epsilon = this.slider("epsilon", { min: -12, max: 0, step: 0.5, value: -3, power: true });
    this.size = this.slider("size of the scene", { min: -6, max: 6, step: 0.5, value: -3, power: true });
    const light = [-2, 3.6, 0];
    this.cases({ "ε too large": { light, epsilon: 1e-3, size: 10 ** -3.5 }, "ε too small": { light, epsilon: 1e-10, size: 1e6 }, "ε right": { light, epsilon: 1e-3, size: 1 } });
  }

  /// What is seen of a point: "lit" or "dark", by the ball; or "acne", blocked by its own shape.
  async fate(way, ball, ground, own) {
    const hits = async (stage, shape) => (await this.ask(stage, "intersect", way.ray, shape, way.interval)) !== null;
    const by_ball = await hits(3, ball), by_ground = await hits(4, ground);
    return (own === "ball" ? by_ball : by_ground) ? "own" : by_ball || by_ground ? "dark" : "lit";
  }

  async draw(sketch) {
    const size = this.size.value, light = times(size, [this.light.place[0], this.light.place[1], 0.3]);
    const ball = { center: times(size, [0.1, 1, 0]), radius: size }, ground = { point: [0, 0, 0], normal: [0.02, 1, 0.01] };
    const counts = { ours: { own: 0, lost: 0 }, printed: { own: 0, lost: 0 } };
    const x_of = { ours: 0, printed: 6.1 };
    for (const side of [0, x_of.printed]) {
      sketch.circle([0.1 + side, 1, 0], 1, { width: 1 });
      sketch.line([side - 2.6, 0, 0], [side + 2.8, 0, 0], { width: 1 });
    }
    for (let i = 0; i < 2 * shown; ++i) {
      const own = i % 2 ? "ball" : "ground", share = (i + 0.5) / (2 * shown);
      const angle = 2 * Math.PI * share, x = 5.2 * share - 2.5;
      const origin = times(size, own === "ball" ? [0.1 + 3 * Math.cos(angle), 1 + 3 * Math.sin(angle), 0.11] : [x, 0.9, 2.7]);
      const target = times(size, own === "ball" ? [0.1, 1, 0.11] : [x, 0, 0]);
      const surface = await this.ask(0, "shade", { origin, direction: target.map((value, k) => value - origin[k]) }, own === "ball" ? ball : ground);
      if (surface === null) continue;
      // Points that face away from the light are dark without a shadow ray.
      const facing = surface.geometric_normal.reduce((sum, value, k) => sum + value * (light[k] - surface.point[k]), 0) > 0;
      const ways = { ours: await this.ask(10, "shadow_ray", surface, light), printed: await this.ask(0, "printed_shadow_ray", surface, light, this.epsilon.value) };
      const fates = {};
      for (const kind of ["ours", "printed"]) fates[kind] = facing ? await this.fate(ways[kind], ball, ground, own) : "dark";
      for (const kind of ["ours", "printed"]) {
        const lost = fates[kind] === "lit" && fates.ours === "dark";
        if (fates[kind] === "own") ++counts[kind].own;
        if (lost) ++counts[kind].lost;
        const at = own === "ball" ? [0.1 + Math.cos(angle), 1 + Math.sin(angle), 0] : [x, 0, 0];
        const [cx, cy] = sketch.screen([at[0] + x_of[kind], at[1], 0]);
        const wrong = fates[kind] === "own" ? color.red : color.amber;
        if (fates[kind] === "own" || lost) sketch.pixels("rect", { x: cx - 4, y: cy - 4, width: 8, height: 8 }, { fill: wrong });
        else sketch.pixels("circle", { cx, cy, r: 3 }, { fill: fates[kind] === "lit" ? color.pale_amber : color.gray, stroke: color.gray, width: 0.5 });
      }
    }
    // Within this distance of a point, hits do not count.
    sketch.circle([x_of.printed + 1.6, 0, 0], Math.min(99, this.epsilon.value / size), { fill: "none", stroke: color.gray, width: 1, dashes: "5 4" });
    for (const [kind, title] of [["ours", "shadow_ray"], ["printed", `fixed ε = ${this.epsilon.value.toExponential()}`]])
      sketch.label([x_of[kind] + 0.1, 0, 0], [0, 34], title);
    sketch.shape("text", { x: 320, y: 312, text_anchor: "middle", style: `fill: ${color.red}` }, "red squares: acne, a point shadows itself");
    sketch.shape("text", { x: 320, y: 334, text_anchor: "middle", style: `fill: ${color.amber}` }, "amber squares: light where the ball stands in the way");
    const row = (kind) => `${counts[kind].own} points with acne, ${counts[kind].lost} with lost shadow, of ${2 * shown}`;
    return [["size of the scene", `${size.toExponential()}`], ["shadow_ray", row("ours")], ["fixed epsilon (CR §3.2)", row("printed")]];
  }
});
