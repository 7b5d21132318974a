// Stage 4: the horizon, and an epsilon that removes the ground below it. Drag the ray.
import { Figure, ahead, at, color, define, minus, short } from "./drawing.js";

const ground = { point: [0, 0, 0], normal: [0, 1, 0] };
const strip = 80;

define("plane_horizon", class extends Figure {
  static height = 300;
  view = { place: [60, 240], scale: 95 };

  setup() {
    this.eye = this.handle("eye", [0, 1, 0], { keep: ([, y]) => [0, Math.max(y, 0.1), 0] });
    this.tip = this.handle("direction", undefined, { fill: color.blue });
    this.epsilon = this.slider("epsilon", { min: -12, max: 0, step: 0.5, value: -1, power: true });
    this.length = this.slider("length of directions", { min: -6, max: 0, step: 1, value: 0, power: true });
    const toward = (y, exponent = -1) => ({ eye: [0, 1, 0], tip: [1, y, 0], epsilon: 10 ** exponent, length: 1 });
    this.cases({ "⟨d, n⟩ < 0": toward(0.75), "nearly parallel": toward(0.92), "⟨d, n⟩ = 0": toward(1), "⟨d, n⟩ > 0": toward(1.6) });
  }

  async draw(sketch) {
    const origin = this.eye.place, epsilon = this.epsilon.value, scale = this.length.value;
    const seen = { origin, direction: minus(this.tip.place, origin) };
    const scaled = (direction) => ({ origin, direction: direction.map((x) => x * scale) });
    const ray = scaled(seen.direction);
    sketch.polygon([[-0.4, 0, 0], [4.6, 0, 0], [4.6, -0.4, 0], [-0.4, -0.4, 0]], { fill: color.tint });
    sketch.line([-0.4, 0, 0], [4.6, 0, 0], { width: 2 });
    sketch.line(origin, [4.6, origin[1], 0], { stroke: color.gray, width: 1, dashes: "4 4" });
    const t = await this.ask(4, "intersect", ray, ground, ahead);
    const printed = await this.ask(0, "intersect_with_epsilon", ray, ground, ahead, epsilon);
    const beyond = await this.ask(4, "intersect", ray, ground, { min: 5, max: Infinity });
    const tilted = await this.ask(4, "normal", { point: [0, 0, 0], normal: [0, 3, 4] }, [0, 0, 0]);
    const roots = await this.roots(4, ray, ground);
    sketch.ray(seen, roots.length && roots[0] > 0 ? Math.min(6, Math.hypot(...minus(at(ray, roots[0]), origin))) : 6);
    for (const root of roots) {
      const p = at(ray, root), [x] = p, inside = x < 4.6;
      sketch.mark(p, root === t && printed !== null ? "hit" : "refused");
      sketch.label([Math.min(x, 4.6), 0, 0], [0, 22], `$t$ = ${short(root)}${inside ? "" : " →"}`, root === t ? color.red : color.gray, x < 0 ? "start" : inside ? "middle" : "end");
      if (root === t && printed === null) sketch.label([2.3, 0, 0], [0, 46], `|⟨$d_r$, $n$⟩| < ε: refused`, color.red);
    }
    // A column of pixels, from above the horizon downwards.
    for (let i = 0; i < strip; ++i) {
      const column = scaled([1, 0.2 - (1.2 * (i + 0.5)) / strip, 0]);
      const hits = (await this.ask(4, "intersect", column, ground, ahead)) !== null;
      const kept = (await this.ask(0, "intersect_with_epsilon", column, ground, ahead, epsilon)) !== null;
      [[530, hits], [575, kept]].forEach(([x, ground_is_seen]) => {
        const is_lost = hits && !ground_is_seen;  // narrower too
        sketch.pixels("rect", { x, y: 40 + 2.5 * i, width: is_lost ? 18 : 36, height: 2.6 }, { fill: ground_is_seen ? color.green : is_lost ? color.red : color.pale_blue });
      });
    }
    sketch.shape("text", { x: 636, y: 16, text_anchor: "end" }, "a column of pixels");
    sketch.shape("text", { x: 564, y: 34, text_anchor: "end" }, "exact");
    sketch.shape("text", { x: 577, y: 34 }, "with ε");
    [["sky", color.blue, 62], ["lost", color.red, 88], ["ground", color.green, 150]].forEach(([text, fill, y]) => sketch.shape("text", { x: 522, y, text_anchor: "end", style: `fill: ${fill}` }, text));
    sketch.label([2.6, origin[1], 0], [0, -6], "the horizon: ⟨$d_r$, $n$⟩ = 0", color.gray);
    return [await this.ask(0, "explain", ray, ground, ahead), ["intersect", t], [`with |⟨d_r, n⟩| < ${epsilon.toExponential()} refused`, printed], ["intersect from t = 5 on", beyond], ["normal of a plane given as (0, 3, 4)", tilted]];
  }
});
