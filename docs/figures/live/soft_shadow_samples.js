// Stage 11: samples on a light, well spread and independent, and the share of it that is seen. Drag the ball.
import { Figure, color, define, short } from "./drawing.js";

const from = { point: [0, 0, 0], normal: [0, 1, 0], geometric_normal: [0, 1, 0], to_eye: [0, 1, 0], error: 0, material: { color: [1, 1, 1], specular: 0, shininess: 32, mirror: 0 } };

define("soft_shadow_samples", class extends Figure {
  static height = 330;
  view = { place: [98, 160], scale: 80 };  // the light seen from below: x to the right, z down

  setup() {
    this.ball = this.handle("ball", [0.5, 0.1, 0]);
    this.count = this.slider("samples: 2 to the power of", { min: 0, max: 9, step: 1, value: 6 });
    this.radius = this.slider("radius of the light", { min: 0.1, max: 1.3, step: 0.05, value: 1 });
    this.seed = this.slider("seed", { min: 0, max: 99, step: 1, value: 59 });
  }

  async draw(sketch) {
    const light = { position: [0, 4, 0], brightness: 1, color: [1, 1, 1], radius: this.radius.value };
    const [, height] = light.position, seen_radius = light.radius / Math.sqrt(1 - (light.radius / height) ** 2);
    const [x, y] = this.ball.place, ball = { center: [x / 2, 2, y / 2], radius: 0.3 };
    const count = 2 ** this.count.value, rows = [["samples", `${count}`]];
    const [true_share, ...errors] = await this.ask(0, "share_and_errors", light, ball, count);
    for (const [i, [kind, shift, square]] of [["well spread", 0, 202], ["independent", 4.1, 528]].entries()) {
      sketch.circle([shift, 0, 0], seen_radius, { fill: color.pale_amber, stroke: color.amber });
      sketch.circle([shift + x, y, 0], 0.6 / Math.sqrt(1 - 0.15 ** 2), { fill: "none", stroke: color.gray, dashes: "4 4" });
      sketch.label([shift + x, y + 0.6, 0], [0, -6], "ball", color.gray);
      // Boxes of equal size, as many as samples.
      const across = 2 ** Math.ceil(this.count.value / 2), down = count / across, size = 108, top = 106;
      for (let i = 0; i <= across && count <= 64; ++i) sketch.pixels("path", { d: `M${square + (size * i) / across} ${top}v${size}${i <= down ? `M${square} ${top + (size * i) / down}h${size}` : ""}` }, { stroke: color.faint, width: 1 });
      sketch.pixels("rect", { x: square, y: top, width: size, height: size }, { stroke: color.gray });
      let reached = 0;
      for (let i = 0; i < count; ++i) {
        const sample = await this.ask(0, `${kind.replace(" ", "_")}_sample`, i, this.seed.value);
        const point = await this.ask(11, "sample_light", light, from.point, sample);
        const way = await this.ask(10, "shadow_ray", from, point);
        const blocked = (await this.ask(3, "intersect", way.ray, ball, way.interval)) !== null;
        if (!blocked) ++reached;
        // A blocked sample is a cross, one that arrives is a dot; in the plane of the light's center, as they are seen.
        const nearer = height / point[1];
        const [cx, cy] = sketch.screen([shift + nearer * point[0], nearer * point[2], 0]), places = [[cx, cy], [square + size * sample[0], top + size * (1 - sample[1])]];
        for (const [u, v] of places)
          if (blocked) sketch.pixels("path", { d: `M${u - 2} ${v - 2}l4 4m0 -4l-4 4` }, { stroke: color.gray, width: 1 });
          else sketch.pixels("circle", { cx: u, cy: v, r: 1.8 }, { fill: color.blue });
      }
      const rays = { sent: count, reached };
      const share = await this.ask(11, "visibility", rays);
      sketch.label([shift, 0, 0], [0, -110], kind);
      sketch.label([shift, 0, 0], [22, 112], `visible share by ${count} rays: ${short(share)}`);
      sketch.label([shift, 0, 0], [22, 132], `error: ${Math.abs(share - true_share).toFixed(3)}, typical error: ${errors[i].toFixed(3)}`, color.purple);
      rows.push([`${kind}: visibility`, share], [`${kind}: error (root mean square of 64 seeds)`, errors[i]]);
      if (!shift) rows.push(["well spread: visibility_error, an estimate", await this.ask(11, "visibility_error", rays)]);
    }
    sketch.write([320, 20], `true share, by 8192 rays: ${short(true_share, 3)}`, color.ink, "middle");
    for (const x of [256, 582]) sketch.write([x, 98], "samples", color.ink, "middle");
    sketch.write([256, 236], "one in each box", color.ink, "middle");
    sketch.write([636, 236], "some empty", color.ink, "end");
    sketch.write([320, 318], "the light as the point sees it; dot: its ray arrives; cross: the ball is in the way", color.gray, "middle");
    return rows;
  }
});
