// The mesh as files: OBJ for programs, SVG for documents.

// "digon-6-6_2-1": the region and the configuration.
const fileName = (node, ending) =>
    `${shape}-${data.sides.join("-")}_${node.label.replace(/[()]/g, "").replaceAll(",", "-")}.${ending}`;

// The first edge of the first face is the one where side 1 starts. An edge has about length 1.
function objText(node, unit) {
  const faces = node.faces.filter(Boolean);
  const [v, w] = node.root;
  const first = faces.findIndex((corners) => corners.some((a, k) => a === v && corners[(k + 1) % 4] === w));
  const [rooted] = faces.splice(first, 1);
  const turn = rooted.indexOf(v);
  faces.unshift([...rooted.slice(turn), ...rooted.slice(0, turn)]);
  const number = new Map();
  for (const corners of faces)
    for (const a of corners)
      if (!number.has(a)) number.set(a, number.size + 1);
  const lines = [
    `# ${data.pair} pair, sides ${data.sides.join(" ")}, configuration ${nameOf(node)}`,
    "# side 1 starts at the first edge of the first face"
  ];
  for (const a of number.keys()) lines.push(`v ${node.vertices[a].map((x) => (x / unit).toFixed(4)).join(" ")} 0`);
  for (const corners of faces) lines.push(`f ${corners.map((a) => number.get(a)).join(" ")}`);
  return lines.join("\n") + "\n";
}

const DRAWN =
    ["fill", "stroke", "stroke-width", "stroke-dasharray", "stroke-linejoin", "stroke-linecap", "paint-order"];
const WRITTEN = ["font-size", "font-weight", "font-family", "text-anchor"];

// What the style sheet says of a part of a drawing; null if it is hidden.
function styleOf(part) {
  const style = getComputedStyle(part);
  if (style.display === "none") return null;
  const names = part.localName === "path" || part.localName === "circle" ? DRAWN :
      part.localName === "text" || part.localName === "tspan"            ? [...DRAWN, ...WRITTEN] :
                                                                           [];
  const values = names.map((name) => [name, style.getPropertyValue(name)]);
  return Object.fromEntries(values.filter(([, value]) => value !== "normal"));
}

// The drawing as a document of its own, in the colours of the light page: each element has its style written out, and
// nothing that is hidden is in it.
function svgText(view, title) {
  const copy = view.svg.cloneNode(true);
  // The copy stands in the page for a moment, with the light colours, so that the browser tells its styles.
  const place = document.createElement("div");
  place.className = "frame light";
  Object.assign(place.style, {position: "absolute", visibility: "hidden", width: `${view.svg.clientWidth}px`});
  copy.removeAttribute("id");
  place.append(copy);
  document.body.append(place);
  const [left, top, width, height] = view.box;
  const parts = [...copy.querySelectorAll("*")];
  const styles = parts.map(styleOf);
  parts.forEach((part, i) => {
    for (const name of ["class", "style", "data-key"]) part.removeAttribute(name);
    if (!styles[i]) part.remove();
    // On the page the widths of paths are pixels.
    const pixels = (value) => value.replace(/[\d.]+(px)?/g, (x) => (parseFloat(x) * view.unitsPerPixel).toFixed(2));
    for (const [name, value] of Object.entries(styles[i] ?? {})) {
      const isWidth = part.localName === "path" && (name === "stroke-width" || name === "stroke-dasharray");
      part.setAttribute(name, isWidth ? pixels(value) : value);
    }
    // On the page the middle of a text is at its place. Some programs know baselines only.
    if (styles[i] && part.localName === "text")
      part.setAttribute("y", (Number(part.getAttribute("y")) + 0.35 * parseFloat(styles[i]["font-size"])).toFixed(2));
  });
  place.remove();
  for (const name of ["id", "class", "style", "aria-hidden"]) copy.removeAttribute(name);
  copy.setAttribute("xmlns", SVG);
  const scale = 640 / Math.max(width, height);
  copy.setAttribute("width", (width * scale).toFixed(0));
  copy.setAttribute("height", (height * scale).toFixed(0));
  copy.prepend(element("title", {}, title), element("rect", {x: left, y: top, width, height, fill: "#ffffff"}));
  return new XMLSerializer().serializeToString(copy) + "\n";
}

// Offers a text as a file to keep.
function save(name, type, text) {
  const link = Object.assign(document.createElement("a"), {download: name});
  link.href = URL.createObjectURL(new Blob([text], {type}));
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}
