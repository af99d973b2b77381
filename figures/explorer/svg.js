// SVG elements and paths, and what both drawings share.

const SVG = "http://www.w3.org/2000/svg";

function element(name, attributes = {}, text = null) {
  const made = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  if (text !== null) made.textContent = text;
  return made;
}

const KEYS = ["up", "left", "right", "down"];
const KEY_SIGNS = {
  up: "↑",
  left: "←",
  right: "→",
  down: "↓"
};

const point = ([x, y]) => `${x.toFixed(1)} ${(-y).toFixed(1)}`;  // y upwards in the data, downwards in SVG
const openPath = (points) => points.length ? "M" + points.map(point).join("L") : "";
const closedPath = (points) => points.length ? openPath(points) + "Z" : "";

const length = ([x, y]) => Math.hypot(x, y);
const minus = (p, q) => [p[0] - q[0], p[1] - q[1]];
const plus = (p, q, factor = 1) => [p[0] + factor * q[0], p[1] + factor * q[1]];

// A regular polygon with as many corners as the vertex has edges. So the valence can be seen without colours.
function valenceShape(at, valence, radius) {
  const corners = Math.max(valence, 2);
  if (corners === 2) {
    return closedPath([[0, 1.35], [0.8, 0], [0, -1.35], [-0.8, 0]].map((p) => plus(at, p, radius)));
  }
  const grow = corners === 3 ? 1.3 : 1.1;
  const points = [];
  for (let i = 0; i < corners; ++i) {
    const angle = Math.PI / 2 + 2 * Math.PI * i / corners;
    points.push(plus(at, [Math.cos(angle), Math.sin(angle)], radius * grow));
  }
  return closedPath(points);
}
