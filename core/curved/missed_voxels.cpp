#include "curved/missed_voxels.h"

#include "curved/flood.h"
#include "curved/voxel_graph.h"

#include <algorithm>
#include <string>

namespace voluta::curved {

namespace {

struct Group {
  std::vector<std::int32_t> voxels;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero(); // of the member nearest to the mean
  bool shadowed = false;
};

std::vector<Group> missedGroups(const VoxelGraph& graph, const std::vector<std::int32_t>& rank,
                                const std::vector<std::int32_t>& reachedOrder) {
  const auto cellOf = [&](std::size_t v) {
    return graph.grid.index(graph.cell[v][0], graph.cell[v][1], graph.cell[v][2]);
  };
  std::vector<std::uint8_t> seen(graph.size(), 0);
  std::vector<Group> groups;
  for (std::size_t first = 0; first < graph.size(); ++first) {
    if (seen[first] || rank[cellOf(first)] >= 0)
      continue;
    Group group;
    group.shadowed = reachedOrder[first] >= 0;
    group.voxels.push_back(static_cast<std::int32_t>(first));
    seen[first] = 1;
    for (std::size_t i = 0; i < group.voxels.size(); ++i)
      for (const std::int32_t w : graph.neighbour[static_cast<std::size_t>(group.voxels[i])])
        if (w >= 0 && !seen[static_cast<std::size_t>(w)] &&
            rank[cellOf(static_cast<std::size_t>(w))] < 0) {
          seen[static_cast<std::size_t>(w)] = 1;
          group.voxels.push_back(w);
        }
    const auto centreOf = [&](std::int32_t v) {
      const auto& c = graph.cell[static_cast<std::size_t>(v)];
      return graph.grid.centre(c[0], c[1], c[2]);
    };
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const std::int32_t v : group.voxels)
      mean += centreOf(v);
    mean /= static_cast<double>(group.voxels.size());
    group.centre = centreOf(group.voxels[0]);
    for (const std::int32_t v : group.voxels)
      if ((centreOf(v) - mean).squaredNorm() < (group.centre - mean).squaredNorm())
        group.centre = centreOf(v);
    groups.push_back(std::move(group));
  }
  std::stable_sort(groups.begin(), groups.end(), [](const Group& a, const Group& b) {
    return a.voxels.size() > b.voxels.size();
  });
  return groups;
}

plan::Finding findingOf(const Group& group) {
  plan::Finding finding;
  finding.stage = "decompose";
  finding.where = group.centre;
  finding.count = group.voxels.size();
  const std::string many =
      std::to_string(finding.count) + (finding.count == 1 ? " voxel is " : " voxels are ");
  if (group.shadowed) {
    finding.kind = "shadowedVoxels";
    finding.reason = many + "shadowed: inside the front before it was reached";
    finding.remedy = "turn the part, change the platform's size or allow supports";
  } else {
    finding.kind = "unreachedVoxels";
    finding.reason = many + "unreached: no path through the part from the platform";
    finding.remedy = "a larger platform, supports, or join this piece to the part";
  }
  return finding;
}

} // namespace

void describeMissed(const voxel::SolidVoxels& voxels, Decomposition& decomposition,
                    const base::RunContext& ctx) {
  // From below the plate too: what lies there is missed as well.
  const VoxelGraph graph =
      voxelGraph(voxels.grid, voxels.solid, voxels.plateLayer(), decomposition.platform);
  const std::vector<std::int32_t> reached = flood(graph, {}, {}, 1.0f, ctx).order;
  const std::vector<Group> groups = missedGroups(graph, decomposition.rank, reached);
  decomposition.shadowedVoxels = decomposition.unreachedVoxels = 0;
  for (const Group& g : groups)
    (g.shadowed ? decomposition.shadowedVoxels : decomposition.unreachedVoxels) += g.voxels.size();
  const std::size_t belowPlate = voxels.count - graph.size();
  decomposition.unreachedVoxels += belowPlate;
  decomposition.missedVoxels = decomposition.shadowedVoxels + decomposition.unreachedVoxels;

  constexpr std::size_t kTold = 20;
  for (std::size_t g = 0; g < std::min(kTold, groups.size()); ++g)
    decomposition.findings.push_back(findingOf(groups[g]));
  if (groups.size() > kTold) {
    plan::Finding rest = findingOf(groups[kTold]);
    rest.kind = "missedVoxels";
    rest.count = 0;
    for (std::size_t g = kTold; g < groups.size(); ++g)
      rest.count += groups[g].voxels.size();
    rest.reason = std::to_string(rest.count) + " more voxels are missed in " +
                  std::to_string(groups.size() - kTold) + " smaller groups; this is the largest";
    decomposition.findings.push_back(rest);
  }
  if (belowPlate > 0) {
    plan::Finding below;
    below.stage = "decompose";
    below.kind = "unreachedVoxels";
    below.count = belowPlate;
    below.reason = std::to_string(belowPlate) + " voxels lie below the plate";
    below.remedy = "drop the part to the plate";
    decomposition.findings.push_back(below);
  }
}

} // namespace voluta::curved
