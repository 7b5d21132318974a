"use strict";
// The comparison of both pictures of page.js: their difference, amplified, and one over the other.
const rounding = 1;  // as in `./course compare`: a color near n + ½ may be rounded up or down

/// Draws the difference, and counts the pixels that differ.
function compare() {
  const {mine, reference} = images;
  const caption = figure("difference").querySelector("figcaption");
  const canvas = $("difference");
  const comparable = mine && reference && mine.width === reference.width;
  $("worst").disabled = true;
  caption.textContent = "";
  for (const of of ["difference", "over"]) $(of).hidden = !comparable;
  if (!comparable) return;
  Object.assign(canvas, {width: mine.width, height: mine.height});
  const result = new ImageData(mine.width, mine.height);
  const gain = +$("gain").value;
  let count = 0, most = 0, where = 0;
  for (let i = 0; i < result.data.length; i += 4) {
    let largest = 0;
    for (let k = i; k < i + 3; ++k) {
      const difference = Math.abs(mine.data[k] - reference.data[k]);
      result.data[k] = difference * gain;
      largest = Math.max(largest, difference);
    }
    result.data[i + 3] = 255;
    if (largest > rounding) ++count;
    if (largest > most) { most = largest; where = i / 4; }
  }
  canvas.getContext("2d").putImageData(result, 0, 0);
  $("worst").disabled = count === 0;
  const scale = size.width / mine.width;
  $("worst").onclick = () => choose(Math.floor(Math.floor(where / mine.width) * scale),
                                    Math.floor(where % mine.width * scale));
  caption.textContent = count === 0 ? tr("The same picture as the reference’s.")
    : tr("{count} of {all} pixels differ, by {most} of 255 at most.", {count, all: mine.width * mine.height, most});
  swipe();
}

/// Draws mine at the left of the slider, and the reference's at its right.
function swipe() {
  const {mine, reference} = images;
  if (!mine || !reference) return;
  const canvas = $("over");
  const column = Math.round(mine.width * $("split").value / 100);
  Object.assign(canvas, {width: mine.width, height: mine.height});
  const context = canvas.getContext("2d");
  context.putImageData(reference, 0, 0);
  if (column > 0) context.putImageData(mine, 0, 0, 0, 0, column, mine.height);
  $("whose").textContent = column === 0 ? tr("Reference") : column === mine.width ? tr("Mine")
    : tr("Mine | Reference");
}

function flip() {
  $("split").value = +$("split").value > 50 ? 0 : 100;
  swipe();
}
