"use strict";
// Meshes as lists of faces, and what a move does to one, operation by operation. Nothing here touches the page.
//
// A mesh is an array of faces [a, b, c, d], counter-clockwise vertex ids, null where a face id is free; positions are
// an array of points [x, y] by vertex id. The data are described in figures/explorer/explorer.hpp.

// The faces after a patch; the argument stays as it is.
function patched(faces, patch) {
  const result = faces.slice();
  for (const [face, ...corners] of patch) result[face] = corners.length ? corners : null;
  return result;
}

const edgeKey = (a, b) => a * 1e6 + b;

// Directed edges: key of (a, b) -> [face on the left, corner of a].
function directedEdges(faces) {
  const edges = new Map();
  faces.forEach((corners, face) => {
    if (corners) corners.forEach((a, k) => edges.set(edgeKey(a, corners[(k + 1) % 4]), [face, k]));
  });
  return edges;
}

// The isomorphism that takes one root edge to the other, as a map of vertices; null if there is none. So two meshes are
// compared rel boundary.
function isomorphism(faces, root, others, otherRoot) {
  const edges = directedEdges(faces);
  const otherEdges = directedEdges(others);
  if (edges.size !== otherEdges.size) return null;
  const vertexOf = new Map();
  const taken = new Map();
  const placeOf = new Map();  // face -> its place in the other mesh, as "face,corner" of its corner 0
  const start = edges.get(edgeKey(...root));
  const otherStart = otherEdges.get(edgeKey(...otherRoot));
  if (!start || !otherStart) return null;
  const queue = [[start, otherStart]];
  while (queue.length) {
    const [[face, k], [other, l]] = queue.pop();
    const place = other * 4 + ((l - k + 4) % 4);
    if (placeOf.has(face)) {
      if (placeOf.get(face) !== place) return null;
      continue;
    }
    placeOf.set(face, place);
    for (let i = 0; i < 4; ++i) {
      const [a, b] = [faces[face][(k + i) % 4], faces[face][(k + i + 1) % 4]];
      const [c, d] = [others[other][(l + i) % 4], others[other][(l + i + 1) % 4]];
      if ((vertexOf.has(a) && vertexOf.get(a) !== c) || (taken.has(c) && taken.get(c) !== a)) return null;
      vertexOf.set(a, c);
      taken.set(c, a);
      const twin = edges.get(edgeKey(b, a));
      const otherTwin = otherEdges.get(edgeKey(d, c));
      if (Boolean(twin) !== Boolean(otherTwin)) return null;
      if (twin) queue.push([twin, otherTwin]);
    }
  }
  return placeOf.size * 4 === edges.size ? vertexOf : null;
}

// Vertices on the boundary, in order, counter-clockwise from the root's.
function boundaryOf(faces, root) {
  const edges = directedEdges(faces);
  const next = new Map();
  for (const corners of faces) {
    if (!corners) continue;
    corners.forEach((a, k) => {
      const b = corners[(k + 1) % 4];
      if (!edges.has(edgeKey(b, a))) next.set(a, b);
    });
  }
  const loop = [root[0]];
  for (let v = next.get(root[0]); v !== root[0]; v = next.get(v)) loop.push(v);
  return loop;
}

// Interior vertices whose valence is not 4, as [vertex, valence].
function irregularVertices(faces, boundary) {
  const valence = new Map();
  for (const corners of faces) {
    if (corners)
      for (const v of corners) valence.set(v, (valence.get(v) ?? 0) + 1);
  }
  return [...valence].filter(([v, number]) => number !== 4 && !boundary.has(v));
}

const between = (p, q, t) => [p[0] + (q[0] - p[0]) * t, p[1] + (q[1] - p[1]) * t];

