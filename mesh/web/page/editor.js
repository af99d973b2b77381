// The page: what is chosen, the edits that are offered, the history, files, keys and words.

const $ = (id) => document.getElementById(id);
const plural = (number, one, many = one + "s") => `${number} ${number === 1 ? one : many}`;
const styles = getComputedStyle(document.documentElement);
const colour = (name) => styles.getPropertyValue("--" + name).trim();
const kTint = {alpha: 1, chosen: 2, change: 3};
const kArrowColours = ["slide-first", "slide-second", "open", "close"];

const state = {
  name: "",          // of the file that is open
  status: null,      // what the session says of the mesh
  selection: null,   // as the session takes it, or null
  subject: null,     // what the session says of the selection
  offers: {list: []},
  legal: [],         // of these, those that can be made
  shown: null,       // the offer whose effect is tinted
  partners: [],      // irregular vertices by their distance from the one that was chosen
  history: [],       // {words, lines}, those undone last
};
let library, view;

// --- asking the session ----------------------------------------------------------------------------------------------

function say(words) {
  $("live").textContent = words;
}

function fail(words) {
  $("error").textContent = words;
  $("error").hidden = words === "";
  if (words) say(words);
}

// Takes over what changed, shows it, and chooses this.
function refresh(selection) {
  const before = state.status;
  const now = state.status = library.ask("status");
  if (now.everything) {
    view.setMesh(library, now.capacity);
  } else {
    view.updateQuads(library, now.changed);
  }
  if (!before || before.centre.join() !== now.centre.join() || before.radius !== now.radius)
    view.lookAt(now.centre, now.radius);
  choose(selection);
  showFacts();
  showHistory();
  for (const id of ["export-obj", "export-script", "number", "choose", "next-vertex", "previous-vertex"])
    $(id).disabled = false;
  $("undo").disabled = now.done === 0;
  $("redo").disabled = now.done === state.history.length;
  $("welcome").hidden = true;
}

// --- choosing --------------------------------------------------------------------------------------------------------

const vertexOf = (id) => ({kind: "vertex", a: id});
const isIrregular = (id) => state.status.irregular.some((v) => v.id === id);

function choose(selection) {
  state.selection = selection;
  state.shown = null;
  state.subject = null;
  state.offers = {list: [], why: "", hint: ""};
  if (selection) {
    state.subject = library.ask("subject", {selection, separatrices: true});
    if (!state.subject.live) {
      choose(null);
      return;
    }
    state.offers = library.ask("offers", {selection});
  }
  state.legal = state.offers.list.filter((offer) => !offer.why);
  $("clear").disabled = !selection;
  $("partner").disabled = !selection || selection.kind === "edge" || selection.kind === "quad";
  $("subject").textContent = subjectWords();
  showOffers();
  draw();
}

function subjectWords() {
  if (!state.selection) return "Nothing.";
  const names = state.subject.vertices.map((v) => v.name);
  switch (state.selection.kind) {
    case "pair": return `The pair ${names[0]} and ${names[1]}.`;
    case "edge": return `The edge from ${names[0]} to ${names[1]}.`;
    case "quad": return `The quad ${names.join(", ")}.`;
    default: return `Vertex ${names[0]}.`;
  }
}

// A vertex was pointed at: alone, or as the second of a pair.
function chooseVertex(id, asSecond) {
  const s = state.selection;
  if (s && (s.a === id || s.b === id) && (s.kind === "vertex" || s.kind === "pair")) {
    choose(s.kind === "pair" ? vertexOf(s.a === id ? s.b : s.a) : null);
  } else if (s && s.kind === "vertex" && (asSecond || (isIrregular(s.a) && isIrregular(id)))) {
    choose({kind: "pair", a: s.a, b: id});
  } else {
    choose(vertexOf(id));
  }
  if (!state.selection || state.selection.kind === "vertex") state.partners = [];
  say($("subject").textContent);
}

