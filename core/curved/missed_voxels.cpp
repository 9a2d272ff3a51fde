#include "curved/missed_voxels.h"

#include "curved/convex_front.h"
#include "curved/flood.h"
#include "curved/voxel_graph.h"
#include "plan/finding_kinds.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <string>

namespace voluta::curved {

namespace {

struct Group {
  std::vector<std::int32_t> voxels;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero(); // Centre of the member nearest to the mean
  Loss loss = Loss::Unreached;                      // Loss of the first member
  std::size_t cascade = 0;
  std::int32_t root = -1; // The shadowed member that could have been printed first
  std::int32_t rootRank = 0;
  std::int32_t coveredAt = 0; // Rank after which the front covers the root, 0: not found
  std::array<Eigen::Vector3d, 3> cover{
      Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(),
      Eigen::Vector3d::Zero()}; // Corners of the facet over it then [mm]
};

class Missed {
public:
  Missed(const VoxelGraph& graph, Decomposition& decomposition, const base::RunContext& ctx)
      : graph_(graph), d_(decomposition), ctx_(ctx) {}

  std::vector<Group> groups() {
    markLoss();
    gather();
    findCovers();
    return std::move(groups_);
  }

private:
  std::int32_t rank(std::size_t v) const { return d_.rank[graph_.cellOf(v)]; }
  Eigen::Vector3d centreOf(std::int32_t v) const {
    const auto& c = graph_.cell[static_cast<std::size_t>(v)];
    return graph_.grid.centre(c[0], c[1], c[2]);
  }

  // Returns the lowest rank after which v could have been supported; 0: never.
  std::int32_t supportedFrom(std::size_t v) const {
    if (graph_.onPlatform[v])
      return 1;
    std::int32_t minimum = 0;
    for (const std::int32_t w : graph_.neighbour[v])
      if (w >= 0 && rank(static_cast<std::size_t>(w)) > 0 &&
          (minimum == 0 || rank(static_cast<std::size_t>(w)) < minimum))
        minimum = rank(static_cast<std::size_t>(w));
    return minimum;
  }

  void markLoss() {
    const std::vector<std::int32_t> reached = flood(graph_, {}, ctx_).order;
    for (std::size_t v = 0; v < graph_.size(); ++v)
      if (rank(v) < 0)
        d_.loss[graph_.cellOf(v)] = reached[v] < 0         ? Loss::Unreached
                                    : supportedFrom(v) > 0 ? Loss::Shadowed
                                                           : Loss::Cascade;
  }

  void gather() {
    std::vector<std::uint8_t> seen(graph_.size(), 0);
    for (std::size_t first = 0; first < graph_.size(); ++first) {
      if (seen[first] || rank(first) >= 0)
        continue;
      Group group;
      group.voxels.push_back(static_cast<std::int32_t>(first));
      seen[first] = 1;
      for (std::size_t i = 0; i < group.voxels.size(); ++i)
        for (const std::int32_t w : graph_.neighbour[static_cast<std::size_t>(group.voxels[i])])
          if (w >= 0 && !seen[static_cast<std::size_t>(w)] &&
              rank(static_cast<std::size_t>(w)) < 0) {
            seen[static_cast<std::size_t>(w)] = 1;
            group.voxels.push_back(w);
          }
      describe(group);
      groups_.push_back(std::move(group));
    }
    std::stable_sort(groups_.begin(), groups_.end(), [](const Group& a, const Group& b) {
      return a.voxels.size() > b.voxels.size();
    });
  }

  void describe(Group& group) const {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const std::int32_t v : group.voxels)
      mean += centreOf(v);
    mean /= static_cast<double>(group.voxels.size());
    group.centre = centreOf(group.voxels[0]);
    for (const std::int32_t v : group.voxels) {
      const auto x = static_cast<std::size_t>(v);
      if ((centreOf(v) - mean).squaredNorm() < (group.centre - mean).squaredNorm())
        group.centre = centreOf(v);
      const Loss loss = d_.loss[graph_.cellOf(x)];
      group.cascade += loss == Loss::Cascade;
      if (loss != Loss::Shadowed)
        continue;
      group.loss = Loss::Shadowed;
      const std::int32_t from = supportedFrom(x);
      if (group.root < 0 || from < group.rootRank) {
        group.root = v;
        group.rootRank = from;
      }
    }
  }

