// What the page shows beside the mesh: words, lists and buttons; and what it draws on the mesh.

// The four steps have their colours; transports take them in turn.
const kSteps = ["slide_first", "slide_second", "open", "close"];
function arrowColour(offer) {
  const step = kSteps.indexOf(offer.name.split(".")[0]);
  return colour(kArrowColours[(step >= 0 ? step : state.legal.indexOf(offer)) % kArrowColours.length]);
}

function draw() {
  if (!state.status || view.playing) return;
  const chosen = state.selection ? [state.selection.a, state.selection.b].filter((id) => id !== undefined) : [];
  const subject = state.subject || {vertices: [], paths: [], quads: []};
  // A chosen vertex is marked even if it is regular.
  const marks = state.status.irregular.concat(state.selection && state.selection.kind !== "quad" ?
      subject.vertices.filter((v) => !isIrregular(v.id)) : []);
  view.setMarkers(marks, chosen, helpers());
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

// The boundary, and features: those of the session, or those that a slider asks about.
function drawEdges(features = state.features) {
  view.setLines([[state.boundary, colour("boundary"), 3], [features, colour("feature"), 4]], view.edges);
}

// Tints what the offer would change, or what is chosen, and draws the arrows.
function showEffect(offer) {
  state.shown = offer;
  [...$("offers").children].forEach((item, index) => item.classList.toggle("shown", offer !== null && state.legal[index] === offer));
  const tints = [];
  const quad = state.selection && state.selection.kind === "quad";
  if (state.subject && (quad || $("show-alpha").checked)) tints.push([state.subject.quads, quad ? kTint.chosen : kTint.alpha]);
  if (offer) tints.push([offer.quads, kTint.change]);
  view.setTints(tints);
  if (view.playing) return;
  const arrows = [];
  // While third vertices are chosen, no arrow is in front of them.
  const offered = state.helping ? [] : state.legal;
  offered.forEach((other, index) => {
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

// The name that scripts and requad-edit have for it, in words.
const nameWords = (offer) => offer.name.replaceAll("_", " ");

function effectWords(offer) {
  const quads = [offer.made ? `${plural(offer.made, "quad")} made` : "", offer.deleted ? `${plural(offer.deleted, "quad")} deleted` : ""]
      .filter(Boolean).join(", ") || "no quad made or deleted";
  return [offer.effect, quads, plural(offer.operations, "operation")].filter(Boolean).join("; ");
}

function showOffers() {
  const note = [state.offers.why, state.offers.hint, state.offers.more ? "Looking for more …" : ""].filter(Boolean);
  $("offers-note").textContent = note.length ? note.join(". ") : !state.selection ?
      `${kClick} a vertex, an edge or a quad of the mesh, or a second irregular vertex.` : "";
  $("third").hidden = !(state.offers.third >= 0);
  if (!$("third").hidden) $("third").textContent = "Choose " + library.ask("name", {vertex: state.offers.third}) + " instead";
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
    button.append(part("key", index < 9 ? String(index + 1) : ""), part("name", nameWords(offer)), part("effect", effectWords(offer)));
    button.addEventListener("click", (event) => takeUp(offer, isTouch(event)));
    for (const event of ["pointerenter", "focus"]) button.addEventListener(event, () => showEffect(offer));
    for (const event of ["pointerleave", "blur"])
      button.addEventListener(event, () => { if (state.shown === offer) showEffect(null); });
    item.append(button);
    return item;
  }));
  const refused = state.offers.list.filter((offer) => offer.why);
  $("refused").hidden = refused.length === 0;
  $("refused").open = state.legal.length === 0 && !state.offers.more;
  $("refused").querySelector("summary").textContent = `Cannot be made: ${refused.length}, and why`;
  $("refused").querySelector("ul").replaceChildren(...refused.map((offer) => {
    const item = document.createElement("li"), name = document.createElement("b"), why = document.createElement("span");
    name.textContent = nameWords(offer) + ": ";
    why.textContent = offer.why + (offer.help ? ". What helps: " + offer.help + "." : "");
    why.className = "why";
    item.append(name, why);
    return item;
  }));
}

function showHelpers() {
  const ids = helpers();
  $("helpers").hidden = ids.length === 0 && !state.helping;
  if (state.helping || (state.selection && state.selection.helpers)) $("helpers").open = true;
  $("helpers-text").textContent = "Third vertices that may help to cancel: " +
      (state.selection && state.selection.helpers ? `your choice of ${ids.length}` : `the nearest ${ids.length}`);
  $("helper-list").replaceChildren(...ids.map((id) => {
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = library.ask("name", {vertex: id}) + " ×";
    button.setAttribute("aria-label", "without " + library.ask("name", {vertex: id}));
    button.addEventListener("click", () => chooseHelpers(ids.filter((other) => other !== id)));
    return button;
  }));
  $("helping").setAttribute("aria-pressed", String(state.helping));
}

// What can be done with the mesh as a whole, and with the history.
function showTools() {
  const s = state.status;
  const always = ["export-obj", "export-script", "export-png", "number", "choose", "next-vertex", "previous-vertex",
    "smooth-all", "angle", "until", "deviation"];
  for (const id of always) $(id).disabled = false;
  $("export-link").disabled = !(state.name in kExamples);
  $("undo").disabled = s.done === 0;
  $("redo").disabled = s.done === state.history.length;
  $("smooth-near").disabled = !state.selection || state.selection.kind === "quad";
  $("no-features").disabled = s.features === 0;
  $("features-text").textContent = plural(s.features, "feature edge");
  const minimal = s.irregular.length === 0;
  for (const id of ["reduce", "reduce-one"]) $(id).disabled = reducing.timer !== 0 || minimal;
  $("reduce-stop").disabled = !s.reduces;
}

function showFacts() {
  const s = state.status;
  const irregular = Object.entries(s.valences).map(([valence, count]) => `${count} v${valence}`).join(", ") || "none";
  $("facts").textContent = `${state.name}: ${plural(s.vertices, "vertex", "vertices")}, ${plural(s.quads, "quad")}, genus ` +
      `${s.genus}, ${plural(s.boundary_loops, "boundary loop")}. Irregular inside: ${irregular} ` +
      `(${s.irregular.length}; the topology needs ${s.least}), 4 − l summed up: ${s.index_sum}.` +
      (s.inverted ? ` Inverted quads: ${s.inverted}.` : "");
}

function showHistory() {
  const done = state.status.done;
  $("time").max = state.history.length;
  $("time").value = done;
  $("time").disabled = state.history.length === 0;
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
  const list = $("history"), current = list.children[done];
  list.scrollTop += current.getBoundingClientRect().top - list.getBoundingClientRect().top - list.clientHeight / 2;
}