function step(by) {
  if (!state.status || state.status.irregular.length === 0) return;
  const all = state.status.irregular.map((v) => v.id);
  const at = state.selection ? all.indexOf(state.selection.a) : -1;
  const next = at < 0 ? (by > 0 ? 0 : all.length - 1) : (at + by + all.length) % all.length;
  state.partners = [];
  choose(vertexOf(all[next]));
  showSubject();
}

function nextPartner() {
  const s = state.selection;
  if (!s || (s.kind !== "vertex" && s.kind !== "pair")) return;
  if (state.partners.length === 0 || state.partners.of !== s.a) {
    state.partners = library.ask("nearest", {vertex: s.a, most: 12});
    state.partners.of = s.a;
  }
  if (state.partners.length === 0) return;
  const at = s.kind === "pair" ? state.partners.indexOf(s.b) : -1;
  choose({kind: "pair", a: s.a, b: state.partners[(at + 1) % state.partners.length]});
  showSubject();
}

function showSubject() {
  view.show(state.subject.vertices.map((v) => v.at));
  say(subjectWords() + " " + plural(state.legal.length, "edit") + " can be made.");
}

function chooseByNumber(text) {
  const numbers = text.trim().split(/[\s,]+/).filter(Boolean).map(Number);
  const ids = numbers.map((number) => (Number.isInteger(number) ? library.ask("numbered", {number}) : -1));
  if (ids.length < 1 || ids.length > 2 || ids.includes(-1) || ids[0] === ids[1])
    return fail(`There is no such vertex or pair: '${text}'; expected one or two numbers from 1 to ${state.status.vertices}.`);
  fail("");
  choose(ids.length === 1 ? vertexOf(ids[0]) : {kind: "pair", a: ids[0], b: ids[1]});
  showSubject();
}

// --- doing -----------------------------------------------------------------------------------------------------------

// What is chosen after an edit: the pair where it is then.
function selectionAfter(offer) {
  const s = state.selection;
  if (s.kind !== "pair") return s;
  const left = [...new Set(offer.after)].filter((id) => id >= 0);
  return left.length === 2 ? {kind: "pair", a: left[0], b: left[1]} : left.length === 1 ? vertexOf(left[0]) : null;
}

function perform(offer) {
  const selection = state.selection;
  const why = library.ask("perform", {selection, name: offer.name}).why;
  if (why) return fail(why);
  fail("");
  const last = library.ask("last_step");
  state.history.splice(state.status.done, state.history.length, last);
  refresh(selectionAfter(offer));
  say(`Done: ${last.words}.`);
}

// Undoes or redoes until so many steps are done.
function goTo(count) {
  if (!state.status || count < 0 || count > state.history.length || count === state.status.done) return;
  const by = count < state.status.done ? "undo" : "redo";
  for (let i = Math.abs(count - state.status.done); i > 0; --i) library.ask(by);
  fail("");
  refresh(state.selection);
  say(`${by === "undo" ? "Undone" : "Redone"}. ${plural(count, "step")} of ${state.history.length} done.`);
}

// --- showing ---------------------------------------------------------------------------------------------------------

// The four steps have their colours; transports take them in turn.
const kSteps = ["slide_first", "slide_second", "open", "close"];
function arrowColour(offer) {
  const step = kSteps.indexOf(offer.name.split(".")[0]);
  return colour(kArrowColours[(step >= 0 ? step : state.legal.indexOf(offer)) % kArrowColours.length]);
}

