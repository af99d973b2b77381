// Options for how drawings look: the same for every command that draws, in all programs. Not installed.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "mesh/pictures/page.hpp"
#include "mesh/program/options.hpp"

namespace requad::pictures {

// The entries of a command's table. `formats_of` gives the formats that the command writes with these options; an option
// that changes none of them is refused. So is --no-labels if `has_labels` says that the drawings have none; without
// `has_labels` no drawing of the command has any, and there is no such option.
std::vector<program::Option> page_options(
    const std::function<std::vector<std::string>(const program::Options&)>& formats_of,
    const std::function<bool(const program::Options&)>& has_labels = {});

// The page that the options describe, without title and description. Throws UsageError.
Page page_of(const program::Options& options);

}  // namespace requad::pictures
