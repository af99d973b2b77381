// The controls of the page, and the parts that are written once.

const arrowKeys = {
  ArrowUp: "up",
  ArrowDown: "down",
  ArrowLeft: "left",
  ArrowRight: "right"
};

// Arrow keys make moves while a drawing or a move has the focus. If nothing has the focus they make moves where there
// is room for one and a drawing is on the screen. Elsewhere they scroll the page or belong to what has the focus.
document.addEventListener("keydown", (event) => {
  const key = arrowKeys[event.key];
  if (!key || event.altKey || event.ctrlKey || event.metaKey) return;
  if (event.target.closest("select, input")) return;
  const isHere = event.target.closest("#graph-panel, #mesh-panel, #moves-panel") !== null;
  if (!isHere && (document.activeElement !== document.body || !(isSeen($("graph-frame")) || isSeen($("mesh-frame")))))
    return;
  if (event.shiftKey) {
    if (!graphView.cube) return;
    event.preventDefault();
    const [across, up] = {left: [0.2, 0], right: [-0.2, 0], up: [0, -0.2], down: [0, 0.2]}[key];
    graphView.turn(across, up);
    return;
  }
  if (isHere || moveByKey(key)) event.preventDefault();
  press(key);
});

// Whether at least half of the element is on the screen.
function isSeen(part) {
  const box = part.getBoundingClientRect();
  return Math.min(box.bottom, window.innerHeight) - Math.max(box.top, 0) > box.height / 2;
}

function option(index) {
  return Object.assign(document.createElement("option"), {value: index, textContent: nameOf(data.nodes[index])});
}

// An item of the legend: groups with the classes that the drawings have, so that they look as there.
function legendItem(kind, parts, text) {
  const item = document.createElement("li");
  const svg = element("svg", {class: kind, viewBox: "-44 -30 88 60", "aria-hidden": "true"});
  for (const [css, ...drawn] of parts) {
    const group = svg.appendChild(element("g", {class: css}));
    group.append(...drawn);
  }
  item.append(svg, text);
  return item;
}

const shapeOf = (d) => element("path", {d});

function legendItems() {
  const strip = () => shapeOf("M-36 -20H36V20H-36Z");
  const vertex = (valence) => legendItem(
      "drawing", [[
        `vertex v${valence}`, shapeOf(valenceShape([0, 0], valence, 22)),
        element("text", {x: 0, y: valence === 3 ? 2 : 0, "font-size": 27}, valence)
      ]],
      {
        2: "v2: the two v3 merged",
        3: "v3: an irregular vertex with three edges",
        5: "v5: an irregular vertex with five edges",
        6: "v6: the two v5 merged"
      }[valence] ?? `v${valence}`);
  const arrow = (key) => [
    `arrow ${key}`, element("path", {class: "shaft", d: "M-36 0H6"}),
    element("path", {class: "head", d: "M38 0L4 20V-20Z"}),
    element("text", {x: 15, y: 1, "font-size": 28}, KEY_SIGNS[key])
  ];
  const node = (css, text) =>
      [css, element("ellipse", {rx: 38, ry: 21}), element("text", {"font-size": 21}, text)];
  const seen = new Set(data.nodes.flatMap((n) => valences(n).map((name) => Number(name.slice(1)))));
  const items = [
    ...[...seen].sort().map(vertex),
    legendItem(
        "drawing", [["alpha", strip()], ["rim", strip()]], "Rα, the grid between the two; its sides are d1 and d2"),
    legendItem(
        "drawing", [["separatrices", shapeOf("M-40 0H40")]],
        "an outward separatrix: e_i quad strips lie between Rα and side i"),
    legendItem(
        "drawing", [arrow("up")],
        "where a move takes a vertex of the pair, in the colour and with the sign of its button"),
    ...[["split", "a quad that an edge split makes"], ["collapse", "a quad that a collapse removes"],
        ["flip", "two quads whose common edge is flipped"]]
        .map(([css, text]) => {
          const quad = strip();
          quad.setAttribute("class", css);
          return legendItem("drawing", [["changed", quad]], text);
        }),
    legendItem("network", [node("spot current", "m,n")], "the configuration that the mesh shows"),
    legendItem("network", [node("spot reachable", "m,n")], "a configuration that one move reaches"),
    legendItem(
        "network", [["path", element("path", {class: "path", d: "M-40 0H40"})]], "the shortest path that is chosen"),
  ];
  if (graphView.spots.some((spot) => spot.copy))
    items.push(
        legendItem("network", [node("spot copy", "0,x")], "(0,x): the same configuration as (x,0), drawn twice"));
  return items;
}

