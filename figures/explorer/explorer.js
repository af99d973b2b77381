// The page: its state, the motion of the mesh, and the words.

const data = JSON.parse(document.getElementById("data").textContent);
const $ = (id) => document.getElementById(id);
const symmetric = data.pair !== "3-5";
const stillness = window.matchMedia("(prefers-reduced-motion: reduce)");

const state = {
  node: 0,
  moving: null,      // {move, film, start, duration, whole} while a mesh changes
  path: [],          // indices of moves: the shortest path that is chosen
  step: 0,           // the next one of them
  pathShown: false,  // whether the graph shows the path: once somebody has chosen or played one
  playing: false,
  timer: 0,
  last: null,  // the last move made and the mesh that its operations gave
};

const movesFrom = (node) => data.moves.filter((move) => move.from === node);
const moveByKey = (key) => data.moves.find((move) => move.from === state.node && move.key === key);
const plural = (number, one, many = one + "s") => `${number} ${number === 1 ? one : many}`;
const valences = (node) => {
  const boundary = new Set(boundaryOf(node.faces, node.root));
  return irregularVertices(node.faces, boundary).map(([, valence]) => `v${valence}`).sort();
};

// --- words -----------------------------------------------------------------------------------------------------------

const shape = {
  "3-3": "digon",
  "5-5": "hexagon",
  "3-5": "quadrilateral"
}[data.pair];
const grid = {
  "3-3": "Figure 10",
  "5-5": "Figure 11",
  "3-5": "Figure 12"
}[data.pair];

function facts(node) {
  const place = node.d1 + node.d2 === 0 ? "the pair is merged" :
      node.d1 === 0 || node.d2 === 0    ? `the pair is ${plural(node.d1 + node.d2, "edge")} apart on one separatrix` :
                                          `Rα is ${node.d1} × ${node.d2}`;
  return `${valences(node).join(" and ")}; ${place}; ${node.quads} quads.`;
}

function nameOf(node) {
  return node.names.length > 1 ? node.names.join(" = ") : node.label;
}

const effect = (move) => symmetric ? `(d1,d2) by ${move.change}` : `(m,n) by ${move.change}, (d1,d2) stay`;

function workOf(move) {
  const count = (kind) => move.operations.filter((operation) => operation.kind === kind).length;
  const parts = [["split", "splits"], ["collapse", "collapses"], ["flip", "flips"]]
                    .filter(([kind]) => count(kind))
                    .map(([kind, many]) => plural(count(kind), kind, many));
  return parts.length ? parts.join(", ") : "no operation";
}

function announce(text) {
  $("live").textContent = text;
}

function announceNode() {
  const node = data.nodes[state.node];
  const open = KEYS.filter(moveByKey).map((key) => `${key} to ${data.nodes[moveByKey(key).to].label}`);
  announce(`Configuration ${nameOf(node)}. ${facts(node)} Moves: ${open.join(", ") || "none"}.`);
}

// --- drawing ---------------------------------------------------------------------------------------------------------

const meshView = new MeshView($("mesh"), data, (key) => press(key), (key) => pointAt(key));
const graphView = new GraphView($("graph"), data, (node) => walkTo(node));

function pointAt(key) {
  for (const marked of document.querySelectorAll(".pointed")) marked.classList.remove("pointed");
  if (key)
    for (const shown of document.querySelectorAll(`[data-key="${key}"]`)) shown.classList.add("pointed");
}

function drawGraph() {
  const choices = state.moving ? [] : movesFrom(state.node);
  const path = state.pathShown ? state.path.map((index) => data.moves[index]) : [];
  graphView.setState(state.node, choices, path);
}

function drawMoves() {
  for (const button of $("moves").children) {
    const move = moveByKey(button.dataset.key);
    const [change, what] = [button.querySelector(".change"), button.querySelector(".what")];
    button.setAttribute("aria-disabled", String(!move));
    if (move) {
      const to = data.nodes[move.to].label;
      change.textContent = move.change;
      // Of the two labellings of a segment, the one is named in which the change is true.
      const seen = move.names[0] === data.nodes[move.from].label ? "" : `${move.names[0]} `;
      what.replaceChildren(
          `${seen}to ${move.names[1]}`,
          Object.assign(document.createElement("span"), {className: "more", textContent: `, ${workOf(move)}`}));
      button.setAttribute(
          "aria-label", `${button.dataset.key}: changes ${effect(move)}, ${seen}to ${to}, ${workOf(move)}`);
    } else {
      change.textContent = "–";
      what.textContent = "no room";
      button.setAttribute("aria-label", `${button.dataset.key}: no room for a move`);
    }
  }
}

