// Stage 4: the horizon, and an epsilon that removes the ground below it. Drag the ray.
import { Figure, ahead, at, color, define, minus } from "./drawing.js";

const ground = { point: [0, 0, 0], normal: [0, 1, 0] };
const strip = 80;

define("plane_horizon", class extends Figure {
  static title = "An eye above a plane: drag the eye, or the direction; a column of pixels shows what an epsilon removes";
  static height = 300;
  view = { place: [60, 240], scale: 95 };

  setup() {
    this.eye = this.handle("eye", [0, 1, 0], { keep: ([, y]) => [0, Math.max(y, 0.1), 0] });
    this.tip = this.handle("direction", [1, 0.75, 0], { fill: color.blue });
    this.epsilon = this.slider("epsilon", { min: -12, max: 0, step: 0.5, value: -1, power: true });
    this.length = this.slider("length of directions", { min: -6, max: 0, step: 1, value: 0, power: true });
  }

  async draw(sketch) {
    const origin = this.eye.place, epsilon = this.epsilon.value, scale = this.length.value;
    const seen = { origin, direction: minus(this.tip.place, origin) };
    const scaled = (direction) => ({ origin, direction: direction.map((x) => x * scale) });
    const ray = scaled(seen.direction);
    sketch.polygon([[-0.4, 0, 0], [4.6, 0, 0], [4.6, -0.4, 0], [-0.4, -0.4, 0]], { fill: color.tint });
    sketch.line([-0.4, 0, 0], [4.6, 0, 0], { width: 2 });
    sketch.line(origin, [4.6, origin[1], 0], { stroke: color.gray, width: 1, dashes: "4 4" });
    sketch.ray(seen, 6);
    const t = await this.ask(4, "intersect", ray, ground, ahead);
    const printed = await this.ask(0, "intersect_with_epsilon", ray, ground, ahead, epsilon);
    const beyond = await this.ask(4, "intersect", ray, ground, { min: 5, max: Infinity });
    const tilted = await this.ask(4, "normal", { point: [0, 0, 0], normal: [0, 3, 4] }, [0, 0, 0]);
    if (t !== null) sketch.mark(at(ray, t), printed === null ? "refused" : "hit");
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
    sketch.shape("text", { x: 562, y: 30, text_anchor: "end" }, "ours");
    sketch.shape("text", { x: 575, y: 30 }, "with ε");
    sketch.label([2.6, origin[1], 0], [0, -6], "to the horizon: ⟨d_r, n⟩ = 0", color.gray);
    return [await this.ask(0, "explain", ray, ground, ahead), ["intersect", t], [`refused if |⟨d_r, n⟩| < ${epsilon.toExponential()}`, printed], ["intersect from t = 5 on", beyond], ["normal of a plane given as (0, 3, 4)", tilted]];
  }
});
