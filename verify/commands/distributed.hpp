// A campaign on several processes, over MPI (built with -DREQUAD_MPI=ON only).
//
// Rank 0 knows which cases are still to be run. It hands them out one by one, the costliest first, to whichever rank
// asks. It gathers the results, keeps the journal and writes the reports. The other ranks list the same cases from the
// same command line and run the cases they are given. A single process does everything itself. MPI ends all processes
// when one of them dies; with a journal the next start continues.
#pragma once

#include "verify/campaign.hpp"

namespace requad::verify {

// MPI for the life of the program. MPI requires that it is made before anything else.
class Processes {
 public:
  Processes(int& argc, char**& argv);
  ~Processes();
  Processes(const Processes&) = delete;
  Processes& operator=(const Processes&) = delete;

  bool leads() const;  // rank 0
  bool alone() const;  // there is no other process
  // On rank 0: hands out cases. Call it at most once; if it is not called, call dismiss().
  void hand_out(const std::vector<std::size_t>& todo, std::size_t claims, const Done& done);
  // On rank 0: dismisses the others, which wait for hand_out() until then. A second call does nothing.
  void dismiss();
  // On the others: runs cases until dismissed.
  void work(const std::function<CaseResult(std::size_t)>& run);

 private:
  struct State;
  State* state_;
};

}  // namespace requad::verify
