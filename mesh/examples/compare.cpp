// compare A [B]: says whether two meshes are isomorphic. Without B, whether A is its own mirror image.
#include <iostream>

#include <requad/mesh/files/surface.hpp>
#include <requad/mesh/topology/signature.hpp>

int main(int argc, char** argv) {
  using namespace requad::mesh;
  if (argc != 2 && argc != 3) return 2;
  const QuadMesh a = read_surface(argv[1], /*subdivided=*/false).mesh;
  const QuadMesh b = argc == 3 ? read_surface(argv[2], /*subdivided=*/false).mesh : a;
  const Orientation orientation = argc == 3 ? Orientation::kept : Orientation::mirrored;
  const bool same = canonical_signature(a) == canonical_signature(b, orientation);
  std::cout << (same ? "isomorphic" : "different") << '\n';
}
