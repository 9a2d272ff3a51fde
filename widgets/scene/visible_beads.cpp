#include "scene/visible_beads.h"

#include <algorithm>

namespace voluta::scene {

namespace {

// The layers of a view and the printed range of each.
class Extent {
public:
  Extent(const PathsDrawing& paths, const ViewState& view)
      : first(std::max(0, view.firstLayer)), last(std::min(view.lastLayer, layerCount(paths) - 1)),
        printed_(view.printedWaypoints) {
    const auto& ofLast = waypointsOfLayer(paths, last);
    partial_ = view.moves < ofLast.size();
    if (partial_)
      lastLimit_ = view.moves == 0 ? 0 : ofLast[view.moves - 1] + std::size_t{1};
  }

  int first, last;
  // Returns the index below which waypoints of a layer are shown.
  std::size_t limit(int layer) const {
    return layer == last ? std::min(printed_, lastLimit_) : printed_;
  }
  bool hides(const BeadChunk& chunk) const {
    // Below the first layer shown there is nothing: its inner beads are visible from below.
    const bool openBelow = first > 0 && chunk.layer <= first + 1;
    return !openBelow && chunk.hidingLayer <= (partial_ ? last - 1 : last) &&
           chunk.hidingWaypoint < printed_;
  }

private:
  std::size_t printed_, lastLimit_ = kAllMoves;
  bool partial_ = false;
};

std::size_t shownUpTo(const std::vector<std::uint32_t>& arrival, std::size_t from, std::size_t to,
                      std::size_t limit) {
  const auto begin = arrival.begin();
  return static_cast<std::size_t>(std::lower_bound(begin + static_cast<std::ptrdiff_t>(from),
                                                   begin + static_cast<std::ptrdiff_t>(to), limit) -
                                  begin);
}

// Beads farther behind the section than this are hidden by those in front.
constexpr double kSectionDepthMm = 2.0;
// While dragging, the uppermost layers keep every waypoint.
constexpr int kFullLayers = 2;

bool isCutOpen(const BeadChunk& chunk, const ViewState& view) {
  if (!view.sectionOn)
    return false;
  const double beyond = (chunk.centre - view.sectionOrigin).dot(view.sectionNormal);
  const double reach = chunk.half.dot(view.sectionNormal.cwiseAbs());
  return beyond < reach && beyond > -reach - kSectionDepthMm;
}

bool isHidden(const PathsDrawing& paths, const ViewState& view, std::size_t segment) {
  const auto kind = static_cast<std::uint32_t>(paths.values.kind[paths.arrival[segment]]);
  return (view.hiddenKinds >> kind & 1U) != 0;
}

int layerBeingPrinted(const PathsDrawing& paths, const ViewState& view, const Extent& extent) {
  if (view.printedWaypoints == kAllMoves || paths.pathOf.empty())
    return extent.last;
  const std::size_t waypoint =
      std::min(view.printedWaypoints, paths.pathOf.size()) - (view.printedWaypoints > 0 ? 1 : 0);
  return paths.layerOfPath[paths.pathOf[waypoint]];
}

} // namespace

std::vector<Stretch> visibleBeads(const PathsDrawing& paths, const ViewState& view) {
  const Extent extent(paths, view);
  const int currentLayer = layerBeingPrinted(paths, view, extent);
  std::vector<Stretch> shown;
  const auto add = [&](int layer, std::size_t from, std::size_t to) {
    const std::size_t end = shownUpTo(paths.arrival, from, to, extent.limit(layer));
    const bool inMaterial = view.materialColour && layer != currentLayer;
    if (view.hiddenKinds == 0) {
      appendStretch(shown, {2 * from, 2 * (end - from), inMaterial});
      return;
    }
    for (std::size_t first = from; first < end; ++first) {
      std::size_t last = first;
      while (last < end && !isHidden(paths, view, last))
        ++last;
      if (last > first)
        appendStretch(shown, {2 * first, 2 * (last - first), inMaterial});
      first = last;
    }
  };
  const int fullFrom = view.dragging ? extent.last - kFullLayers + 1 : extent.first;
  for (int layer = extent.first; layer <= extent.last; ++layer) {
    const auto l = static_cast<std::size_t>(layer);
    const auto& start = layer < fullFrom ? paths.coarseStart : paths.outerStart;
    add(layer, start[l], start[l + 1]);
  }
  for (int layer = extent.first; layer <= extent.last; ++layer) {
    const auto l = static_cast<std::size_t>(layer);
    for (std::size_t c = paths.chunkStart[l]; c < paths.chunkStart[l + 1]; ++c)
      if (const BeadChunk& chunk = paths.chunks[c];
          // Beads of a hidden kind may have covered it.
          view.hiddenKinds != 0 || !extent.hides(chunk) || isCutOpen(chunk, view))
        add(layer, chunk.first, chunk.first + chunk.count);
  }
  return shown;
}

std::vector<Stretch> visibleTravels(const PathsDrawing& paths, const ViewState& view) {
  const Extent extent(paths, view);
  std::vector<Stretch> shown;
  for (int layer = extent.first; layer <= extent.last; ++layer) {
    const auto l = static_cast<std::size_t>(layer);
    const std::size_t from = paths.travelStart[l];
    const std::size_t end =
        shownUpTo(paths.travelArrival, from, paths.travelStart[l + 1], extent.limit(layer));
    appendStretch(shown, {from, end - from});
  }
  return shown;
}

} // namespace voluta::scene
