// Mouse, touch, keys and buttons.

const isTouch = (event) => event.pointerType === "touch";

// What the pointer means at a place of the canvas. `corner`: of a quad, its nearest corner.
function pointedAt(event, corner = false) {
  if (!state.status) return null;
  const box = $("canvas").getBoundingClientRect();
  const kFinger = 16;  // pixels
  const hit = view.pick(event.clientX - box.x, event.clientY - box.y, isTouch(event) ? kFinger : undefined);
  if (!hit || hit.kind !== "quad") return hit;
  const selection = library.ask("point", {quad: hit.quad, origin: hit.origin, direction: hit.direction, corner});
  return selection && {kind: "selection", selection};
}

// A click, or a tap; `asSecond`: what it means is the second vertex of a pair.
function act(event, asSecond) {
  view.finish();
  if (!state.status) return;
  const hit = pointedAt(event, asSecond);
  if (!hit) {
    if (!state.helping) chooseNothing();
  } else if (hit.kind === "arrow") {
    takeUp(state.legal[hit.tag], isTouch(event));
  } else if (hit.kind === "marker" && event.altKey && state.selection && state.selection.kind === "pair") {
    toggleHelper(hit.id);
  } else if (hit.kind === "marker") {
    chooseVertex(hit.id, asSecond);
  } else if (hit.selection.kind === "vertex" || state.helping) {
    chooseVertex(hit.selection.a, asSecond);
  } else {
    choose(hit.selection);
    say($("subject").textContent);
  }
}

