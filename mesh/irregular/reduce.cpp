#include "mesh/irregular/reduce.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <queue>
#include <tuple>
#include <utility>

#include "mesh/irregular/reduction_fit.hpp"
#include "mesh/irregular/reduction_judge.hpp"
#include "mesh/irregular/reduction_memory.hpp"
#include "mesh/irregular/reduction_values.hpp"

namespace requad::mesh {

namespace {

constexpr int kPartners = 3;  // candidates looked for at each vertex
constexpr int kHelpers = 8;   // third vertices offered to a cancellation
// How long a cancellation is looked for, and in the end, if no more than so many pairs are left.
constexpr int kPositions = 200;  // that a transport may visit
constexpr CancellationEffort kEffort{.positions = 1000, .detours = 10};
constexpr int kThoroughPositions = 1000;
constexpr std::size_t kFew = 32;
constexpr std::size_t kSeldom = 16;  // edits between two fits on the way
constexpr std::size_t kOften = 4;    // the same, if it is looked for thoroughly
constexpr int kMostRetreats = 2;
constexpr int kRefresh = 4;             // cancellations between two fits of all that was touched
constexpr double kOperationCost = 0.3;  // beside a face that is lost, which costs 1
constexpr double kGuessedCost = 6;      // of a candidate, for each edge between its vertices: about what is measured

}  // namespace

class Reduction::Work {
  static constexpr int kNotMeasured = -1;
  struct Candidate {
    double cost;
    VertexId three;
    VertexId five;
    int measured_at;                            // the number of cancellations then, or kNotMeasured
    bool operator<(const Candidate& o) const {  // for a heap: the cheapest first, then by ids
      return std::tie(cost, three, five) > std::tie(o.cost, o.three, o.five);
    }
  };

  using Reason = ReductionMemory::Reason;

  // What a cancellation that was made adds to the report.
  struct Made {
    ReductionMemory::Pair pair;
    std::size_t start;   // the editor's mark before it
    std::size_t images;  // that of the mirror
    int transports;
    int operations;
    int parted;  // ReduceReport::parted before it
  };

 public:
  Work(Editor& editor, const ReduceOptions& options)
      : editor_(editor),
        m_(editor.mesh()),
        options_(options),
        quick_transport_(editor, kPositions),
        thorough_transport_(editor, kThoroughPositions),
        thorough_(options.patience == 0),
        mirror_(options.symmetry),
        fit_(editor, options, mirror_ ? &*mirror_ : nullptr),
        values_(editor, options.cost == ReduceCost::curvature),
        judge_(fit_, values_, options) {
    report_.before = report_.after = count_irregular();
    if (mirror_) mirror_->symmetrise(editor_, m_.vertices());
  }

  Work(const Work&) = delete;
  Work& operator=(const Work&) = delete;

  Slice advance() {
    constexpr std::size_t kAtOnce = 16;
    if (queued_ < all_.size()) {
      const std::size_t end = std::min(queued_ + kAtOnce, all_.size());
      for (; queued_ < end; ++queued_) add_candidates(all_[queued_]);
      return Slice::working;
    }
    if (!goes_on() || (queue_.empty() && !progress_)) {
      count_failures();
      return retry_refused() || look_across() || look_thoroughly() ? Slice::working : Slice::ended;
    }
    if (queue_.empty()) {
      begin_round();
      return Slice::working;
    }
    if (!take_cheapest()) return Slice::working;
    progress_ = true;
    if (options_.progress) options_.progress(report_.after);
    return Slice::cancelled;
  }
  int irregular() const { return report_.after; }

  // What leads too far may be between the samples that is_too_far() asks about, and early. Then those after it stay only if
  // they can be made without it.
  bool retreat() {
    if (retreats_ == kMostRetreats) return false;
    finish();
    const std::vector<Made> wrong = keep_bound();
    finished_ = wrong.empty();
    if (finished_) return false;
    ++retreats_;
    memory_.forget_failures();
    memory_.forget_costs();
    for (const Made& made : wrong) memory_.fails(made.pair, Reason::too_far, {});
    failures_in_a_row_ = 0;
    thorough_ = options_.patience == 0;
    retried_at_ = -1;
    progress_ = true;
    queue_ = {};
    queued_ = all_.size();
    report_.after = count_irregular();
    return true;
  }
  ReduceReport conclude() {
    if (!finished_) {
      finish();
      if (!keep_bound().empty()) finish();
    }
    report_.after = count_irregular();
    const int sides = mirror_ ? 2 : 1;
    report_.cancelled = sides * static_cast<int>(made_.size());
    for (const Made& made : made_) {
      report_.transports += sides * made.transports;
      report_.operations += sides * made.operations;
    }
    report_.lost_patience = lost_patience();
    report_.minimal = editor_.sectors().is_minimal();
    return report_;
  }