function draw() {
  if (!state.status) return;
  const chosen = state.selection ? [state.selection.a, state.selection.b].filter((id) => id !== undefined) : [];
  const subject = state.subject || {vertices: [], paths: [], quads: []};
  // A chosen vertex is marked even if it is regular.
  const marks = state.status.irregular.concat(state.selection && state.selection.kind !== "quad" ?
      subject.vertices.filter((v) => !isIrregular(v.id)) : []);
  view.setMarkers(marks, chosen);
  const lines = [];
  if ($("show-all-separatrices").checked) lines.push([library.ask("all_separatrices"), colour("separatrix"), 2]);
  const pair = state.selection && state.selection.kind === "pair";
  if ($("show-separatrices").checked && state.selection && (pair || state.selection.kind === "vertex"))
    lines.push([subject.paths, colour("separatrix"), 3.5]);
  if (state.selection && state.selection.kind === "edge")
    lines.push([[subject.vertices.map((v) => v.at)], colour("alpha-rim"), 6]);
  if (pair && $("show-alpha").checked) lines.push([[subject.rim], colour("alpha-rim"), 4]);
  view.setLines(lines);
  showEffect(state.shown);
}

// Tints what the offer would change, or what is chosen, and draws the arrows.
function showEffect(offer) {
  state.shown = offer;
  const tints = [];
  const quad = state.selection && state.selection.kind === "quad";
  if (state.subject && (quad || $("show-alpha").checked)) tints.push([state.subject.quads, quad ? kTint.chosen : kTint.alpha]);
  if (offer) tints.push([offer.quads, kTint.change]);
  view.setTints(tints);
  const arrows = [];
  state.legal.forEach((other, index) => {
    for (const [from, to] of other.arrows)
      arrows.push({from, to, colour: arrowColour(other), tag: index, faint: offer !== null && other !== offer});
  });
  view.setArrows(arrows, state.subject ? arrowLength() : 1);
}

// As long as the edges at the chosen vertices are, on the average.
function arrowLength() {
  const lengths = state.subject.paths.filter((path) => path.length > 1)
      .map(([p, q]) => Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
  return lengths.length ? 0.85 * lengths.reduce((a, b) => a + b) / lengths.length : 0.1 * state.status.radius;
}

function effectWords(offer) {
  const quads = [offer.made ? `${plural(offer.made, "quad")} made` : "", offer.deleted ? `${plural(offer.deleted, "quad")} deleted` : ""]
      .filter(Boolean).join(", ") || "no quad made or deleted";
  return [offer.effect, quads, plural(offer.operations, "operation")].filter(Boolean).join("; ");
}

function showOffers() {
  const note = [state.offers.why, state.offers.hint].filter(Boolean);
  $("offers-note").textContent = note.length ? note.join(". ") : !state.selection ?
      "Choose a vertex, an edge or a quad of the mesh; shift adds a second vertex." : "";
  $("offers").replaceChildren(...state.legal.map((offer, index) => {
    const item = document.createElement("li"), button = document.createElement("button");
    const part = (name, text) => {
      const span = document.createElement("span");
      span.className = name;
      span.textContent = text;
      return span;
    };
    button.type = "button";
    button.dataset.name = offer.name;
    if (offer.arrows.length) button.style.setProperty("--colour", arrowColour(offer));
    button.append(part("key", index < 9 ? String(index + 1) : ""), part("name", offer.name), part("effect", effectWords(offer)));
    button.addEventListener("click", () => perform(offer));
    for (const event of ["pointerenter", "focus"]) button.addEventListener(event, () => showEffect(offer));
    for (const event of ["pointerleave", "blur"])
      button.addEventListener(event, () => { if (state.shown === offer) showEffect(null); });
    item.append(button);
    return item;
  }));
  const refused = state.offers.list.filter((offer) => offer.why);
  $("refused").hidden = refused.length === 0;
  $("refused").open = state.legal.length === 0 || (state.selection && state.selection.kind === "pair");
  $("refused").querySelector("summary").textContent = `Cannot be made: ${refused.length}, and why`;
  $("refused").querySelector("ul").replaceChildren(...refused.map((offer) => {
    const item = document.createElement("li"), name = document.createElement("b"), why = document.createElement("span");
    name.textContent = offer.name + ": ";
    why.textContent = offer.why;
    why.className = "why";
    item.append(name, why);
    return item;
  }));
}

function showFacts() {
  const s = state.status;
  const irregular = Object.entries(s.valences).map(([valence, count]) => `${count} v${valence}`).join(", ") || "none";
  $("facts").textContent = `${state.name}: ${plural(s.vertices, "vertex", "vertices")}, ${plural(s.quads, "quad")}, genus ` +
      `${s.genus}, ${plural(s.boundary_loops, "boundary loop")}. Irregular inside: ${irregular} ` +
      `(${s.irregular.length}; the topology needs ${s.least}).`;
}

function showHistory() {
  const done = state.status.done;
  const start = {words: "the mesh that was opened", lines: []};
  $("history").replaceChildren(...[start, ...state.history].map((step, index) => {
    const item = document.createElement("li"), button = document.createElement("button");
    button.type = "button";
    button.textContent = step.words;
    if (step.lines.length) {
      const lines = document.createElement("code");
      lines.textContent = step.lines.join("; ");
      button.append(lines);
    }
    if (index === done) button.setAttribute("aria-current", "step");
    item.className = index > done ? "undone" : "";
    button.addEventListener("click", () => goTo(index));
    item.append(button);
    return item;
  }));
}

// --- files -----------------------------------------------------------------------------------------------------------

function open(bytes, name, subdivided = false) {
  fail("");
  const answer = library.open(bytes, name, subdivided);
  if (answer.why) {
    fail(answer.why);
    if (answer.subdividing_helps) {
      $("question-text").textContent = answer.why;
      $("subdivide").onclick = () => {
        $("question").close();
        open(bytes, name, true);
      };
      $("question").showModal();
    }
    return;
  }
  state.name = name;
  state.history = [];
  state.partners = [];
  state.status = null;
  refresh(null);
  say(`Opened ${name}. ${plural(state.status.irregular.length, "irregular vertex", "irregular vertices")}.`);
}

async function openFile(file) {
  if (file) open(new Uint8Array(await file.arrayBuffer()), file.name);
}

function save(text, name) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], {type: "text/plain"}));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

