// Stage 13: the ray goes to the mesh, not the mesh to the ray: the same t in both frames. Drag the ray.
import { Figure, add, ahead, at, color, define, minus, times } from "./drawing.js";

const mesh = { a: [-0.8, -0.6, 0], b: [0.9, -0.5, 0], c: [0, 0.9, 0] };  // in its own frame

define("mesh_frame", class extends Figure {
  static title = "A ray in the scene and in the frame of a mesh: drag its origin, or its direction; turn and scale the mesh";
  view = { place: [165, 175], scale: 60 };
  static height = 340;

  setup() {
    this.origin = this.handle("origin", [-2.2, -1.2, 0]);
    this.tip = this.handle("direction", [-1.2, -0.7, 0], { fill: color.blue });
    this.angle = this.slider("turned by", { min: -180, max: 180, step: 5, value: 30, unit: "°" });
    this.scale = this.slider("scale", { min: 0.3, max: 2.5, step: 0.1, value: 1.6 });
  }

  async draw(sketch) {
    const ray = { origin: this.origin.place, direction: minus(this.tip.place, this.origin.place) };
    const angle = (this.angle.value * Math.PI) / 180, [cos, sin] = [Math.cos(angle), Math.sin(angle)];
    const rotation = { x: [cos, sin, 0], y: [-sin, cos, 0], z: [0, 0, 1] };
    const placement = { rotation, scale: this.scale.value, translation: [0.3, 0.2, 0] };
    const own = await this.ask(13, "to_object_space", ray, placement);
    const placed = ([x, y]) => add(placement.translation, times(placement.scale, add(times(x, rotation.x), times(y, rotation.y))));
    const right = [5.2, 0, 0];  // where the mesh's own frame is drawn
    const edges = [[mesh.a, mesh.b], [mesh.b, mesh.c], [mesh.c, mesh.a]];
    sketch.polygon([mesh.a, mesh.b, mesh.c].map(placed), { fill: color.tint, stroke: color.ink });
    sketch.polygon([mesh.a, mesh.b, mesh.c].map((p) => add(p, right)), { fill: color.tint, stroke: color.ink });
    sketch.ray(ray, 4);
    sketch.ray({ ...own, origin: add(own.origin, right) }, 4);
    // Where the rays pass through the walls over the edges: boxes of no width, met at the same t.
    const rows = [];
    for (const [from, to] of edges) {
      const wall = { a: [...from.slice(0, 2), -1], b: [...to.slice(0, 2), -1], c: from.map((x, i) => (x + to[i]) / 2 + (i === 2 ? 4 : 0)) };
      const t = await this.ask(5, "intersect", own, wall, ahead);
      if (t === null) continue;
      sketch.mark(at(ray, t), "hit");
      sketch.mark(add(at(own, t), right), "hit");
      rows.push(["an edge is passed at t", t]);
    }
    sketch.label([0, 0, 0], [0, -150], "in the scene");
    sketch.label(right, [0, -150], "in the mesh's frame");
    return [["o_r in the mesh's frame", own.origin], ["d_r in the mesh's frame", own.direction], ...rows];
  }
});
