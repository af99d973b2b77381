// Edit scripts: their text, and replaying them.
//
// A fingerprint ties a script to one mesh, and no fuzzer guesses it. So each script is applied as if it were made for
// the open cube. What is legal there is recorded as another script, which must obey the laws.
#include "mesh/editing/script.hpp"

#include "tests/fuzz/fuzz.hpp"
#include "tests/fuzz/open_cube.hpp"
#include "tests/fuzz/surface.hpp"

using namespace requad;
using namespace requad::mesh;

const fuzz::Memory fuzz::kMemory{32 << 10, 200};

namespace {

// A copy of the cube with an editor. Some edges are features.
struct Copy {
  QuadMesh mesh = fuzz::open_cube().mesh;
  Positions positions = fuzz::open_cube().positions;
  FeatureSet features;
  Editor editor{mesh, &features, &positions};

  explicit Copy(bool with_features) {
    if (!with_features) return;
    for (const VertexId v : mesh.neighbours(VertexId(0))) features.insert(VertexId(0), v);
  }
  bool is(const QuadMesh& other, const Positions& others) const {
    if (!(mesh == other)) return false;
    const auto live = mesh.vertices();
    return std::all_of(live.begin(), live.end(),
                       [&](VertexId v) { return same_bits(positions[v.slot()], others[v.slot()]); });
  }
};

Script read_again(const Script& script) {
  const std::string text = to_string(script);
  Script again = parse_script(text, script.name);
  fuzz::require(to_string(again) == text, "what was written reads differently");
  return again;
}

// Law editing-14: a script makes all its changes or none.
void try_replay(const Script& script, bool with_features) {
  Copy copy(with_features);
  Replay result{Refusal::dead_element, 0};
  fuzz::accepts([&] { result = replay(copy.editor, script); });
  const bool done = result.refusal == Refusal::none;
  fuzz::require(validate(copy.mesh).empty(), "the mesh is not valid");
  fuzz::require(done || copy.is(fuzz::open_cube().mesh, fuzz::open_cube().positions), "a refused script left changes");
  fuzz::require(!done || digest(copy.mesh, copy.positions) == script.after, "a script that is done led elsewhere");
}

// Performs the legal operations of the script. Returns them as a script.
Script perform(const Script& script, Copy& copy) {
  for (const Change& change : script.changes) {
    if (change.operation) {
      if (copy.editor.why_not(*change.operation) == Refusal::none) copy.editor.run(*change.operation);
    } else if (copy.mesh.is_live(change.vertex) && !copy.editor.is_fixed(change.vertex)) {
      copy.editor.place(change.vertex, change.to);
    }
  }
  fuzz::require(validate(copy.mesh).empty(), "the mesh is not valid");
  return record_script(fuzz::open_cube().mesh, fuzz::open_cube().positions, copy.editor);
}

}  // namespace

void fuzz::try_input(std::string_view text) {
  Script script;
  if (!accepts([&] { script = parse_script(text, "script"); })) return;
  read_again(script);
  accepts([&] {
    Surface cube = open_cube();
    script.after = digest(cube.mesh, cube.positions);
    restore_ids(script, cube);
    require(validate(cube.mesh).empty(), "the mesh is not valid");
  });
  script.before = digest(open_cube().mesh, open_cube().positions);
  try_replay(script, false);
  try_replay(script, true);

  // Laws editing-11 to editing-13 for the recorded script: it is written, read, replayed and undone.
  Copy done(false), copy(false);
  const Script recorded = read_again(perform(script, done));
  require(replay(copy.editor, recorded).refusal == Refusal::none, "a script cannot be replayed");
  require(copy.is(done.mesh, done.positions), "a script does not give the mesh that it was recorded on");
  require(replay(copy.editor, inverse(recorded)).refusal == Refusal::none, "a script cannot be undone");
  require(copy.is(open_cube().mesh, open_cube().positions), "a script and its inverse do not give the mesh back");
  try_replay(recorded, true);
}
