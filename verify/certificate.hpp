// Certificates: text files that say what moves found in a region. A program that shares no code with this one checks
// them again (check/main.cpp, `requad-verify check DIR`).
//
// A folder holds MANIFEST and a text file for each region:
//
//   requad manifest 2
//   family regular-digons sides 3..24            the regions: all of these families in these ranges that have a
//   family other-digons perimeters 4..24         configuration, each once up to rotation
//   certificates 67
//   3-3-3-3.txt ed50a2f3                         their files, named by pair and sides, with the CRC-32 of their bytes
//   ...
//   end
//
//   requad certificate 2
//   pair 3-3                              valences, the smaller first
//   sides 6 6                             counter-clockwise; of all rotations the first in lexicographic order
//   configurations 6                      meshes that hold the pair
//   merged 1                              meshes that hold the merged vertex
//   edges 10                              of the configuration graph with apex; a self-loop counts once
//   mesh 0 pair (1,1) d1 1 d2 1 p 1 strips 2 2 vertices 20 faces 13
//                                         label and canonical labelling: theory/configurations.hpp
//   0 1 8 19                              faces, counter-clockwise; vertices 0, 1, ... are the boundary, side 1 from 0
//   ...
//   edge 0 1 step open from 1 1 1 to 2 2 1 operations 2
//                                         from mesh 0 to mesh 1; d1, d2 and p of the labellings before and after
//   flip 8 9 13 14                        the edge 8-9 becomes 13-14
//   collapse 8 9 10 13                    the face 8 9 10 13 goes, 10 becomes 8
//   split 9 8 10 21                       along 8 - 9 - 10: in the faces counter-clockwise from the one left of 9 -> 8
//                                         to the one left of 10 -> 9, 9 becomes 21, the next new vertex; the face
//                                         9 8 21 10 opens
//   end
//
// Boundary vertices keep their names, and no operation changes how many faces they have. The vertex that the first
// operation of a move has moved, and the other one of the pair, keep their names until the last operation. Words have
// one space between them.
#pragma once

#include <set>
#include <string>

#include "verify/case_list.hpp"
#include "verify/studies/study.hpp"

namespace requad::verify {

// The text of one region's certificate. Precondition: moves found at least one configuration, and their graph is
// connected.
std::string certificate_text(const PairStudy& study);

// The families of regions of which there are certificates.
std::set<Family> certified_families();

// Explores all regions with a pair that the ranges have of these families, and writes the certificates and the MANIFEST
// into the folder, which is made if it does not exist. Writes all or none. Returns the number of certificates. Throws
// program::UsageError if the folder cannot be written.
int write_certificates(const std::string& folder, const Ranges& ranges, const std::set<Family>& families, bool quiet);

}  // namespace requad::verify
