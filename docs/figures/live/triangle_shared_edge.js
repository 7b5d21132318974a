// Stage 5: two triangles with one edge, and the rays at it, one rounding apart. A square that
// neither hits is a crack.
import { Figure, ahead, color, define } from "./drawing.js";

const reach = 8;

define("triangle_shared_edge", class extends Figure {
  static height = 330;
  view = { place: [160, 165], scale: 95 };

  setup() {
    const at_depth = (depth) => ({ keep: ([x, y]) => [x, y, depth] });
    this.a = this.handle("one end of the edge", [-0.31, 1.27, 0.7], at_depth(0.7));
    this.b = this.handle("other end of the edge", [0.42, -1.23, -0.9], at_depth(-0.9));
    this.share = this.slider("place on the edge", { min: 0.02, max: 0.98, step: 0.01, value: 0.37 });
  }

  async draw(sketch) {
    const [a, b] = [this.a.place, this.b.place], s = this.share.value, float = this.engine.precision === "float";
    const round = float ? Math.fround : (x) => x;
    const middle = a.map((x, i) => round(round(x) + s * (round(b[i]) - round(x))));
    const ulp = (x) => 2 ** (Math.floor(Math.log2(Math.abs(x) || 1e-3)) - (float ? 23 : 52));
    const triangles = [{ a, b: [-1.45, -0.2, 0.2], c: b }, { a: b, b: [1.43, 0.3, -0.5], c: a }];
    sketch.polygon([a, triangles[0].b, b], { fill: color.pale_blue, stroke: color.gray });
    sketch.polygon([b, triangles[1].b, a], { fill: color.pale_green, stroke: color.gray });
    sketch.line(a, b, { width: 2 });
    sketch.mark(middle, "hit");
    const cells = {}, lost = [0, 0], left = [335, 490];
    for (let row = -reach; row <= reach; ++row)
      for (let column = -reach; column <= reach; ++column) {
        // Slanted, so that the products are rounded.
        const p = [middle[0] + column * ulp(middle[0]), middle[1] - row * ulp(middle[1])];
        const ray = { origin: [p[0] + 0.3, p[1] - 0.7, middle[2] + 1.1], direction: [-0.3, 0.7, -1.1] };
        const hits = [], textbook = [];
        for (const triangle of triangles) {
          hits.push((await this.ask(5, "intersect", ray, triangle, ahead)) !== null);
          textbook.push(!/is not on/.test(await this.ask(0, "explain", ray, triangle, ahead)));
        }
        [hits, textbook].forEach(([first, second], form) => {
          const fill = first ? (second ? "gray" : "pale_blue") : second ? "pale_green" : "purple";
          if (fill === "purple") ++lost[form];
          (cells[fill] ??= []).push([left[form] + 8 * (column + reach), 70 + 8 * (row + reach), 8, 8]);
        });
      }
    for (const [fill, all] of Object.entries(cells)) sketch.cells(all, { fill: color[fill], stroke: color.white, width: 0.5 });
    for (const [x, y] of cells.purple ?? []) sketch.pixels("path", { d: `M${x + 1} ${y + 1}l6 6m0 -6l-6 6` }, { stroke: color.white });
    const all = (2 * reach + 1) ** 2;
    ["the reference", "three half-planes"].forEach((name, form) => {
      sketch.write([left[form] + 58 + 10 * form, 38], name, color.ink, "middle");
      sketch.write([left[form] + 58 + 10 * form, 60], `lost: ${lost[form]} of ${all}`, lost[form] ? color.purple : color.ink, "middle");
    });
    ["blue, green: one triangle", "gray: both", "with a cross: neither, a crack"].forEach((text, i) => sketch.write([480, 232 + 22 * i], text, i === 2 ? color.purple : color.ink, "middle"));
    return [["cracks with intersect", `${lost[0]} of ${all} rays`], ["cracks with three half-planes (MRT §5)", `${lost[1]} of ${all} rays`]];
  }
});
