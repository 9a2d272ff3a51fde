#include "toolpath/order/assemble.h"

#include "base/error.h"
#include "process/bead_model.h"
#include "toolpath/order/island_order.h"
#include "toolpath/order/place_seams.h"
#include "toolpath/order/print_turn.h"
#include "toolpath/order/seam.h"
#include "toolpath/order/tool_order.h"
#include "toolpath/order/travel.h"
#include "toolpath/unsupported/bead_tip.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>

namespace voluta::toolpath {

namespace {
using Eigen::Vector3d;
using plan::PathKind;

struct PlacedBead {
  std::size_t patch = 0;
  const Bead* bead = nullptr;
};

// Beads of one tool and one turn of a patch.
struct ToolGroup {
  int tool = 0;
  StopGroup stops;
};

// The beads of all patches as stops of the head, by index.
struct BeadStops {
  std::vector<PlacedBead> beads;
  std::vector<Stop> stops;
  std::vector<std::vector<ToolGroup>> groupsOfPatch;

  // The tools of these patches, ascending, each once.
  std::vector<int> toolsOf(std::span<const std::size_t> patches) const {
    std::set<int> tools;
    for (const std::size_t patch : patches)
      for (const ToolGroup& toolGroup : groupsOfPatch[patch])
        tools.insert(toolGroup.tool);
    return {tools.begin(), tools.end()};
  }

