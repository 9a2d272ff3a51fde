#include "layers/follow_top.h"

#include "base/index.h"
#include "base/parallel.h"
#include "geometry/edges.h"
#include "geometry/measures.h"
#include "layers/level_surface.h"
#include "layers/stack_query.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>

namespace voluta::layers {

namespace {

// Cosines of 25 and 40 degrees.
constexpr double kAlong = 0.9063, kLateral = 0.7660;
constexpr double kOnSurface = 1e-3; // mm
// [mm] offset from the boundary; small enough that with a rim on a top inclined by 25 degrees the
// point is still within kOnSurface.
constexpr double kInwards = 2e-3;
// relative to half the height: the search for the top begins this far below a vertex
constexpr double kStartShare = 0.1;
// [mm] edges are split where heights differ by more from the interpolated one
constexpr double kOff = 0.05;
constexpr int kRounds = 4;

using base::at;

double thicknessAt(const std::vector<Patch>& patches, const StackQuery::Place& place) {
  const Patch& p = patches[at(place.patch)];
  const auto& t = p.surface.triangles[at(place.triangle)];
  return (p.thicknessMm[at(t[0])] + p.thicknessMm[at(t[1])] + p.thicknessMm[at(t[2])]) / 3.0;
}

// The target of a vertex: its height and the displacement of its foot along the direction.
struct Aim {
  double heightMm = 0.0, liftMm = 0.0;
};

// The part's surface above a point of a patch.
struct Over {
  double farMm = 0.0; // along the direction
  double share = 1.0; // 1 if it is parallel to the layers, 0 if it is too steep
};

class Follower {
public:
  Follower(LevelSurface& s, const PartBoundary& part, const TopOptions& options)
      : s_(s), part_(part), options_(options) {
    inwards_.assign(s_.surface.vertices.size(), Eigen::Vector3d::Zero());
    for (std::size_t v = 0; v < s_.surface.vertices.size(); ++v)
      over_.push_back(overVertex(static_cast<int>(v)));
    if (any())
      markBoundary();
  }

  bool any() const {
    return std::any_of(over_.begin(), over_.end(), [](const auto& o) { return o.has_value(); });
  }
  // Returns a box around the region between the surface above the vertices and the patch below
  // them.
  Eigen::AlignedBox3d box() const {
    Eigen::AlignedBox3d box;
    for (std::size_t v = 0; v < over_.size(); ++v)
      if (over_[v]) {
        box.extend(s_.surface.vertices[v] - options_.heightMaxMm * s_.direction[v]);
        box.extend(s_.surface.vertices[v] + over_[v]->farMm * s_.direction[v]);
      }
    return box;
  }

  // `own`: the index of this patch in `patches`; `near`: those that intersect the box.
  void run(const std::vector<Patch>& patches, const StackQuery& query, int own,
           const std::vector<int>& near) {
    patches_ = &patches;
    query_ = &query;
    const auto middle = std::lower_bound(near.begin(), near.end(), own);
    earlier_.assign(near.begin(), middle);
    later_.assign(std::upper_bound(middle, near.end(), own), near.end());
    for (std::size_t v = 0; v < over_.size(); ++v)
      aim_.push_back(aimOf(static_cast<int>(v)));
    for (int round = 0; round < kRounds && split(); ++round) {
    }
    for (std::size_t v = 0; v < aim_.size(); ++v) {
      move(v, aim_[v].liftMm + 0.5 * (aim_[v].heightMm - s_.thicknessMm[v]));
      s_.thicknessMm[v] = aim_[v].heightMm;
    }
  }

private:
  const Eigen::Vector3d& point(int v) const { return s_.surface.vertices[at(v)]; }
  // The point that represents a vertex in queries: moved off walls and rims, which a line could
  // miss.
  Eigen::Vector3d place(int v) const { return point(v) + inwards_[at(v)]; }

  void move(std::size_t v, double up) {
    Eigen::Vector3d& x = s_.surface.vertices[v];
    if (isFixed_[v] || up == 0.0)
      return;
    // Vertices at a wall move up along the wall.
    const bool isAtWall = isBoundary_[v] && part_.query().closest(x, kOnSurface).triangle >= 0;
    x += up * s_.direction[v];
    if (!isAtWall)
      return;
    const auto wall = part_.query().closest(x, std::abs(up));
    if (wall.triangle >= 0)
      x = wall.point;
  }