function drawFilmState() {
  const [from, to] = [Number($("film-from").value), Number($("film-to").value)];
  const total = state.path.length;
  const inside = state.playing || (state.step > 0 && state.step <= total && !finished());
  $("film-play").textContent = state.playing ? "Pause" : inside ? "Go on" : "Play";
  const label = (node) => data.nodes[node].label;
  $("film-state").textContent = total === 0 ?
      `${label(from)} is where the path ends.` :
      `${plural(total, "move")} from ${label(from)} to ${label(to)}` + (state.step ? `; ${state.step} made.` : ".");
}

const finished = () => state.step >= state.path.length;

// The chosen configuration at rest.
function show() {
  const node = data.nodes[state.node];
  meshView.show(node, movesFrom(state.node));
  $("mesh-title").textContent = `Mesh of ${nameOf(node)}`;
  $("mesh-facts").textContent = facts(node);
  $("caption").textContent = "";
  $("jump").value = String(state.node);
  drawGraph();
  drawMoves();
  drawFilmState();
}

// --- moving ----------------------------------------------------------------------------------------------------------

function choose(node) {
  finishMove();
  state.node = node;
  show();
  announceNode();
}

const speed = () => 2 ** Number($("speed").value);

function make(move) {
  finishMove();
  const film = new MoveFilm(data.nodes[move.from], data.nodes[move.to], move);
  const count = film.operations.length;
  const whole = film.arrives && count > 0 && !stillness.matches;
  const duration = whole ? Math.min(Math.max(330 * count, 700), 2600) / speed() : 0;
  state.moving = {move, film, start: performance.now(), duration};
  drawGraph();
  if (whole)
    requestAnimationFrame(tick);
  else
    finishMove();
}

const kindWords = {
  split: "edge split",
  collapse: "quad collapse",
  flip: "edge flip"
};

function tick(now) {
  const moving = state.moving;
  if (!moving) return;
  const t = Math.max(now - moving.start, 0) / moving.duration;
  if (t >= 1) {
    finishMove();
    return;
  }
  const moment = moving.film.at(t);
  meshView.showMoment(moment, moving.film.boundary);
  $("caption").textContent = `${moving.move.change}: ${kindWords[moment.operation.kind]} ${moment.index + 1} of ${
      moving.film.operations.length}`;
  requestAnimationFrame(tick);
}

// Ends a move that is under way. The operations must have made the mesh that the program found.
function finishMove() {
  if (!state.moving) return;
  const {move, film} = state.moving;
  state.moving = null;
  state.last =
      {move: data.moves.indexOf(move), faces: film.result, root: data.nodes[move.from].root, arrives: film.arrives};
  state.node = move.to;
  show();
  if (!film.arrives) {
    const text = `The operations of ${move.change} do not make the mesh of ${data.nodes[move.to].label}.`;
    $("caption").textContent = text;
    console.error(text);
  }
  if (!state.playing) announceNode();
  if (state.playing) playOn();
}

function press(key) {
  stopPlaying();
  finishMove();
  const move = moveByKey(key);
  if (move)
    make(move);
  else
    announce(`No room for a move ${key} from ${data.nodes[state.node].label}.`);
}

// --- the shortest path -----------------------------------------------------------------------------------------------

function choosePath(from, to) {
  stopPlaying();
  $("film-from").value = String(from);
  $("film-to").value = String(to);
  state.path = shortestPath(data.moves, from, to) ?? [];
  state.step = 0;
  state.pathShown = true;
  drawGraph();
  drawFilmState();
}

function stopPlaying() {
  clearTimeout(state.timer);
  state.playing = false;
}

// The present configuration of the film: the start of its next move, or the end of the path.
function filmNode() {
  return finished() ? Number($("film-to").value) : data.moves[state.path[state.step]].from;
}

function rewindIfNeeded() {
  finishMove();
  state.pathShown = true;
  if (finished() || filmNode() !== state.node) {
    state.step = 0;
    choose(Number($("film-from").value));
  }
}

function nextMove() {
  if (finished()) return false;
  make(data.moves[state.path[state.step++]]);
  return true;
}

function play() {
  if (state.playing) {
    stopPlaying();
    finishMove();
    drawFilmState();
    announce("Paused. " + $("film-state").textContent);
    return;
  }
  rewindIfNeeded();
  if (!state.path.length) return;
  state.playing = true;
  announce("Playing: " + $("film-state").textContent);
  nextMove();
  drawFilmState();
}

// Goes on with the film after a pause. The pause is longer if the reader prefers reduced motion.
function playOn() {
  drawFilmState();
  if (finished()) {
    stopPlaying();
    drawFilmState();
    announceNode();
    return;
  }
  state.timer = setTimeout(() => {
    nextMove();
    drawFilmState();
  }, (stillness.matches ? 1200 : 350) / speed());
}