 private:
  bool is_three(VertexId v) const { return m_.is_live(v) && editor_.sectors().lacks(v); }
  bool is_five(VertexId v) const { return m_.is_live(v) && editor_.sectors().exceeds(v); }
  bool is_irregular(VertexId v) const { return editor_.sectors().is_irregular(v); }
  const Positions& positions() const { return *editor_.positions(); }
  // Whether both lie beside the plane of symmetry, if there is one, and on the same side. Cancellations that stay there
  // seldom meet their image. In the end this no longer counts.
  bool are_on_one_side(VertexId v, VertexId w) const {
    return !mirror_ || across_ || mirror_->side(positions(), v) * mirror_->side(positions(), w) > 0;
  }

  int count_irregular() const {
    const std::vector<VertexId> all = m_.vertices();
    return static_cast<int>(std::count_if(all.begin(), all.end(), [this](VertexId v) { return is_irregular(v); }));
  }
  // Everything is tried again as long as something succeeds: what was refused once may have become possible.
  void begin_round() {
    memory_.forget_plans();
    // Where nothing can be cancelled, parting would only make more irregular vertices.
    if (!editor_.sectors().is_minimal() && !mirror_) part();
    values_.remember_all();
    report_.after = values_.irregular();
    all_ = m_.vertices();
    progress_ = false;
    queue_ = {};
    queued_ = 0;
  }
  // In the end, lets all that was refused be tried again, once between two cancellations: what was in its way may have
  // been far from it. Returns whether there is anything.
  bool retry_refused() {
    if (!goes_on() || retried_at_ == memory_.stage()) return false;
    retried_at_ = memory_.stage();
    progress_ = memory_.forget(Reason::refused);
    return progress_;
  }
  // In the end, lets third vertices lie anywhere, on the plane of symmetry too. Returns whether that may help.
  bool look_across() {
    if (!mirror_ || across_ || report_.after <= options_.until) return false;
    across_ = true;
    memory_.forget(Reason::refused);
    memory_.forget(Reason::unsymmetric);
    memory_.forget_costs();
    queue_ = {};
    progress_ = true;
    return true;
  }
  // In the end, looks longer for the cancellations of the pairs that are left. Returns whether that may help.
  bool look_thoroughly() {
    const std::size_t left =
        static_cast<std::size_t>(report_.folded) +
        std::accumulate(report_.refusals.begin(), report_.refusals.end(), std::size_t{0},
                        [](std::size_t sum, const auto& some) { return sum + static_cast<std::size_t>(some.second); });
    if (thorough_ || !goes_on() || left == 0 || left > kFew) return false;
    thorough_ = true;
    memory_.forget(Reason::refused);
    memory_.forget(Reason::folded);
    progress_ = true;
    return true;
  }
  void count_failures() {
    report_.too_far = 0;
    report_.folded = 0;
    report_.inward = 0;
    report_.unsymmetric = 0;
    report_.worn = 0;
    report_.refusals.clear();
    for (const auto& [pair, failure] : memory_.failures()) {
      if (is_three(pair.first) && is_five(pair.second) && memory_.would_fail(pair))
        ++(failure.reason == Reason::refused       ? report_.refusals[failure.refusal]
           : failure.reason == Reason::inward      ? report_.inward
           : failure.reason == Reason::unsymmetric ? report_.unsymmetric
           : failure.reason == Reason::folded      ? report_.folded
           : failure.reason == Reason::worn        ? report_.worn
                                                   : report_.too_far);
    }
  }
  bool goes_on() const { return report_.after > options_.until && !lost_patience(); }
  bool lost_patience() const { return options_.patience > 0 && failures_in_a_row_ >= options_.patience; }

  void part() {
    const std::size_t start = editor_.mark();
    const int inverted = count_inverted(m_, positions());
    const int parted = part_all(editor_);
    if (parted == 0) return;
    fit_.fit_made(start);
    if ((options_.allow_inverted || count_inverted(m_, positions()) <= inverted) && fit_.is_within_bound()) {
      report_.parted += parted;
      memory_.forget_failures();
    } else {
      editor_.roll_back(start);
    }
  }