  std::optional<Over> overVertex(int v) {
    const double half = 0.5 * s_.thicknessMm[at(v)];
    const Eigen::Vector3d& d = s_.direction[at(v)];
    const double before = kStartShare * half, reach = 2.0 * options_.heightMaxMm;
    const Eigen::Vector3d from = place(v) - before * d, to = place(v) + reach * d;
    if (!part_.mayCross(from, to))
      return std::nullopt;
    part_.crossings(from, to, 0.0, found_);
    for (const PartBoundary::Crossing& c : found_) {
      if (c.entering)
        continue;
      const double along = part_.normal(c.triangle).dot(d);
      if (along <= kLateral)
        return std::nullopt;
      return Over{std::max(0.0, c.t * (before + reach) - before),
                  std::min(1.0, (along - kLateral) / (kAlong - kLateral))};
    }
    return std::nullopt;
  }

  Aim aimOf(int v) {
    const double own = s_.thicknessMm[at(v)];
    const std::optional<Over>& over = over_[at(v)];
    Aim aim{own, 0.0};
    if (!over)
      return aim;
    const Eigen::Vector3d& d = s_.direction[at(v)];
    hits_.clear();
    if (over->farMm > kOnSurface)
      query_->hits(later_, place(v), place(v) + (over->farMm + kOnSurface) * d, hits_);
    const double maximum = std::max(options_.heightMaxMm, own),
                 minimum = std::min(options_.heightMinMm, own);
    const bool isLast = hits_.empty();
    if (!isLast && (hits_.size() > 1 || own >= maximum))
      return aim;
    // The last patch gets its height to the surface; the patch below takes the excess.
    const double last = isLast ? own : thicknessAt(*patches_, hits_.front());
    const double wanted =
        isLast ? 0.5 * own + over->farMm : over->farMm - hits_.front().distance + 0.5 * last;
    const double excess = wanted - options_.heightMaxMm;
    // A larger excess is not caused by the top: there should have been another level.
    if (excess > 0.5 * last)
      return aim;
    if (!isLast) {
      aim.heightMm = own + over->share * std::clamp(excess, 0.0, maximum - own);
      return aim;
    }
    aim.heightMm = own + over->share * (std::clamp(wanted, minimum, maximum) - own);
    if (excess > 0.0) {
      query_->hits(earlier_, place(v), place(v) - options_.heightMaxMm * d, hits_);
      if (!hits_.empty())
        aim.liftMm =
            over->share *
            std::clamp(options_.heightMaxMm - thicknessAt(*patches_, hits_.front()), 0.0, excess);
    }
    return aim;
  }

  void markBoundary() {
    isBoundary_.assign(s_.surface.vertices.size(), 0);
    isFixed_ = isBoundary_;
    boundary_.clear();
    const auto edges = geometry::sortedHalfEdges(s_.surface);
    geometry::forEachEdge(edges, [&](std::size_t b, std::size_t e) {
      if (e - b != 1)
        return;
      const int low = edges[b].low, high = edges[b].high;
      boundary_.push_back(key(low, high));
      const auto& t = s_.surface.triangles[at(edges[b].triangle)];
      const Eigen::Vector3d inwards =
          (point(t[0]) + point(t[1]) + point(t[2])) / 3.0 - 0.5 * (point(low) + point(high));
      for (int v : {low, high}) {
        isBoundary_[at(v)] = 1;
        inwards_[at(v)] += inwards;
      }
    });
    for (std::size_t v = 0; v < over_.size(); ++v) {
      if (!isBoundary_[v])
        continue;
      inwards_[v] = kInwards * inwards_[v].stableNormalized();
      over_[v] = overVertex(static_cast<int>(v));
      isFixed_[v] = !over_[v] || over_[v]->farMm <= kOnSurface;
    }
  }

  static std::uint64_t key(int a, int b) {
    return static_cast<std::uint64_t>(std::min(a, b)) << 32 |
           static_cast<std::uint64_t>(std::max(a, b));
  }

  // Splits edges along which heights deviate from linear interpolation; returns false if there are
  // none.
  bool split() {
    std::unordered_map<std::uint64_t, int> middleOf; // -1: not split
    bool any = false;
    for (std::size_t t = 0; t < s_.surface.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        const int a = s_.surface.triangles[t][k], b = s_.surface.triangles[t][(k + 1) % 3];
        if ((!over_[at(a)] && !over_[at(b)]) ||
            (point(a) - point(b)).norm() < 2.0 * options_.fineMm)
          continue;
        const auto [entry, isNew] = middleOf.try_emplace(key(a, b), -1);
        if (!isNew || std::binary_search(boundary_.begin(), boundary_.end(), key(a, b)))
          continue;
        const int middle = appendBlend(s_, std::min(a, b), std::max(a, b), 0.5);
        inwards_.push_back(Eigen::Vector3d::Zero());
        over_.push_back(overVertex(middle));
        const Aim aim = aimOf(middle);
        const Aim &one = aim_[at(a)], &other = aim_[at(b)];
        if (std::abs(aim.heightMm - 0.5 * (one.heightMm + other.heightMm)) <= kOff) {
          dropLast();
          continue;
        }
        aim_.push_back(aim);
        isBoundary_.push_back(0);
        isFixed_.push_back(0);
        entry->second = middle;
        any = true;
      }
    if (!any)
      return false;
    std::vector<std::array<int, 3>> whole;
    for (const auto& t : s_.surface.triangles) {
      std::array<int, 3> m;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto found = middleOf.find(key(t[k], t[(k + 1) % 3]));
        m[k] = found == middleOf.end() ? -1 : found->second;
      }
      appendSplit(t, m, whole);
    }
    s_.surface.triangles.swap(whole);
    return true;
  }

