// What can be chosen in the editor, and what is offered for it.
//
// Terms
//   selection   what the user has chosen: a vertex, a pair of vertices, an edge or a quad.
//   offer       an edit of the selection, by its name, with its effect; or with the reason why it is refused.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "mesh/editing/editor.hpp"

namespace requad::web {

using mesh::FaceId;
using mesh::VertexId;

struct Selection {
  enum class Kind { vertex, pair, edge, quad };
  Kind kind = Kind::vertex;
  VertexId a;  // the vertex, or the first of two
  VertexId b;  // of a pair or an edge
  FaceId quad;
  // Of a pair: the third vertices that may help to cancel it. Without any, the nearest ones help.
  std::vector<VertexId> helpers = {};

  friend bool operator==(const Selection&, const Selection&) = default;
};

// From where a vertex of the selection moves to, in space. Both are equal if it stays.
struct Arrow {
  Eigen::Vector3d from;
  Eigen::Vector3d to;
};

struct Offer {
  std::string name;  // one of its kind in the selection: "slide_first", "move-v3 flip left to 149"
  std::string why;   // the reason of a refusal; empty if the edit can be made
  std::string help;  // what would help where it is refused; may be empty
  // The rest has a meaning only if the edit can be made.
  std::string effect;
  mesh::EditCounts counts;
  std::vector<VertexId> vertices;  // of the present mesh, by id: those that would have another valence or be gone
  std::vector<FaceId> quads;       // of the present mesh, by id: those that would have other corners or be gone
  std::vector<Arrow> arrows;       // one for each vertex of a pair that moves
  std::array<VertexId, 2> after;   // where the vertices of a pair would be; none for one that would be regular
  std::vector<VertexId> helpers;   // of a cancellation: the third vertices that may move
  std::optional<bool> feature;     // of an edge: whether it becomes a feature edge, or ceases to be one

  bool is_legal() const { return why.empty(); }
};

struct Offers {
  std::string why;   // why nothing at all is offered; else empty
  std::string hint;  // what would help then, or if no offer can be made
  VertexId third;    // an irregular vertex that could help a pair of which no offer can be made
  std::vector<Offer> list;
  bool more = false;  // there may be others, which take longer to find: Session::offers() adds them
};

}  // namespace requad::web
