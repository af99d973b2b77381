// Drawings in SVG: the mesh of one configuration, and the graph of all configurations.

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

class MeshView {
  // `onArrow(key)` is called when an arrow is clicked, `onPoint(key or null)` when it is pointed at.
  constructor(svg, data, onArrow, onPoint) {
    this.svg = svg;
    this.data = data;
    this.onArrow = onArrow;
    this.onPoint = onPoint;
    const layer = (name) => svg.appendChild(element("g", {class: name}));
    for (const name
             of ["alpha", "changed", "edges", "boundary", "separatrices", "rim", "sides", "arrows", "irregular"]) {
      this[name] = layer(name);
    }
    // All configurations have the same boundary.
    const node = data.nodes[0];
    const loop = boundaryOf(node.faces, node.root);
    const points = loop.map((v) => node.vertices[v]);
    const xs = points.map((p) => p[0]);
    const ys = points.map((p) => p[1]);
    let area = 0;
    points.forEach((p, i) => {
      const q = points[(i + 1) % points.length];
      area += (p[0] * q[1] - q[0] * p[1]) / 2;
    });
    const most = Math.max(...data.nodes.map((n) => n.quads));
    this.unit = Math.min(Math.sqrt(area / most), 260);  // about the length of an edge
    const margin = 135;
    const [left, right, low, high] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
    this.whole = [left - margin, -high - margin, right - left + 2 * margin, high - low + 2 * margin];
    this.closeUp = false;
    this.boundary.appendChild(element("path", {d: closedPath(points)}));
    this.loop = points;
    this.node = node;
    new ResizeObserver(() => this.fit()).observe(svg);
  }

  // Side lengths E_i outside the middle of each side, and the corners.
  drawSides() {
    const points = this.loop;
    const centre = points.reduce((sum, p) => plus(sum, p, 1 / points.length), [0, 0]);
    const size = this.letters(14, 44, 96);
    let at = 0;
    this.sides.replaceChildren();
    this.data.sides.forEach((side, i) => {
      const place = (number) => points[number % points.length];
      const middle = between(place(at + Math.floor(side / 2)), place(at + Math.ceil(side / 2)), 0.5);
      let outward = minus(place(at + side), place(at));
      outward = length(outward) < 1 ? minus(middle, centre) : [outward[1], -outward[0]];
      const across = outward[0] / length(outward);
      const beside = plus(middle, outward, (0.95 - 0.4 * Math.abs(across)) * size / length(outward));
      const anchor = across > 0.4 ? "start" : across < -0.4 ? "end" : "middle";
      const label = this.label(beside, "E", i + 1, ` = ${side}`, size);
      label.setAttribute("text-anchor", anchor);
      const [x, y] = place(at);
      this.sides.append(label, element("circle", {cx: x, cy: -y, r: 0.24 * size, class: "corner"}));
      at += side;
    });
  }

  // The height of letters: constant on the screen, but within bounds in the mesh's units.
  letters(pixels, least, most) {
    return Math.min(Math.max(pixels * this.unitsPerPixel, least), most);
  }

  label([x, y], name, index, rest, size) {
    const text = element("text", {x, y: -y, "font-size": size});
    text.append(
        name, element("tspan", {class: "index", dy: 0.22 * size}, index), element("tspan", {dy: -0.22 * size}, rest));
    return text;
  }

  drawFaces(faces, positions) {
    const drawn = new Set();
    let path = "";
    for (const corners of faces) {
      if (!corners) continue;
      corners.forEach((a, k) => {
        const b = corners[(k + 1) % 4];
        const key = a < b ? edgeKey(a, b) : edgeKey(b, a);
        if (drawn.has(key)) return;
        drawn.add(key);
        path += openPath([positions[a], positions[b]]);
      });
    }
    this.edges.replaceChildren(element("path", {d: path}));
  }

  drawIrregular(vertices, positions) {
    const radius = this.letters(9, 0.24 * this.unit, 0.42 * this.unit);
    this.irregular.replaceChildren(...vertices.map(([v, valence]) => {
      const group = element("g", {class: `vertex v${valence}`});
      const [x, y] = positions[v];
      group.append(
          element("path", {d: valenceShape(positions[v], valence, radius)}),
          element("text", {x, y: -y + (valence === 3 ? 0.1 : 0) * radius, "font-size": radius * 1.25}, valence));
      group.append(element("title", {}, `v${valence}`));
      return group;
    }));
  }

