// Reads a farop v2 screen file into arrays and says what is in it. Usage: node reader.js FILE.scr
// Samples: x right, y down, centers at (i + 0.5, j + 0.5). See docs/screen-files.md.
"use strict";
const fs = require("fs");

let width = 0, height = 0;
const polygons = []; // each: its surface, its planes by name, its vertices
for (const line of fs.readFileSync(process.argv[2], "utf8").split(/\r?\n/)) {
  const word = line.split("#")[0].trim().split(/\s+/);
  const last = polygons[polygons.length - 1];
  if (word[0] === "size") {
    [width, height] = [Number(word[1]), Number(word[2])];
  } else if (word[0] === "polygon") {
    polygons.push({ surface: Number(word[3]), planes: {}, vertices: [] });
  } else if (word[0] === "plane") { // value = a * x + b * y + c; name, then a b c low high
    last.planes[word[1]] = word.slice(2, 7).map(Number);
  } else if (word[0] === "vertex") { // x y inverse_w xw yw w edge, then what varies
    const [x, y, inverseW] = word.slice(1, 4).map(Number);
    last.vertices.push({ x, y, inverseW, values: word.slice(8).map(Number) });
  }
}

// Here begins your rasterizer: one color and one depth (1/w, larger is nearer) a sample.
const all = polygons.flatMap((polygon) => polygon.vertices);
const span = (numbers) => {
  const [low, high] = numbers.reduce(([low, high], n) => [Math.min(low, n), Math.max(high, n)], [Infinity, -Infinity]);
  return numbers.length ? `${low.toFixed(6)} ${high.toFixed(6)}` : "0.000000 0.000000";
};
console.log(`size ${width} ${height}`);
console.log(`polygons ${polygons.length}`);
console.log(`vertices ${all.length}`);
console.log(`x ${span(all.map((vertex) => vertex.x))}`);
console.log(`y ${span(all.map((vertex) => vertex.y))}`);