// --- mouse, touch and keys -------------------------------------------------------------------------------------------

// What the pointer means at a place of the canvas.
function pointedAt(event) {
  if (!state.status) return null;
  const box = $("canvas").getBoundingClientRect();
  const hit = view.pick(event.clientX - box.x, event.clientY - box.y);
  if (!hit || hit.kind !== "quad") return hit;
  const selection = library.ask("point", {quad: hit.quad, origin: hit.origin, direction: hit.direction});
  return selection && {kind: "selection", selection};
}

function act(event) {
  const hit = pointedAt(event);
  if (!hit) return;
  if (hit.kind === "arrow") {
    perform(state.legal[hit.tag]);
  } else if (hit.kind === "marker") {
    chooseVertex(hit.id, event.shiftKey);
  } else if (hit.selection.kind === "vertex") {
    chooseVertex(hit.selection.a, event.shiftKey);
  } else {
    choose(hit.selection);
    say($("subject").textContent);
  }
}

function listenToPointer() {
  const canvas = $("canvas");
  const kSlack = 6;  // pixels that a click may move
  let pressed = null;
  canvas.addEventListener("pointerdown", (event) => {
    pressed = event.isPrimary && event.button === 0 ? {x: event.clientX, y: event.clientY} : null;
  });
  canvas.addEventListener("pointerup", (event) => {
    if (pressed && event.isPrimary && Math.hypot(event.clientX - pressed.x, event.clientY - pressed.y) < kSlack) act(event);
    pressed = null;
  });
  let asked = 0;
  canvas.addEventListener("pointermove", (event) => {
    if (event.buttons || event.pointerType === "touch" || asked) return;
    asked = requestAnimationFrame(() => {
      asked = 0;
      const hit = state.status && state.legal.some((o) => o.arrows.length) ? pointedAt(event) : null;
      const offer = hit && hit.kind === "arrow" ? state.legal[hit.tag] : null;
      canvas.classList.toggle("pointing", Boolean(offer));
      if (offer !== state.shown) showEffect(offer);
    });
  });
  const frame = $("frame");
  for (const type of ["dragenter", "dragover"]) {
    document.addEventListener(type, (event) => {
      event.preventDefault();
      frame.classList.add("dropping");
    });
  }
  document.addEventListener("dragleave", (event) => { if (!event.relatedTarget) frame.classList.remove("dropping"); });
  document.addEventListener("drop", (event) => {
    event.preventDefault();
    frame.classList.remove("dropping");
    openFile(event.dataTransfer.files[0]);
  });
}

