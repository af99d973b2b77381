// Certificates: text files that say what moves found in a region. A program that shares no code with this one checks
// them again (check/main.cpp, `requad-verify check DIR`).
//
// A folder holds MANIFEST, whose lines name the other files in order, and a text file for each region:
//
//   requad certificate 1
//   pair 3-3                              valences, the smaller first
//   sides 6 6                             counter-clockwise
//   configurations 6                      meshes that hold the pair
//   merged 1                              meshes that hold the merged vertex
//   edges 10                              of the configuration graph with apex; a self-loop counts once
//   mesh 0 pair (1,1) vertices 20 faces 13
//   0 1 8 19                              faces, counter-clockwise; vertices 0, 1, ... are the boundary, side 1 from 0
//   on ...
//   edge 0 1 step open operations 2       from mesh 0 to mesh 1; parallel edges differ by the step
//   flip 8 9 13 14                        the edge 8-9 becomes 13-14
//   collapse 8 9 10 13                    the face 8 9 10 13 goes, 10 becomes 8
//   split 9 8 10 21                       along 8 - 9 - 10: in the faces counter-clockwise from the one left of 9 -> 8
//                                         to the one left of 10 -> 9, 9 becomes 21, the next new vertex; the face
//                                         9 8 21 10 opens
//   end
//
// Boundary vertices keep their names, and no operation changes how many faces they have.
#pragma once

#include <string>

#include "verify/studies/study.hpp"

namespace requad::verify {

// The text of one region's certificate. Precondition: moves found at least one configuration, and their graph is
// connected.
std::string certificate_text(const PairStudy& study);

// Explores every pair of the list again and writes the certificates into the folder, which is made if it does not
// exist. Writes all certificates or none. Returns their number. Throws program::UsageError if the folder cannot be
// written.
int write_certificates(const std::string& folder, const std::vector<RegionCase>& cases, bool quiet);

}  // namespace requad::verify
