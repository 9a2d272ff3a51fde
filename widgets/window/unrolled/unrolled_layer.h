// One layer laid flat by its chart, as lines to draw.
#pragma once

#include "base/run_context.h"
#include "layers/layer_stack.h"
#include "plan/tool_plan.h"

#include <QLineF>
#include <QPointF>
#include <QRectF>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace voluta::window {

// (u, v) in mm, u around and v along (layers::Chart); of a layer that closes, u lies within half a
// period of 0, and what crosses the seam goes on at the other side.
struct UnrolledLayer {
  int layer = 0;
  double periodMm = 0.0; // 0: does not close
  QRectF area;           // a whole period, or what there is of it
  std::vector<QLineF> outline;

  // Points [first, first + count) of one path between two seams.
  struct Stretch {
    std::size_t first = 0, count = 0;
    std::size_t path = 0; // index in the ToolPlan
    plan::PathKind kind = plan::PathKind::Wall;
  };
  std::vector<Stretch> stretches; // in print order
  std::vector<QPointF> points;
  std::vector<std::size_t> waypoint; // of each point: the one that the nozzle is on its way to
  std::vector<float> widthMm;        // of the bead at each point
};

// Has a patch of the layer a chart, of any layer where none is given?
bool hasChart(const layers::LayerStack& stack, std::optional<int> layer = {});

// `plan` may be null: outlines alone. Patches without a chart, and their paths, are left out; a
// waypoint lies where the patch is nearest to it. Same result for any number of threads.
std::shared_ptr<const UnrolledLayer> unrolledLayer(const layers::LayerStack& stack,
                                                   const plan::ToolPlan* plan, int layer,
                                                   const base::RunContext& ctx);

// The waypoint that the path's nearest segment leads to, and how far that is from `place`; none
// within `reachMm`. Periods apart counts as the same place.
struct UnrolledHit {
  std::size_t path = 0, waypoint = 0;
  plan::PathKind kind = plan::PathKind::Wall;
  double distanceMm = 0.0;
};
std::optional<UnrolledHit> nearestPath(const UnrolledLayer& layer, const QPointF& place,
                                       double reachMm);
// Where the waypoint lies; none: not in this layer.
std::optional<QPointF> placeOf(const UnrolledLayer& layer, std::size_t waypoint);

} // namespace voluta::window
