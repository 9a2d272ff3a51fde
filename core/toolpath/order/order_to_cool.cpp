#include "toolpath/order/order_to_cool.h"

#include "collision/bead_samples.h"
#include "toolpath/order/print_turn.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace voluta::toolpath {

namespace {
using collision::BeadSample, collision::BeadSampleGrid;

constexpr double kNever = -std::numeric_limits<double>::infinity();
// A path is turned round, or begun elsewhere, only if that gains more [s].
constexpr double kWorthS = 0.05;
// The turns of a patch's beads are given up if there is a longer wait and the other order needs no
// longer one, in shares of the least time: it saves one in the next layer, if not in this one.
constexpr double kWorthTurns = 0.05, kSameWait = 0.01;

int rankOf(const plan::ToolPath& path) {
  Bead bead;
  bead.kind = path.kind;
  bead.ring = path.ring;
  return printOrder(bead);
}

bool ofOnePatch(const plan::ToolPath& a, const plan::ToolPath& b) {
  return a.layer == b.layer && a.patch == b.patch && a.group == b.group && a.item == b.item &&
         a.tool == b.tool;
}

// A way of printing a path: from the waypoint `begin` of its first one on, or backwards.
struct Course {
  std::size_t begin = 0;
  bool backwards = false;
  // The time at which a bead below was printed, less the time from the path's beginning until it is
  // covered: the maximum over the path [s].
  double readyS = kNever;
};
// A path of the patch with its course; paths of one turn that follow each other have equal turns.
struct Planned {
  std::size_t path = 0;
  Course course;
  std::size_t rank = 0;
  int kind = 0;           // rankOf()
  std::vector<int> below; // kinds that it covers, but its own
};

// Returns the paths in the order of the beads below them. A path follows those of a kind that it
// covers in the layer below, since those of the next layer will lean likewise; otherwise the path
// above the oldest beads comes first.
std::vector<Planned> inOrderOfBelow(std::vector<Planned> left) {
  const auto covers = [](const Planned& a, const Planned& b) {
    return std::ranges::find(a.below, b.kind) != a.below.end();
  };
  std::ranges::stable_sort(left, {}, [](const Planned& p) { return p.course.readyS; });
  std::vector<Planned> ordered;
  while (!left.empty()) {
    auto next = std::ranges::find_if(left, [&](const Planned& a) {
      return std::ranges::none_of(left,
                                  [&](const Planned& b) { return covers(a, b) && !covers(b, a); });
    });
    next = next == left.end() ? left.begin() : next;
    ordered.push_back(std::move(*next));
    left.erase(next);
  }
  return ordered;
}

class Cooler {
public:
  Cooler(Assembled& assembled, bool movesSeams, double minS)
      : in_(assembled), movesSeams_(movesSeams), minS_(minS), grid_(assembled.plan) {}

  void run() {
    const std::vector<plan::ToolPath>& paths = in_.plan.paths;
    for (std::size_t first = 0, end = 0; first < paths.size(); first = end) {
      end = first + 1;
      while (end < paths.size() && ofOnePatch(paths[first], paths[end]))
        ++end;
      order(first, end);
    }
    out_.plan.fill = in_.plan.fill;
    out_.travelMm = in_.travelMm;
    in_ = std::move(out_);
  }

private:
  double secondsTo(std::size_t waypoint) const {
    return (in_.plan.position[waypoint] - in_.plan.position[waypoint - 1]).norm() /
           static_cast<double>(in_.plan.speedMmPerS[waypoint]);
  }

  void order(std::size_t first, std::size_t end) {
    std::vector<Planned> planned;
    std::size_t rank = 0;
    for (std::size_t p = first; p < end; ++p) {
      rank += p > first && rankOf(in_.plan.paths[p]) != rankOf(in_.plan.paths[p - 1]);
      const plan::ToolPath& path = in_.plan.paths[p];
      planned.push_back({p, bestCourse(path), rank, rankOf(path), kindsBelow(path)});
    }
    std::ranges::stable_sort(planned, {},
                             [](const Planned& p) { return std::pair(p.rank, p.course.readyS); });
    if (minS_ > 0.0) {
      std::vector<Planned> free = inOrderOfBelow(planned);
      const double wait = waitBefore(planned);
      if (wait > kWorthTurns * minS_ && waitBefore(free) < wait + kSameWait * minS_)
        planned = std::move(free);
    }
    for (const Planned& p : planned)
      append(in_.plan.paths[p.path], p.course);
  }

  // Returns the wait before paths in this order with which all beads below have cooled.
  double waitBefore(const std::vector<Planned>& planned) const {
    double wait = 0.0, beginS = nowS_;
    for (const Planned& p : planned) {
      wait = std::max(wait, p.course.readyS + minS_ - beginS);
      const plan::ToolPath& path = in_.plan.paths[p.path];
      for (std::size_t k = 1; k < path.count; ++k)
        beginS += secondsTo(path.first + k);
    }
    return wait;
  }