  // Fits all that was touched, or everything if the caller asks for it. Takes all back if nothing was cancelled.
  void finish() {
    if (made_.empty()) {
      editor_.roll_back(fit_.start());
      report_.parted = 0;
    }
    if (options_.final_rounds == 0 || (made_.empty() && !options_.fit_all)) return;
    fit_.fit_in_the_end();
  }
  // Takes back the last cancellations, and as many as it must, until the bound holds. Returns those of the last time.
  std::vector<Made> keep_bound() {
    std::vector<Made> last;
    for (std::size_t step = 1; !made_.empty() && !fit_.is_within_bound(); ++step) {
      const std::size_t number = std::min(step / 4 + 1, made_.size());
      const auto first = made_.end() - static_cast<std::ptrdiff_t>(number);
      last.assign(first, made_.end());
      made_.erase(first, made_.end());
      editor_.roll_back(last.front().start);
      if (mirror_) mirror_->roll_back(last.front().images);
      report_.parted = last.front().parted;
      report_.too_far += static_cast<int>(number);
    }
    return last;
  }
  // Pairs of v with its nearest partners of opposite index.
  void add_candidates(VertexId v) {
    if (is_three(v)) {
      for (const VertexId w :
           nearest(editor_, around_, v, kPartners, [&](VertexId x) { return is_five(x) && are_on_one_side(v, x); }))
        add(v, w, around_.distance(w));
    }
    if (is_five(v)) {
      for (const VertexId w :
           nearest(editor_, around_, v, kPartners, [&](VertexId x) { return is_three(x) && are_on_one_side(v, x); }))
        add(w, v, around_.distance(w));
    }
  }
  void add(VertexId three, VertexId five, int distance) {
    const double guess = options_.cost == ReduceCost::fit ? kGuessedCost * distance : 0;
    if (!memory_.would_fail({three, five})) queue_.push({guess, three, five, kNotMeasured});
  }
  void remember_failure(VertexId three, VertexId five, Reason why) {
    std::vector<VertexId> where = fit_.affected().near;
    where.insert(where.end(), fit_.affected().removed.begin(), fit_.affected().removed.end());
    memory_.fails({three, five}, why, std::move(where));
    if (why != Reason::unsymmetric) ++failures_in_a_row_;
  }

  // Cancels the pair. Leaves the mesh as it was if this is refused.
  bool make(VertexId three, VertexId five) {
    const auto helpers = nearest(editor_, around_, three, kHelpers,
                                 [&](VertexId v) { return v != five && is_irregular(v) && are_on_one_side(three, v); });
    PairTransport& transport = thorough_ ? thorough_transport_ : quick_transport_;
    Cancellation made =
        cancel_pair(editor_, transport, three, five, helpers, {}, thorough_ ? CancellationEffort() : kEffort);
    if (made.refusal == Refusal::none) {
      memory_.plans({three, five}, std::move(made));
      return true;
    }
    memory_.fails({three, five}, Reason::refused, around_.met(), made.refusal);
    return false;
  }
  // The same with fits on the way. Null if it is refused, or if it is lost on the way.
  const Cancellation* make_fitted(VertexId three, VertexId five) {
    const std::size_t start = editor_.mark();
    if (memory_.plan({three, five}) == nullptr) {
      if (!make(three, five)) return nullptr;
      editor_.roll_back(start);
    }
    const Cancellation* plan = memory_.plan({three, five});
    std::size_t fitted = start;
    const bool done = repeat(editor_, *plan, [&](std::size_t) {
      if (editor_.mark() - fitted < (is_careful() ? kOften : kSeldom)) return true;
      fit_.fit_on_the_way(fitted);
      fitted = editor_.mark();
      return thorough_ || !judge_.is_lost(start);
    });
    if (done) return plan;
    remember_failure(three, five, judge_.reason());
    editor_.roll_back(start);
    return nullptr;
  }

  // What a cancellation seems to cost. Nothing is fitted for it, so this is quick: the paper's cost, or the number of
  // samples that lose their face, a quarter each, and some of the number of operations. Where the mesh is coarse, many
  // samples lie on a face.
  bool estimate(VertexId three, VertexId five, double& cost) {
    if (const std::optional<double> known = memory_.cost({three, five})) {
      cost = *known;
      return true;
    }
    ++report_.measured;
    const std::size_t before = editor_.mark();
    const bool made = make(three, five);
    if (made && options_.cost == ReduceCost::curvature) {
      fit_.look_since(before, 1);
      cost = values_.change(fit_.affected()).curvature;
    } else if (made) {
      cost = static_cast<double>(fit_.carry()) / 4 + kOperationCost * memory_.plan({three, five})->steps;
    }
    if (made) memory_.costs({three, five}, cost, around_.met());
    editor_.roll_back(before);
    return made;
  }

