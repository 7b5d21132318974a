// Stage 13: boxes in boxes around an owl. A ray tests the boxes in a box only if it hits that box.
// Drag the ray.
import { Figure, Sketch, color, define, minus } from "./drawing.js";

// How a box is drawn, and its place in the tree.
const pens = {
  opened: [{ stroke: color.blue, width: 2 }, { fill: color.blue }, "hit, opened"],
  behind: [{ stroke: color.gray, width: 2, dashes: "8 4" }, { fill: color.gray }, "hit, behind the closest hit"],
  missed: [{ stroke: color.gray, width: 1.2, dashes: "3 3" }, { fill: color.faint }, "tested, missed"],
  untested: [{ stroke: color.gray, width: 0.6 }, { stroke: color.faint, width: 1 }, "not tested"],
};

const leaves = ({ parts }) => (parts.length ? parts.reduce((sum, part) => sum + leaves(part), 0) : 1);

define("mesh_hierarchy", class extends Figure {
  static height = 504;
  static most_of_mine = 200;
  view = { place: [185, 300], scale: 104 };
  side = { place: [492, 300], scale: 104, right: [0, 0, 1] };

  setup() {
    this.origin = this.handle("origin", [-1.5, 1.9, 0]);
    this.target = this.handle("direction", [0.1, 1.3, 0], { fill: color.blue });
    this.depth = this.slider("z of the origin", { min: 0, max: 1.3, step: 0.05, value: 1.1 });
    this.level = this.slider("level", { min: 0, max: 4, step: 1, value: 1 });
  }

  /// Tests the boxes in a box, or the triangles in it; the nearest boxes first.
  async open(box, ray) {
    box.state = "opened";
    if (box.triangles.length > 0) {
      this.tested.push(...box.triangles);
      const vertices = box.triangles.flatMap((triangle) => this.corners(triangle));
      const triangles = box.triangles.map((_, i) => [3 * i, 3 * i + 1, 3 * i + 2]);
      const hit = await this.ask(13, "intersect", ray, { vertices, normals: [], triangles }, { min: 0, max: this.t });
      if (hit !== null) [this.t, this.hit] = [hit.t, box.triangles[hit.triangle]];
    }
    const entered = [];
    for (const part of box.parts) {
      const inside = await this.overlap(part, ray);
      if (inside !== null) entered.push([inside.min, part]);
    }
    for (const [near, part] of entered.sort(([a], [b]) => a - b)) {
      if (near < this.t) await this.open(part, ray);
      else part.state = "behind";
    }
  }

  corners(triangle) {
    return this.owl.triangles[triangle].map((corner) => this.owl.vertices[corner]);
  }

  async overlap(box, ray) {
    box.state = "missed";
    return this.ask(13, "overlap", ray, box.box, { min: 0, max: this.t });
  }

  async draw(sketch) {
    const { place: origin } = this.origin, { place: target } = this.target;
    const from = [origin[0], origin[1], this.depth.value];
    const ray = { origin: from, direction: minus(target, from) };
    this.owl = await this.ask(0, "owl");
    const boxes = await this.ask(0, "owl_hierarchy");
    boxes.forEach((box, i) => {
      Object.assign(box, { parts: [], state: "untested", level: i ? boxes[box.parent].level + 1 : 0 });
      if (i) boxes[box.parent].parts.push(box);
    });
    [this.t, this.hit, this.tested] = [Infinity, null, []];
    if ((await this.overlap(boxes[0], ray)) !== null) await this.open(boxes[0], ray);

    const shown = boxes.filter(({ level }) => level === this.level.value);
    for (const view of [sketch, new Sketch(sketch.group, sketch.labels, this.side)]) {
      this.draw_owl(view);
      for (const state of Object.keys(pens).reverse())
        for (const { box: { min, max } } of shown.filter((box) => box.state === state)) {
          const [[left, bottom], [right, top]] = [view.screen(min), view.screen(max)];
          view.pixels("rect", { x: left, y: top, width: right - left, height: bottom - top }, pens[state][0]);
        }
      view.ray(ray, 3);
      if (this.hit !== null) view.mark(ray.origin.map((x, i) => x + this.t * ray.direction[i]), "hit");
    }
    sketch.write([338, 320], `${boxes.filter(({ state }) => state !== "untested").length} of ${boxes.length} boxes tested, ${this.tested.length} of ${this.owl.triangles.length} triangles; shown: level ${this.level.value}`, color.ink, "middle");
    sketch.write([185, 24], "from the front", color.ink, "middle");
    sketch.write([492, 24], "from the side", color.ink, "middle");
    this.draw_tree(sketch, boxes[0], 84, 536 / leaves(boxes[0]));
    [0, 1, 2, 3, 4].forEach((level) => sketch.write([20, 351 + 20 * level], `level ${level}`, level === this.level.value ? color.ink : color.gray));
    Object.values(pens).forEach(([pen, cell, text], i) => {
      const x = i % 2 ? 320 : 20, y = 450 + 26 * (i >> 1);
      sketch.pixels("rect", { x, y, width: 26, height: 14 }, pen);
      sketch.pixels("rect", { x: x + 34, y, width: 8, height: 14 }, cell);
      sketch.write([x + 52, y + 13], text);
    });
    const count = (states, all) => all.filter(({ state }) => states.includes(state)).length;
    const sums = (all) => `${all.length} ${all.length === 1 ? "box" : "boxes"}, ${count(["opened", "behind", "missed"], all)} tested, ${count(["opened"], all)} opened`;
    return [
      ...[0, 1, 2, 3, 4].map((k) => [`level ${k}`, sums(boxes.filter(({ level }) => level === k))]),
      ["all", sums(boxes)],
      ["triangles", `${this.tested.length} of ${this.owl.triangles.length} tested`],
      ["t", this.hit === null ? null : this.t],
    ];
  }

  /// A box over its parts, as wide as all of them.
  draw_tree(sketch, box, left, wide) {
    sketch.pixels("rect", { x: left, y: 338 + 20 * box.level, width: wide * leaves(box) - 1, height: 16 }, pens[box.state][1]);
    for (const part of box.parts) {
      this.draw_tree(sketch, part, left, wide);
      left += wide * leaves(part);
    }
  }

  /// The triangles that face the viewer, the far ones first.
  draw_owl(view) {
    const toward = view.view.right[0] ? [0, 0, 1] : [-1, 0, 0];
    const along = (p) => p.reduce((sum, x, i) => sum + x * toward[i], 0);
    const triangles = this.owl.triangles.map((_, i) => [i, this.corners(i)]);
    triangles.sort(([, a], [, b]) => Math.max(...a.map(along)) - Math.max(...b.map(along)));
    for (const [i, triangle] of triangles) {
      const [a, b, c] = triangle.map((p) => view.screen(p));
      const is_tested = this.tested.includes(i);
      const faces = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) < 0;  // y points down
      if (faces || is_tested) view.polygon(triangle, { fill: i === this.hit ? color.red : is_tested ? color.pale_blue : color.tint, stroke: is_tested ? color.blue : color.faint, width: is_tested ? 1 : 0.6 });
    }
  }
});
