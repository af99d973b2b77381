// The data of the page, and its words: what configurations and moves are called, and what is said of them.

const data = JSON.parse(document.getElementById("data").textContent);
const $ = (id) => document.getElementById(id);
const symmetric = data.pair !== "3-5";
const plural = (number, one, many = one + "s") => `${number} ${number === 1 ? one : many}`;

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

const valences = (node) => {
  const boundary = new Set(boundaryOf(node.faces, node.root));
  return irregularVertices(node.faces, boundary).map(([, valence]) => `v${valence}`).sort();
};
const isMerged = (node) => node.d1 + node.d2 === 0;
const isSegment = (node) => symmetric && !isMerged(node) && (node.d1 === 0 || node.d2 === 0);

// "18 configurations and the merged one".
function countOf(nodes) {
  const pairs = nodes.filter((node) => !isMerged(node)).length;
  return plural(pairs, "configuration") + (pairs < nodes.length ? " and the merged one" : "");
}

function facts(node) {
  const place = isMerged(node)       ? "the pair is merged" :
      node.d1 === 0 || node.d2 === 0 ? `the pair is ${plural(node.d1 + node.d2, "edge")} apart on one separatrix` :
                                       `Rα is ${node.d1} × ${node.d2}`;
  return `${valences(node).join(" and ")}; ${place}; ${node.quads} quads.`;
}

function nameOf(node) {
  return node.names.length > 1 ? node.names.join(" = ") : node.label;
}

// What the graph calls the configuration where a move starts and where it leads.
const spotName = (index, spot) => data.nodes[index].names[spot] ?? data.nodes[index].label;
const sourceName = (move) => spotName(move.from, move.spots[0]);
const targetName = (move) => spotName(move.to, move.spots[1]);

const effect = (move) => symmetric ? `(d1,d2) by ${move.change}` : `(m,n) by ${move.change}, (d1,d2) stay`;

function workOf(move) {
  const count = (kind) => move.operations.filter((operation) => operation.kind === kind).length;
  const parts = [["split", "splits"], ["collapse", "collapses"], ["flip", "flips"]]
                    .filter(([kind]) => count(kind))
                    .map(([kind, many]) => plural(count(kind), kind, many));
  return parts.length ? parts.join(", ") : "no operation";
}

// What the move of a key would add to the label, "" if a merged vertex does not part that way.
function changeOf(node, key) {
  if (!symmetric) return {up: "(0,+1)", left: "(-1,0)", right: "(+1,0)", down: "(0,-1)"}[key];
  if (isMerged(node)) return "";
  return {up: "(+1,+1)", left: "(-1,+1)", right: "(+1,-1)", down: isSegment(node) ? "(+1,+1)" : "(-1,-1)"}[key];
}

// Of the two labellings of a segment, the one to which the moves of a key add.
const labellingOf = (node, key) => isSegment(node) ? node.names["up left".includes(key) ? 0 : 1] : node.label;