  // The turns of these patches in that order; within a layer, tool after tool, so that the fewest
  // changes are needed. Beads of one layer do not support each other.
  std::vector<StopGroup> turnsOf(const layers::LayerStack& stack,
                                 const std::vector<std::size_t>& patches) const {
    const auto isOtherLayer = [&](std::size_t a, std::size_t b) {
      return stack.patches[a].layer != stack.patches[b].layer;
    };
    std::vector<std::span<const std::size_t>> layers;
    std::vector<std::vector<int>> tools;
    for (auto begin = patches.begin(); begin != patches.end();) {
      auto end = std::adjacent_find(begin, patches.end(), isOtherLayer);
      end = end == patches.end() ? end : end + 1;
      tools.push_back(toolsOf(layers.emplace_back(begin, end)));
      begin = end;
    }
    const std::vector<std::vector<int>> order = toolOrder(tools);
    std::vector<StopGroup> groups;
    for (std::size_t l = 0; l < layers.size(); ++l)
      for (const int tool : order[l])
        for (const std::size_t patch : layers[l])
          for (const ToolGroup& toolGroup : groupsOfPatch[patch])
            if (toolGroup.tool == tool)
              groups.push_back(toolGroup.stops);
    return groups;
  }
};

// The points at which the bead may begin, see Stop.
Stop stopOf(const Bead& bead, bool beginsAtSeam) {
  Stop stop;
  stop.closed = bead.closed;
  if (!bead.closed)
    stop.ends = {tipOf(bead.points.front()), tipOf(bead.points.back())};
  else if (beginsAtSeam)
    stop.ends = {tipOf(bead.points.front())};
  else
    for (std::size_t k = 0; k + 1 < bead.points.size(); ++k)
      stop.ends.push_back(tipOf(bead.points[k]));
  return stop;
}

int toolOf(const layers::Patch& patch, const Bead& bead) {
  return bead.tool < 0 ? patch.tool : bead.tool;
}

BeadStops beadStops(const layers::LayerStack& stack, const std::vector<PatchCover>& covers,
                    const std::vector<std::vector<std::optional<Bead>>>& atSeams) {
  BeadStops out;
  for (std::size_t i = 0; i < covers.size(); ++i) {
    std::map<std::pair<int, int>, StopGroup> groups; // by turn and tool
    for (std::size_t k = 0; k < covers[i].beads.size(); ++k) {
      const std::optional<Bead>& atSeam = atSeams[i][k];
      const Bead& bead = atSeam ? *atSeam : covers[i].beads[k];
      groups[{printOrder(bead), toolOf(stack.patches[i], bead)}].push_back(out.stops.size());
      out.stops.push_back(stopOf(bead, atSeam.has_value()));
      out.beads.push_back({i, &bead});
    }
    std::vector<ToolGroup>& ofPatch = out.groupsOfPatch.emplace_back();
    for (auto& [toolGroup, stops] : groups)
      ofPatch.push_back({toolGroup.second, std::move(stops)});
  }
  return out;
}

std::vector<Visit> shortestVisits(const layers::LayerStack& stack, const BeadStops& beads,
                                  const OrderOptions& options) {
  if (options.keepIslandOrder)
    return visitShortly(beads.stops, beads.turnsOf(stack, orderAsBelow(stack)), Vector3d::Zero());
  std::vector<std::size_t> inOrder(stack.patches.size());
  for (std::size_t i = 0; i < inOrder.size(); ++i)
    inOrder[i] = i;
  std::vector<Visit> shortest =
      visitShortly(beads.stops, beads.turnsOf(stack, inOrder), Vector3d::Zero());
  if (!options.orderIslands)
    return shortest;
  double minMm = travelMm(beads.stops, shortest);
  for (const std::vector<std::size_t>& order : islandOrders(stack)) {
    std::vector<Visit> visits =
        visitShortly(beads.stops, beads.turnsOf(stack, order), Vector3d::Zero());
    if (const double mm = travelMm(beads.stops, visits); mm < minMm) {
      minMm = mm;
      shortest = std::move(visits);
    }
  }
  return shortest;
}

// Returns the bead's points from the one at which the visit begins.
std::vector<BeadPoint> pointsFrom(const Bead& bead, std::size_t begin) {
  std::vector<BeadPoint> points = bead.points;
  if (begin == 0)
    return points;
  if (bead.closed) {
    points.pop_back();
    std::ranges::rotate(points, points.begin() + static_cast<std::ptrdiff_t>(begin));
    points.push_back(points.front());
  } else {
    std::ranges::reverse(points);
  }
  return points;
}

void append(Assembled& out, const std::vector<BeadPoint>& points, const process::Process& process) {
  double last = 0.0; // section
  for (const BeadPoint& p : points) {
    const double own = process::beadArea(p.widthMm, p.heightMm);
    // While the section decreases the extruder delivers more than at the end point.
    const double section = std::max(own, std::exchange(last, own));
    out.plan.position.push_back(tipOf(p));
    out.plan.direction.push_back(p.direction);
    out.plan.widthMm.push_back(static_cast<float>(p.widthMm));
    out.plan.heightMm.push_back(static_cast<float>(p.heightMm));
    out.plan.speedMmPerS.push_back(
        static_cast<float>(std::min(process.speedMmPerS, process::flowLimit(process) / section)));
    out.clearDirection.push_back(p.clearDirection);
  }
}
} // namespace

Assembled assemble(const layers::LayerStack& stack, const std::vector<PatchCover>& covers,
                   const process::Tooling& tooling, const OrderOptions& options) {
  base::require(covers.size() == stack.patches.size(), "one cover a patch");
  const auto atSeams = placeSeams(stack, covers, seamKind(options.seam), options.seamsOfRegions);
  const BeadStops beads = beadStops(stack, covers, atSeams);
  const std::vector<Visit> visits = shortestVisits(stack, beads, options);
  Assembled out;
  out.travelMm = travelMm(beads.stops, visits);
  for (const Visit& visit : visits) {
    const auto& [index, bead] = beads.beads[visit.stop];
    const layers::Patch& patch = stack.patches[index];
    const std::vector<BeadPoint> points = pointsFrom(*bead, visit.begin);
    plan::ToolPath path;
    path.first = out.plan.waypointCount();
    path.count = points.size();
    path.kind = patch.group == layers::kSupportGroup ? PathKind::Support : bead->kind;
    path.layer = patch.layer;
    path.patch = static_cast<int>(index);
    path.group = patch.group;
    path.closed = bead->closed;
    path.item = patch.item;
    path.tool = toolOf(patch, *bead);
    path.ring = bead->ring;
    append(out, points, tooling.at(path.tool).process);
    out.plan.paths.push_back(path);
  }
  return out;
}

} // namespace voluta::toolpath