// Positions that stay near the given ones, with every interior vertex drawn towards its neighbours.
function evened(faces, positions, boundary) {
  const neighbours = new Map();
  for (const corners of faces) {
    if (!corners) continue;
    corners.forEach((a, k) => {
      for (const b of [corners[(k + 1) % 4], corners[(k + 3) % 4]]) {
        if (!neighbours.has(a)) neighbours.set(a, new Set());
        neighbours.get(a).add(b);
      }
    });
  }
  const result = positions.slice();
  for (let round = 0; round < 14; ++round) {
    for (const [v, around] of neighbours) {
      if (boundary.has(v)) continue;
      let [x, y] = positions[v];
      for (const w of around) {
        x += result[w][0];
        y += result[w][1];
      }
      result[v] = [x / (around.size + 1), y / (around.size + 1)];
    }
  }
  return result;
}

// A move as a film: the meshes between its operations, and a drawing for every moment from 0 to 1.
//
// A vertex goes from where it is drawn before the move to where its image under the isomorphism is drawn after it. One
// that a collapse removes goes where the vertex goes into which it merges; one that a split makes comes from where the
// vertex was that it parted from.
class MoveFilm {
  constructor(from, to, move) {
    this.operations = move.operations;
    this.meshes = [from.faces];
    for (const operation of this.operations) this.meshes.push(patched(this.meshes.at(-1), operation.patch));
    this.boundary = new Set(boundaryOf(from.faces, from.root));
    // No operation touches the boundary, so the root keeps its name.
    const image = isomorphism(this.result, from.root, to.faces, to.root);
    this.arrives = image !== null;
    if (this.arrives) this.plan(from, to, image);
  }

  // The mesh that the operations make, with the names of the mesh before.
  get result() {
    return this.meshes.at(-1);
  }

  plan(from, to, image) {
    const count = this.operations.length;
    const starts = [from.vertices];
    this.operations.forEach((operation, k) => {
      const next = starts[k].slice();
      if (operation.kind === "split") next[operation.vertex] = next[operation.from];
      starts.push(next);
    });
    const ends = [];
    ends[count] = [];
    for (const [v, w] of image) ends[count][v] = to.vertices[w];
    for (let k = count - 1; k >= 0; --k) {
      const operation = this.operations[k];
      ends[k] = ends[k + 1].slice();
      if (operation.kind === "collapse") ends[k][operation.vertex] = ends[k + 1][operation.into];
    }
    this.keys = this.meshes.map((faces, k) => {
      if (k === 0) return from.vertices;
      if (k === count) return ends[count];
      const points = [];
      for (const corners of faces) {
        if (corners)
          for (const v of corners) points[v] ??= between(starts[k][v], ends[k][v], k / count);
      }
      return evened(faces, points, this.boundary);
    });
  }

  // {faces, positions, operation, index} at time t.
  at(t) {
    const count = this.operations.length;
    if (count === 0) return {faces: this.result, positions: this.keys[0], operation: null, index: 0};
    const k = Math.min(Math.floor(t * count), count - 1);
    const operation = this.operations[k];
    const part = t * count - k;
    const s = part * part * (3 - 2 * part);
    const later = operation.kind === "split" || (operation.kind === "flip" && s > 0.5);
    const faces = this.meshes[later ? k + 1 : k];
    const positions = [];
    for (const corners of faces) {
      if (!corners) continue;
      for (const v of corners) {
        if (positions[v]) continue;
        const made = operation.kind === "split" && v === operation.vertex;
        const gone = operation.kind === "collapse" && v === operation.vertex;
        positions[v] = between(this.keys[k][made ? operation.from : v], this.keys[k + 1][gone ? operation.into : v], s);
      }
    }
    return {faces, positions, operation, index: k};
  }
}

// All configurations that moves reach from one, the nearest first: node -> the move by which a shortest path arrives.
function reached(moves, from) {
  const arrival = new Map([[from, null]]);
  for (const node of arrival.keys()) {  // meets what is added on the way
    moves.forEach((move, index) => {
      if (move.from === node && !arrival.has(move.to)) arrival.set(move.to, index);
    });
  }
  return arrival;
}

// A shortest path from one configuration to another, as indices of moves; null if there is none.
function shortestPath(moves, from, to) {
  const arrival = reached(moves, from);
  if (!arrival.has(to)) return null;
  const path = [];
  for (let node = to; node !== from; node = moves[path[0]].from) path.unshift(arrival.get(node));
  return path;
}