  // Repeats the growth and checks after each rank which roots the front now covers.
  void findCovers() {
    constexpr std::size_t kMax = 20;
    const std::size_t examined = std::min(kMax, groups_.size());
    if (std::none_of(groups_.begin(), groups_.begin() + static_cast<std::ptrdiff_t>(examined),
                     [](const Group& g) { return g.root >= 0; }))
      return;
    std::vector<std::int32_t> order;
    for (std::size_t v = 0; v < graph_.size(); ++v)
      if (rank(v) > 0)
        order.push_back(static_cast<std::int32_t>(v));
    std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
      return rank(static_cast<std::size_t>(a)) < rank(static_cast<std::size_t>(b));
    });
    ConvexFront front(graph_);
    std::size_t hint = 0;
    for (std::size_t i = 0; i < order.size();) {
      ctx_.checkpoint();
      const std::int32_t at = rank(static_cast<std::size_t>(order[i]));
      for (; i < order.size() && rank(static_cast<std::size_t>(order[i])) == at; ++i)
        front.insert(static_cast<std::size_t>(order[i]));
      front.rebuild();
      bool open = false;
      for (std::size_t g = 0; g < examined; ++g) {
        Group& group = groups_[g];
        if (group.root < 0 || group.coveredAt > 0)
          continue;
        const auto root = static_cast<std::size_t>(group.root);
        if (front.deeperThan(root, 0.0, hint)) {
          group.coveredAt = at;
          group.cover = front.facetOver(root);
          for (Eigen::Vector3d& corner : group.cover)
            corner =
                graph_.grid.origin + graph_.grid.pitch * (corner + Eigen::Vector3d::Constant(0.5));
        } else {
          open = true;
        }
      }
      if (!open)
        return;
    }
  }

  const VoxelGraph& graph_;
  Decomposition& d_;
  const base::RunContext& ctx_;
  std::vector<Group> groups_;
};

plan::Finding findingOf(const Group& group) {
  using plan::FindingKind;
  const std::size_t own = group.voxels.size() - group.cascade;
  std::vector<plan::NamedValue> values{{"voxels", own}};
  FindingKind kind = FindingKind::Unreached;
  if (group.loss == Loss::Shadowed) {
    kind = group.coveredAt > 0 ? FindingKind::ShadowedUnderFacet : FindingKind::ShadowedUnreached;
    if (group.coveredAt > 0) {
      values.push_back({"step", group.coveredAt});
      values.push_back({"a", plan::pointOf(group.cover[0])});
      values.push_back({"b", plan::pointOf(group.cover[1])});
      values.push_back({"c", plan::pointOf(group.cover[2])});
    }
    if (group.cascade > 0) {
      values.push_back({"more", group.cascade});
      return plan::makeMoreFinding(kind, std::move(values), group.centre, group.voxels.size());
    }
  }
  return plan::makeFinding(kind, std::move(values), group.centre, group.voxels.size());
}

} // namespace

void describeMissed(const voxel::SolidVoxels& voxels, Decomposition& decomposition,
                    const base::RunContext& ctx) {
  // Voxels below the plate are included, as they are missed as well.
  const VoxelGraph graph =
      voxelGraph(voxels.grid, voxels.solid, voxels.plateLayer(), decomposition.platform);
  decomposition.loss.assign(decomposition.rank.size(), Loss::None);
  const std::vector<Group> groups = Missed(graph, decomposition, ctx).groups();
  decomposition.shadowedVoxels = decomposition.unreachedVoxels = decomposition.cascadeVoxels = 0;
  for (const Group& g : groups) {
    (g.loss == Loss::Shadowed ? decomposition.shadowedVoxels : decomposition.unreachedVoxels) +=
        g.voxels.size();
    decomposition.cascadeVoxels += g.cascade;
  }
  const std::size_t belowPlate = voxels.count - graph.size();
  decomposition.unreachedVoxels += belowPlate;
  decomposition.missedVoxels = decomposition.shadowedVoxels + decomposition.unreachedVoxels;

  constexpr std::size_t kMaxListed = 20;
  for (std::size_t g = 0; g < std::min(kMaxListed, groups.size()); ++g)
    decomposition.findings.push_back(findingOf(groups[g]));
  if (groups.size() > kMaxListed) {
    const Group& largest = groups[kMaxListed];
    std::size_t missed = 0;
    for (std::size_t g = kMaxListed; g < groups.size(); ++g)
      missed += groups[g].voxels.size();
    decomposition.findings.push_back(plan::makeFinding(
        plan::FindingKind::MissedGroups,
        {{"voxels", missed}, {"groups", groups.size() - kMaxListed}}, largest.centre, missed));
  }
  if (belowPlate > 0) {
    for (std::size_t c = 0; c < decomposition.rank.size(); ++c)
      if (voxels.solid[c] && decomposition.rank[c] < 0 && graph.voxelAt[c] < 0)
        decomposition.loss[c] = Loss::Unreached;
    decomposition.findings.push_back(plan::makeFinding(
        plan::FindingKind::BelowPlate, {{"voxels", belowPlate}}, std::nullopt, belowPlate));
  }
}

} // namespace voluta::curved
