// What a user may have meant by a word that is not known.
#pragma once

#include <string>
#include <vector>

namespace requad::program {

// The known word that differs from the given one by the fewest characters added, removed, changed or swapped with the
// next (upper and lower case are one), if these are few for its length; "" if none is that near.
std::string suggestion(const std::string& word, const std::vector<std::string>& known);
// "; did you mean 'smooth'?", or "".
std::string did_you_mean(const std::string& word, const std::vector<std::string>& known);

}  // namespace requad::program
