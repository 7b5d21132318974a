// Stage 13: the ray goes to the mesh, not the mesh to the ray: the same t in both frames. Drag the ray.
import { RayFigure, add, ahead, at, color, define, minus, short, times } from "./drawing.js";

const outline = [[-0.8, -0.6, 0], [0.9, -0.5, 0], [0, 0.9, 0]];  // of the mesh, in its own frame
const middle = [1 / 30, -1 / 15, 0];
const outward = (p) => times(1 / Math.hypot(...minus(p, middle)), minus(p, middle));
// The mesh: a wall over each edge, a triangle that reaches far out of the page, and the normals of its corners.
const walls = outline.map((from, i) => {
  const to = outline[(i + 1) % 3], half = times(0.5, add(from, to));
  return [[...from.slice(0, 2), -1], [...to.slice(0, 2), -1], [...half.slice(0, 2), 999]];
});
const mesh = { vertices: walls.flat(), normals: [], triangles: [[0, 1, 2], [3, 4, 5], [6, 7, 8]] };
const normals = walls.map((corners) => corners.map(([x, y]) => outward([x, y, 0])));

define("mesh_frame", class extends RayFigure {
  view = { place: [165, 165], scale: 64 };
  static height = 340;

  setup() {
    super.setup();
    [this.origin.place, this.tip.place] = [[-2.2, 0.55, 0], [-1.2, 0.4, 0]];
    this.angle = this.slider("turned by", { min: -180, max: 180, step: 5, value: 30, unit: "°" });
    this.scale = this.slider("scale", { min: 0.3, max: 2.5, step: 0.1, value: 1.6 });
  }

  async draw(sketch) {
    const { ray } = this;
    const angle = (this.angle.value * Math.PI) / 180, [cos, sin] = [Math.cos(angle), Math.sin(angle)];
    const rotation = { x: [cos, sin, 0], y: [-sin, cos, 0], z: [0, 0, 1] };
    const placement = { rotation, scale: this.scale.value, translation: [0.3, 0.2, 0] };
    const own = await this.ask(13, "to_object_space", ray, placement);
    const placed = ([x, y]) => add(placement.translation, times(placement.scale, add(times(x, rotation.x), times(y, rotation.y))));
    const right = [5.5, 0, 0];  // where the mesh's own frame is drawn
    sketch.polygon(outline.map(placed), { fill: color.tint, stroke: color.ink });
    sketch.polygon(outline.map((p) => add(p, right)), { fill: color.tint, stroke: color.ink });
    for (const [o, x, y] of [[placed([0, 0]), placed([0.42, 0]), placed([0, 0.42])], [right, add(right, [0.42, 0, 0]), add(right, [0, 0.42, 0])]]) {
      sketch.arrow(o, x, { stroke: color.green });
      sketch.arrow(o, y, { stroke: color.green });
    }
    sketch.ray(ray, 4);
    sketch.ray({ ...own, origin: add(own.origin, right) }, 3, 0.5);
    for (const t of [0, 1, 2])
      for (const [p, d] of [[at(ray, t), ray.direction], [add(at(own, t), right), own.direction]]) {
        sketch.mark(p, t ? "foot" : "given");
        sketch.label(p, d[1] < 0 ? [4, -10] : [-4, -10], t ? String(t) : "$o_r$", t ? color.gray : color.ink);
      }
    // The nearest triangle, and then those behind it.
    const rows = [], nearest = await this.ask(13, "intersect", own, mesh, ahead);
    for (let hit = nearest; hit !== null && rows.length < 4;) {
      for (const p of [at(ray, hit.t), add(at(own, hit.t), right)]) {
        sketch.mark(p, hit === nearest ? "hit" : "refused");
        sketch.label(p, hit === nearest ? [-4, 24] : [0, 28], `$t$ = ${short(hit.t)}`, hit === nearest ? color.red : color.gray, hit === nearest ? "end" : "middle");
      }
      rows.push([hit === nearest ? "intersect: the nearest triangle" : "behind it", hit]);
      hit = await this.ask(13, "intersect", own, mesh, { min: hit.t, max: Infinity });
    }
    for (const [i, corner] of outline.entries()) sketch.arrow(add(corner, right), add(add(corner, right), times(0.5, normals[i][0])), { stroke: color.gray });
    if (nearest !== null && nearest.triangle in normals) {
      const n = await this.ask(13, "interpolated_normal", normals[nearest.triangle], nearest.weights), p = add(at(own, nearest.t), right);
      this.normal(sketch, p, n, 0.8);
      rows.push(["interpolated_normal", n]);
    }
    [["in the scene", [0, 0, 0], ray], ["in the mesh's frame", right, own]].forEach(([name, place, { direction }]) => {
      sketch.label(place, [0, -140], name);
      sketch.label(place, [0, 118], `‖$d_r$‖ = ${short(Math.hypot(...direction))}`, color.blue);
    });
    sketch.write([320, 322], "the same $t$ at the same point: $d_r$ is turned and scaled, not made unit length", color.gray, "middle");
    return [["o_r in the mesh's frame", own.origin], ["d_r in the mesh's frame", own.direction], ...rows];
  }
});
