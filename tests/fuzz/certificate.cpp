// Certificates. Their checker shares no code with the project.
#include "verify/check/certificate.hpp"

#include <sstream>

#include "mesh/topology/validate.hpp"
#include "tests/fuzz/fuzz.hpp"

using namespace requad;

const fuzz::Memory fuzz::kMemory{256 << 10, 400};

namespace {

bool holds(const std::string& text) {
  std::istringstream in(text);
  check::Lines lines(in);
  check::FillingCounter counter;
  try {
    check::check_certificate(lines, nullptr, counter);
    return true;
  } catch (const check::Rejected& rejected) {
    fuzz::require_one_line(rejected.what());
  } catch (const check::Undecided& undecided) {
    fuzz::require_one_line(undecided.what());
  }
  return false;
}

// Checks that all meshes of a certificate that holds are disks for the library, too.
void check_meshes(const std::string& text) {
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    std::istringstream head(line);
    std::string mesh, word;
    int vertices = 0, count = 0;
    if (!(head >> mesh) || mesh != "mesh") continue;
    while (head >> word) {
      if (word == "vertices") head >> vertices;
      if (word == "faces") head >> count;
    }
    std::vector<std::array<int, 4>> faces(static_cast<std::size_t>(count));
    for (auto& face : faces) {
      for (int& corner : face) in >> corner;
    }
    std::getline(in, line);
    const auto m = mesh::QuadMesh::from_faces(vertices, faces);
    fuzz::require(mesh::validate(m).empty(), "a mesh is not valid");
    fuzz::require(mesh::euler_characteristic(m) == 1 && mesh::boundary_loop_count(m) == 1, "a mesh is no disk");
  }
}

// The text, in which the number after `what` is one larger. This number is in one of the first lines. The number of
// blanks between the words is not known.
std::string with_one_more(std::string text, const std::string& what) {
  const std::size_t start = text.find_first_of("0123456789", text.find(what));
  const std::size_t end = text.find_first_not_of("0123456789", start);
  return text.replace(start, end - start, std::to_string(std::stoi(text.substr(start, end - start)) + 1));
}

}  // namespace

void fuzz::try_input(std::string_view text) {
  const std::string certificate(text);
  if (!holds(certificate)) return;
  check_meshes(certificate);
  for (const char* what : {"configurations", "merged", "edges"})
    require(!holds(with_one_more(certificate, what)), std::string("a wrong number of ") + what + " is let through");
  require(!holds(certificate.substr(0, certificate.rfind("end"))), "a certificate without its end is let through");
}
