#include "verify/commands/distributed.hpp"

#include <new>
#include <string>

#include <boost/mpi/communicator.hpp>
#include <boost/mpi/environment.hpp>

#include "mesh/program/run/errors.hpp"

namespace requad::verify {

namespace mpi = boost::mpi;

namespace {

// A rank asks for work by sending its last result, or an empty one at first. It receives the number of a case or
// kNoMore. A rank that sends kLeaves or kExhausted receives nothing.
constexpr int kResult = 1;
constexpr int kCase = 2;
constexpr std::int64_t kNoMore = -1;
const std::string kLeaves = "leaves";        // because of wrong arguments, or of an output that only rank 0 can write
const std::string kExhausted = "exhausted";  // it has no memory for a case

}  // namespace

struct Processes::State {
  mpi::environment environment;
  mpi::communicator world;
  int asking = 0;          // on rank 0: number of ranks that are not yet dismissed
  bool dismissed = false;  // on the other ranks
};

Processes::Processes(int& argc, char**& argv) : state_(new State{{argc, argv}, {}, 0, false}) {
  state_->asking = state_->world.size() - 1;
}

Processes::~Processes() {
  if (leads()) {
    dismiss();
  } else if (!state_->dismissed) {
    state_->world.send(0, kResult, kLeaves);
  }
  delete state_;
}

bool Processes::leads() const { return state_->world.rank() == 0; }
bool Processes::alone() const { return state_->world.size() == 1; }

void Processes::hand_out(const std::vector<std::size_t>& todo, std::size_t claims, const Done& done) {
  mpi::communicator& world = state_->world;
  std::vector<std::int64_t> given(static_cast<std::size_t>(world.size()), kNoMore);
  std::size_t next = 0;
  std::size_t missing = todo.size();
  while (missing > 0) {
    std::string text;
    const int rank = world.recv(mpi::any_source, kResult, text).source();
    std::int64_t& current = given[static_cast<std::size_t>(rank)];
    if (text == kLeaves || text == kExhausted) {
      --state_->asking;
      if (text == kExhausted) throw std::bad_alloc();
      if (state_->asking == 0) throw program::UsageError("no other process came to work");
      continue;
    }
    if (!text.empty()) {
      done(static_cast<std::size_t>(current), case_result(nlohmann::ordered_json::parse(text), claims));
      --missing;
    }
    current = next < todo.size() ? static_cast<std::int64_t>(todo[next++]) : kNoMore;
    world.send(rank, kCase, current);
    if (current == kNoMore) --state_->asking;
  }
}

void Processes::dismiss() {
  for (; state_->asking > 0; --state_->asking) {
    std::string text;
    const int rank = state_->world.recv(mpi::any_source, kResult, text).source();
    if (text != kLeaves && text != kExhausted) state_->world.send(rank, kCase, kNoMore);
  }
}

void Processes::work(const std::function<CaseResult(std::size_t)>& run) {
  mpi::communicator& world = state_->world;
  std::string text;
  for (;;) {
    world.send(0, kResult, text);
    std::int64_t index = kNoMore;
    world.recv(0, kCase, index);
    if (index == kNoMore) {
      state_->dismissed = true;
      return;
    }
    try {
      text = to_json(run(static_cast<std::size_t>(index))).dump();
    } catch (...) {  // only exhaustion gets here; rank 0 reports it, unless MPI ends rank 0 first
      world.send(0, kResult, kExhausted);
      state_->dismissed = true;
      return;
    }
  }
}

}  // namespace requad::verify
