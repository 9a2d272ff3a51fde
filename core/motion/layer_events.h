// The places of layer events in the tool-paths, and their events in the trajectory.
#pragma once

#include "plan/layer_event.h"
#include "plan/trajectory.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace voluta::plan {
struct ToolPlan;
}

namespace voluta::motion {

struct EventPlace {
  std::size_t path = 0;               // before this path of the plan
  std::size_t event = 0;              // index of the event
  std::vector<std::size_t> also = {}; // further pauses at the same stop
  int layer = 0, layers = 0; // of the item: the layer's number from 1, and how many there are
  double heightMm = 0.0;     // of the nozzle where the path begins
};

// Returns the places of the events, ascending by path; of a path in the order of the events. Pauses
// that follow each other at a path are one stop if its text has room for theirs. Events of layers,
// heights and beads that an item does not have are left out. Layers of an item are those
// in which it has beads; those of a plan with one item are counted as the plan counts them.
std::vector<EventPlace> eventPlaces(const plan::ToolPlan& plan,
                                    const std::vector<plan::LayerEvent>& events);

// Returns the number of layers of an item, as eventPlaces() counts them.
int layersOfItem(const plan::ToolPlan& plan, int item);

// Returns the item that begins a layer of the plan, counted from 0, and the layer's number there;
// nullopt if the plan has no beads in it.
struct LayerOfItem {
  int item = 0, layer = 1;
};
std::optional<LayerOfItem> layerOfItem(const plan::ToolPlan& plan, int layer);
// Returns each item that has beads in that layer, in the order of printing, with its own number.
std::vector<LayerOfItem> itemsInLayer(const plan::ToolPlan& plan, int layer);

// Returns whether the arm waits beside the part for it.
bool waitsAside(plan::LayerEventKind kind);

// Returns the trajectory's events of a place, at point 0: one, of a photo three. The text of a
// pause names its layer and the height. Precondition: the event is no change of the tool.
std::vector<plan::TrajectoryEvent> trajectoryEvents(const plan::ToolPlan& plan,
                                                    const std::vector<plan::LayerEvent>& events,
                                                    const EventPlace& place);
// A stop's text has at most this many characters (program/job_head.h).
inline constexpr std::size_t kStopTextLength = 80;

} // namespace voluta::motion
