// The mesh on the screen: drawing by three.js, turning, and pointing. Nothing here knows what an edit is.

const kQuadColours = ["back", "edge", "dark", "wrong"];
const kMarkerColours = ["v2", "v3", "v5", "v6", "rim", "help"];
const kPaints = ["plain", "quality", "checkerboard", "stripes"];
const kMark = 20;    // the size of a marker in CSS pixels
const kFloats = 28;  // of a quad: for each of its four corners position, normal and paint

class View {
  // `canvas` fills its parent.
  constructor(canvas) {
    this.canvas = canvas;
    this.renderer = new THREE.WebGLRenderer({canvas, antialias: true, alpha: false, preserveDrawingBuffer: false});
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(30, 1, 0.01, 100);
    this.controls = new THREE.OrbitControls(this.camera, canvas);
    this.controls.enableKeys = false;
    this.controls.rotateSpeed = 0.8;
    this.controls.screenSpacePanning = true;
    this.controls.addEventListener("change", () => this.draw());
    this.radius = 1;
    this.capacity = 0;
    this.uploaded = 0;  // bytes, since the page was opened
    this.tinted = [];
    this.playing = null;
    const quads = {
      side: THREE.DoubleSide, extensions: {derivatives: true},
      polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1,
    };
    this.material = new THREE.ShaderMaterial({
      ...kQuadShaders, ...quads,
      uniforms: {colours: {value: Array.from({length: 5}, () => new THREE.Color())}, paint: {value: 0}, edges: {value: 1},
                 ...Object.fromEntries(kQuadColours.map((name) => [name, {value: new THREE.Color()}]))},
    });
    this.pickMaterial = new THREE.ShaderMaterial({...pickShaders(kQuadShaders, "vQuad", "1.0"), ...quads});
    const colours = Object.fromEntries(kMarkerColours.map((name) => [name, {value: new THREE.Color()}]));
    this.markerUniforms = {
      ...colours, size: {value: 18}, lift: {value: 0}, digits: {value: digitTexture()}, numbered: {value: 0},
    };
    this.markerMaterial = new THREE.ShaderMaterial({...kMarkerShaders, uniforms: this.markerUniforms});
    this.markerPickMaterial = new THREE.ShaderMaterial({
      ...pickShaders(kMarkerShaders, "vNumber", "0.5"),
      uniforms: {size: {value: kMark}, lift: this.markerUniforms.lift},
    });
    this.mesh = new THREE.Mesh(new THREE.BufferGeometry(), this.material);
    this.mesh.frustumCulled = false;
    this.markers = new THREE.Points(new THREE.BufferGeometry(), this.markerMaterial);
    this.markers.frustumCulled = false;
    this.lines = new THREE.Group();
    this.edges = new THREE.Group();  // the boundary and features, which change seldom
    this.arrows = new THREE.Group();
    this.scene.add(this.mesh, this.markers, this.lines, this.edges, this.arrows);
    // Materials of lines and arrows, by what they look like. They are kept, since three.js compiles a program anew after
    // its last material is gone, which takes long.
    this.materials = new Map();
    this.shapes = {
      shaft: new THREE.CylinderGeometry(0.07, 0.07, 0.6, 10),
      head: new THREE.ConeGeometry(0.2, 0.4, 16),
      handle: new THREE.CylinderGeometry(0.26, 0.26, 1.05, 8),
    };
    this.pickWindow = new THREE.WebGLRenderTarget(33, 33);
    this.ray = new THREE.Raycaster();
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
    this.resize();
  }