  facePath(faces, ids, positions) {
    return ids.map((id) => closedPath(faces[id].map((v) => positions[v]))).join("");
  }

  setCloseUp(closeUp) {
    this.closeUp = closeUp;
    this.svg.classList.toggle("close-up", closeUp);
    this.fit();
  }

  // Shows the whole region, or the pair and its surroundings.
  fit() {
    let box = this.whole;
    if (this.closeUp) {
      const points = this.node.irregular.map((v) => this.node.vertices[v]);
      const low = [0, 1].map((i) => Math.min(...points.map((p) => p[i])));
      const high = [0, 1].map((i) => Math.max(...points.map((p) => p[i])));
      const side = Math.min(
          Math.max(high[0] - low[0], high[1] - low[1]) + 5 * this.unit, Math.max(this.whole[2], this.whole[3]));
      box = [(low[0] + high[0] - side) / 2, -(low[1] + high[1] + side) / 2, side, side];
    }
    this.svg.setAttribute("viewBox", box.join(" "));
    this.unitsPerPixel = Math.max(box[2] / (this.svg.clientWidth || 500), box[3] / (this.svg.clientHeight || 500));
    this.drawSides();
    this.drawSeparatrices(this.node);
  }

  // Shows a configuration at rest, and the moves that are possible.
  show(node, moves) {
    this.node = node;
    this.fit();
    const positions = node.vertices;
    this.svg.classList.remove("moving");
    this.drawFaces(node.faces, positions);
    this.alpha.replaceChildren(element("path", {d: this.facePath(node.faces, node.alpha, positions)}));
    const rim = node.rim.map((v) => positions[v]);
    this.rim.replaceChildren(element("path", {d: node.alpha.length ? closedPath(rim) : openPath(rim)}));
    this.changed.replaceChildren();
    const boundary = new Set(boundaryOf(node.faces, node.root));
    this.drawIrregular(irregularVertices(node.faces, boundary), positions);
    this.arrows.replaceChildren(...moves.map((move) => this.arrowPair(move, positions)));
  }

  drawSeparatrices(node) {
    this.separatrices.replaceChildren();
    node.outward.forEach((path, i) => {
      const points = path.map((v) => node.vertices[v]);
      this.separatrices.append(element("path", {d: openPath(points)}));
      // The label lies beside the middle of the last edge.
      const [p, q] = points.slice(-2);
      const along = minus(q, p);
      const size = this.letters(12, 26, 74);
      const aside = [-along[1] / (length(along) || 1), along[0] / (length(along) || 1)];
      this.separatrices.append(this.label(
          plus(between(p, q, 0.5), aside, (0.62 + 0.85 * Math.abs(aside[0])) * size), "e", i + 1, `=${path.length - 1}`,
          size));
    });
  }

  // Figure 9: for each move two arrows of one colour. Each points from a vertex of the pair to where the move takes it.
  arrowPair(move, positions) {
    const group = element("g", {class: `arrow ${move.key}`, "data-key": move.key});
    const head = this.letters(12, 0.3 * this.unit, 0.5 * this.unit);
    for (const [v, w] of move.arrows) {
      const way = minus(positions[w], positions[v]);
      const reach = length(way) || 1;
      const direction = [way[0] / reach, way[1] / reach];
      // Two arrows that point at each other leave a gap between them.
      const facing = move.arrows.some(([other]) => other === w);
      const long = facing ? 0.46 * reach :
                            Math.min(Math.max(0.84 * reach, 1.9 * head + 0.2 * this.unit), 1.15 * this.unit + head);
      const tip = plus(positions[v], direction, long);
      const neck = plus(tip, direction, -head);
      const side = [-direction[1], direction[0]];
      const wings = [plus(neck, side, 0.62 * head), plus(neck, side, -0.62 * head)];
      const shaft = openPath([plus(positions[v], direction, 0.3 * this.unit), neck]);
      const tipPath = closedPath([tip, ...wings]);
      group.append(
          element("path", {class: "halo", d: shaft + tipPath}), element("path", {class: "shaft", d: shaft}),
          element("path", {class: "head", d: tipPath}));
      const badge = plus(neck, direction, 0.34 * head);
      group.append(element("text", {x: badge[0], y: -badge[1], "font-size": 0.9 * head}, KEY_SIGNS[move.key]));
    }
    group.append(element("title", {}, `${move.change} to ${this.data.nodes[move.to].label}`));
    group.addEventListener("click", () => this.onArrow(move.key));
    group.addEventListener("pointerenter", () => this.onPoint(move.key));
    group.addEventListener("pointerleave", () => this.onPoint(null));
    return group;
  }

