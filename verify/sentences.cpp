#include "verify/sentences.hpp"

namespace requad::verify {

const std::vector<UndecidedSentence>& undecided_sentences() {
  static const std::vector<UndecidedSentence> kSentences{
      {.where = "abstract, section 11",
       .sentence = "The movement of a pair is fundamental, and the best possible compound operation.",
       .reason = "\"Best\" is not defined. Claims N4, T1 and M1 check the three facts that it rests on: the smallest "
                 "region, no edit of fewer vertices, all edits of two."},
      {.where = "section 1",
       .sentence = "The enumeration of all requadrangulations of a regular convex region is new (section 9 says this "
                   "again).",
       .reason = "A statement about the literature."},
      {.where = "section 8",
       .sentence =
           "Smoothing can improve the aspect ratios of modified faces, and pulling narrows the difference to the "
           "original mesh.",
       .reason =
           "It depends on weights and a threshold that the paper does not give. requad-edit measures both on each "
           "mesh that it writes."},
      {.where = "section 9",
       .sentence =
           "On a triangle mesh the simplest edits move a 5-7, a 5-5 or a 7-7 pair. The first keeps the relative "
           "distance, the other two change it, as on a quad mesh a 3-5, a 3-3 and a 5-5 pair do.",
       .reason = "requad has quad meshes only: the operations, the labels and the search of fillings are about quads. "
                 "Claims T1, P1 and P2 check what the section says of quad meshes."},
      {.where = "section 10, Figures 1, 15",
       .sentence =
           "The panel structure has 24 irregular vertices after the edits, in place of 168, in about 12 minutes; "
           "the disc has four aligned v3s, in place of 36 v3s and two v36s.",
       .reason = "The authors' meshes and sessions are not published with the paper."},
      {.where = "section 10",
       .sentence = "No general solution of quad remeshing is likely, so manual editing is essential.",
       .reason = "An opinion, as the paper says itself."},
      {.where = "section 10, Figure 19",
       .sentence = "Greedy cancellation reduces a mesh of 956 irregular vertices to eight v3s.",
       .reason = "The input is not published with the paper. requad-edit reduces other meshes in the same way "
                 "(mesh/irregular/README.md)."},
  };
  return kSentences;
}

std::string sentences_text() {
  std::string text;
  for (const UndecidedSentence& s : undecided_sentences())
    text += s.where + ": " + s.sentence + "\n     not checked: " + s.reason + '\n';
  return text;
}

}  // namespace requad::verify
