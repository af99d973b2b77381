// The functions of this room that read the disk or standard input. Builds without a file system leave this source out.
#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <new>

#include "mesh/files/feature_edges.hpp"
#include "mesh/files/read_polygons.hpp"
#include "mesh/files/reading.hpp"
#include "mesh/files/surface.hpp"
#include "mesh/text/text_scanner.hpp"

namespace requad::mesh {

std::string read_text(const std::string& path) {
  const std::string name = name_in_messages(path);
  const auto fail = [&name](const std::string& why) { throw FileError(name + ": cannot be read: " + why); };
  std::ifstream file;
  if (path != "-") {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) fail("it is a folder");
    file.open(path, std::ios::binary);
    if (!file) fail(std::strerror(errno));
  }
  std::istream& in = path == "-" ? std::cin : file;
  // The text is read in pieces, because a pipe does not know its size and may have no end.
  std::string text;
  constexpr std::size_t kLargestText = std::size_t{1} << 31;  // over thirty million quads
  constexpr std::size_t kPiece = std::size_t{1} << 20;
  std::size_t size = 0;
  try {
    do {
      text.resize(std::max(size + kPiece, size + size / 2));
      in.read(text.data() + size, static_cast<std::streamsize>(text.size() - size));
      const std::size_t end = size + static_cast<std::size_t>(in.gcount());
      if (size == 0) require_text(std::string_view(text).substr(0, end), name);
      require_no_zero_byte(std::string_view(text).substr(size, end - size), name);
      if (end > kLargestText) fail("it is larger than 2 GiB");
      size = end;
    } while (in);
    if (in.bad()) fail("input error");
    text.resize(size);
  } catch (const std::bad_alloc&) {
    fail("it does not fit into memory");
  }
  return text;
}

std::string name_in_messages(const std::string& path) { return path == "-" ? "standard input" : path; }

PolygonMesh read_polygon_mesh(const std::string& path) {
  require_known_end(path);
  return parse_polygon_mesh(read_text(path), path, name_in_messages(path));
}

Surface read_surface(const std::string& path, bool subdivided, bool welded) {
  return to_surface(read_polygon_mesh(path), subdivided, welded);
}

FeatureEdges read_feature_edges(const std::string& path, const Surface& surface) {
  return parse_feature_edges(read_text(path), name_in_messages(path), surface);
}

}  // namespace requad::mesh
