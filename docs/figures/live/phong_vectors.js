// Stage 9: Phong's three terms on a ball. Drag the light and the point; change the shares.
import { Figure, add, color, define, times } from "./drawing.js";

const ball = { center: [0, 0, 0], radius: 1 };
const cells = 26;
// Seen from the front, by parallel rays.
const seen = (x, y) => ({ origin: [x, y, 3], direction: [0, 0, -1] });
const paint = (value) => `rgb(${value.map((x) => Math.round(255 * Math.min(1, Math.max(0, x)))).join(" ")})`;

define("phong_vectors", class extends Figure {
  static title = "A ball and a light: drag the light, or the point on the ball";
  static height = 330;
  view = { place: [200, 165], scale: 130 };

  setup() {
    this.light = this.handle("light", [1.1, 1, 0], { fill: color.amber });
    this.point = this.handle("point", [0.3, 0.35, 0], { fill: color.red, keep: ([x, y]) => times(Math.min(1, 0.97 / (Math.hypot(x, y) || 1)), [x, y, 0]) });
    this.ambient = this.slider("ambient", { min: 0, max: 1, step: 0.05, value: 0.15 });
    this.specular = this.slider("k_s", { min: 0, max: 1, step: 0.05, value: 0.6 });
    this.shininess = this.slider("n", { min: 1, max: 256, step: 1, value: 32 });
    this.depth = this.slider("light's z", { min: -2, max: 4, step: 0.1, value: 2 });
    this.term = this.choice("term", ["all", "ambient", "diffuse", "specular"]);
  }

  async terms(x, y) {
    const surface = await this.ask(0, "shade", seen(x, y), ball);
    if (surface === null) return null;
    surface.material = { color: [0.35, 0.55, 0.85], specular: this.specular.value, shininess: this.shininess.value, mirror: 0 };
    const light = { position: [...this.light.place.slice(0, 2), this.depth.value], brightness: 0.9, color: [1, 1, 1], radius: 0 };
    return {
      surface, light,
      ambient: await this.ask(9, "ambient_term", surface, { ratio: this.ambient.value, color: [1, 1, 1] }),
      diffuse: await this.ask(9, "diffuse_term", surface, light),
      specular: await this.ask(9, "specular_term", surface, light),
    };
  }

  async draw(sketch) {
    const sum = ({ ambient, diffuse, specular }) => add(ambient, add(diffuse, specular));
    const shown = (terms) => (this.term.value === "all" ? sum(terms) : terms[this.term.value]);
    const width = 2 / cells;
    for (let row = 0; row < cells; ++row)
      for (let column = 0; column < cells; ++column) {
        const [x, y] = [(column + 0.5) * width - 1, 1 - (row + 0.5) * width];
        const terms = await this.terms(x, y);
        if (terms === null) continue;
        const [left, top] = sketch.screen([x - width / 2, y + width / 2, 0]);
        sketch.pixels("rect", { x: left, y: top, width: width * 130 + 0.4, height: width * 130 + 0.4 }, { fill: paint(shown(terms)) });
      }
    const [x, y] = this.point.place, terms = await this.terms(x, y), { surface, light } = terms;
    sketch.arrow(surface.point, add(surface.point, times(0.6, surface.normal)), { stroke: color.green, width: 2 });
    sketch.label(add(surface.point, times(0.6, surface.normal)), [0, -6], "N", color.green);
    sketch.line(surface.point, light.position, { stroke: color.amber, dashes: "5 4" });
    sketch.label(this.light.place, [0, -14], "light");
    const bars = [["ambient", color.gray], ["diffuse", color.blue], ["specular", color.amber]];
    bars.forEach(([name, fill], i) => {
      sketch.pixels("rect", { x: 430, y: 110 + 34 * i, width: 190 * Math.min(1, terms[name][2]), height: 16 }, { fill });
      sketch.shape("text", { x: 430, y: 106 + 34 * i }, name);
    });
    sketch.shape("text", { x: 430, y: 76 }, "blue at the point:");
    return [await this.ask(0, "explain_light", surface, light), ...bars.map(([name]) => [name, terms[name]])];
  }
});
