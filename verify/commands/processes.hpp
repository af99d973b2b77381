// The processes that a campaign runs on: over MPI with -DREQUAD_MPI=ON, otherwise this one alone.
#pragma once

#ifdef REQUAD_MPI
#include "verify/commands/distributed.hpp"
#else

#include "verify/campaign.hpp"

namespace requad::verify {

// As in distributed.hpp.
struct Processes {
  Processes(int&, char**&) {}
  bool leads() const { return true; }
  bool alone() const { return true; }
  void hand_out(const std::vector<std::size_t>&, std::size_t, const Done&) {}
  void work(const std::function<CaseResult(std::size_t)>&) {}
};

}  // namespace requad::verify

#endif
