// Stage 2: the camera's basis. Turn the view through the vertical: X as printed shrinks, and jumps.
import { Figure, color, define, short, times } from "./drawing.js";

const onto_circle = ([, y, z]) => times(1 / (Math.hypot(y, z) || 1), [0, y, z]);
const size = (v) => Math.hypot(...v);

define("unnormalized_x", class extends Figure {
  static height = 450;
  view = { place: [170, 145], scale: 115, right: [0.45, 0, -1], up: [-0.3, 1, 0] };

  setup() {
    this.direction = this.handle("direction", onto_circle([0, -1, -0.57735]), { fill: color.blue, keep: onto_circle });
    this.away = this.slider("to the side", { min: -0.5, max: 0.5, step: 0.05, value: 0 });
  }

  async draw(sketch) {
    const [, y, z] = this.direction.place, direction = [this.away.value, y, z];
    const basis = await this.ask(2, "camera_basis", direction);
    const printed = await this.ask(0, "printed_basis", direction);
    // Into the world, and back; before the plot, which asks a student's file for all that it may be asked.
    const position = [1, 2, 3], ray = { origin: [0.5, 0, 0], direction: [0, 0, -1] };
    const in_world = await this.ask(2, "to_world", ray, basis, position);
    const columns = await this.ask(2, "view_matrix", basis, position);
    const circle = Array.from({ length: 73 }, (_, i) => [0, Math.sin((i * Math.PI) / 36), Math.cos((i * Math.PI) / 36)]);
    sketch.polyline(circle, { stroke: color.faint });
    const origin = [0, 0, 0];
    sketch.arrow(origin, direction, { stroke: color.blue, width: 2.5 });
    for (const axis of ["x", "y", "z"]) {
      sketch.arrow(origin, basis[axis], { stroke: color.green, width: 2 });
      sketch.label(basis[axis], [10, -6], `$${axis.toUpperCase()}$`, color.green);
      if (axis !== "z") sketch.arrow(origin, printed[axis], { stroke: color.purple, width: 3, dashes: "6 3" });
    }
    sketch.label(direction, [-16, 16], "$c$", color.blue);
    // The length of X over the pitch, as printed and normalized.
    const place = (degrees, length) => [475 + degrees * 1.45, 215 - 150 * length];
    const plot = { printed_basis: color.purple, camera_basis: color.green };
    for (const [name, stroke] of Object.entries(plot)) {
      const points = [];
      for (let pitch = -90; pitch <= 90; pitch += 5) {
        const angle = (pitch * Math.PI) / 180;
        const { x } = await this.ask(name === "camera_basis" ? 2 : 0, name, [this.away.value, Math.sin(angle), -Math.cos(angle)]);
        points.push(place(pitch, size(x)));
      }
      sketch.pixels("polyline", { points: points.join(" ") }, { stroke, width: 2, dashes: name === "camera_basis" ? "none" : "6 3" });
    }
    sketch.pixels("polyline", { points: `${place(-90, 1.1)} ${place(-90, 0)} ${place(90, 0)}` }, { stroke: color.gray, width: 1 });
    const [cx, cy] = place((Math.atan2(y, Math.abs(z)) * 180) / Math.PI, size(printed.x));
    sketch.pixels("circle", { cx, cy, r: 5 }, { fill: color.purple, stroke: color.white });
    for (const pitch of [-90, -45, 0, 45, 90]) sketch.write([place(pitch, 0)[0], 233], `${pitch}°`, color.ink, "middle");
    sketch.write([475, 256], "pitch of the camera", color.ink, "middle");
    sketch.write([475, 37], "‖$X$‖, normalized", color.green, "middle");
    sketch.write([cx + 12, cy + 18], `as printed: ${short(size(printed.x))}`, color.purple);
    // The picture in both bases: as printed X and Y shrink, and with them the screen, so all that is seen grows.
    const shrunk = size(printed.x), balls = [[0, 8, 16, "red"], [-44, 18, 13, "amber"], [38, -18, 9, "blue"], [12, -34, 5, "green"]];
    const content = balls.map(([x, y, r, name]) => `<circle cx="${x}" cy="${y}" r="${r}" style="fill: ${color[`pale_${name}`]}; stroke: ${color[name]}"/>`).join("");
    for (const [left, share, fill, title] of [[90, 1, color.green, "$X$ normalized"], [370, shrunk, color.purple, "$X$ = (0, 1, 0) ∧ $Z$, as printed"]]) {
      const view = [-90 * share, -52 * share, 180 * share, 104 * share];
      sketch.pixels("rect", { x: left, y: 316, width: 180, height: 104 }, { fill: color.tint, stroke: fill, width: 2 });
      sketch.pixels("svg", { x: left, y: 316, width: 180, height: 104, viewBox: view.join(" ") }, {}, content);
      sketch.write([left + 90, 308], title, fill, "middle");
    }
    sketch.pixels("rect", { x: 180 - 90 * shrunk, y: 368 - 52 * shrunk, width: 180 * shrunk, height: 104 * shrunk }, { stroke: color.purple, width: 2, dashes: "6 3" });
    sketch.write([460, 440], `all looks ${short(1 / shrunk)} times as large`, color.purple, "middle");
    return [
      ["c", direction], ["X of camera_basis", basis.x], ["Y of camera_basis", basis.y], ["X as printed: (0, 1, 0) ∧ Z", printed.x], ["Y as printed: Z ∧ X", printed.y],
      [`to_world: from (0.5, 0, 0) along −z; camera at (${position.join(", ")})`, in_world],
      ...["1", "2", "3"].map((row, i) => [`row ${row} of view_matrix`, columns.map((column) => column[i])]),
    ];
  }
});
