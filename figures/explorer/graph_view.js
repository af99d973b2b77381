// The drawing of the graph of all configurations.

class GraphView {
  static CUBE_UNIT = 128;
  static HALF_HEIGHT = 25;  // of a node; under a finger nodes are rounder
  static HALF_HEIGHT_UNDER_FINGER = 38;
  static LABEL = 24;
  // The least pixels for each unit: a label is then 9.6 pixels high, a node under a finger 34.
  static LEAST_SCALE = 0.4;
  static LEAST_SCALE_UNDER_FINGER = 0.45;

  // `frame` holds the drawing and scrolls if the drawing is larger. `onNode(index)` is called when a configuration is
  // clicked, `onFit(fits)` when the size has changed, with whether all of the graph could be shown at once.
  constructor(frame, svg, data, {onNode, onFit}) {
    this.frame = frame;
    this.svg = svg;
    this.onFit = onFit;
    this.underFinger = window.matchMedia("(pointer: coarse)").matches;
    this.isWhole = false;  // whether all of the graph is shown, however small
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
    new ResizeObserver(() => this.layout()).observe(frame);
  }

  setWhole(isWhole) {
    this.isWhole = isWhole;
    this.layout();
  }

  // The size of the drawing on the screen: as large as the frame, but never so small that nodes cannot be read or hit.
  layout() {
    const least = this.underFinger ? GraphView.LEAST_SCALE_UNDER_FINGER : GraphView.LEAST_SCALE;
    this.svg.style.width = this.svg.style.height = "";
    const all = Math.min(this.frame.clientWidth / this.width, this.svg.clientHeight / this.height);
    const scale = this.isWhole ? all : Math.max(all, least);
    this.scrolls = scale > all * 1.001;
    if (this.scrolls) {
      this.svg.style.width = `${Math.ceil(Math.max(this.width * scale, this.frame.clientWidth))}px`;
      this.svg.style.height = `${Math.ceil(this.height * scale)}px`;
    }
    this.svg.classList.toggle("scrolls", this.scrolls);
    // Labels that would be too small to read are hidden. The label of the chosen configuration is also above the mesh.
    this.svg.classList.toggle("dense", GraphView.LABEL * scale < 8.5);
    this.onFit(all >= least);
    this.showCurrent();
  }

  // Scrolls so that the chosen configuration is seen.
  showCurrent() {
    if (!this.scrolls) return;
    const spot = this.spots.find((s) => s.index === this.current).group.getBoundingClientRect();
    const frame = this.frame.getBoundingClientRect();
    this.frame.scrollBy(
        spot.x + spot.width / 2 - frame.x - frame.width / 2, spot.y + spot.height / 2 - frame.y - frame.height / 2);
  }

  resetTurn() {
    this.yaw = Math.PI / 4;  // the view is into the corner of the cube, with axis 1 upwards
    this.pitch = Math.asin(1 / Math.sqrt(3));
  }

  addSpot(node, index, at, copy) {
    const group = element("g", {class: copy ? "spot copy" : "spot"});
    const name = node.names[copy] ?? node.label;
    const height = this.underFinger ? GraphView.HALF_HEIGHT_UNDER_FINGER : GraphView.HALF_HEIGHT;
    group.append(
        element("ellipse", {rx: Math.max(46, 7.2 * name.length), ry: height}),
        element("text", {"font-size": GraphView.LABEL}, name));
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
    this.showCurrent();
  }

  listenForTurns() {
    let grip = null;
    this.svg.addEventListener("pointerdown", (event) => {
      this.turned = false;
      if (this.scrolls && event.pointerType === "touch") return;  // the finger scrolls
      grip = {x: event.clientX, y: event.clientY};
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
    this.height = high - low + 2 * margin;
    // These must be readable on a large graph, too.
    this.boost = Math.min(Math.max(1, this.width / 1100), 1.7);
    this.svg.style.setProperty("--boost", this.boost);
    const centre = (left + right) / 2;
    this.svg.setAttribute(
        "viewBox", `${centre - this.width / 2} ${-high - margin} ${this.width} ${this.height}`);
  }
}
