// Antialiasing: an edge through a pixel, and what rays through points of three kinds report of it.
// Drag the ends of the edge.
import { Figure, add, ahead, color, define, minus, times } from "./drawing.js";

const kinds = ["regular", "independent", "spread"];
const many = 1024;
const within = (x, least, most) => Math.min(Math.max(x, least), most);

define("pixel_points", class extends Figure {
  static height = 300;
  view = { place: [22, 212], scale: 180 };  // the first pixel is (0, 1)²

  setup() {
    this.top = this.handle("upper end of the edge", [0.53, 1, 0], { keep: ([x, y]) => [within(x, 0, 1), within(y, 0.6, 1), 0] });
    this.bottom = this.handle("lower end of the edge", [0.49, 0, 0], { keep: ([x, y]) => [within(x, 0, 1), within(y, 0, 0.4), 0] });
    this.count = this.slider("rays: 4 to the power of", { min: 0, max: 4, step: 1, value: 2 });
    this.seed = this.slider("seed", { min: 0, max: 99, step: 1, value: 4 });
  }

  point(kind, i, side) {
    if (kind === "regular") return [((i % side) + 0.5) / side, (Math.floor(i / side) + 0.5) / side];
    return this.ask(0, kind === "spread" ? "well_spread_sample" : "independent_sample", i, this.seed.value);
  }

  async hits(triangle, [x, y]) {
    return (await this.ask(5, "intersect", { origin: [x, y, 1], direction: [0, 0, -1] }, triangle, ahead)) !== null;
  }

  async draw(sketch) {
    const [a, c] = [this.top.place, this.bottom.place], beyond = times(20, minus(a, c));
    const triangle = { a: add(a, beyond), b: [-99, 0.5, 0], c: minus(c, beyond) };
    const side = 2 ** this.count.value, rows = [];
    for (const [column, kind] of kinds.entries()) {
      const shift = [(208 / 180) * column, 0, 0], [left, bottom] = sketch.screen(shift);
      const corners = Object.values(triangle).map(([x, y]) => [180 * x, 180 * (1 - y)]).join(" ");
      sketch.pixels("svg", { x: left, y: bottom - 180, width: 180, height: 180, viewBox: "0 0 180 180" }, {}, `<polygon points="${corners}" style="fill: ${color.pale_blue}; stroke: ${color.ink}; stroke-width: 2"/>`);
      for (let i = 1; i < side && side <= 8; ++i) sketch.pixels("path", { d: `M${left + (180 * i) / side} ${bottom}v-180M${left} ${bottom - (180 * i) / side}h180` }, { stroke: color.faint, width: 1 });
      sketch.pixels("rect", { x: left, y: bottom - 180, width: 180, height: 180 }, { stroke: color.ink });
      let hits = 0;
      for (let i = 0; i < side * side; ++i) {
        const point = await this.point(kind, i, side), hit = await this.hits(triangle, point);
        hits += hit;
        sketch.pixels("circle", { cx: left + 180 * point[0], cy: bottom - 180 * point[1], r: side > 8 ? 2 : 4 }, { fill: hit ? color.blue : color.white, stroke: color.blue });
      }
      sketch.label(shift, [90, -192], kind);
      sketch.label(shift, [90, 24], `${hits} of ${side * side}: ${((100 * hits) / side ** 2).toFixed(1)} %`);
      // The pixel's color, from black to white.
      const gray = Math.round((255 * hits) / side ** 2);
      sketch.pixels("rect", { x: left + 60, y: bottom + 34, width: 60, height: 24 }, { fill: `rgb(${gray}, ${gray}, ${gray})`, stroke: color.gray });
      rows.push([kind, `${hits} of ${side * side} rays: ${((100 * hits) / side ** 2).toFixed(1)} %`]);
    }
    let hits = 0;
    for (let i = 0; i < many; ++i) hits += await this.hits(triangle, await this.point("spread", i));
    sketch.write([320, 294], `true share, by ${many} rays: ${((100 * hits) / many).toFixed(1)} %`, color.red, "middle");
    return [...rows, [`${many} spread rays`, `${((100 * hits) / many).toFixed(1)} %`]];
  }
});
