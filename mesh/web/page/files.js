// Files, links, and reducing step by step.

// --- files -----------------------------------------------------------------------------------------------------------

const isUnsaved = () => state.status !== null && state.status.done !== state.saved;

// While edits are not saved, the browser asks before it leaves the page.
function watchLeaving() {
  window.onbeforeunload = isUnsaved() ? (event) => event.preventDefault() : null;
}
// The edits are saved as they are now.
function keepEdits() {
  state.saved = state.status.done;
  watchLeaving();
}

// The mesh that was open before, if its edits were not saved: {bytes, name, subdivided, script, steps}.
let left = null;
let opened = null;  // the same of the mesh that is open, without its edits

function goBack() {
  const {bytes, name, subdivided, script} = left;
  open(bytes, name, subdivided);
  replay(new TextEncoder().encode(script), name);
}

function open(bytes, name, subdivided = false) {
  fail("");
  const before = isUnsaved() ? {...opened, script: library.text("script"), steps: state.status.done} : null;
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
  stopReducing();
  view.finish();
  left = before;
  opened = {bytes, name, subdivided};
  $("back").hidden = left === null;
  if (left) $("back").textContent = `Back to ${left.name} with its ${plural(left.steps, "step")}`;
  state.name = name;
  state.saved = 0;
  state.history = [];
  state.partners = [];
  state.status = null;
  refresh(null);
  say(`Opened ${name}. ${plural(state.status.irregular.length, "irregular vertex", "irregular vertices")}.`);
}

// A mesh, or a script of the mesh that is open.
async function openFile(file) {
  if (!file) return;
  const bytes = new Uint8Array(await file.arrayBuffer());
  const begin = new TextDecoder().decode(bytes.subarray(0, 13));
  if (begin !== "requad-script") return open(bytes, file.name);
  if (!state.status) return fail("Open the mesh first to which the script belongs.");
  replay(bytes, file.name);
}

function replay(bytes, name) {
  view.finish();
  const why = library.apply(bytes, name).why;
  if (why) return fail(why);
  done(null);
}

function save(blob, name) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  say(`Saved ${name}.`);
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

const textBlob = (text) => new Blob([text], {type: "text/plain"});

// --- links -----------------------------------------------------------------------------------------------------------

// After its # a link has, with commas between them, the name of an example, the script, compressed, and the numbers of the
// chosen vertices: #figure-17.obj,,153+163.
const kExamples = JSON.parse($("example-files").textContent);
const kExampleTitles = {
  "figure-16.obj": "a v3 that is off its corner",
  "figure-17.obj": "four v3s that are not aligned",
  "figure-18.obj": "a v3 on a sharp edge",
};

const through = async (bytes, stream) =>
  new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());

async function makeLink() {
  const chosen = state.selection && ["vertex", "pair"].includes(state.selection.kind) ?
      state.subject.vertices.map((v) => v.number).join("+") : "";
  let code = "";
  if (state.status.done > 0) {
    const bytes = await through(new TextEncoder().encode(library.text("script")), new CompressionStream("deflate-raw"));
    let letters = "";
    for (const byte of bytes) letters += String.fromCharCode(byte);
    code = btoa(letters).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
  }
  history.replaceState(null, "", "#" + [state.name, code, chosen].join(",").replace(/,+$/, ""));
  let where = "The link is in the address bar.";
  try {
    await navigator.clipboard.writeText(location.href);
    where = "The link is in the address bar and on the clipboard.";
  } catch (error) {
    // Not every browser lets a file write to the clipboard.
  }
  keepEdits();
  say(where);
}