  resize() {
    const {clientWidth: width, clientHeight: height} = this.canvas.parentElement;
    if (width === 0 || height === 0) return;
    this.renderer.setPixelRatio(window.devicePixelRatio);
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  draw() {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      this.render();
    });
  }

  render() {
    const ratio = this.renderer.getPixelRatio();
    this.markerUniforms.size.value = kMark * ratio;
    const size = this.renderer.getSize(new THREE.Vector2());
    for (const line of this.lines.children.concat(this.edges.children)) line.material.resolution.copy(size);
    this.sizeArrows(size.y);
    this.renderer.render(this.scene, this.camera);
    this.drawn = (this.drawn || 0) + 1;
  }

  // Colours by their names in the style sheet.
  setColours(colour) {
    this.renderer.setClearColor(new THREE.Color(colour("canvas")));
    this.material.uniforms.colours.value =
        ["quad", "alpha", "chosen", "change", "change-strong"].map((name) => new THREE.Color(colour(name)));
    for (const name of kQuadColours) this.material.uniforms[name].value.set(colour(name));
    for (const name of kMarkerColours) this.markerUniforms[name].value.set(colour(name));
    this.draw();
  }

  // --- the mesh ------------------------------------------------------------------------------------------------------

  // Uploads all arrays, for a mesh that was opened or has outgrown its buffers.
  setMesh(library, capacity) {
    this.finish();
    this.capacity = capacity;
    const geometry = new THREE.BufferGeometry();
    this.corners = new THREE.InterleavedBuffer(library.corners(capacity).slice(), kFloats / 4);
    geometry.setAttribute("position", new THREE.InterleavedBufferAttribute(this.corners, 3, 0));
    geometry.setAttribute("normal", new THREE.InterleavedBufferAttribute(this.corners, 3, 3));
    geometry.setAttribute("paint", new THREE.InterleavedBufferAttribute(this.corners, 1, 6));
    const place = new Float32Array(capacity * 8), quad = new Float32Array(capacity * 4);
    for (let i = 0; i < capacity; ++i) {
      place.set([0, 0, 1, 0, 1, 1, 0, 1], 8 * i);
      quad.fill(i, 4 * i, 4 * i + 4);
    }
    geometry.setAttribute("place", new THREE.BufferAttribute(place, 2));
    geometry.setAttribute("quad", new THREE.BufferAttribute(quad, 1));
    this.tint = new THREE.BufferAttribute(new Float32Array(capacity * 4), 1);
    geometry.setAttribute("tint", this.tint);
    this.triangles = new THREE.BufferAttribute(library.triangles(capacity).slice(), 1);
    geometry.setIndex(this.triangles);
    for (const buffer of [this.corners, this.tint, this.triangles]) this.keepHandle(buffer);
    this.mesh.geometry.dispose();
    this.mesh.geometry = geometry;
    this.tinted = [];
    this.uploaded += capacity * (kFloats + 6 + 8 + 4 + 4) * 4;
    this.draw();
  }

  // three.js can update only one range of a buffer. Quads that changed lie anywhere, so they are written to the buffer
  // itself, whose handle is bound when three.js has made it.
  keepHandle(buffer) {
    const gl = this.renderer.getContext();
    const binding = buffer === this.triangles ? gl.ELEMENT_ARRAY_BUFFER_BINDING : gl.ARRAY_BUFFER_BINDING;
    buffer.onUpload(() => { buffer.handle = gl.getParameter(binding); });
  }

  // Writes `size` values for each of these quads, which are in order. Those near each other go in one call, with what lies
  // between them, for calls are slow.
  write(buffer, target, size, quads, values) {
    const kGap = 16;
    quads.forEach((f, i) => buffer.array.set(values.subarray(size * i, size * (i + 1)), size * f));
    if (!buffer.handle) return;  // three.js uploads all of it when it draws next
    const gl = this.renderer.getContext();
    gl.bindBuffer(target, buffer.handle);
    for (let i = 0, j = 1; i < quads.length; i = j, ++j) {
      while (j < quads.length && quads[j] <= quads[j - 1] + kGap) ++j;
      const run = buffer.array.subarray(size * quads[i], size * (quads[j - 1] + 1));
      gl.bufferSubData(target, 4 * size * quads[i], run);
      this.uploaded += 4 * run.length;
    }
  }

  // Uploads these quads: {quads, corners, triangles}, with kFloats and six numbers for each of them. The quads are in
  // order. `triangles` may be missing.
  writeQuads({quads, corners, triangles}) {
    const gl = this.renderer.getContext();
    this.write(this.corners, gl.ARRAY_BUFFER, kFloats, quads, corners);
    if (triangles) this.write(this.triangles, gl.ELEMENT_ARRAY_BUFFER, 6, quads, triangles);
    // The index buffer belongs to the vertex array that is bound; none may be.
    this.renderer.state.reset();
    this.draw();
  }

  // --- motion --------------------------------------------------------------------------------------------------------

  // Shows frames one after the other: {quads, corners, triangles, ms, begin}. Quads go from where they are to the corners
  // of the frame in this time; `begin` is called before. `ended` is called after the last one.
  play(frames, ended) {
    this.finish();
    this.playing = {frames: [...frames], ended, from: null, start: 0};
    requestAnimationFrame((now) => this.advance(now));
  }
  advance(now) {
    const playing = this.playing;
    if (!playing) return;
    const frame = playing.frames[0];
    if (!frame) return this.finish();
    if (!playing.from) {
      playing.start = now;
      playing.from = new Float32Array(frame.corners.length);
      frame.quads.forEach((f, i) => {
        playing.from.set(this.corners.array.subarray(kFloats * f, kFloats * (f + 1)), kFloats * i);
      });
      this.writeQuads({...frame, corners: playing.from});
      if (frame.begin) frame.begin();
    }
    const t = Math.min(1, (now - playing.start) / Math.max(frame.ms, 1));
    const part = t * t * (3 - 2 * t);
    const corners = t === 1 ? frame.corners : playing.from.map((x, i) => x + part * (frame.corners[i] - x));
    this.writeQuads({quads: frame.quads, corners});
    if (t === 1) {
      playing.frames.shift();
      playing.from = null;
    }
    requestAnimationFrame((later) => this.advance(later));
  }
  // Shows the end of what is played at once.
  finish() {
    if (!this.playing) return;
    const {frames, ended} = this.playing;
    this.playing = null;
    for (const frame of frames) this.writeQuads(frame);
    ended();
  }

  // Tints quads: a list of [quads, kind], of which later ones win. All others lose theirs.
  setTints(lists) {
    const kinds = new Map(this.tinted.map((f) => [f, 0]));
    for (const [quads, kind] of lists) {
      for (const f of quads) kinds.set(f, kind);
    }
    const gl = this.renderer.getContext();
    const quads = [...kinds.keys()].sort((f, g) => f - g);
    const values = Float32Array.from({length: 4 * quads.length}, (_, i) => kinds.get(quads[i >> 2]));
    this.write(this.tint, gl.ARRAY_BUFFER, 4, quads, values);
    this.tinted = [...kinds].filter(([, kind]) => kind !== 0).map(([f]) => f);
    this.renderer.state.reset();
    this.draw();
  }

  // Irregular vertices: [{id, valence, at}]; those in `chosen` are larger, and those in `helpers`, with another rim.
  setMarkers(vertices, chosen, helpers) {
    const geometry = new THREE.BufferGeometry();
    const column = (values, size) => new THREE.BufferAttribute(new Float32Array(values), size);
    geometry.setAttribute("position", column(vertices.flatMap((v) => v.at), 3));
    geometry.setAttribute("valence", column(vertices.map((v) => v.valence), 1));
    geometry.setAttribute("number", column(vertices.map((v) => v.id), 1));
    geometry.setAttribute("chosen", column(vertices.map((v) => (chosen.includes(v.id) ? 1 : helpers.includes(v.id) ? 0.5 : 0)), 1));
    this.markers.geometry.dispose();
    this.markers.geometry = geometry;
    this.marked = new Map(vertices.map((v) => [v.id, v.at]));
    this.draw();
  }

  // --- lines and arrows ------------------------------------------------------------------------------------------------

  materialOf(key, make) {
    if (!this.materials.has(key)) this.materials.set(key, make());
    return this.materials.get(key);
  }

  // Polylines: a list of [paths, colour, width in pixels]; a path is a list of points.
  setLines(lists, group = this.lines) {
    for (const line of [...group.children]) {
      group.remove(line);
      line.geometry.dispose();
    }
    for (const [paths, colour, width] of lists) {
      const positions = [];
      for (const path of paths) {
        for (let i = 1; i < path.length; ++i) positions.push(...path[i - 1], ...path[i]);
      }
      if (positions.length === 0) continue;
      const geometry = new THREE.LineSegmentsGeometry();
      geometry.setPositions(positions);
      const material = this.materialOf(`line ${colour} ${width}`, () => new THREE.LineMaterial({
        color: new THREE.Color(colour).getHex(), linewidth: width,
        polygonOffset: true, polygonOffsetFactor: -2, polygonOffsetUnits: -2,
      }));
      const line = new THREE.LineSegments2(geometry, material);
      line.frustumCulled = false;
      group.add(line);
    }
    this.draw();
  }

  // Arrows: a list of {from, to, colour, tag, faint}. `length` is that of each, but they are not shorter than some pixels;
  // they are seen through the mesh.
  setArrows(arrows, length) {
    this.arrowLength = length;
    this.arrows.remove(...this.arrows.children);
    for (const {from, to, colour, tag, faint} of arrows) {
      const start = new THREE.Vector3(...from);
      const direction = new THREE.Vector3(...to).sub(start);
      if (direction.length() === 0) continue;
      direction.normalize();
      const arrow = new THREE.Group();
      const material = this.materialOf(`arrow ${colour} ${faint}`, () => new THREE.MeshBasicMaterial(
          {color: colour, depthTest: false, transparent: true, opacity: faint ? 0.3 : 1}));
      const unseen = this.materialOf("unseen", () => new THREE.MeshBasicMaterial({visible: false}));
      const part = (shape, height, look) => {
        const mesh = new THREE.Mesh(shape, look);
        mesh.position.y = height;
        mesh.userData.tag = tag;
        mesh.renderOrder = faint ? 2 : 3;
        arrow.add(mesh);
      };
      part(this.shapes.shaft, 0.6, material);
      part(this.shapes.head, 1.1, material);
      part(this.shapes.handle, 0.8, unseen);  // what can be hit
      arrow.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), direction);
      arrow.position.copy(start);
      arrow.userData.tag = tag;
      this.arrows.add(arrow);
    }
    this.sizeArrows(this.renderer.getSize(new THREE.Vector2()).y);
    this.draw();
  }
  sizeArrows(height) {
    const kLeast = 34;  // pixels
    const perPixel = 2 * Math.tan((Math.PI / 360) * this.camera.fov) / height;
    for (const arrow of this.arrows.children)
      arrow.scale.setScalar(Math.max(this.arrowLength, kLeast * perPixel * this.camera.position.distanceTo(arrow.position)));
  }

  // --- the camera ------------------------------------------------------------------------------------------------------

  // Looks at the whole mesh from the front and above.
  lookAt(centre, radius) {
    this.radius = radius || 1;
    this.centre = new THREE.Vector3(...centre);
    this.markerUniforms.lift.value = 0.015 * this.radius;
    this.camera.near = 0.01 * this.radius;
    this.camera.far = 100 * this.radius;
    this.controls.target.copy(this.centre);
    const narrow = Math.min(1, this.camera.aspect);
    const distance = this.radius / Math.sin((Math.PI / 180) * 15) / narrow;
    this.camera.position.copy(this.centre).add(new THREE.Vector3(0.45, 0.35, 0.85).normalize().multiplyScalar(distance));
    this.camera.updateProjectionMatrix();
    this.controls.minDistance = 0.05 * this.radius;
    this.controls.maxDistance = 30 * this.radius;
    this.controls.update();
    this.draw();
  }

  // Turns by angles, or comes nearer by a factor.
  turn(right, up) {
    const offset = this.camera.position.clone().sub(this.controls.target);
    const at = new THREE.Spherical().setFromVector3(offset);
    at.theta += right;
    at.phi = Math.min(Math.max(at.phi + up, 0.05), Math.PI - 0.05);
    this.camera.position.copy(this.controls.target).add(offset.setFromSpherical(at));
    this.controls.update();
    this.draw();
  }
  zoom(factor) {
    const offset = this.camera.position.clone().sub(this.controls.target).multiplyScalar(factor);
    this.camera.position.copy(this.controls.target).add(offset);
    this.controls.update();
    this.draw();
  }

  // Looks at these points from outside, so near that edges of this length can be told apart.
  approach(points, length) {
    const middle = points.reduce((sum, p) => sum.add(new THREE.Vector3(...p)), new THREE.Vector3())
        .multiplyScalar(1 / points.length);
    const outward = middle.clone().sub(this.centre);
    if (outward.length() < 1e-9 * this.radius) outward.copy(this.camera.position).sub(this.controls.target);
    const reach = 5 * length + Math.max(...points.map((p) => middle.distanceTo(new THREE.Vector3(...p))));
    const distance = reach / Math.sin((Math.PI / 180) * 15) / Math.min(1, this.camera.aspect);
    this.controls.minDistance = Math.min(this.controls.minDistance, distance / 4);
    this.controls.target.copy(middle);
    this.camera.position.copy(middle).add(outward.normalize().multiplyScalar(distance));
    this.camera.near = Math.min(this.camera.near, distance / 20);
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.draw();
  }

  // Turns so that these points are in front, if they are not in view.
  show(points) {
    if (points.length === 0) return;
    const middle = points.reduce((sum, p) => sum.add(new THREE.Vector3(...p)), new THREE.Vector3())
        .multiplyScalar(1 / points.length);
    const visible = points.every((p) => {
      const at = this.project(p);
      const hit = at && this.pick(at.x, at.y);
      if (!hit || !this.inside(at)) return false;
      const distance = this.camera.position.distanceTo(new THREE.Vector3(...p));
      return hit.kind === "marker" || (hit.kind === "quad" && this.depthAt(hit.quad) > distance - 0.08 * this.radius);
    });
    if (visible) return;
    const outward = middle.clone().sub(this.centre);
    if (outward.length() < 1e-9) return;
    // From so near as before, but all of them are in view and the surface is not crossed.
    const reach = 0.3 * this.radius + 1.5 * Math.max(...points.map((p) => middle.distanceTo(new THREE.Vector3(...p))));
    const distance = Math.max(this.camera.position.distanceTo(this.controls.target),
                              reach / Math.sin((Math.PI / 180) * 15) / Math.min(1, this.camera.aspect));
    this.controls.target.copy(middle);
    this.camera.position.copy(middle).add(outward.normalize().multiplyScalar(distance));
    this.controls.update();
    this.draw();
  }
  depthAt(quad) {
    const at = this.corners.array.subarray(kFloats * quad, kFloats * quad + 3);
    return this.camera.position.distanceTo(new THREE.Vector3(...at));
  }
  inside({x, y}) {
    const box = this.canvas.getBoundingClientRect();
    return x > 0 && y > 0 && x < box.width && y < box.height;
  }

  // The picture as a PNG.
  picture() {
    this.render();
    return new Promise((done) => this.canvas.toBlob(done, "image/png"));
  }

  // Where a point is on the canvas, in CSS pixels.
  project(point) {
    this.camera.updateMatrixWorld();
    const p = new THREE.Vector3(...point).project(this.camera);
    const box = this.canvas.getBoundingClientRect();
    return {x: (p.x + 1) / 2 * box.width, y: (1 - p.y) / 2 * box.height};
  }

  // --- pointing --------------------------------------------------------------------------------------------------------

  // What is at a place of the canvas, in CSS pixels: {kind: "arrow", tag}, {kind: "marker", id}, {kind: "quad", quad,
  // origin, direction}, or null. A marker is taken if the place is on it, or, beside all arrows, up to `reach` from its
  // middle; of several, the one whose middle is nearest.
  pick(x, y, reach = kMark / 2) {
    const box = this.canvas.getBoundingClientRect();
    this.camera.updateMatrixWorld();
    this.ray.setFromCamera({x: 2 * x / box.width - 1, y: 1 - 2 * y / box.height}, this.camera);
    this.arrows.updateMatrixWorld(true);  // of arrows that are not drawn yet, too
    const [arrow] = this.ray.intersectObjects(this.arrows.children, true);
    const pixels = this.numbersRound(x, y), middle = (pixels.length / 4 - 1) / 2;
    const numberOf = (i) => pixels[4 * i] + 256 * pixels[4 * i + 1] + 65536 * pixels[4 * i + 2];
    const seen = new Set();
    for (let i = 0; i < pixels.length / 4; ++i) {
      const alpha = pixels[4 * i + 3];
      if (alpha > 0 && alpha < 200) seen.add(numberOf(i));
    }
    const nearest = {id: -1, distance: Infinity};
    for (const id of seen) {
      const at = this.project(this.marked.get(id)), distance = Math.hypot(at.x - x, at.y - y);
      if (distance < nearest.distance) Object.assign(nearest, {id, distance});
    }
    if (nearest.distance <= (arrow ? kMark / 2 : reach)) return {kind: "marker", id: nearest.id};
    if (arrow) return {kind: "arrow", tag: arrow.object.userData.tag};
    if (pixels[4 * middle + 3] < 200) return null;
    const {origin, direction} = this.ray.ray;
    return {kind: "quad", quad: numberOf(middle), origin: origin.toArray(), direction: direction.toArray()};
  }

  // Draws a small window round the place with numbers as colours, and reads its pixels, four bytes each.
  numbersRound(x, y) {
    const box = this.canvas.getBoundingClientRect();
    const size = this.pickWindow.width, pixels = new Uint8Array(4 * size * size);
    const before = this.renderer.getClearColor().clone();
    this.camera.setViewOffset(box.width, box.height, Math.floor(x) - (size - 1) / 2, Math.floor(y) - (size - 1) / 2, size, size);
    this.mesh.material = this.pickMaterial;
    this.markers.material = this.markerPickMaterial;
    this.lines.visible = this.edges.visible = this.arrows.visible = false;
    this.renderer.setRenderTarget(this.pickWindow);
    this.renderer.setClearColor(0, 0);
    this.renderer.clear();
    this.renderer.render(this.scene, this.camera);
    this.renderer.readRenderTargetPixels(this.pickWindow, 0, 0, size, size, pixels);
    this.renderer.setRenderTarget(null);
    this.renderer.setClearColor(before, 1);
    this.lines.visible = this.edges.visible = this.arrows.visible = true;
    this.mesh.material = this.material;
    this.markers.material = this.markerMaterial;
    this.camera.clearViewOffset();
    return pixels;
  }
}
