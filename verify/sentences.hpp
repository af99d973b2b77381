// Sentences of the paper that no check can decide. Every other sentence that states something belongs to a claim
// (claims/claims.hpp).
#pragma once

#include <string>
#include <vector>

namespace requad::verify {

struct UndecidedSentence {
  std::string where;     // in the paper
  std::string sentence;  // what the paper says there, in our words
  std::string reason;    // why no check can decide it
};

// In the order of the paper.
const std::vector<UndecidedSentence>& undecided_sentences();

// One sentence to a paragraph: where, what it says, and the reason.
std::string sentences_text();

}  // namespace requad::verify