  // When the beads below were printed, at each segment of the path: the last of them.
  std::vector<double> belowS(const plan::ToolPath& path) const {
    std::vector<double> below(path.count, kNever); // by the waypoint at the segment's end
    std::vector<BeadSample> samples;
    for (std::size_t k = 1; k < path.count; ++k) {
      samples.clear();
      collision::appendSamples(in_.plan, path.first + k - 1, path.first + k, samples);
      for (const BeadSample& sample : samples)
        grid_.below(sample,
                    [&](std::size_t lower) { below[k] = std::max(below[k], endS_[lower]); });
    }
    return below;
  }

  // Returns the kinds of beads, but the path's own, below a tenth or more of it.
  std::vector<int> kindsBelow(const plan::ToolPath& path) const {
    constexpr double kMinShare = 0.1;
    std::map<int, std::size_t> counts;
    std::size_t count = 0;
    std::vector<BeadSample> samples;
    for (std::size_t k = 1; minS_ > 0.0 && k < path.count; ++k) {
      samples.clear();
      collision::appendSamples(in_.plan, path.first + k - 1, path.first + k, samples);
      for (const BeadSample& sample : samples) {
        std::set<int> kinds;
        grid_.below(sample, [&](std::size_t lower) { kinds.insert(kindOf_[lower]); });
        for (const int kind : kinds)
          ++counts[kind];
        ++count;
      }
    }
    std::vector<int> below;
    for (const auto& [kind, times] : counts)
      if (kind != rankOf(path) &&
          static_cast<double>(times) >= kMinShare * static_cast<double>(count))
        below.push_back(kind);
    return below;
  }

  Course bestCourse(const plan::ToolPath& path) const {
    const std::vector<double> below = belowS(path);
    std::vector<double> atS(path.count, 0.0); // since the path's first waypoint
    for (std::size_t k = 1; k < path.count; ++k)
      atS[k] = atS[k - 1] + secondsTo(path.first + k);
    Course forward, backward{0, true};
    for (std::size_t k = 1; k < path.count; ++k) {
      forward.readyS = std::max(forward.readyS, below[k] - atS[k - 1]);
      backward.readyS = std::max(backward.readyS, below[k] - (atS.back() - atS[k]));
    }
    if (!path.closed)
      return backward.readyS < forward.readyS - kWorthS ? backward : forward;
    return movesSeams_ ? bestBegin(below, atS, forward) : forward;
  }

  // Of a closed path. Segments before the beginning are printed a whole round later.
  static Course bestBegin(const std::vector<double>& below, const std::vector<double>& atS,
                          const Course& given) {
    const std::size_t n = below.size();
    std::vector<double> from(n + 1, kNever); // maximum over the segments from here on
    for (std::size_t k = n; k-- > 1;)
      from[k] = std::max(from[k + 1], below[k] - atS[k - 1]);
    Course best = given;
    double before = kNever;
    for (std::size_t begin = 0; begin + 1 < n; ++begin) {
      if (begin > 0)
        before = std::max(before, below[begin] - atS[begin - 1]);
      const double ready = std::max(from[begin + 1], before - atS.back()) + atS[begin];
      if (ready < best.readyS - kWorthS)
        best = {begin, false, ready};
    }
    return best;
  }

  void append(const plan::ToolPath& path, const Course& course) {
    plan::ToolPath moved = path;
    moved.first = out_.plan.waypointCount();
    const std::size_t n = path.count;
    for (std::size_t k = 0; k < n; ++k) {
      // The last waypoint of a closed path is its first one.
      std::size_t from = course.backwards ? n - 1 - k : course.begin + k;
      if (from >= n)
        from -= n - 1;
      // The speed is that of the segment to the waypoint.
      const std::size_t speedFrom = course.backwards && k > 0 ? from + 1 : from;
      copy(path.first + from, path.first + speedFrom);
    }
    out_.plan.paths.push_back(moved);
    deposit(moved);
  }
  void copy(std::size_t from, std::size_t speedFrom) {
    plan::ToolPlan& to = out_.plan;
    to.position.push_back(in_.plan.position[from]);
    to.direction.push_back(in_.plan.direction[from]);
    to.widthMm.push_back(in_.plan.widthMm[from]);
    to.heightMm.push_back(in_.plan.heightMm[from]);
    to.speedMmPerS.push_back(in_.plan.speedMmPerS[speedFrom]);
    out_.clearDirection.push_back(in_.clearDirection[from]);
  }

  void deposit(const plan::ToolPath& path) {
    std::vector<BeadSample> samples;
    for (std::size_t w = path.first + 1; w < path.first + path.count; ++w) {
      const double seconds = (out_.plan.position[w] - out_.plan.position[w - 1]).norm() /
                             static_cast<double>(out_.plan.speedMmPerS[w]);
      samples.clear();
      collision::appendSamples(out_.plan, w - 1, w, samples);
      for (const BeadSample& sample : samples) {
        grid_.add(sample);
        endS_.push_back(nowS_ + sample.to * seconds);
        kindOf_.push_back(rankOf(path));
      }
      nowS_ += seconds;
    }
  }

  Assembled& in_;
  Assembled out_;
  bool movesSeams_;
  double minS_;
  BeadSampleGrid grid_;
  std::vector<double> endS_; // per sample in the grid
  std::vector<int> kindOf_;  // likewise
  double nowS_ = 0.0;
};
} // namespace

void orderToCool(Assembled& assembled, bool movesSeams, double minS) {
  Cooler(assembled, movesSeams, minS).run();
}

} // namespace voluta::toolpath
