// The page: what is chosen, and what is done.

const $ = (id) => document.getElementById(id);
const plural = (number, one, many = one + "s") => `${number} ${number === 1 ? one : many}`;
const styles = getComputedStyle(document.documentElement);
const colour = (name) => styles.getPropertyValue("--" + name).trim();
const kTint = {alpha: 1, chosen: 2, change: 3};
const kClick = matchMedia("(pointer: coarse)").matches ? "Tap" : "Click";
const kArrowColours = ["slide-first", "slide-second", "open", "close"];

const state = {
  name: "",          // of the file that is open
  status: null,      // what the session says of the mesh
  selection: null,   // as the session takes it, or null
  subject: null,     // what the session says of the selection
  offers: {list: []},
  legal: [],         // of these, those that can be made
  shown: null,       // the offer whose effect is tinted
  tapped: null,      // the offer that was tapped once
  partners: [],      // irregular vertices by their distance from the one that was chosen
  history: [],       // {words, lines, before, after}, those undone last; what was chosen before and after some of them
  helping: false,    // clicks choose third vertices
  saved: 0,          // so many steps were done when the edits were saved last
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

// Does something that may take away the control that the keyboard is at. The focus then goes to the one in its place.
function keepingFocus(call) {
  const had = document.activeElement, byKey = had && had.matches(":focus-visible");
  const list = byKey && had.closest("#offers, #helper-list, #history");
  const buttons = () => (list ? [...list.querySelectorAll("button")] : []);
  const index = buttons().indexOf(had);
  call();
  if (!byKey || (had.isConnected && !had.disabled && had.offsetParent !== null)) return;
  (buttons()[Math.min(index, buttons().length - 1)] || $("canvas")).focus({preventScroll: true});
}

// Takes over what changed, shows it, and chooses this. If the edit is animated, `stages` come first, and quads move for
// `ms` in the end.
function refresh(...all) {
  keepingFocus(() => takeChanges(...all));
}
function takeChanges(selection, stages = [], ms = 0) {
  const before = state.status;
  const now = state.status = library.ask("status");
  if (now.everything) {
    view.setMesh(library, now.capacity);
  } else {
    const frame = library.quads(now.changed, now.capacity);
    if (ms > 0) {
      view.play([...stages, {...frame, ms}], draw);
    } else {
      view.writeQuads(frame);
    }
  }
  if (now.boundary_lines) state.boundary = now.boundary_lines;
  if (now.feature_lines) state.features = now.feature_lines;
  if (now.boundary_lines || now.feature_lines) drawEdges();
  if (!before || before.centre.join() !== now.centre.join() || before.radius !== now.radius)
    view.lookAt(now.centre, now.radius);
  choose(selection);
  showFacts();
  showHistory();
  watchLeaving();
  $("welcome").hidden = true;
}

// Takes over the steps that the session has made since `from` of them were done. Those undone stay if it made none.
function takeSteps(from = state.status.done) {
  const {steps, undone} = library.ask("history", {from});
  state.history.splice(from, state.history.length - from - undone, ...steps);
}

// --- choosing --------------------------------------------------------------------------------------------------------

const kTried = "; others are tried.";
const vertexOf = (id) => ({kind: "vertex", a: id});
const isIrregular = (id) => state.status.irregular.some((v) => v.id === id);

function choose(selection) {
  keepingFocus(() => take(selection));
}
function take(selection) {
  state.selection = selection;
  state.shown = state.tapped = null;
  state.subject = null;
  state.offers = {list: [], why: "", hint: ""};
  if (selection) {
    state.subject = library.ask("subject", {selection, separatrices: true});
    if (!state.subject.live) return take(null);
    state.offers = library.ask("offers", {selection, quick: true});
  }
  if (!selection || selection.kind !== "pair") state.helping = false;
  state.legal = state.offers.list.filter((offer) => !offer.why);
  if (state.offers.more) afterPicture(takeOffers);
  $("clear").disabled = $("closer").disabled = !selection;
  $("partner").disabled = !selection || selection.kind === "edge" || selection.kind === "quad";
  $("subject").textContent = subjectWords();
  showHelpers();
  showOffers();
  if (state.status) showTools();
  draw();
}

// Takes over the offers that take longer to find, if any are missing. Those that there are keep their places.
function takeOffers() {
  if (!state.offers.more) return;
  if (view.playing) return afterPicture(takeOffers);
  const shown = state.legal.indexOf(state.shown);
  state.offers = library.ask("offers", {selection: state.selection});
  state.legal = state.offers.list.filter((offer) => !offer.why);
  state.shown = state.legal[shown] || null;
  keepingFocus(() => {
    showHelpers();
    showOffers();
  });
  draw();
  if ($("live").textContent.endsWith(kTried)) sayOffers();
}

// Calls this after the next picture, which shows what there is so far.
function afterPicture(call) {
  requestAnimationFrame(() => setTimeout(call));
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
  if (state.helping && id !== s.a && id !== s.b) {
    return isIrregular(id) ? toggleHelper(id) : say("Only an irregular vertex can help. “Choose others” again ends this.");
  }
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

// The third vertices of the chosen pair that may help to cancel it.
function helpers() {
  const cancel = state.offers.list.find((offer) => offer.helpers.length > 0);
  return cancel ? cancel.helpers : [];
}
function chooseHelpers(next) {
  const helping = state.helping;
  choose({kind: "pair", a: state.selection.a, b: state.selection.b, ...(next.length ? {helpers: next} : {})});
  takeOffers();
  state.helping = helping;
  showHelpers();
  say($("helpers-text").textContent);
}
// One was pointed at. The first one takes the place of the nearest ones.
function toggleHelper(id) {
  const now = state.selection.helpers || [];
  chooseHelpers(now.includes(id) ? now.filter((other) => other !== id) : [...now, id]);
}

function showSubject() {
  view.show(state.subject.vertices.map((v) => v.at));
  sayOffers();
}

function sayOffers() {
  say(`${subjectWords()} ${plural(state.legal.length, "edit")} can be made${state.offers.more ? kTried : "."}`);
}

function approach() {
  if (state.subject) view.approach(state.subject.vertices.map((v) => v.at), arrowLength());
}

function chooseByNumber(text) {
  const numbers = text.trim().split(/[\s,]+/).filter(Boolean).map(Number);
  const ids = numbers.map((number) => (Number.isInteger(number) ? library.ask("numbered", {number}) : -1));
  if (ids.length < 1 || ids.length > 2 || ids.includes(-1) || ids[0] === ids[1])
    return fail(`There is no such vertex or pair: '${text}'; expected a number from 1 to ${state.status.vertices}, or two different ones.`);
  fail("");
  if (state.helping && ids.length === 1) return chooseVertex(ids[0], false);
  choose(ids.length === 1 ? vertexOf(ids[0]) : {kind: "pair", a: ids[0], b: ids[1]});
  showSubject();
}

// --- doing -----------------------------------------------------------------------------------------------------------

// What is chosen after an edit: the pair where it is then.
function selectionAfter(s, offer) {
  if (s.kind !== "pair") return s;
  const left = [...new Set(offer.after)].filter((id) => id >= 0);
  return left.length === 2 ? {kind: "pair", a: left[0], b: left[1]} : left.length === 1 ? vertexOf(left[0]) : null;
}

const animates = () => $("animate").checked;
const kMotion = 250;        // milliseconds in which quads come to rest
const kStages = 1200;       // and for all stages before, at most
const kMostMoving = 20000;  // quads

const kLong = 300;          // operations: an edit of more is announced before it is made

// An arrow or a button was clicked, which makes the edit. By touch, the first tap shows what it would change.
function takeUp(offer, byTouch) {
  if (!byTouch || state.tapped === offer) return perform(offer);
  showEffect(offer);
  state.tapped = offer;
  say(`${nameWords(offer)}: ${effectWords(offer)}. Tap again to do it.`);
}

function perform(offer) {
  view.finish();
  const selection = state.selection, stages = animates();
  const make = () => {
    const answer = library.ask("perform", {selection, name: offer.name, stages});
    if (answer.why) return fail(answer.why);
    done(selectionAfter(selection, offer), stages ? stageFrames(answer.stages) : [], selection);
  };
  if (offer.operations < kLong) return make();
  $("offers-note").textContent = `${plural(offer.operations, "operation")} are being made …`;
  afterPicture(() => { if (state.selection === selection) make(); });
}

// The stages of an edit for the view. Irregular vertices travel with them.
function stageFrames(stages) {
  const marks = new Map(state.status.irregular.map((v) => [v.id, v]));
  const ms = Math.min(120, kStages / Math.max(stages.length, 1));
  return library.stages(stages.map((stage) => stage.quads)).map((frame, i) => {
    for (const id of stages[i].regular) marks.delete(id);
    for (const v of stages[i].irregular) marks.set(v.id, v);
    const now = [...marks.values()];
    return {...frame, ms, begin: () => view.setMarkers(now, [], [])};
  });
}

// A step was made; this is chosen now, and that was chosen before.
function done(selection, stages = [], before = state.selection) {
  fail("");
  takeSteps();
  Object.assign(state.history[state.history.length - 1], {before, after: selection});
  const moving = animates();
  refresh(selection, stages, moving ? kMotion : 0);
  say(`Done: ${state.history[state.status.done - 1].words}. ${countWords()}.${state.selection ? " Chosen: " + subjectWords() : ""}`);
}
const countWords = () => plural(state.status.irregular.length, "irregular vertex", "irregular vertices");

// An edit that needs no offer.
function edit(what, parameters = {}) {
  if (!state.status) return;
  view.finish();
  const why = library.ask(what, parameters).why;
  if (why) return fail(why);
  done(state.selection);
}

// Undoes or redoes until so many steps are done.
function goTo(count) {
  if (!state.status || count < 0 || count > state.history.length || count === state.status.done) return;
  view.finish();
  stopReducing();
  const by = count < state.status.done ? "undo" : "redo";
  const known = by === "undo" ? state.history[count].before : state.history[count - 1].after;
  for (let i = Math.abs(count - state.status.done); i > 0; --i) library.ask(by);
  fail("");
  refresh(known === undefined ? state.selection : known, [], animates() ? kMotion : 0);
  say(`${by === "undo" ? "Undone" : "Redone"}. ${plural(count, "step")} of ${state.history.length} done` +
      `${count > 0 ? ", the last: " + state.history[count - 1].words : ""}. ${countWords()}.`);
}