  void dropLast() {
    s_.surface.vertices.pop_back();
    s_.thicknessMm.pop_back();
    s_.direction.pop_back();
    s_.clearDirection.pop_back();
    if (!s_.innerRim.empty())
      s_.innerRim.pop_back();
    if (!s_.chart.empty())
      s_.chart.at.pop_back();
    inwards_.pop_back();
    over_.pop_back();
  }

  // `middle`: midpoints of sides (0,1), (1,2), (2,0); -1 for sides that are not split.
  void appendSplit(const std::array<int, 3>& t, const std::array<int, 3>& middle,
                   std::vector<std::array<int, 3>>& out) const {
    const int count = (middle[0] >= 0) + (middle[1] >= 0) + (middle[2] >= 0);
    if (count == 0) {
      out.push_back(t);
      return;
    }
    if (count == 3) {
      for (std::size_t k = 0; k < 3; ++k)
        out.push_back({t[k], middle[k], middle[(k + 2) % 3]});
      out.push_back(middle);
      return;
    }
    // Rotated so that a single midpoint is on (a, b), and with two midpoints (a, b) is not split.
    std::size_t k = 0;
    while ((middle[k] >= 0) != (count == 1))
      ++k;
    const int a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
    if (count == 1) {
      out.push_back({a, middle[k], c});
      out.push_back({middle[k], b, c});
      return;
    }
    const int bc = middle[(k + 1) % 3], ca = middle[(k + 2) % 3];
    out.push_back({ca, bc, c});
    if ((point(a) - point(bc)).squaredNorm() < (point(b) - point(ca)).squaredNorm()) {
      out.push_back({a, b, bc});
      out.push_back({a, bc, ca});
    } else {
      out.push_back({a, b, ca});
      out.push_back({b, bc, ca});
    }
  }

  LevelSurface& s_;
  const PartBoundary& part_;
  TopOptions options_;
  std::vector<std::optional<Over>> over_; // per vertex
  std::vector<Eigen::Vector3d> inwards_;  // per vertex, zero except at the boundary
  const std::vector<Patch>* patches_ = nullptr;
  const StackQuery* query_ = nullptr;
  std::vector<int> earlier_, later_;               // patches nearby
  std::vector<Aim> aim_;                           // per vertex
  std::vector<std::uint8_t> isBoundary_, isFixed_; // per vertex
  std::vector<std::uint64_t> boundary_;            // edges, sorted
  std::vector<PartBoundary::Crossing> found_;
  std::vector<StackQuery::Place> hits_;
};

} // namespace

void followTop(LayerStack& stack, const PartBoundary& part, const TopOptions& options,
               const base::RunContext& ctx) {
  const std::size_t n = stack.patches.size();
  struct Followed {
    LevelSurface surface;
    std::optional<Follower> follower;
  };
  std::vector<std::unique_ptr<Followed>> followed(n); // null if no top is near
  base::parallelChunks(ctx, n, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      if (stack.patches[p].group == kSupportGroup)
        continue;
      auto one = std::make_unique<Followed>();
      one->surface = surfaceOf(stack.patches[p]);
      if (one->follower.emplace(one->surface, part, options).any())
        followed[p] = std::move(one);
    }
  });
  std::vector<Eigen::AlignedBox3d> around;
  for (const auto& one : followed)
    if (one != nullptr)
      around.push_back(one->follower->box());
  const StackQuery query(stack.patches, around, 0.0, ctx);
  // All patches use the unmodified others.
  base::parallelChunks(ctx, n, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p)
      if (followed[p] != nullptr)
        followed[p]->follower->run(
            stack.patches, query, static_cast<int>(p),
            query.near(followed[p]->follower->box(), 0, static_cast<int>(n)));
  });
  for (std::size_t p = 0; p < n; ++p) {
    if (followed[p] == nullptr)
      continue;
    setSurface(stack.patches[p], std::move(followed[p]->surface));
  }
}

} // namespace voluta::layers
