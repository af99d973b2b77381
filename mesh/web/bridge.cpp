// The session as the page calls it: a request comes as JSON and is answered as JSON. For WebAssembly alone.
//
// Functions of C that the page calls: requad_open() and requad_apply() with the bytes of a file, requad_call() for
// everything else, requad_text() for texts that may be long, and the arrays of the scene and of stages. Ids of vertices
// and quads stand for themselves; positions are arrays of three numbers. An answer is valid until the next call.
#include <algorithm>
#include <memory>

#include <emscripten.h>
#include <nlohmann/json.hpp>

#include "mesh/web/scene.hpp"
#include "mesh/web/session.hpp"

namespace requad::web {

namespace {

using nlohmann::json;

struct State {
  std::unique_ptr<Session> session;
  std::unique_ptr<Scene> scene;
  std::string answer;
  std::vector<float> stages;
  bool grown = false;  // the scene's arrays, since the last status
};
State& state() {
  static State only;
  return only;
}

json to_json(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

json to_json(const Session& session, const std::vector<VertexId>& path) {
  json points = json::array();
  for (const VertexId v : path) points.push_back(to_json(session.positions()[v.slot()]));
  return points;
}

template <class Id>
json ids(const std::vector<Id>& list) {
  json result = json::array();
  for (const Id id : list) result.push_back(id.index());
  return result;
}

json segments(const Session& session, const mesh::FeatureEdges& edges) {
  json paths = json::array();
  for (const auto& [a, b] : edges) paths.push_back(to_json(session, {a, b}));
  return paths;
}

constexpr std::array kKinds{"vertex", "pair", "edge", "quad"};
constexpr std::array kPaints{"plain", "quality", "checkerboard", "stripes"};

Selection selection_of(const json& request) {
  Selection s;
  for (std::size_t i = 0; i < kKinds.size(); ++i) {
    if (request.value("kind", "") == kKinds[i]) s.kind = static_cast<Selection::Kind>(i);
  }
  s.a = VertexId(request.value("a", -1));
  s.b = VertexId(request.value("b", -1));
  s.quad = FaceId(request.value("quad", -1));
  for (const int v : request.value("helpers", std::vector<int>{})) s.helpers.emplace_back(v);
  return s;
}

json to_json(const Selection& s) {
  json result{{"kind", kKinds[static_cast<std::size_t>(s.kind)]}};
  if (s.a.valid()) result["a"] = s.a.index();
  if (s.b.valid()) result["b"] = s.b.index();
  if (s.quad.valid()) result["quad"] = s.quad.index();
  return result;
}

// An irregular vertex.
json mark(const Session& session, VertexId v) {
  return {{"id", v.index()}, {"valence", session.mesh().valence(v)}, {"at", to_json(session.positions()[v.slot()])}};
}

// What the page shows of a mesh at all times, and what it must draw anew.
json status(State& s) {
  Session& session = *s.session;
  const Changes changes = session.take_changes();
  bool everything = changes.everything || s.grown;
  if (changes.everything) {
    s.scene = std::make_unique<Scene>(session.mesh(), session.positions(), s.scene ? s.scene->paint() : Paint::plain);
  } else {
    everything = s.scene->update(session.mesh(), session.positions(), changes.quads) || everything;
  }
  s.grown = false;
  const Description d = session.describe();
  json irregular = json::array(), valences = json::object();
  for (const VertexId v : session.irregular()) irregular.push_back(mark(session, v));
  for (const auto& [valence, count] : d.irregular) valences[std::to_string(valence)] = count;
  json answer{{"vertices", d.vertices},
              {"quads", d.quads},
              {"genus", d.genus},
              {"boundary_loops", d.boundary_loops},
              {"valences", valences},
              {"index_sum", d.index_sum},
              {"least", d.least_irregular()},
              {"irregular", irregular},
              {"done", session.steps().size()},
              {"everything", everything},
              {"changed", everything ? json::array() : ids(changes.quads)},
              {"capacity", s.scene->quad_capacity()},
              {"centre", to_json(s.scene->centre())},
              {"inverted", d.inverted},
              {"features", d.features},
              {"reduces", session.reduces()},
              {"radius", s.scene->radius()}};
  if (changes.features) answer["feature_lines"] = segments(session, session.features());
  if (changes.everything) {
    answer["boundary_lines"] = json::array();
    for (const auto& loop : session.boundary()) answer["boundary_lines"].push_back(to_json(session, loop));
  }
  return answer;
}

// Makes an edit. `stages` lists, for each of its operations, the quads that it changed, the irregular vertices at them,
// and those that are irregular no more. State::stages has the arrays of each of these quads in turn, those of the scene:
// Scene::kFloats, then the six corners of the triangles, as numbers.
json perform(State& s, const json& request) {
  Session& session = *s.session;
  json stages = json::array();
  s.stages.clear();
  std::set<VertexId> marked = session.irregular();
  Session::Watch watch;
  if (request.value("stages", false) && !is_global(s.scene->paint())) {
    watch = [&](std::span<const FaceId> quads) {
      s.grown = s.scene->update(session.mesh(), session.positions(), quads) || s.grown;
      json near = json::array(), regular = json::array();
      for (const FaceId f : quads) {
        if (!session.mesh().is_live(f)) continue;
        for (const VertexId v : session.mesh().corners(f)) {
          if (mesh::is_irregular(session.mesh(), v)) {
            marked.insert(v);
            near.push_back(mark(session, v));
          } else if (marked.erase(v) != 0) {
            regular.push_back(v.index());
          }
        }
      }
      for (auto v = marked.begin(); v != marked.end();) {
        const bool gone = !session.mesh().is_live(*v);
        if (gone) regular.push_back(v->index());
        v = gone ? marked.erase(v) : std::next(v);
      }
      stages.push_back(
          {{"quads", ids(std::vector<FaceId>(quads.begin(), quads.end()))}, {"irregular", near}, {"regular", regular}});
      for (const FaceId f : quads) {
        const auto corners = std::span(s.scene->corners()).subspan(Scene::kFloats * f.slot(), Scene::kFloats);
        s.stages.insert(s.stages.end(), corners.begin(), corners.end());
        for (const std::uint32_t i : std::span(s.scene->triangles()).subspan(6 * f.slot(), 6))
          s.stages.push_back(static_cast<float>(i));
      }
    };
  }
  const std::string why = session.perform(selection_of(request.at("selection")), request.at("name"), watch);
  return {{"why", why}, {"stages", stages}};
}

json to_json(const Offers& offers) {
  json list = json::array();
  for (const Offer& o : offers.list) {
    json arrows = json::array();
    for (const Arrow& arrow : o.arrows) arrows.push_back({to_json(arrow.from), to_json(arrow.to)});
    list.push_back({{"name", o.name},
                    {"why", o.why},
                    {"help", o.help},
                    {"effect", o.effect},
                    {"operations", o.counts.operations},
                    {"made", o.counts.faces_made},
                    {"deleted", o.counts.faces_deleted},
                    {"vertices", ids(o.vertices)},
                    {"quads", ids(o.quads)},
                    {"after", {o.after[0].index(), o.after[1].index()}},
                    {"helpers", ids(o.helpers)},
                    {"arrows", arrows}});
  }
  return {{"why", offers.why},
          {"hint", offers.hint},
          {"third", offers.third.index()},
          {"list", list},
          {"more", offers.more}};
}

json answer_to(State& s, const json& request) {
  Session& session = *s.session;
  const std::string what = request.at("ask");
  const auto vector = [&request](const char* key) {
    return Eigen::Vector3d(request.at(key)[0], request.at(key)[1], request.at(key)[2]);
  };
  if (what == "status") return status(s);
  if (what == "offers") {
    const Selection chosen = selection_of(request.at("selection"));
    return to_json(request.value("quick", false) ? session.quick_offers(chosen) : session.offers(chosen));
  }
  if (what == "perform") return perform(s, request);
  if (what == "smooth") {
    std::vector<VertexId> centres;
    for (const int v : request.at("vertices")) centres.emplace_back(v);
    return {{"why", session.smooth(centres, request.at("rings"))}};
  }
  if (what == "sharp") return segments(session, session.sharp(request.at("degrees")));
  if (what == "set_features") return {{"why", session.set_features(session.sharp(request.at("degrees")))}};
  if (what == "clear_features") return {{"why", session.set_features({})}};
  if (what == "start_reduction") {
    session.start_reduction(request.at("until"), request.at("deviation"));
    return nullptr;
  }
  if (what == "reduce") {
    constexpr std::array kSlices{"working", "cancelled", "ended"};
    return kSlices[static_cast<std::size_t>(session.reduce())];
  }
  if (what == "finish_reduction") {
    session.finish_reduction();
    return nullptr;
  }
  if (what == "paint") {
    const auto at = std::find(kPaints.begin(), kPaints.end(), request.at("paint").get<std::string>());
    if (at == kPaints.end()) throw std::invalid_argument("unknown paint");
    s.scene->set_paint(session.mesh(), session.positions(), static_cast<Paint>(at - kPaints.begin()));
    s.grown = true;
    return nullptr;
  }
  if (what == "history") {
    json steps = json::array();
    for (std::size_t i = request.at("from"); i < session.steps().size(); ++i)
      steps.push_back({{"words", session.steps()[i].words}, {"lines", session.lines(session.steps()[i])}});
    return {{"steps", steps}, {"undone", session.undone().size()}};
  }
  if (what == "undo") return {{"done", session.undo()}};
  if (what == "redo") return {{"done", session.redo()}};
  if (what == "point") {
    const FaceId quad(request.at("quad"));
    if (!session.mesh().is_live(quad)) return nullptr;
    return to_json(session.pointed_at(quad, vector("origin"), vector("direction"), request.value("corner", false)));
  }
  if (what == "name") return session.name_of(VertexId(request.at("vertex")));
  if (what == "numbered") return session.numbered(request.at("number")).index();
  if (what == "nearest") return ids(session.nearest_irregular(VertexId(request.at("vertex")), request.at("most")));
  if (what == "subject") {
    const Selection chosen = selection_of(request.at("selection"));
    json result{{"live", session.is_live(chosen)},
                {"vertices", json::array()},
                {"paths", json::array()},
                {"quads", json::array()}};
    if (!session.is_live(chosen)) return result;
    std::vector<VertexId> vertices;
    for (const VertexId v : {chosen.a, chosen.b}) {
      if (v.valid()) vertices.push_back(v);
    }
    result["helpers"] = json::array();
    for (const VertexId v : chosen.helpers) {
      if (session.mesh().is_live(v)) result["helpers"].push_back({{"id", v.index()}, {"name", session.name_of(v)}});
    }
    if (chosen.quad.valid()) {
      for (const VertexId v : session.mesh().corners(chosen.quad)) vertices.push_back(v);
      result["quads"].push_back(chosen.quad.index());
    }
    for (const VertexId v : vertices)
      result["vertices"].push_back({{"id", v.index()},
                                    {"name", session.name_of(v)},
                                    {"number", session.number(v)},
                                    {"valence", session.mesh().valence(v)},
                                    {"at", to_json(session.positions()[v.slot()])}});
    if (request.value("separatrices", false)) {
      for (const VertexId v : vertices) {
        for (const auto& path : session.separatrices(v)) result["paths"].push_back(to_json(session, path));
      }
    }
    if (chosen.kind == Selection::Kind::pair) {
      const Session::Rectangle rectangle = session.rectangle(chosen.a, chosen.b);
      result["quads"] = ids(rectangle.quads);
      result["rim"] = to_json(session, rectangle.rim);
    }
    return result;
  }
  if (what == "all_separatrices") {
    json paths = json::array();
    for (const VertexId v : session.irregular()) {
      for (const auto& path : session.separatrices(v)) paths.push_back(to_json(session, path));
    }
    return paths;
  }
  throw std::invalid_argument("unknown request: " + what);
}

const char* give(State& s, std::string text) {
  s.answer = std::move(text);
  return s.answer.c_str();
}

}  // namespace

}  // namespace requad::web

extern "C" {

// Opens the text of a file. Answers {"why": ""}, or the reason; then `subdividing_helps` says whether it could be opened
// with its polygons cut into quads, and the mesh that was open stays.
EMSCRIPTEN_KEEPALIVE const char* requad_open(const char* bytes, int size, const char* name, int subdivided) {
  using namespace requad;
  web::State& s = web::state();
  const std::string_view text(bytes, static_cast<std::size_t>(size));
  try {
    s.session = std::make_unique<web::Session>(web::Session::read(text, name, subdivided != 0));
  } catch (const std::exception& error) {
    web::json answer{{"why", error.what()}, {"subdividing_helps", false}};
    try {
      if (subdivided == 0) answer["subdividing_helps"] = web::Session::read(text, name, true).mesh.face_count() > 0;
    } catch (const mesh::FileError&) {
    }
    return web::give(s, answer.dump(-1, ' ', false, web::json::error_handler_t::replace));
  }
  return web::give(s, R"({"why": ""})");
}

EMSCRIPTEN_KEEPALIVE const char* requad_call(const char* request) {
  using namespace requad;
  web::State& s = web::state();
  try {
    return web::give(s, web::answer_to(s, web::json::parse(request)).dump());
  } catch (const std::exception& error) {
    return web::give(s, web::json{{"error", error.what()}}.dump());
  }
}

// Replays a script on the mesh that was opened. Answers {"why": ""}, or the reason.
EMSCRIPTEN_KEEPALIVE const char* requad_apply(const char* bytes, int size, const char* name) {
  using namespace requad;
  web::State& s = web::state();
  std::string why;
  try {
    why = s.session->apply(std::string_view(bytes, static_cast<std::size_t>(size)), name);
  } catch (const std::exception& error) {
    why = error.what();
  }
  return web::give(s, web::json{{"why", why}}.dump(-1, ' ', false, web::json::error_handler_t::replace));
}

// "obj" or "script".
EMSCRIPTEN_KEEPALIVE const char* requad_text(const char* what) {
  using namespace requad;
  web::State& s = web::state();
  return web::give(s, std::string_view(what) == "obj" ? s.session->export_obj() : s.session->script());
}

EMSCRIPTEN_KEEPALIVE const float* requad_corners() { return requad::web::state().scene->corners().data(); }
EMSCRIPTEN_KEEPALIVE const float* requad_stages() { return requad::web::state().stages.data(); }
EMSCRIPTEN_KEEPALIVE const unsigned* requad_triangles() { return requad::web::state().scene->triangles().data(); }

}  // extern "C"
