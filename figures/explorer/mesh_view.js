// The drawing of one configuration: its mesh, the pair, and the arrows of its moves.

class MeshView {
  static SHORT_ARROW = 36;  // pixels

  // `onArrow(key)` is called when an arrow is clicked, `onPoint(key or null)` when it is pointed at, `onFit(close)`
  // when the view has changed, with whether it is a close-up.
  constructor(svg, data, {onArrow, onPoint, onFit}) {
    this.svg = svg;
    this.onFit = onFit;
    this.data = data;
    this.onArrow = onArrow;
    this.onPoint = onPoint;
    const layer = (name) => svg.appendChild(element("g", {class: name}));
    const layers =
        ["alpha", "changed", "edges", "boundary", "separatrices", "rim", "sides", "ends", "arrows", "irregular"];
    for (const name of layers) {
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
    this.wish = null;
    this.boundary.appendChild(element("path", {d: closedPath(points)}));
    this.loop = points;
    this.node = node;
    new ResizeObserver(() => this.fit()).observe(svg);
  }

  // Outside the boundary: the side lengths E_i near the middle of each side, the strip counts e_i where the
  // separatrices end. E_i moves along its side if e_i is in its way.
  drawLabels() {
    const points = this.loop;
    const centre = points.reduce((sum, p) => plus(sum, p, 1 / points.length), [0, 0]);
    const [large, small] = [this.letters(14, 44, 96), this.letters(12, 26, 74)];
    let at = 0;
    this.sides.replaceChildren();
    this.ends.replaceChildren();
    this.data.sides.forEach((side, i) => {
      const place = (number) => points[number % points.length];
      const middle = between(place(at + Math.floor(side / 2)), place(at + Math.ceil(side / 2)), 0.5);
      let along = minus(place(at + side), place(at));
      if (length(along) < 1) along = [centre[1] - middle[1], middle[0] - centre[0]];
      along = [along[0] / length(along), along[1] / length(along)];
      const across = along[1];  // how far the outward direction, (along[1], -along[0]), points to the right
      const anchor = across > 0.4 ? "start" : across < -0.4 ? "end" : "middle";
      const put = (group, p, size, ...words) => {
        const beside = plus(p, [along[1], -along[0]], (0.95 - 0.4 * Math.abs(across)) * size);
        const label = this.label(beside, ...words, size);
        label.setAttribute("text-anchor", anchor);
        group.append(label);
      };
      const path = this.node.outward[i];
      const end = this.node.vertices[path.at(-1)];
      const ahead = minus(middle, end)[0] * along[0] + minus(middle, end)[1] * along[1];
      const room = large * Math.min(1.25 / Math.abs(along[1]), 3.6 / Math.abs(along[0]));
      const aside = Math.abs(ahead) < room ? (ahead < 0 ? -room : room) - ahead : 0;
      put(this.sides, plus(middle, along, aside), large, "E", i + 1, `\u00a0= ${side}`);
      put(this.ends, end, small, "e", i + 1, `=${path.length - 1}`);
      const [x, y] = place(at);
      this.sides.append(element("circle", {cx: x, cy: -y, r: 0.24 * large, class: "corner"}));
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

  // The radius of an irregular vertex: the same on every screen, but small beside the arrows.
  markRadius() {
    return Math.max(Math.min(9 * this.unitsPerPixel, 0.3 * this.shortestWay(this.node)), 5 * this.unitsPerPixel);
  }

  drawIrregular(vertices, positions) {
    const radius = this.markRadius();
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

  // Close-up: true, false, or null for what the pair needs: close up where the arrows would be too short to be told
  // apart.
  setCloseUp(closeUp) {
    this.wish = closeUp;
    this.fit();
  }

  // The shortest way to a vertex that an arrow points at, in units of the mesh.
  shortestWay(node) {
    const ways = this.data.moves.filter((move) => this.data.nodes[move.from] === node)
                     .flatMap((move) => move.arrows.map(([v, w]) => length(minus(node.vertices[w], node.vertices[v]))));
    return Math.min(this.unit, ...ways);
  }

  // The view box of a configuration: the whole region, or the pair and its surroundings.
  boxOf(node) {
    const [across, down] = [this.svg.clientWidth || 500, this.svg.clientHeight || 500];
    const way = this.shortestWay(node);
    const pixels = way / Math.max(this.whole[2] / across, this.whole[3] / down);
    const isClose = this.wish ?? pixels < MeshView.SHORT_ARROW;
    if (!isClose) return this.whole;
    const points = node.irregular.map((v) => node.vertices[v]);
    const low = [0, 1].map((i) => Math.min(...points.map((p) => p[i])));
    const high = [0, 1].map((i) => Math.max(...points.map((p) => p[i])));
    const side = Math.min(
        Math.max(high[0] - low[0] + 3 * way, high[1] - low[1] + 3 * way, way * Math.min(across, down) / 80),
        Math.max(this.whole[2], this.whole[3]));
    const isCloser = side <= 0.8 * Math.max(this.whole[2], this.whole[3]);
    if (this.wish === null && !isCloser) return this.whole;
    return [(low[0] + high[0] - side) / 2, -(low[1] + high[1] + side) / 2, side, side];
  }

  setBox(box) {
    this.box = box;
    this.svg.setAttribute("viewBox", box.map((x) => x.toFixed(2)).join(" "));
    this.unitsPerPixel = Math.max(box[2] / (this.svg.clientWidth || 500), box[3] / (this.svg.clientHeight || 500));
  }

  fit() {
    this.setBox(this.boxOf(this.node));
    this.svg.classList.toggle("close-up", this.box !== this.whole);
    this.onFit(this.box !== this.whole);
    this.drawLabels();
    this.drawSeparatrices(this.node);
    if (!this.svg.classList.contains("moving")) this.drawPair(this.node);
  }

  // Shows a configuration at rest, and the moves that are possible.
  show(node) {
    this.node = node;
    this.svg.classList.remove("moving");
    this.fit();
    const positions = node.vertices;
    this.drawFaces(node.faces, positions);
    this.alpha.replaceChildren(element("path", {d: this.facePath(node.faces, node.alpha, positions)}));
    const rim = node.rim.map((v) => positions[v]);
    this.rim.replaceChildren(element("path", {d: node.alpha.length ? closedPath(rim) : openPath(rim)}));
    this.changed.replaceChildren();
    this.drawPair(node);
  }

  // The irregular vertices, and the arrows of the moves.
  drawPair(node) {
    const boundary = new Set(boundaryOf(node.faces, node.root));
    this.drawIrregular(irregularVertices(node.faces, boundary), node.vertices);
    const moves = this.data.moves.filter((move) => this.data.nodes[move.from] === node);
    this.arrows.replaceChildren(...moves.map((move) => this.arrowPair(move, moves, node)));
  }

  drawSeparatrices(node) {
    this.separatrices.replaceChildren(
        ...node.outward.map((path) => element("path", {d: openPath(path.map((v) => node.vertices[v]))})));
  }

  // Figure 9: for each move two arrows of one colour. Each points from a vertex of the pair to where the move takes it.
  // Arrows that meet at a vertex, or point at each other, are shorter, so that each head is seen.
  arrowPair(move, moves, node) {
    const positions = node.vertices;
    const group = element("g", {class: `arrow ${move.key}`, "data-key": move.key});
    const pixel = this.unitsPerPixel;
    const head = Math.max(Math.min(13 * pixel, 0.3 * this.shortestWay(node)), 6 * pixel);
    const start = 1.25 * this.markRadius();
    const all = moves.flatMap((other) => other.arrows);
    for (const [v, w] of move.arrows) {
      const way = minus(positions[w], positions[v]);
      const reach = length(way) || 1;
      const direction = [way[0] / reach, way[1] / reach];
      const facing = all.some(([other]) => other === w && other !== v);
      const shared = all.filter(([, end]) => end === w).length > 1;
      const most = facing ? 0.47 * reach : shared ? 0.7 * reach : Math.min(0.86 * reach, 1.2 * this.unit);
      const long = Math.max(most, Math.min(start + 1.5 * head, facing ? 0.5 * reach : reach));
      const tip = plus(positions[v], direction, long);
      const neck = plus(tip, direction, -head);
      const side = [-direction[1], direction[0]];
      const wings = [plus(neck, side, 0.6 * head), plus(neck, side, -0.6 * head)];
      const shaft = openPath([plus(positions[v], direction, Math.min(start, long - head)), neck]);
      const tipPath = closedPath([tip, ...wings]);
      group.append(
          element("path", {class: "halo", d: shaft + tipPath}), element("path", {class: "shaft", d: shaft}),
          element("path", {class: "head", d: tipPath}));
      if (head < 11 * pixel) continue;  // too small for a sign; the colour must suffice
      const badge = plus(neck, direction, 0.34 * head);
      group.append(element("text", {x: badge[0], y: -badge[1], "font-size": 0.9 * head}, KEY_SIGNS[move.key]));
    }
    group.append(element("title", {}, `${move.change} to ${targetName(move)}`));
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