  // The cheapest candidate, if its estimate is up to date. If not, it is measured and queued again, and nothing is returned.
  std::optional<Candidate> next_candidate() {
    while (!queue_.empty()) {
      Candidate c = queue_.top();
      queue_.pop();
      if (!is_three(c.three) || !is_five(c.five) || memory_.would_fail({c.three, c.five})) continue;
      if (c.measured_at == memory_.stage()) return c;
      c.measured_at = memory_.stage();
      if (estimate(c.three, c.five, c.cost)) queue_.push(c);
      break;
    }
    return std::nullopt;
  }

  // Makes the cheapest cancellation and fits it. If it is not acceptable then, fits more. Returns false, and leaves the
  // mesh as it was, if none can be made or if that does not help either.
  bool take_cheapest() {
    const std::optional<Candidate> c = next_candidate();
    if (!c) return false;
    const std::size_t before = editor_.mark();
    const std::size_t images = mirror_ ? mirror_->mark() : 0;
    const Cancellation* made = make_fitted(c->three, c->five);
    if (made == nullptr) return false;
    const bool symmetric = !mirror_ || mirror_->follow(editor_, before);
    if (!symmetric) fit_.look_since(before, 1);
    if (!symmetric || !judge_.accepts(before, is_careful())) {
      const Reason why = symmetric ? judge_.reason() : Reason::unsymmetric;
      const bool worn = why == Reason::worn;
      if (!worn || !may_refresh()) remember_failure(c->three, c->five, why);
      editor_.roll_back(before);
      if (mirror_) mirror_->roll_back(images);
      if (worn && may_refresh()) refresh();
      return false;
    }
    failures_in_a_row_ = 0;
    made_.push_back({{c->three, c->five}, before, images, made->transports, made->steps, report_.parted});
    memory_.begin_stage(std::array{&fit_.affected().removed, &fit_.affected().changed});
    values_.remember(fit_.affected());
    report_.after = values_.irregular();
    const std::vector<VertexId> changed = fit_.affected().changed;
    for (const VertexId v : changed) add_candidates(v);
    return true;
  }

  // What was touched may have better quads than the fits on the way have left. So it is fitted as in the end, some
  // cancellations after the last time.
  bool may_refresh() const { return options_.final_rounds > 0 && memory_.stage() >= refreshed_at_ + kRefresh; }
  void refresh() {
    refreshed_at_ = memory_.stage();
    finish();
    memory_.forget(Reason::worn);
    begin_round();
  }
  // Whether fits take more time: where a bound was asked for, or the search is thorough.
  bool is_careful() const { return thorough_ || options_.max_deviation >= 0; }

  Editor& editor_;
  const QuadMesh& m_;
  const ReduceOptions& options_;
  PairTransport quick_transport_;
  PairTransport thorough_transport_;
  bool thorough_;  // look_thoroughly()
  std::optional<Mirror> mirror_;
  ReductionFit fit_;
  ReductionValues values_;  // of the mesh after the last cancellation
  ReductionJudge judge_;
  BreadthFirstDistances around_;
  std::priority_queue<Candidate> queue_;
  std::vector<VertexId> all_;  // at the start of the round
  std::size_t queued_ = 0;     // so many of these have their candidates in the queue
  bool progress_ = true;       // something was cancelled in the round
  bool across_ = false;        // look_across()
  ReduceReport report_;
  std::vector<Made> made_;
  ReductionMemory memory_;
  int failures_in_a_row_ = 0;
  int refreshed_at_ = 0;  // ReductionMemory::stage()
  int retried_at_ = -1;   // the same
  int retreats_ = 0;
  bool finished_ = false;  // by retreat()
};

Reduction::Reduction(Editor& editor, const ReduceOptions& options) : work_(std::make_unique<Work>(editor, options)) {}
Reduction::~Reduction() = default;
Reduction::Slice Reduction::advance() { return work_->advance(); }
int Reduction::irregular() const { return work_->irregular(); }
bool Reduction::retreat() { return work_->retreat(); }
ReduceReport Reduction::finish() { return work_->conclude(); }

ReduceReport reduce(Editor& editor, const ReduceOptions& options) {
  Reduction reduction(editor, options);
  do {
    while (reduction.advance() != Reduction::Slice::ended) {
    }
  } while (reduction.retreat());
  return reduction.finish();
}

}  // namespace requad::mesh