  // Shows a moment of a film. Quads that are being made are yellow; quads that are being deleted are red and hatched,
  // as in the paper.
  showMoment({faces, positions, operation}, boundary) {
    this.svg.classList.add("moving");
    this.drawFaces(faces, positions);
    this.drawIrregular(irregularVertices(faces, boundary), positions);
    this.changed.replaceChildren();
    if (!operation) return;
    if (operation.kind === "flip") {
      const touched = operation.patch.map(([id]) => id);
      this.changed.append(element("path", {class: "flip", d: this.facePath(faces, touched, positions)}));
    } else if (faces[operation.face]) {
      this.changed.append(
          element("path", {class: operation.kind, d: this.facePath(faces, [operation.face], positions)}));
    }
  }
}

class GraphView {
  static CUBE_UNIT = 128;

  // `onNode(index)` is called when a configuration is clicked, and `onTurn()` after the cube was turned.
  constructor(svg, data, onNode) {
    this.svg = svg;
    this.data = data;
    this.onNode = onNode;
    this.cube = data.grid === "cube";
    this.layers = {};
    for (const name of ["quadrants", "lines", "path", "choices", "spots"]) {
      this.layers[name] = svg.appendChild(element("g", {class: name}));
    }
    this.resetTurn();
    this.spots = [];
    data.nodes.forEach((node, index) => node.spots.forEach((at, copy) => this.addSpot(node, index, at, copy)));
    this.lines = [];
    const drawn = new Set();
    data.moves.forEach((move) => {
      const ends = [this.spotIndex(move.from, move.spots[0]), this.spotIndex(move.to, move.spots[1])];
      const key = Math.min(...ends) + "," + Math.max(...ends);
      if (drawn.has(key)) return;
      drawn.add(key);
      this.lines.push(ends);
    });
    this.current = 0;
    this.choices = [];
    this.path = [];
    this.draw();
    if (this.cube) this.listenForTurns();
  }

  resetTurn() {
    this.yaw = Math.PI / 4;  // the view is into the corner of the cube, with axis 1 upwards
    this.pitch = Math.asin(1 / Math.sqrt(3));
  }

  addSpot(node, index, at, copy) {
    const group = element("g", {class: copy ? "spot copy" : "spot"});
    group.append(element("ellipse", {rx: 44, ry: 25}), element("text", {}, node.names[copy] ?? node.label));
    const names = node.names.length > 1 ? `${node.names.join(" and ")} are one configuration` : node.label;
    group.append(element("title", {}, `${names}: ${node.quads} quads`));
    group.addEventListener("click", () => {
      if (!this.turned) this.onNode(index);
    });
    this.spots.push({index, copy, at, group});
  }

  spotIndex(node, copy) {
    return this.spots.findIndex((s) => s.index === node && s.copy === copy);
  }

  // Projects grid coordinates to the plane, with the depth towards the viewer.
  project([x, y, z]) {
    if (!this.cube) {
      const scale = this.data.pair === "3-5" ? 128 : 66;
      return [x * scale, y * scale * (this.data.pair === "3-5" ? 0.8 : 0.75), 0];
    }
    // Axis 1 is the cube's vertical; axes 2 and 3 lie below it to the right and to the left.
    const [up, right, left] = [x, y, z];
    const c = Math.cos(this.yaw);
    const s = Math.sin(this.yaw);
    const across = right * c - left * s;
    const towards = right * s + left * c;
    const scale = GraphView.CUBE_UNIT;
    const cp = Math.cos(this.pitch);
    const sp = Math.sin(this.pitch);
    return [across * scale, (up * cp - towards * sp) * scale, (up * sp + towards * cp) * scale];
  }

  setState(current, choices, path) {
    this.current = current;
    this.choices = choices;
    this.path = path;
    this.draw();
  }

