// Text for people: counts of things, and lines that are not too wide.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace requad::program {

// "1 vertex", "2 vertices". Without `many`, the plural of `one` ends in s.
std::string counted(std::int64_t count, const std::string& one, const std::string& many = "");

// How wide a line on standard output should be at the most: what the environment variable COLUMNS says, else the width
// of the terminal, else 80; never less than 40.
std::size_t text_width();

// The text in lines of at most `width` characters, each after `indent` blanks. A word that is wider stays where it
// is. A line of the text that starts with blanks is an entry of a list, "  name  meaning". The lines that it is broken
// into start below the meaning, or below the name if there is no meaning.
std::vector<std::string> wrapped(const std::string& text, std::size_t indent, std::size_t width);

// The text with every line that is wider than text_width() broken at blanks. Its further lines are indented by
// `hanging` more blanks than the line itself.
std::string fitted(const std::string& text, std::size_t hanging = 4);

}  // namespace requad::program
