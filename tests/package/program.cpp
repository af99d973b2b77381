// A user of requad::program, which knows no mesh: a program with the exit codes and one-line errors of requad.
#include <requad/mesh/program/program.hpp>

int main() {
  return requad::program::run("use-program", [] {
    const auto numbers = requad::program::parse_integers("6,6,6", "sides");
    return numbers.size() == 3 ? requad::program::kDone : requad::program::kCheckFailed;
  });
}