  listenForTurns() {
    let grip = null;
    this.svg.addEventListener("pointerdown", (event) => {
      grip = {x: event.clientX, y: event.clientY};
      this.turned = false;
    });
    window.addEventListener("pointermove", (event) => {
      if (!grip) return;
      const [dx, dy] = [event.clientX - grip.x, event.clientY - grip.y];
      if (!this.turned && Math.hypot(dx, dy) < 6) return;
      this.turned = true;
      grip = {x: event.clientX, y: event.clientY};
      this.turn(-dx / 160, dy / 160);
    });
    window.addEventListener("pointerup", () => {
      grip = null;
    });
    window.addEventListener("pointercancel", () => {
      grip = null;
    });
  }

  turn(yaw, pitch) {
    this.yaw += yaw;
    this.pitch = Math.min(Math.max(this.pitch + pitch, -Math.PI / 2), Math.PI / 2);
    this.draw();
  }

  draw() {
    const places = this.spots.map((spot) => this.project(spot.at));
    this.fit(places);
    const line = (ends, cls) => element("path", {class: cls, d: openPath(ends.map((i) => places[i]))});
    this.layers.lines.replaceChildren(...this.lines.map((ends) => line(ends, "line")));
    const spotOf = (move, end) => this.spotIndex(end ? move.to : move.from, move.spots[end]);
    this.layers.path.replaceChildren(...this.path.map((move) => line([spotOf(move, 0), spotOf(move, 1)], "path")));
    this.layers.choices.replaceChildren(...this.choices.map((move) => {
      const ends = [spotOf(move, 0), spotOf(move, 1)];
      const group = element("g", {class: `choice ${move.key}`, "data-key": move.key});
      const at = between(places[ends[0]], places[ends[1]], 0.52);
      group.append(
          line(ends, "line"), element("circle", {cx: at[0], cy: -at[1], r: 16 * this.boost}),
          element("text", {x: at[0], y: -at[1]}, KEY_SIGNS[move.key]));
      return group;
    }));
    const reachable = new Set(this.choices.map((move) => move.to));
    const onPath = new Set(this.path.flatMap((move) => [move.from, move.to]));
    const order = this.spots.map((_, i) => i).sort((i, j) => places[i][2] - places[j][2]);
    for (const i of order) {
      const {group, index} = this.spots[i];
      group.setAttribute("transform", `translate(${places[i][0].toFixed(1)} ${(-places[i][1]).toFixed(1)})`);
      group.classList.toggle("current", index === this.current);
      group.classList.toggle("reachable", reachable.has(index));
      group.classList.toggle("on-path", onPath.has(index));
      this.layers.spots.appendChild(group);
    }
    this.drawCube();
  }

  // The three faces of the half cube, and its edges.
  drawCube() {
    if (!this.cube) return;
    const far = Math.max(...this.data.nodes.map((node) => node.d1 + node.d2)) + 0.6;
    const axis = (p) => [1, 2, 3].map((q) => (q === (p + 2) % 3 + 1 ? far : 0));
    this.layers.quadrants.replaceChildren(...[1, 2, 3].map((p) => {
      const corners = [[0, 0, 0], axis(p), axis(p - 1)].map((at) => this.project(at));
      return element("path", {class: `quadrant p${p}`, d: closedPath(corners)});
    }));
  }

  // Fits everything into the view. The cube keeps one scale, so that it does not grow and shrink while it turns.
  fit(places) {
    let [left, right, low, high] = [0, 0, 0, 0];
    if (this.cube) {
      const radius = Math.max(...this.spots.map((s) => Math.hypot(...s.at))) * GraphView.CUBE_UNIT;
      [left, right, low, high] = [-0.8 * radius, 0.8 * radius, -0.52 * radius, 0.9 * radius];
    } else {
      const xs = places.map((p) => p[0]);
      const ys = places.map((p) => p[1]);
      [left, right, low, high] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
    }
    const margin = 60;
    this.width = Math.max(right - left + 2 * margin, 700);
    // These must be readable on a large graph, too.
    this.boost = Math.min(Math.max(1, this.width / 1100), 1.7);
    this.svg.style.setProperty("--boost", this.boost);
    const centre = (left + right) / 2;
    this.svg.setAttribute(
        "viewBox", `${centre - this.width / 2} ${- high - margin} ${this.width} ${high - low + 2 * margin}`);
  }
}