function fillPage() {
  const region =
      `${data.regular ? "Regular " + shape : shape[0].toUpperCase() + shape.slice(1)}, sides ${data.sides.join(", ")}`;
  document.title = `requad: ${data.pair} pair, ${data.sides.join(" ")}`;
  $("title").textContent = `${region}: a ${data.pair} pair`;
  $("subtitle").textContent = `Every quad mesh that fills this boundary with a ${
      data.pair} pair inside, and every pair move between two of them (${
      grid} of Peng, Zhang, Kobayashi and Wonka, 2011).`;
  $("graph-title").textContent = countOf(data.nodes);
  $("graph-help").innerHTML = graphView.underFinger ?
      "A tap on a configuration goes there by a shortest path." :
      "<kbd>←</kbd> <kbd>↑</kbd> <kbd>↓</kbd> <kbd>→</kbd> make a move; a click goes there by a shortest path." +
          (graphView.cube ? " Drag, or <kbd>Shift</kbd> with an arrow key, turns the cube." : "");
  for (const id of ["jump", "film-from", "film-to"]) $(id).append(...data.nodes.map((_, index) => option(index)));
  for (const key of KEYS) {
    const button = Object.assign(document.createElement("button"), {type: "button", className: `move ${key}`});
    button.dataset.key = key;
    for (const [name, text] of [["sign", KEY_SIGNS[key]], ["change", ""], ["what", ""]]) {
      button.append(Object.assign(document.createElement("span"), {className: name, textContent: text}));
    }
    button.addEventListener("click", () => press(key));
    for (const type of ["pointerenter", "focus"]) button.addEventListener(type, () => pointAt(key));
    for (const type of ["pointerleave", "blur"]) button.addEventListener(type, () => pointAt(null));
    $("moves").append(button);
  }
  for (const claim of data.claims) {
    const row = $("claims").tBodies[0].insertRow();
    row.insertCell().append(
        `${claim.id}. ${claim.statement} `,
        Object.assign(document.createElement("span"), {className: "where", textContent: `(${claim.where})`}));
    for (const name of ["predicted", "found"]) {
      const cell = row.insertCell();
      cell.textContent = claim[name];
      cell.dataset.title = name;
    }
    row.insertCell().append(
        Object.assign(
            document.createElement("span"),
            claim.holds ? {className: "holds", textContent: "✓ holds"} : {className: "fails", textContent: "✗ fails"}),
        claim.holds ? "" : ` ${claim.violation}`);
  }
  if (data.claims.some((claim) => !claim.holds)) $("claims-title").textContent = "Claims, some of which fail here";
  $("legend").append(...legendItems());
}

function listen() {
  $("jump").addEventListener("change", (event) => {
    stopPlaying();
    choose(Number(event.target.value));
  });
  for (const id of ["film-from", "film-to"]) {
    $(id).addEventListener("change", () => choosePath(Number($("film-from").value), Number($("film-to").value)));
  }
  $("film-swap").addEventListener("click", () => choosePath(Number($("film-to").value), Number($("film-from").value)));
  $("film-play").addEventListener("click", play);
  $("film-step").addEventListener("click", () => {
    stopPlaying();
    if (state.moving)
      finishMove();
    else if (finished() || filmNode() !== state.node)
      rewindIfNeeded();
    else
      nextMove();
    drawFilmState();
  });
  for (const name of ["arrows", "separatrices", "alpha"]) {
    $(`show-${name}`)
        .addEventListener("change", (event) => $("mesh").classList.toggle(`no-${name}`, !event.target.checked));
  }
  $("close-up").addEventListener("change", (event) => meshView.setCloseUp(event.target.checked));
  $("whole-graph").addEventListener("change", (event) => graphView.setWhole(event.target.checked));
  $("save-svg").addEventListener("click", () => {
    finishMove();
    const node = data.nodes[state.node];
    save(fileName(node, "svg"), "image/svg+xml", svgText(meshView, `${data.pair} pair, ${nameOf(node)}`));
  });
  $("save-obj").addEventListener("click", () => {
    finishMove();
    const node = data.nodes[state.node];
    save(fileName(node, "obj"), "text/plain", objText(node, meshView.unit));
  });
  if (graphView.cube) {
    document.querySelector(".turns").hidden = false;
    $("graph").classList.add("cube");
    $("turn-left").addEventListener("click", () => graphView.turn(0.25, 0));
    $("turn-right").addEventListener("click", () => graphView.turn(-0.25, 0));
    $("turn-reset").addEventListener("click", () => {
      graphView.resetTurn();
      graphView.draw();
    });
  }
  // Back and forward, and an address that somebody enters.
  for (const type of ["popstate", "hashchange"]) {
    window.addEventListener(type, () => {
      if (location.hash !== addressOf(state.node) && openAddress()) announceNode();
    });
  }
}

fillPage();
listen();
openAddress();
// At the start, the film leads from the first configuration to one that is farthest from it.
$("film-to").value = String([...reached(data.moves, 0).keys()].at(-1));
state.path = shortestPath(data.moves, 0, Number($("film-to").value));
drawFilmState();

// The interface for tests.
window.explorer = {
  data,
  state: () => ({
    node: state.node,
    label: data.nodes[state.node].label,
    moving: state.moving !== null,
    playing: state.playing,
    path: state.path,
    step: state.step,
    last: state.last
  }),
  files: () => ({
    svg: svgText(meshView, "the mesh"),
    obj: objText(data.nodes[state.node], meshView.unit),
  }),
};
