// Stage 1: from a pixel to a ray, MRT's way and M1's. Drag the pixel, and change the field of view.
import { Figure, color, define, short, times } from "./drawing.js";

const [columns, rows, cell, left, top] = [8, 6, 0.27, -3.4, 0.81];
const clamp = (x, most) => Math.min(Math.max(Math.round(x), 0), most - 1);

define("screen_side_view", class extends Figure {
  static height = 300;
  view = { place: [350, 150], scale: 96 };
  resolution = { width: columns, height: rows };

  setup() {
    this.pixel = this.handle("pixel", this.center({ row: 1, column: 5 }), { fill: color.red, keep: (p) => this.center(this.at(p)), step: 30 });
    this.fov = this.slider("field of view", { min: 10, max: 150, step: 5, value: 60, unit: "°" });
  }
  at([x, y]) {
    return { row: clamp((top - y) / cell - 0.5, rows), column: clamp((x - left) / cell - 0.5, columns) };
  }
  center({ row, column }) {
    return [left + cell * (column + 0.5), top - cell * (row + 0.5), 0];
  }

  async draw(sketch) {
    const pixel = this.at(this.pixel.place), fov = (this.fov.value * Math.PI) / 180;
    const ray = await this.ask(1, "camera_ray", pixel, this.resolution, fov);
    for (let row = 0; row < rows; ++row)
      for (let column = 0; column < columns; ++column) {
        const [x, y] = this.center({ row, column }), h = cell / 2, here = row === pixel.row && column === pixel.column;
        sketch.polygon([[x - h, y - h, 0], [x + h, y - h, 0], [x + h, y + h, 0], [x - h, y + h, 0]], { stroke: color.gray, width: 1, fill: here ? color.pale_red : color.tint });
      }
    sketch.label([left, top, 0], [0, -8], `row ${pixel.row}, column ${pixel.column}`, color.ink, "start");
    // From the side: −z to the right. The edges of the screen are where its outermost rays end.
    const side = ([, y, z]) => [-z, y, 0], eye = [0, 0, 0];
    const half = Math.tan(fov / 2);
    sketch.polygon([eye, [2, 2 * half, 0], [2, -2 * half, 0]], { fill: color.tint, stroke: color.gray, width: 1, dashes: "4 4" });
    sketch.line([1, -half, 0], [1, half, 0], { stroke: color.ink, width: 2 });
    sketch.arrow(eye, [2.4, 0, 0], { stroke: color.gray, width: 1 });
    sketch.label([2.4, 0, 0], [6, 5], "−$z$", color.gray, "start");
    sketch.label([2, Math.min(2 * half, 1.5), 0], [0, -8], "$t$ = 2: twice as deep");
    sketch.polyline(Array.from({ length: 21 }, (_, i) => ((i - 10) * fov) / 20).map((angle) => [0.35 * Math.cos(angle), 0.35 * Math.sin(angle), 0]));
    sketch.label([0, 0, 0], [0, 52], "FOV");
    sketch.line([1.08, 0, 0], [1.08, half, 0], { stroke: color.green, width: 3 });
    sketch.label([1, Math.min(half, 1.4), 0], [-6, -8], `tan(FOV/2) = ${short(half)}`, color.green, "end");
    for (let row = 0; row < rows; ++row) {
      const { direction } = await this.ask(1, "camera_ray", { row, column: pixel.column }, this.resolution, fov);
      sketch.line(eye, times(2, side(direction)), { stroke: color.blue, width: 0.6 });
      sketch.mark(side(direction), "foot");
    }
    sketch.arrow(eye, times(2.2, side(ray.direction)), { stroke: color.blue, width: 2 });
    sketch.mark(side(ray.direction), "hit");
    sketch.mark(eye, "given");
    sketch.label(eye, [-14, 4], "$o_r$", color.ink, "end");
    sketch.label([1, -Math.min(half, 1.4), 0], [-6, 22], "the screen: $z$ = −1, $t$ = 1", color.ink, "end");
    const [x, y] = ray.direction;
    sketch.label([left, top, 0], [0, 182], `pixFinal = (${short(x)}, ${short(y)})`, color.red, "start");

    const [near, far] = [0.5, 8];
    const matrix = await this.ask(0, "image_to_world", this.resolution, fov, near, far);
    const identity = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]];
    const m1 = await this.ask(1, "unprojected_ray", pixel, identity, matrix);
    return [await this.ask(0, "explain_screen", pixel, this.resolution, fov), ["camera_ray, direction", ray.direction], [`unprojected_ray (M1), far plane at ${far}`, m1.direction]];
  }
});
