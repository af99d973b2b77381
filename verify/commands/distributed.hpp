// A campaign on several processes, over MPI (built with -DREQUAD_MPI=ON only).
//
// Rank 0 knows which cases are still to be done and hands them out one by one, the costliest first, to whichever rank
// asks; it gathers the results, keeps the journal and writes the reports. All other ranks list the same cases from the
// same command line and run those they are given. With one process everything is done in it. MPI ends all processes when
// one of them dies; a journal lets the next start go on.
#pragma once

#include "verify/campaign.hpp"

namespace requad::verify {

// MPI for the life of the program: made first of all, as MPI wants it.
class Processes {
 public:
  Processes(int& argc, char**& argv);
  ~Processes();
  Processes(const Processes&) = delete;
  Processes& operator=(const Processes&) = delete;

  bool leads() const;  // rank 0
  bool alone() const;  // there is no other
  // On rank 0: hands out cases. To be called once at most, and dismiss() if it is not.
  void hand_out(const std::vector<std::size_t>& todo, std::size_t claims, const Done& done);
  // On rank 0: lets the others go; they work for hand_out() until then. Nothing the second time.
  void dismiss();
  // On the others: runs cases until dismissed.
  void work(const std::function<CaseResult(std::size_t)>& run);

 private:
  struct State;
  State* state_;
};

}  // namespace requad::verify
