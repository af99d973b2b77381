// The session as the page calls it: a request comes as JSON and is answered as JSON. For WebAssembly alone.
//
// Functions of C that the page calls: requad_open() with the bytes of a file, requad_call() for everything else,
// requad_text() for texts that may be long, and the arrays of the scene. Ids of vertices and quads stand for themselves;
// positions are arrays of three numbers. An answer is valid until the next call.
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

constexpr std::array kKinds{"vertex", "pair", "edge", "quad"};

Selection selection_of(const json& request) {
  Selection s;
  for (std::size_t i = 0; i < kKinds.size(); ++i) {
    if (request.value("kind", "") == kKinds[i]) s.kind = static_cast<Selection::Kind>(i);
  }
  s.a = VertexId(request.value("a", -1));
  s.b = VertexId(request.value("b", -1));
  s.quad = FaceId(request.value("quad", -1));
  return s;
}

json to_json(const Selection& s) {
  json result{{"kind", kKinds[static_cast<std::size_t>(s.kind)]}};
  if (s.a.valid()) result["a"] = s.a.index();
  if (s.b.valid()) result["b"] = s.b.index();
  if (s.quad.valid()) result["quad"] = s.quad.index();
  return result;
}

// What the page shows of a mesh at all times, and what it must draw anew.
json status(State& s) {
  Session& session = *s.session;
  const Changes changes = session.take_changes();
  bool everything = changes.everything;
  if (everything) {
    s.scene = std::make_unique<Scene>(session.mesh(), session.positions());
  } else {
    everything = s.scene->update(session.mesh(), session.positions(), changes.quads);
  }
  const Description d = session.describe();
  json irregular = json::array(), valences = json::object();
  for (const VertexId v : session.irregular())
    irregular.push_back(
        {{"id", v.index()}, {"valence", session.mesh().valence(v)}, {"at", to_json(session.positions()[v.slot()])}});
  for (const auto& [valence, count] : d.irregular) valences[std::to_string(valence)] = count;
  return {{"vertices", d.vertices},
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
          {"radius", s.scene->radius()}};
}

json to_json(const Offers& offers) {
  json list = json::array();
  for (const Offer& o : offers.list) {
    json arrows = json::array();
    for (const Arrow& arrow : o.arrows) arrows.push_back({to_json(arrow.from), to_json(arrow.to)});
    list.push_back({{"name", o.name},
                    {"why", o.why},
                    {"effect", o.effect},
                    {"operations", o.counts.operations},
                    {"made", o.counts.faces_made},
                    {"deleted", o.counts.faces_deleted},
                    {"vertices", ids(o.vertices)},
                    {"quads", ids(o.quads)},
                    {"after", {o.after[0].index(), o.after[1].index()}},
                    {"arrows", arrows}});
  }
  return {{"why", offers.why}, {"hint", offers.hint}, {"list", list}};
}

json answer_to(State& s, const json& request) {
  Session& session = *s.session;
  const std::string what = request.at("ask");
  const auto vector = [&request](const char* key) {
    return Eigen::Vector3d(request.at(key)[0], request.at(key)[1], request.at(key)[2]);
  };
  if (what == "status") return status(s);
  if (what == "offers") return to_json(session.offers(selection_of(request.at("selection"))));
  if (what == "perform") {
    const std::string why = session.perform(selection_of(request.at("selection")), request.at("name"));
    return {{"why", why}};
  }
  if (what == "undo") return {{"done", session.undo()}};
  if (what == "redo") return {{"done", session.redo()}};
  if (what == "point") {
    const FaceId quad(request.at("quad"));
    if (!session.mesh().is_live(quad)) return nullptr;
    return to_json(session.pointed_at(quad, vector("origin"), vector("direction")));
  }
  if (what == "last_step") {
    const Step& step = session.steps().back();
    return {{"words", step.words}, {"lines", session.lines(step)}};
  }
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

// "obj" or "script".
EMSCRIPTEN_KEEPALIVE const char* requad_text(const char* what) {
  using namespace requad;
  web::State& s = web::state();
  return web::give(s, std::string_view(what) == "obj" ? s.session->export_obj() : s.session->script());
}

EMSCRIPTEN_KEEPALIVE const float* requad_corners() { return requad::web::state().scene->corners().data(); }
EMSCRIPTEN_KEEPALIVE const unsigned* requad_triangles() { return requad::web::state().scene->triangles().data(); }

}  // extern "C"
