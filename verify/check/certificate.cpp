#include "verify/check/certificate.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include "verify/check/disk.hpp"
#include "verify/check/labels.hpp"
#include "verify/check/moves.hpp"

namespace check {

namespace {

using Words = std::vector<std::string_view>;

// "12 <what>, but <whose> 13"
void require_equal(std::uint64_t listed, const char* what, const char* other, std::uint64_t expected) {
  if (listed != expected)
    throw Rejected(std::to_string(listed) + " " + what + ", but " + other + " " + std::to_string(expected));
}

class Certificate {
 public:
  Certificate(Lines& lines, const Region* expected) : lines_(lines) {
    const Words& title = lines_.next("requad", 3);
    require(title[1] == "certificate" && title[2] == "2", "not a certificate of version 2");
    const std::string pair(lines_.next("pair", 2)[1]);
    const Words& words = lines_.next("sides", 0);
    std::vector<int> sides;
    for (std::size_t i = 1; i < words.size(); ++i) sides.push_back(number(words[i]));
    region_ = region_of(pair, std::move(sides));
    require(expected == nullptr || region_ == *expected, "the region is not the one that the file is named by");
    counts_ = {1, total("configurations"), total("merged"), total("edges")};
    require(counts_.configurations > 0, "there is no configuration");
  }

  Counts check(FillingCounter& counter) {
    check_closed_form(region_, static_cast<std::uint64_t>(counts_.configurations));
    std::vector<std::vector<Labelling>> labellings;
    for (int i = 0; i < counts_.configurations + counts_.merged; ++i) labellings.push_back(read_mesh(i));
    require(pairs_ == counts_.configurations, "not as many meshes hold the pair as claimed");
    Moves moves(region_, std::move(labellings));
    std::vector<int> group(disks_.size());
    std::iota(group.begin(), group.end(), 0);
    for (int e = 0; e < counts_.edges; ++e) read_edge(moves, group);
    lines_.next("end", 1);
    lines_.finish();
    moves.require_all();
    for (std::size_t i = 0; i < group.size(); ++i)
      require(root(group, static_cast<int>(i)) == root(group, 0), "the moves do not connect the configurations");
    require_equal(static_cast<std::uint64_t>(counts_.configurations), "meshes hold the pair", "the region has",
                  counter.with_pair(region_));
    require_equal(static_cast<std::uint64_t>(counts_.merged), "meshes hold the merged vertex", "the region has",
                  counter.with_merged_vertex(region_));
    return counts_;
  }

 private:
  int total(std::string_view what) { return number(lines_.next(what, 2)[1]); }

  // The labellings of mesh i.
  std::vector<Labelling> read_mesh(int i) {
    const auto k = static_cast<std::size_t>(region_.side_count());
    const Words& head = lines_.next("mesh", 15 + k);
    require(number(head[1]) == i, "the meshes are not numbered 0, 1, 2, ...");
    require(head[2] == "pair" || head[2] == "merged", "a mesh neither holds the pair nor is merged");
    require(head[4] == "d1" && head[6] == "d2" && head[8] == "p" && head[10] == "strips" &&
                head[11 + k] == "vertices" && head[13 + k] == "faces",
            "a mesh has a wrong head");
    const bool is_pair = head[2] == "pair";
    const std::string name(head[3]);
    Labelling claimed{number(head[5]), number(head[7]), number(head[9]), {}};
    for (std::size_t s = 0; s < k; ++s) claimed.e.push_back(number(head[11 + s]));
    const int vertices = number(head[12 + k]);
    // A disk of such little curvature has less than perimeter^2 faces; the limit keeps the memory small.
    const int claimed_faces = number(head[14 + k]);
    require(claimed_faces <= region_.perimeter() * region_.perimeter(), "a mesh has too many faces");
    std::vector<Face> faces;
    for (int f = claimed_faces; f > 0; --f) {
      const Words& words = lines_.next("", 4);
      faces.push_back({number(words[0]), number(words[1]), number(words[2]), number(words[3])});
    }
    require(!faces.empty(), "a mesh has no face");
    Disk disk(region_, faces, vertices);
    std::vector<Labelling> labellings = read_labellings(region_, disk);
    require(is_pair == (labellings[0].d1 > 0), "a mesh does not hold what its head says");
    require(claimed == labellings[0], "a mesh's separatrices do not have the d1, d2, p and strips of its head");
    require(name == label(region_, claimed), "a mesh has another label than its parameters");
    pairs_ += is_pair ? 1 : 0;
    require(index_.emplace(disk.form(), i).second, "two meshes are the same");
    disks_.push_back(std::move(disk));
    return labellings;
  }

  void read_edge(Moves& moves, std::vector<int>& group) {
    const Words& head = lines_.next("edge", 15);
    require(head[3] == "step" && head[5] == "from" && head[9] == "to" && head[13] == "operations",
            "an edge has a wrong head");
    const Moves::End from{number(head[1]), number(head[6]), number(head[7]), number(head[8])};
    const Moves::End to{number(head[2]), number(head[10]), number(head[11]), number(head[12])};
    const auto nodes = static_cast<int>(disks_.size());
    require(from.node < nodes && to.node < nodes, "an edge leads to a mesh that is not there");
    const Step step = step_of(head[4]);
    const int operations = number(head[14]);
    moves.add(from, step, to);
    const Disk& before = disks_[static_cast<std::size_t>(from.node)];
    Disk disk = before;
    Transport transport(region_, before);
    for (int i = 0; i < operations; ++i) {
      const Operation operation = read_operation();
      require(step != Step::open || operation.kind == Operation::Kind::split, "an open move does not only split");
      require(step != Step::close || operation.kind == Operation::Kind::collapse,
              "a close move does not only collapse");
      disk.apply(operation);
      i + 1 < operations ? transport.pass(disk) : transport.arrive(disk);
    }
    const auto found = index_.find(disk.form());
    require(found != index_.end() && found->second == to.node, "a script leads to another mesh");
    group[static_cast<std::size_t>(root(group, from.node))] = root(group, to.node);
  }

  Operation read_operation() {
    const Words& words = lines_.next("", 5);
    Operation operation{};
    if (words[0] == "flip") {
      operation.kind = Operation::Kind::flip;
    } else if (words[0] == "collapse") {
      operation.kind = Operation::Kind::collapse;
    } else {
      require(words[0] == "split", "there is no such operation");
      operation.kind = Operation::Kind::split;
    }
    for (std::size_t i = 0; i < 4; ++i) operation.vertices[i] = number(words[i + 1]);
    return operation;
  }

  // The node that stands for all that are connected with this one.
  static int root(std::vector<int>& group, int node) {
    while (group[static_cast<std::size_t>(node)] != node) {
      int& next = group[static_cast<std::size_t>(node)];
      next = group[static_cast<std::size_t>(next)];
      node = next;
    }
    return node;
  }

  Lines& lines_;
  Region region_;
  Counts counts_;
  std::vector<Disk> disks_;
  std::map<std::vector<int>, int> index_;  // of the meshes, by form
  int pairs_ = 0;
};

}  // namespace

Counts check_certificate(Lines& lines, const Region* expected, FillingCounter& counter) {
  return Certificate(lines, expected).check(counter);
}

void check_closed_form(const Region& region, std::uint64_t fillings) {
  require_equal(fillings, "configurations", "the closed form gives", static_cast<std::uint64_t>(closed_form(region)));
}

}  // namespace check
