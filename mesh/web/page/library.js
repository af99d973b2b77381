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

  // Opens a file by its bytes (a Uint8Array). Answers {why, subdividing_helps}.
  open(bytes, name, subdivided) {
    const at = this.module._malloc(bytes.length + 1);
    try {
      this.module.HEAPU8.set(bytes, at);
      return this.withText(name, (text) => JSON.parse(this.module.UTF8ToString(
          this.module._requad_open(at, bytes.length, text, subdivided ? 1 : 0))));
    } finally {
      this.module._free(at);
    }
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
    return new Float32Array(this.module.HEAPU8.buffer, this.module._requad_corners(), quads * 4 * 6);
  }
  triangles(quads) {
    return new Uint32Array(this.module.HEAPU8.buffer, this.module._requad_triangles(), quads * 6);
  }
}
