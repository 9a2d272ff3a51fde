#include "toolpath/order/assemble.h"

#include "base/error.h"
#include "process/bead_model.h"
#include "toolpath/order/islands.h"
#include "toolpath/order/place_seams.h"
#include "toolpath/order/print_turn.h"
#include "toolpath/order/seam.h"
#include "toolpath/order/travel.h"
#include "toolpath/unsupported/bead_tip.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

namespace voluta::toolpath {

namespace {
using Eigen::Vector3d;
using plan::PathKind;

struct PlacedBead {
  std::size_t patch = 0;
  const Bead* bead = nullptr;
};

// The beads of all patches as stops of the head, by index.
struct BeadStops {
  std::vector<PlacedBead> beads;
  std::vector<Stop> stops;
  std::vector<std::vector<StopTurn>> turnsOfPatch;

  std::vector<StopTurn> turnsOf(const std::vector<std::size_t>& patches) const {
    std::vector<StopTurn> turns;
    for (const std::size_t patch : patches)
      turns.insert(turns.end(), turnsOfPatch[patch].begin(), turnsOfPatch[patch].end());
    return turns;
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

BeadStops beadStops(const std::vector<PatchCover>& covers,
                    const std::vector<std::vector<std::optional<Bead>>>& atSeams) {
  BeadStops out;
  for (std::size_t i = 0; i < covers.size(); ++i) {
    std::map<int, StopTurn> turns;
    for (std::size_t k = 0; k < covers[i].beads.size(); ++k) {
      const std::optional<Bead>& atSeam = atSeams[i][k];
      const Bead& bead = atSeam ? *atSeam : covers[i].beads[k];
      turns[printTurn(bead)].push_back(out.stops.size());
      out.stops.push_back(stopOf(bead, atSeam.has_value()));
      out.beads.push_back({i, &bead});
    }
    std::vector<StopTurn>& ofPatch = out.turnsOfPatch.emplace_back();
    for (auto& [turn, stops] : turns)
      ofPatch.push_back(std::move(stops));
  }
  return out;
}

std::vector<Visit> shortestVisits(const layers::LayerStack& stack, const BeadStops& beads,
                                  const OrderOptions& options) {
  if (options.keepIslandOrder)
    return visitShortly(beads.stops, beads.turnsOf(orderAsBelow(stack)), Vector3d::Zero());
  std::vector<std::size_t> inOrder(stack.patches.size());
  for (std::size_t i = 0; i < inOrder.size(); ++i)
    inOrder[i] = i;
  std::vector<Visit> shortest = visitShortly(beads.stops, beads.turnsOf(inOrder), Vector3d::Zero());
  if (!options.orderIslands)
    return shortest;
  double leastMm = travelMm(beads.stops, shortest);
  for (const std::vector<std::size_t>& order : islandOrders(stack)) {
    std::vector<Visit> visits = visitShortly(beads.stops, beads.turnsOf(order), Vector3d::Zero());
    if (const double mm = travelMm(beads.stops, visits); mm < leastMm) {
      leastMm = mm;
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
  const auto atSeams = placeSeams(stack, covers, seamKind(options.seam));
  const BeadStops beads = beadStops(covers, atSeams);
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
    path.tool = patch.tool;
    path.ring = bead->ring;
    append(out, points, tooling.at(patch.tool).process);
    out.plan.paths.push_back(path);
  }
  return out;
}

} // namespace voluta::toolpath
