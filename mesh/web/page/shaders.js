// The shaders of quads, of irregular vertices, and of the picture that tells what the pointer is at.

const kShades = `
  vec3 shade(vec3 colour, vec3 normal) {
    float light = 0.62 + 0.38 * abs(normalize(normal).z);
    return colour * light;
  }`;

// Quads with their edges, which are found by the corner coordinates (0 and 1 at the corners).
const kQuadShaders = {
  vertexShader: `
    attribute vec2 place;
    attribute float tint;
    attribute float paint;
    attribute float quad;
    varying vec2 vPlace;
    varying vec3 vNormal;
    varying float vTint;
    varying float vPaint;
    varying float vQuad;
    void main() {
      vPlace = place;
      vNormal = normalMatrix * normal;
      vTint = tint;
      vPaint = paint;
      vQuad = quad;
      gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
    }`,
  fragmentShader: `
    uniform vec3 colours[5];
    uniform vec3 back;
    uniform vec3 edge;
    uniform vec3 dark;
    uniform vec3 wrong;
    uniform int paint;    // as kPaints counts
    uniform float edges;  // 0: none are drawn
    varying vec2 vPlace;
    varying vec3 vNormal;
    varying float vTint;
    varying float vPaint;
    ${kShades}
    // From dark violet over green to yellow, which also those tell apart who see few colours.
    vec3 scale(float t) {
      vec3 low = vec3(0.27, 0.0, 0.33), middle = vec3(0.13, 0.57, 0.55), high = vec3(0.99, 0.91, 0.14);
      return t < 0.5 ? mix(low, middle, 2.0 * t) : mix(middle, high, 2.0 * t - 1.0);
    }
    vec3 painted(vec3 plain) {
      if (vPaint < -0.5) return mod(gl_FragCoord.x + gl_FragCoord.y, 8.0) < 4.0 ? wrong : plain;
      if (paint == 1) return scale(clamp(vPaint, 0.0, 1.0));
      if (paint == 2) return vPaint < 0.5 ? plain : vPaint < 1.5 ? dark : mix(plain, dark, vPaint < 2.5 ? 0.35 : 0.65);
      if (paint == 3) return fract((vPaint < 0.5 ? vPlace.y : vPlace.x) * 2.0 + 0.25) < 0.5 ? dark : plain;
      return plain;
    }
    void main() {
      int kind = int(vTint + 0.5);
      vec3 plain = !gl_FrontFacing && paint == 0 ? back : colours[0];
      vec3 colour = kind == 1 ? colours[1] : kind == 2 ? colours[2] : kind == 3 ? colours[3] : kind == 4 ? colours[4] : painted(plain);
      colour = shade(colour, vNormal);
      vec2 width = fwidth(vPlace);
      vec2 near = min(vPlace, 1.0 - vPlace) / max(width, vec2(1e-6));
      float line = 1.0 - smoothstep(0.4, 1.2, min(near.x, near.y));
      // Where edges are closer than some pixels they would hide the quads.
      float room = clamp(0.35 / max(max(width.x, width.y), 1e-6), 0.0, 1.0);
      gl_FragColor = vec4(mix(colour, edge, line * room * 0.85 * edges), 1.0);
    }`,
};

// The number of what is drawn, as a colour: quads with alpha 1, markers with alpha 1/2.
const kIdColour = `
  vec4 number_as_colour(float number, float alpha) {
    float low = mod(number, 256.0);
    float middle = mod(floor(number / 256.0), 256.0);
    return vec4(low, middle, floor(number / 65536.0), alpha * 255.0) / 255.0;
  }`;

// The digits 2 to 9 side by side.
function digitTexture() {
  const canvas = document.createElement("canvas");
  canvas.width = 8 * 64;
  canvas.height = 64;
  const pen = canvas.getContext("2d");
  pen.font = "bold 36px sans-serif";
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  for (let digit = 2; digit <= 9; ++digit) pen.fillText(String(digit), 64 * (digit - 2) + 32, 34);
  return new THREE.CanvasTexture(canvas);
}

// Irregular vertices: a triangle for a v3, a pentagon for a v5 and so on; a diamond for a v2.
const kMarkerShaders = {
  vertexShader: `
    attribute float valence;
    attribute float number;
    attribute float chosen;
    uniform float size;
    uniform float lift;
    varying float vValence;
    varying float vNumber;
    varying float vChosen;
    void main() {
      vValence = valence;
      vNumber = number;
      vChosen = chosen;
      vec4 at = modelViewMatrix * vec4(position, 1.0);
      at.z += lift;
      gl_Position = projectionMatrix * at;
      gl_PointSize = size * (chosen > 0.25 ? 1.5 : 1.0);
    }`,
  fragmentShader: `
    uniform vec3 v2;
    uniform vec3 v3;
    uniform vec3 v5;
    uniform vec3 v6;
    uniform vec3 rim;
    uniform vec3 help;
    uniform sampler2D digits;
    uniform float numbered;
    varying float vValence;
    varying float vChosen;
    float polygon(vec2 p, float corners) {
      float part = 6.2831853 / corners;
      float angle = atan(p.x, -p.y);  // a corner on top
      return cos(floor(0.5 + angle / part) * part - angle) * length(p) / cos(0.5 * part);
    }
    void main() {
      vec2 p = vec2(2.0, -2.0) * (gl_PointCoord - 0.5);
      float valence = floor(vValence + 0.5);
      p.y += valence == 3.0 ? 0.2 : 0.0;
      float reach = valence == 2.0 ? abs(p.x) + abs(p.y) / 0.62 : polygon(p, valence);
      reach /= 0.92;
      if (reach > 1.0) discard;
      vec3 colour = valence == 2.0 ? v2 : valence == 3.0 ? v3 : valence == 5.0 ? v5 : v6;
      float inside = vChosen > 0.25 ? 0.6 : 0.78;
      colour = reach > inside ? (vChosen > 0.25 && vChosen < 0.75 ? help : rim) : colour;
      vec2 cell = gl_PointCoord - vec2(0.0, valence == 3.0 ? 0.08 : 0.0);
      float ink = texture2D(digits, vec2((clamp(valence, 2.0, 9.0) - 2.0 + cell.x) / 8.0, 1.0 - cell.y)).a;
      gl_FragColor = vec4(mix(colour, vec3(1.0), ink * numbered), 1.0);
    }`,
};

function pickShaders(shaders, number, alpha) {
  return {
    vertexShader: shaders.vertexShader,
    fragmentShader: `
      varying float ${number};
      ${kIdColour}
      void main() { gl_FragColor = number_as_colour(${number}, ${alpha}); }`,
  };
}