async function followLink() {
  const [name, code, chosen] = location.hash.slice(1).split(",");
  if (!name) return;
  if (!(name in kExamples)) return fail(`The link names no example: '${name}'.`);
  open(new TextEncoder().encode(kExamples[name]), name);
  try {
    if (code) {
      const letters = atob(code.replaceAll("-", "+").replaceAll("_", "/"));
      const bytes = await through(Uint8Array.from(letters, (c) => c.charCodeAt(0)), new DecompressionStream("deflate-raw"));
      replay(bytes, "link");
    }
    if (chosen) {
      chooseByNumber(chosen.replace("+", " "));
      approach();
    }
  } catch (error) {
    fail("The link is broken: its script cannot be read.");
  }
}

// --- reducing --------------------------------------------------------------------------------------------------------

const reducing = {timer: 0, single: false, stopping: false, changed: false, start: 0, until: 0, deviation: 0, shown: 0};
const kSlice = 30;    // milliseconds of work before the page can draw
const kRefresh = 150;  // milliseconds between pictures

// Starts or goes on, until so many irregular vertices are left, or by one cancellation.
function reduce(single) {
  if (reducing.timer || !state.status) return;
  view.finish();
  fail("");
  const until = Number($("until").value), deviation = Number($("deviation").value);
  if (!Number.isInteger(until) || until < 0 || !(deviation >= 0 && deviation <= 100))
    return fail("Reduce: expected a number of vertices, and a deviation from 0 to 100 percent.");
  if (!state.status.reduces || until !== reducing.until || deviation !== reducing.deviation) {
    library.ask("start_reduction", {until, deviation: deviation === 0 ? -1 : deviation / 100});
    Object.assign(reducing, {until, deviation, start: state.status.irregular.length});
    state.status.reduces = true;
  }
  reducing.single = single;
  reducing.stopping = false;
  reducing.shown = performance.now();
  reducing.timer = setTimeout(reduceMore);
  keepingFocus(showTools);
  showReducing("Reducing …");
}

function reduceMore() {
  const start = performance.now();
  let slice = "working", cancelled = false;
  while (performance.now() - start < kSlice && !reducing.stopping && slice !== "ended" && !(cancelled && reducing.single)) {
    slice = library.ask("reduce");
    cancelled = cancelled || slice === "cancelled";
  }
  reducing.changed = reducing.changed || cancelled;
  const ends = slice === "ended" || reducing.stopping || (cancelled && reducing.single);
  if (reducing.changed && (ends || start - reducing.shown > kRefresh)) {
    reducing.changed = false;
    reducing.shown = start;
    takeSteps();
    refresh(null, [], animates() && reducing.single ? kMotion : 0);
    showReducing(`${state.status.irregular.length} irregular vertices.`);
  }
  reducing.timer = ends ? 0 : setTimeout(reduceMore);
  if (slice === "ended" || reducing.stopping) return finishReducing(reducing.stopping);
  if (!ends) return;
  keepingFocus(showTools);
  say(`Done: ${state.history[state.status.done - 1].words}.`);
}

// Ends the reduction with a fit of what it touched.
function finishReducing(stopped = true) {
  if (!state.status || !state.status.reduces) return;
  clearTimeout(reducing.timer);
  reducing.stopping = false;
  showReducing("Fitting what was reduced …");
  reducing.timer = setTimeout(() => {
    reducing.timer = 0;
    const before = state.status.irregular.length;
    library.ask("finish_reduction");
    takeSteps(0);
    refresh(null);
    const left = state.status.irregular.length;
    showReducing(`${plural(left, "irregular vertex", "irregular vertices")} left` +
        (left > before ? "; the last cancellations went too far and were taken back." :
         stopped ? "; stopped." : left > reducing.until ? "; no other pair can be cancelled so." : "."));
    say($("reduce-text").textContent);
  }, 30);
}

// Ends it as it is.
function stopReducing() {
  clearTimeout(reducing.timer);
  reducing.timer = 0;
  showReducing("");
}

function showReducing(words) {
  $("reduce-text").textContent = words;
  const bar = $("reduce-progress");
  bar.hidden = reducing.timer === 0;
  bar.max = Math.max(1, reducing.start - reducing.until);
  bar.value = state.status ? reducing.start - state.status.irregular.length : 0;
}
