// Stage 4: the horizon, and an epsilon that removes the ground below it. Drag the ray.
import { RayFigure, ahead, at, color, define, minus, short } from "./drawing.js";

const ground = { point: [0, 0, 0], normal: [0, 1, 0] };
const strip = 80;

define("plane_horizon", class extends RayFigure {
  static height = 310;
  view = { place: [108, 245], scale: 80 };

  setup() {
    this.origin = this.handle("eye", [0, 1, 0], { keep: ([, y]) => [0, Math.max(y, 0.1), 0] });
    this.tip = this.handle("direction", undefined, { fill: color.blue });
    this.epsilon = this.slider("epsilon", { min: -12, max: 0, step: 0.5, value: -1, power: true });
    this.length = this.slider("length of directions", { min: -6, max: 0, step: 1, value: 0, power: true });
    const toward = (y, exponent = -1) => ({ origin: [0, 1, 0], tip: [1, y, 0], epsilon: 10 ** exponent, length: 1 });
    this.cases({ "⟨d, n⟩ < 0": toward(0.65), "nearly parallel": toward(0.92), "⟨d, n⟩ = 0": toward(1), "⟨d, n⟩ > 0": toward(2) }, "⟨d, n⟩ < 0", true);
  }

  async draw(sketch) {
    const origin = this.origin.place, epsilon = this.epsilon.value, scale = this.length.value;
    const scaled = (direction) => ({ origin, direction: direction.map((x) => x * scale) });
    sketch.polygon([[-1.3, 0, 0], [4.6, 0, 0], [4.6, -0.3, 0], [-1.3, -0.3, 0]], { fill: color.tint });
    sketch.line([-1.3, 0, 0], [4.6, 0, 0], { width: 2 });
    sketch.arrow([-0.6, 0, 0], [-0.6, 0.6, 0], { stroke: color.green, width: 2 });
    sketch.label([-0.6, 0.6, 0], [-10, 6], "$n$", color.green);
    sketch.label(origin, [-16, -8], "$o_r$");
    sketch.line(origin, [4.6, origin[1], 0], { stroke: color.gray, width: 1, dashes: "4 4" });
    for (const [name, seen] of Object.entries(this.rays)) {
      const ray = scaled(seen.direction), [x] = seen.direction;
      const t = await this.ask(4, "intersect", ray, ground, ahead), kept = await this.ask(0, "intersect_with_epsilon", ray, ground, ahead, epsilon);
      const roots = await this.roots(4, ray, ground), end = roots.length && roots[0] > 0 ? Math.min(4.5, Math.hypot(...minus(at(ray, roots[0]), origin))) : name ? 2.2 : 6;
      if (name) sketch.arrow(origin, at(seen, end / Math.hypot(...seen.direction)), { stroke: color.blue, width: 1.8 });
      else sketch.ray(seen, end);
      if (name && seen.direction[1] > 0) sketch.line(origin, at(ray, roots[0]), { stroke: color.blue, width: 1.2, dashes: "4 4" });
      for (const root of roots) {
        const p = at(ray, root), inside = p[0] < 4.6;
        sketch.mark(p, root === t && kept !== null ? "hit" : "refused");
        sketch.label([Math.min(p[0], 4.6), 0, 0], [inside ? 0 : 12, 22], `$t$ = ${short(root)}${inside ? "" : " →"}`, root === t ? color.red : color.gray, inside ? "middle" : "end");
        if (root === t && kept === null) sketch.label([4.6, 0, 0], [0, 46], `|⟨$d_r$, $n$⟩| < ε: refused`, color.purple, "end");
      }
    }
    const ray = scaled(this.ray.direction);
    const t = await this.ask(4, "intersect", ray, ground, ahead), printed = await this.ask(0, "intersect_with_epsilon", ray, ground, ahead, epsilon);
    const beyond = await this.ask(4, "intersect", ray, ground, { min: 5, max: Infinity });
    const tilted = await this.ask(4, "normal", { point: [0, 0, 0], normal: [0, 3, 4] }, [0, 0, 0]);
    // A column of pixels, from above the horizon downwards.
    const bars = {};
    for (let i = 0; i < strip; ++i) {
      const column = scaled([1, 0.2 - (1.2 * (i + 0.5)) / strip, 0]);
      const hits = (await this.ask(4, "intersect", column, ground, ahead)) !== null;
      const kept = (await this.ask(0, "intersect_with_epsilon", column, ground, ahead, epsilon)) !== null;
      [[530, hits], [575, kept]].forEach(([x, ground_is_seen]) => {
        const is_lost = hits && !ground_is_seen;  // narrower too
        (bars[ground_is_seen ? "gray" : is_lost ? "purple" : "faint"] ??= []).push([x, 40 + 2.5 * i, is_lost ? 18 : 36, 2.6]);
      });
    }
    for (const [fill, all] of Object.entries(bars)) sketch.cells(all, { fill: color[fill] });
    sketch.write([636, 16], "a column of pixels", color.ink, "end");
    sketch.write([564, 34], "exact", color.ink, "end");
    sketch.write([577, 34], "with ε");
    sketch.write([611, 258], `ε = ${epsilon}`, color.ink, "end");
    [["sky", color.gray, 62], ["lost", color.purple, 88], ["ground", color.ink, 150]].forEach(([text, fill, y]) => sketch.write([522, y], text, fill, "end"));
    if (this.together) sketch.label([0, origin[1], 0], [135, -122], "⟨$d_r$, $n$⟩ > 0: hit behind, where $t$ < 0", color.ink, "start");
    sketch.label([4.6, origin[1], 0], [-30, -6], "⟨$d_r$, $n$⟩ = 0: parallel, the horizon", color.gray, "end");
    sketch.label([3.2, 0, 0], [0, -26], "⟨$d_r$, $n$⟩ < 0: hit ahead");
    return [await this.ask(0, "explain", ray, ground, ahead), ["intersect", t], [`with |⟨d_r, n⟩| < ${epsilon.toExponential()} refused`, printed], ["intersect from t = 5 on", beyond], ["normal of a plane given as (0, 3, 4)", tilted]];
  }
});