const kKeys = {
  n: () => step(1),
  p: () => step(-1),
  m: nextPartner,
  u: () => goTo(state.status.done - 1),
  r: () => goTo(state.status.done + 1),
  0: () => view.lookAt(state.status.centre, state.status.radius),
  Escape: () => choose(null),
  "+": () => view.zoom(0.8),
  "-": () => view.zoom(1.25),
};
const kTurns = {ArrowLeft: [-0.15, 0], ArrowRight: [0.15, 0], ArrowUp: [0, -0.15], ArrowDown: [0, 0.15]};

function listenToKeys() {
  document.addEventListener("keydown", (event) => {
    const inField = event.target.matches("input:not([type=checkbox]), select, textarea");
    if (document.querySelector("dialog[open]") || inField || event.altKey) return;
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    if (key === "?") return $("help").showModal();
    if (!state.status) return;
    let does = null;
    if (event.ctrlKey || event.metaKey) {
      if (key === "z") does = () => goTo(state.status.done + (event.shiftKey ? 1 : -1));
      if (key === "y") does = () => goTo(state.status.done + 1);
    } else if (kKeys[key]) {
      does = kKeys[key];
    } else if (/^[1-9]$/.test(key) && state.legal[Number(key) - 1]) {
      does = () => perform(state.legal[Number(key) - 1]);
    } else if (kTurns[key] && event.target === $("canvas")) {
      does = () => view.turn(...kTurns[key]);
    }
    if (!does) return;
    event.preventDefault();
    does();
  });
}

function listenToButtons() {
  const on = (id, type, does) => $(id).addEventListener(type, does);
  on("file", "change", (event) => {
    openFile(event.target.files[0]);
    event.target.value = "";
  });
  const examples = JSON.parse($("example-files").textContent);
  for (const name of Object.keys(examples)) $("examples").add(new Option(name, name));
  on("examples", "change", (event) => {
    if (event.target.value) open(new TextEncoder().encode(examples[event.target.value]), event.target.value);
    event.target.value = "";
  });
  on("undo", "click", () => goTo(state.status.done - 1));
  on("redo", "click", () => goTo(state.status.done + 1));
  const stem = () => state.name.replace(/\.[^.]*$/, "");
  on("export-obj", "click", () => save(library.text("obj"), stem() + "-edited.obj"));
  on("export-script", "click", () => save(library.text("script"), stem() + "-edits.txt"));
  on("next-vertex", "click", () => step(1));
  on("previous-vertex", "click", () => step(-1));
  on("partner", "click", nextPartner);
  on("clear", "click", () => choose(null));
  on("by-number", "submit", (event) => {
    event.preventDefault();
    chooseByNumber($("number").value);
  });
  for (const id of ["show-separatrices", "show-all-separatrices", "show-alpha"]) on(id, "change", draw);
  on("reset-view", "click", () => state.status && view.lookAt(state.status.centre, state.status.radius));
  on("leave", "click", () => $("question").close());
  on("help-open", "click", () => $("help").showModal());
  on("help-close", "click", () => $("help").close());
}

async function start() {
  try {
    view = new View($("canvas"));
  } catch (error) {
    return fail("This browser offers no WebGL, which draws the mesh.");
  }
  library = await Library.load();
  view.setColours(colour);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
    view.setColours(colour);
    draw();
  });
  listenToPointer();
  listenToKeys();
  listenToButtons();
  window.editor = {state, library, view};  // for tests
}

start();
