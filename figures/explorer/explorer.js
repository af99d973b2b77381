// The state of the page, and what changes it: moves, paths, the address.

const stillness = window.matchMedia("(prefers-reduced-motion: reduce)");

const state = {
  node: 0,
  moving: null,      // {move, film, boxes, start, duration} while a mesh changes
  path: [],          // indices of moves: the shortest path that is chosen
  step: 0,           // the next one of them
  pathShown: false,  // whether the graph shows the path: once somebody has chosen or played one
  playing: false,
  timer: 0,
  last: null,  // the last move made and the mesh that its operations gave
};

const movesFrom = (node) => data.moves.filter((move) => move.from === node);
const moveByKey = (key) => data.moves.find((move) => move.from === state.node && move.key === key);

// --- drawing ---------------------------------------------------------------------------------------------------------

const meshView = new MeshView($("mesh"), data, {
  onArrow: (key) => press(key),
  onPoint: (key) => pointAt(key),
  onFit: (isClose) => {
    $("close-up").checked = isClose;
  },
});
const graphView = new GraphView($("graph-frame"), $("graph"), data, {
  onNode: (node) => walkTo(node),
  onFit: (fits) => {
    $("whole-graph").closest("label").hidden = fits && !graphView?.isWhole;
  },
});

function announce(text) {
  $("live").textContent = text;
}

function announceNode() {
  const node = data.nodes[state.node];
  const open = KEYS.filter(moveByKey).map((key) => `${key} to ${targetName(moveByKey(key))}`);
  announce(`Configuration ${nameOf(node)}. ${facts(node)} Moves: ${open.join(", ") || "none"}.`);
}

// What the page could not do: shown above the drawings until the next configuration.
function note(text) {
  $("notice").textContent = text;
  $("notice").hidden = !text;
}

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
  const node = data.nodes[state.node];
  for (const button of $("moves").children) {
    const key = button.dataset.key;
    const move = moveByKey(key);
    const [change, what] = [button.querySelector(".change"), button.querySelector(".what")];
    const more = (text) => Object.assign(document.createElement("span"), {className: "more", textContent: text});
    button.setAttribute("aria-disabled", String(!move));
    // A segment has two labellings. A move that adds to the second one says so.
    const seen = move ? move.names[0] : labellingOf(node, key);
    const of = seen === node.label ? "" : ` of ${seen}`;
    change.textContent = move ? move.change : changeOf(node, key) || "–";
    if (move) {
      what.replaceChildren(more(of ? `${of.trim()}, ` : ""), `to ${targetName(move)}`, more(`, ${workOf(move)}`));
      button.setAttribute(
          "aria-label", `${key}: changes ${effect(move)}${of}, to ${targetName(move)}, ${workOf(move)}`);
    } else {
      const why = isMerged(node) ? `not ${key}` : "no room";
      what.replaceChildren(of ? `${of.trim()}: ` : "", why);
      button.setAttribute("aria-label", `${key}: ${why} for a move`);
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
  meshView.show(node);
  $("mesh-title").textContent = `Mesh of ${nameOf(node)}`;
  $("mesh-facts").textContent = facts(node);
  $("caption").textContent = "";
  $("jump").value = String(state.node);
  note("");
  drawGraph();
  drawMoves();
  drawFilmState();
}

// --- moving ----------------------------------------------------------------------------------------------------------

function choose(node) {
  finishMove();
  state.node = node;
  show();
  remember();
  announceNode();
}

const speed = () => 2 ** Number($("speed").value);

function make(move) {
  finishMove();
  const film = new MoveFilm(data.nodes[move.from], data.nodes[move.to], move);
  const count = film.operations.length;
  const whole = film.arrives && count > 0 && !stillness.matches;
  const duration = whole ? Math.min(Math.max(330 * count, 700), 2600) / speed() : 0;
  const boxes = [meshView.box, meshView.boxOf(data.nodes[move.to])];
  state.moving = {move, film, boxes, start: performance.now(), duration};
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
  meshView.setBox(moving.boxes[0].map((x, i) => x + (moving.boxes[1][i] - x) * t));
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
  remember();
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

// --- the address -----------------------------------------------------------------------------------------------------

// explorer.html#2,1 opens at (2,1). The address follows the moves, so that it can be shared, and each configuration
// that somebody went to is one step back. A film is one step, however many moves it has.
const addressOf = (index) => "#" + data.nodes[index].label.replace(/[()]/g, "");

function remember() {
  const address = addressOf(state.node);
  if (location.hash === address) return;
  const isOnWay = state.playing && state.step > 1;
  history[isOnWay ? "replaceState" : "pushState"](null, "", address);
}

// Goes to the configuration that the address names, and says so if there is none.
function openAddress() {
  let name = location.hash.slice(1);
  try {
    name = decodeURIComponent(name);
  } catch {
    // It is no configuration, as will be said.
  }
  name = name.replace(/[()\s]/g, "");
  const node = name ? data.nodes.findIndex((n) => n.names.includes(`(${name})`)) : 0;
  stopPlaying();
  finishMove();
  if (node >= 0) state.node = node;
  show();
  history.replaceState(null, "", addressOf(state.node));
  if (node < 0)
    note(`This region has no configuration (${name}). Here is ${nameOf(data.nodes[state.node])} in its place.`);
  return node >= 0;
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

