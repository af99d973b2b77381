// The session in C++, as functions of JavaScript. Nothing here knows what a mesh is.

class Library {
  // Waits until the WebAssembly is ready.
  static async load() {
    return new Library(await requadLibrary());
  }

  constructor(module) {
    this.module = module;
  }

  withText(text, use) {
    const size = this.module.lengthBytesUTF8(text) + 1;
    const at = this.module._malloc(size);
    try {
      this.module.stringToUTF8(text, at, size);
      return use(at);
    } finally {
      this.module._free(at);
    }
  }

  // Calls use(at, size) with a copy of the bytes (a Uint8Array) in the memory of the program, and the name as a text there.
  withFile(bytes, name, use) {
    const at = this.module._malloc(bytes.length + 1);
    try {
      this.module.HEAPU8.set(bytes, at);
      return this.withText(name, (text) => JSON.parse(this.module.UTF8ToString(use(at, bytes.length, text))));
    } finally {
      this.module._free(at);
    }
  }

  // Opens a file by its bytes. Answers {why, subdividing_helps}.
  open(bytes, name, subdivided) {
    return this.withFile(bytes, name, (...file) => this.module._requad_open(...file, subdivided ? 1 : 0));
  }
  // Replays a script on the mesh that was opened. Answers {why}.
  apply(bytes, name) {
    return this.withFile(bytes, name, (...file) => this.module._requad_apply(...file));
  }

  // What bridge.cpp answers to {ask: what, ...}.
  ask(what, parameters = {}) {
    const answer = this.withText(JSON.stringify({ask: what, ...parameters}),
        (text) => JSON.parse(this.module.UTF8ToString(this.module._requad_call(text))));
    if (answer && answer.error) throw new Error(answer.error);
    return answer;
  }

  // "obj" or "script", as a file.
  text(what) {
    return this.withText(what, (text) => this.module.UTF8ToString(this.module._requad_text(text)));
  }

  // The arrays of the scene (scene.hpp), which move when memory grows: ask for them each time.
  corners(quads) {
    return new Float32Array(this.module.HEAPU8.buffer, this.module._requad_corners(), quads * kFloats);
  }
  triangles(quads) {
    return new Uint32Array(this.module.HEAPU8.buffer, this.module._requad_triangles(), quads * 6);
  }
  // The present arrays of these quads of a scene with this capacity, copied: {quads, corners, triangles}.
  quads(quads, capacity) {
    const from = this.corners(capacity), indices = this.triangles(capacity);
    const corners = new Float32Array(kFloats * quads.length), triangles = new Uint32Array(6 * quads.length);
    quads.forEach((f, i) => {
      corners.set(from.subarray(kFloats * f, kFloats * (f + 1)), kFloats * i);
      triangles.set(indices.subarray(6 * f, 6 * f + 6), 6 * i);
    });
    return {quads, corners, triangles};
  }
  // The same for the stages of the edit that was performed last: lists of quads.
  stages(lists) {
    let at = this.module._requad_stages() / 4;
    const heap = new Float32Array(this.module.HEAPU8.buffer);
    return lists.map((quads) => {
      const corners = new Float32Array(kFloats * quads.length), triangles = new Uint32Array(6 * quads.length);
      quads.forEach((f, i) => {
        corners.set(heap.subarray(at, at + kFloats), kFloats * i);
        triangles.set(heap.subarray(at + kFloats, at + kFloats + 6), 6 * i);
        at += kFloats + 6;
      });
      return {quads, corners, triangles};
    });
  }
}
