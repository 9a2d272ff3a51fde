// One layer unrolled by its chart, as lines to draw.
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

// (u, v) in mm, u around and v along (layers::Chart). In a closed layer, u is within half a period
// of 0, and lines that cross the seam continue at the other side.
struct UnrolledLayer {
  int layer = 0;
  double periodMm = 0.0; // 0: not closed
  QRectF area;           // A whole period, or the extent of the layer
  std::vector<QLineF> outline;

  // Points [first, first + count) of one path between two seams.
  struct Stretch {
    std::size_t first = 0, count = 0;
    std::size_t path = 0; // Index in the ToolPlan
    plan::PathKind kind = plan::PathKind::Wall;
  };
  std::vector<Stretch> stretches; // In print order
  std::vector<QPointF> points;
  std::vector<std::size_t> waypoint; // Per point: the waypoint that the nozzle is moving to
  std::vector<float> widthMm;        // Width of the bead at each point
};

// Returns whether a patch of the layer (or of any layer, if none is given) has a chart.
bool hasChart(const layers::LayerStack& stack, std::optional<int> layer = {});

// `plan` may be nullptr: outlines only. Patches without a chart, and their paths, are omitted. A
// waypoint is placed at the nearest point of its patch. The result is independent of the number of
// threads.
std::shared_ptr<const UnrolledLayer> unrolledLayer(const layers::LayerStack& stack,
                                                   const plan::ToolPlan* plan, int layer,
                                                   const base::RunContext& ctx);

// The end waypoint of the nearest path segment, and its distance from `place`; nullopt if it is not
// within `reachMm`. Places that differ by whole periods are the same.
struct UnrolledHit {
  std::size_t path = 0, waypoint = 0;
  plan::PathKind kind = plan::PathKind::Wall;
  double distanceMm = 0.0;
};
std::optional<UnrolledHit> nearestPath(const UnrolledLayer& layer, const QPointF& place,
                                       double reachMm);
// Returns the position of the waypoint; nullopt if it is not in this layer.
std::optional<QPointF> placeOf(const UnrolledLayer& layer, std::size_t waypoint);

} // namespace voluta::window
