// Stage 6: a square in its own frame: x, y against h / 2, and HAI's u and v. Drag the ray's end.
import { Figure, Sketch, add, ahead, color, define, short, times } from "./drawing.js";

define("square_frame", class extends Figure {
  view = { place: [460, 170], scale: 108 };

  setup() {
    this.center = this.handle("center", [0, 0, 0]);
    this.p = this.handle("p", [0.5, 0.4, 0], { fill: color.red });
    this.angle = this.slider("turned by", { min: -90, max: 90, step: 5, value: 0, unit: "°" });
    this.side = this.slider("side h", { min: 0.2, max: 3, step: 0.1, value: 2 });
    this.one_sided = this.check("one-sided");
    this.behind = this.check("from behind");
  }

  async draw(sketch) {
    const [o, p, h] = [this.center.place, this.p.place, this.side.value];
    const angle = (this.angle.value * Math.PI) / 180, [cos, sin] = [Math.cos(angle), Math.sin(angle)];
    const basis = { x: [cos, sin, 0], y: [-sin, cos, 0], z: [0, 0, 1] };
    const square = { center: o, basis, side: h, one_sided: this.one_sided.value };
    const from = this.behind.value ? -2 : 2;
    const ray = { origin: [p[0], p[1], from], direction: [0, 0, -from / 2] };
    const t = await this.ask(6, "intersect", ray, square, ahead);
    const beyond = await this.ask(6, "intersect", ray, square, { min: 3, max: Infinity });
    const away = await this.ask(6, "intersect", { ...ray, direction: times(-1, ray.direction) }, square, ahead);
    const uv = await this.ask(6, "square_uv", square, p);
    const corner = (x, y) => add(o, add(times((x * h) / 2, basis.x), times((y * h) / 2, basis.y)));
    sketch.polygon([corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)], { fill: color.tint, stroke: color.ink, width: 2 });
    // The same in space.
    const space = new Sketch(sketch.group, sketch.labels, { place: [130, 180], scale: 76, right: [0.86, 0, -0.5], up: [-0.25, 0.86, -0.44] });
    space.polygon([corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)], { fill: color.tint, stroke: color.ink });
    for (const [name, axis] of Object.entries(basis)) {
      space.arrow(o, add(o, times(0.9, axis)), { stroke: color.green, width: 2 });
      space.label(add(o, times(1.04, axis)), [0, 5], `$${name.toUpperCase()}$`, color.green);
    }
    space.arrow(ray.origin, p, { stroke: color.blue, width: 1.8 });
    for (const [place, kind] of [[ray.origin, "given"], [o, "given"], [p, t === null ? "refused" : "hit"]]) space.mark(place, kind);
    space.label(ray.origin, [0, 22], "$o_r$");
    space.label(p, [12, -6], "$p$", color.red);
    sketch.arrow(o, add(o, basis.x), { stroke: color.green, width: 2 });
    sketch.arrow(o, add(o, basis.y), { stroke: color.green, width: 2 });
    sketch.label(add(o, basis.x), [14, 5], "$X$", color.green);
    sketch.label(add(o, basis.y), [-14, 16], "$Y$", color.green);
    sketch.label(o, [-12, 16], "$o$");
    sketch.mark(corner(-1, -1), "given");
    sketch.label(corner(-1, -1), [-12, 16], "$C$");
    for (const [name, end] of [["U", corner(1, -1)], ["V", corner(-1, 1)]]) {
      sketch.arrow(corner(-1, -1), end, { width: 2.2 });
      sketch.label(end, name === "U" ? [14, 8] : [-14, 0], `$${name}$`);
    }
    sketch.line(corner(0, 1), corner(1, 1), { width: 5 });
    sketch.label(corner(0.5, 1), [0, -10], `$h$ / 2 = ${short(h / 2)}`);
    // The two coordinates of p from C: along U and along V.
    const c = corner(-1, -1), [along, up] = [times(uv[0] * h, basis.x), times(uv[1] * h, basis.y)];
    for (const end of [add(c, along), add(c, up)]) {
      sketch.line(c, end, { stroke: color.ink, width: 3.5 });
      sketch.line(end, p, { stroke: color.gray, width: 1, dashes: "5 4" });
    }
    sketch.label(add(c, times(0.5, along)), [0, 20], `$u$ = ${short(uv[0])}`);
    sketch.label(add(c, times(0.5, up)), [-8, 5], `$v$ = ${short(uv[1])}`, color.ink, "end");
    const [x, y] = uv.map((share) => (share - 0.5) * h), beside = add(o, times(x, basis.x));
    sketch.line(o, beside, { stroke: color.green, width: 4 });
    sketch.line(beside, p, { stroke: color.green, width: 4 });
    sketch.label(times(0.5, add(o, beside)), [4, 18], `$x$ = ${short(x)}`, color.green, "start");
    sketch.label(times(0.5, add(beside, p)), [8, 5], `$y$ = ${short(y)}`, color.green, "start");
    sketch.mark(p, t === null ? "refused" : "hit");
    sketch.label(p, [20, -10], t === null ? "$p$: no hit" : "$p$: hit", t === null ? color.gray : color.red, "start");
    return [await this.ask(0, "explain", ray, square, ahead), ["square_uv: u, v", uv], ["intersect", t], ["intersect from t = 3 on", beyond], ["intersect of the ray away from it", away], ["normal", await this.ask(6, "normal", square, p)]];
  }
});