function listenToPointer() {
  const canvas = $("canvas");
  const slack = (event) => (isTouch(event) ? 12 : 6);  // pixels that a click may move
  const kLongPress = 500;                              // milliseconds
  let pressed = null;
  canvas.addEventListener("pointerdown", (event) => {
    pressed = event.isPrimary && event.button === 0 ? {x: event.clientX, y: event.clientY, since: event.timeStamp} : null;
  });
  canvas.addEventListener("pointerup", (event) => {
    if (pressed && event.isPrimary && Math.hypot(event.clientX - pressed.x, event.clientY - pressed.y) < slack(event))
      act(event, event.shiftKey || (isTouch(event) && event.timeStamp - pressed.since > kLongPress));
    pressed = null;
  });
  let asked = 0;
  canvas.addEventListener("pointermove", (event) => {
    if (event.buttons || isTouch(event) || asked) return;
    asked = requestAnimationFrame(() => {
      asked = 0;
      const hit = state.status && state.legal.some((o) => o.arrows.length) ? pointedAt(event) : null;
      const offer = hit && hit.kind === "arrow" ? state.legal[hit.tag] : null;
      canvas.classList.toggle("pointing", Boolean(offer));
      canvas.title = offer ? `${nameWords(offer)}: ${offer.effect}` : "";
      if (offer !== state.shown) showEffect(offer);
    });
  });
  const frame = $("frame");
  // A touch that the browser scrolls by already is not one that turns the mesh.
  for (const type of ["touchstart", "touchmove"])
    frame.addEventListener(type, (event) => { if (!event.cancelable) event.stopPropagation(); }, {capture: true});
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

// Stops what goes on, or chooses nothing.
function leave() {
  if (reducing.timer) {
    reducing.stopping = true;
  } else if (state.helping) {
    setHelping(false);
  } else {
    chooseNothing();
  }
}

function chooseNothing() {
  choose(null);
  say("Nothing is chosen.");
}

function setHelping(helping) {
  state.helping = helping;
  keepingFocus(showHelpers);
  draw();
  say(helping ? `${kClick} irregular vertices that may help, or enter the number of one.` : $("helpers-text").textContent + ".");
}

const kKeys = {
  n: () => step(1),
  p: () => step(-1),
  m: nextPartner,
  u: () => goTo(state.status.done - 1),
  r: () => goTo(state.status.done + 1),
  0: () => view.lookAt(state.status.centre, state.status.radius),
  c: approach,
  Escape: leave,
  "+": () => view.zoom(0.8),
  "=": () => view.zoom(0.8),
  "-": () => view.zoom(1.25),
};
const kTurns = {ArrowLeft: [-0.15, 0], ArrowRight: [0.15, 0], ArrowUp: [0, -0.15], ArrowDown: [0, 0.15]};

function listenToKeys() {
  document.addEventListener("keydown", (event) => {
    const control = event.ctrlKey || event.metaKey;
    const inField = event.target.matches("input:not([type=checkbox]):not([type=range]), textarea") ||
        (event.target.matches("select") && !control);
    if (document.querySelector("dialog[open]") || inField || event.altKey) return;
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    if (key === "?") return $("help").showModal();
    if (!state.status) return;
    let does = null;
    if (control) {
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
  for (const name of Object.keys(kExamples)) $("examples").add(new Option(`${name}: ${kExampleTitles[name]}`, name));
  // Arrows and letters only pass over the examples; Enter opens the one that is shown.
  let byKey = false;
  const openExample = () => {
    const name = $("examples").value;
    if (name) open(new TextEncoder().encode(kExamples[name]), name);
    $("examples").value = "";
    byKey = false;
  };
  on("examples", "change", () => { if (!byKey) openExample(); });
  on("examples", "keydown", (event) => {
    if (event.key === "Enter" && $("examples").value) {
      event.preventDefault();
      openExample();
    } else {
      byKey = !event.altKey && event.key !== "Enter" && event.key !== " ";
    }
  });
  on("examples", "pointerdown", () => { byKey = false; });
  on("examples", "blur", () => { $("examples").value = ""; });
  on("undo", "click", () => goTo(state.status.done - 1));
  on("redo", "click", () => goTo(state.status.done + 1));
  const stem = () => state.name.replace(/\.[^.]*$/, "");
  const saveEdits = (text, name) => {
    save(textBlob(text), name);
    keepEdits();
  };
  on("export-obj", "click", () => saveEdits(library.text("obj"), stem() + "-edited.obj"));
  on("export-script", "click", () => saveEdits(library.text("script"), stem() + "-edits.txt"));
  on("back", "click", goBack);
  on("export-png", "click", async () => save(await view.picture(), stem() + ".png"));
  on("export-link", "click", makeLink);
  on("next-vertex", "click", () => step(1));
  on("previous-vertex", "click", () => step(-1));
  on("partner", "click", nextPartner);
  on("clear", "click", chooseNothing);
  on("closer", "click", approach);
  on("third", "click", () => {
    choose({kind: "pair", a: state.selection.a, b: state.offers.third});
    showSubject();
  });
  on("helping", "click", () => setHelping(!state.helping));
  on("usual-helpers", "click", () => chooseHelpers([]));
  on("time", "input", () => goTo(Number($("time").value)));
  on("paint", "change", () => {
    view.finish();
    library.ask("paint", {paint: $("paint").value});
    view.material.uniforms.paint.value = kPaints.indexOf($("paint").value);
    if (state.status) refresh(state.selection);
  });
  on("show-numbers", "change", () => {
    view.markerUniforms.numbered.value = $("show-numbers").checked ? 1 : 0;
    view.draw();
  });
  const degrees = () => Number($("angle").value);
  on("angle", "input", () => {
    const edges = library.ask("sharp", {degrees: degrees()});
    drawEdges(edges);
    $("degrees").textContent = degrees();
    $("features-text").textContent = `${plural(edges.length, "edge")} would be features`;
  });
  on("angle", "change", () => {
    edit("set_features", {degrees: degrees()});
    drawEdges();
    showTools();
  });
  on("no-features", "click", () => edit("clear_features"));
  on("smooth-near", "click", () => {
    const {a, b} = state.selection;
    edit("smooth", {vertices: b === undefined ? [a] : [a, b], rings: 3});
  });
  on("smooth-all", "click", () => edit("smooth", {vertices: [], rings: 0}));
  on("reduce", "click", () => reduce(false));
  on("reduce-one", "click", () => reduce(true));
  // A slice that is under way ends first.
  on("reduce-stop", "click", () => {
    if (reducing.timer) reducing.stopping = true;
    else finishReducing();
  });
  on("by-number", "submit", (event) => {
    event.preventDefault();
    chooseByNumber($("number").value);
  });
  on("show-edges", "change", () => {
    view.material.uniforms.edges.value = $("show-edges").checked ? 1 : 0;
    view.draw();
  });
  for (const id of ["show-separatrices", "show-all-separatrices", "show-alpha"]) on(id, "change", draw);
  on("reset-view", "click", () => state.status && view.lookAt(state.status.centre, state.status.radius));
  on("leave", "click", () => $("question").close());
  on("help-open", "click", () => $("help").showModal());
  on("help-close", "click", () => $("help").close());
  on("help", "click", (event) => { if (event.target === $("help")) $("help").close(); });
  on("until", "focus", () => $("until").select());
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
    if (state.status) drawEdges();
  });
  const still = matchMedia("(prefers-reduced-motion: reduce)");
  $("animate").checked = !still.matches;
  still.addEventListener("change", () => { $("animate").checked = !still.matches; });
  listenToPointer();
  listenToKeys();
  listenToButtons();
  showOffers();
  await followLink();
  window.addEventListener("hashchange", followLink);
  window.editor = {state, library, view};  // for tests
}

start();