// Handles a click on a configuration. A neighbour is reached by its move, any other one by a shortest path.
function walkTo(node) {
  stopPlaying();
  finishMove();
  if (node === state.node) {
    announceNode();
    return;
  }
  const move = data.moves.find((m) => m.from === state.node && m.to === node);
  if (move) {
    make(move);
    return;
  }
  choosePath(state.node, node);
  play();
}

// --- controls --------------------------------------------------------------------------------------------------------

const arrowKeys = {
  ArrowUp: "up",
  ArrowDown: "down",
  ArrowLeft: "left",
  ArrowRight: "right"
};

// Arrow keys make moves wherever they have no other use.
document.addEventListener("keydown", (event) => {
  const key = arrowKeys[event.key];
  if (!key || event.altKey || event.ctrlKey || event.metaKey) return;
  if (event.target.closest("select, input, #claims-panel, #legend-panel")) return;
  event.preventDefault();
  if (event.shiftKey) {
    if (graphView.cube)
      graphView.turn(
          (key === "left"      ? 0.2 :
               key === "right" ? -0.2 :
                                 0),
          (key === "up"       ? -0.2 :
               key === "down" ? 0.2 :
                                0));
    return;
  }
  press(key);
});

function option(index) {
  return Object.assign(document.createElement("option"), {value: index, textContent: nameOf(data.nodes[index])});
}

function legendItem(drawing, text) {
  const item = document.createElement("li");
  const svg = element("svg", {viewBox: "-44 -30 88 60", "aria-hidden": "true"});
  svg.append(drawing);
  item.append(svg, text);
  return item;
}

function fillPage() {
  const region =
      `${data.regular ? "Regular " + shape : shape[0].toUpperCase() + shape.slice(1)}, sides ${data.sides.join(", ")}`;
  document.title = `requad: ${data.pair} pair, ${data.sides.join(" ")}`;
  $("title").textContent = `${region}: a ${data.pair} pair`;
  $("subtitle").textContent = `Every quad mesh that fills this boundary with a ${
      data.pair} pair inside, and every pair move between two of them (${
      grid} of Peng, Zhang, Kobayashi and Wonka, 2011).`;
  $("graph-title").textContent = `${plural(data.nodes.filter((n) => n.d1 + n.d2 > 0).length, "configuration")}`;
  $("graph-help").innerHTML =
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
  const vertex = (valence) => {
    const group = element("g", {class: `vertex v${valence}`});
    group.append(
        element("path", {d: valenceShape([0, 0], valence, 19)}),
        element("text", {x: 0, y: 2, "font-size": 24}, valence));
    return group;
  };
  const strip = (cls) => element("path", {class: cls, d: "M-36 -20H36V20H-36Z"});
  const words = {
    2: "v2: the two v3 merged",
    3: "v3: an irregular vertex with three edges",
    5: "v5: with five edges",
    6: "v6: the two v5 merged"
  };
  const seen = new Set(data.nodes.flatMap((node) => valences(node).map((name) => Number(name.slice(1)))));
  $("legend").append(
      ...[...seen].sort().map((valence) => legendItem(vertex(valence), words[valence] ?? `v${valence}`)),
      legendItem(strip("alpha"), "Rα, the grid between the two; its sides are d1 and d2"),
      legendItem(
          element("path", {class: "separatrix", d: "M-40 0H40"}),
          "an outward separatrix: e_i quad strips lie between Rα and side i"),
      legendItem(strip("split"), "a quad that an edge split makes"),
      legendItem(strip("collapse"), "a quad that a collapse removes"),
      legendItem(strip("flip"), "two quads whose common edge is flipped"));
  if (graphView.spots.some((spot) => spot.copy)) {
    $("legend").append(legendItem(
        element("path", {class: "copy", d: "M-36 0A36 20 0 0 1 36 0A36 20 0 0 1 -36 0"}),
        "(0,x): the same configuration as (x,0), drawn twice"));
  }
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
  // Labels that would be too small to read are hidden. The label of the chosen configuration is also above the mesh.
  new ResizeObserver(() => {
    const scale = $("graph").clientWidth / graphView.width;
    $("graph").classList.toggle("dense", 21 * scale < 7.5);
  }).observe($("graph"));
  window.addEventListener("hashchange", () => {
    if (openAddress()) announceNode();
  });
}

// explorer.html#(2,1) opens at a configuration.
function openAddress() {
  const name = decodeURIComponent(location.hash.slice(1));
  const node = data.nodes.findIndex((n) => n.names.includes(name));
  if (node < 0) return false;
  stopPlaying();
  finishMove();
  state.node = node;
  show();
  return true;
}

fillPage();
listen();
if (!openAddress()) show();
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
};
