#include "scene/visible_beads.h"

#include <algorithm>
#include <utility>

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
    whole_ =
        first == 0 && last == layerCount(paths) - 1 && !partial_ && printed_ >= paths.pathOf.size();
  }

  int first, last;
  // Returns whether the finished print is shown.
  bool isWhole() const { return whole_; }
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
  bool partial_ = false, whole_ = false;
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
// While dragging, the uppermost layers keep every waypoint, if they take no more than this share of
// the triangles.
constexpr int kFullLayers = 2;
constexpr std::size_t kFullShare = 4;
// Combinations of levels and layers, finest first.
constexpr std::pair<std::size_t, int> kDetails[] = {{0, 1}, {1, 1}, {1, 2}, {2, 2},
                                                    {2, 3}, {2, 4}, {2, 6}, {2, 8}};

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

// The level of detail of fast frames. It depends on the view, not on the camera, so that it stays
// the same while the camera moves.
struct Detail {
  std::size_t level = kBeadLevels; // kBeadLevels: all segments
  int everyLayer = 1;
  bool closed = false; // nothing inside the print can be seen
  int last = 0, fineFrom = 0, fineLayer = -1;

  bool isFull() const { return level == kBeadLevels; }
  bool isFine(int layer) const { return layer >= fineFrom || layer == fineLayer; }
  bool isDrawn(int layer) const { return (last - layer) % everyLayer == 0; }
};

template <typename ForOpenChunks>
Detail detailFor(const PathsDrawing& paths, const ViewState& view, const Extent& extent,
                 int currentLayer, const ForOpenChunks& forOpenChunks) {
  const std::size_t most = view.draggedTriangles / 2; // segments
  const auto fineCount = [&](int layer) {
    const auto l = static_cast<std::size_t>(layer);
    std::size_t count = paths.outerStart[l + 1] - paths.outerStart[l];
    forOpenChunks(layer, [&](std::size_t from, std::size_t to) { count += to - from; });
    return count;
  };
  std::size_t all = 0;
  std::vector<char> uncovered; // per layer from extent.first
  for (int layer = extent.first; layer <= extent.last; ++layer) {
    const auto l = static_cast<std::size_t>(layer);
    const std::size_t count = fineCount(layer);
    all += count;
    uncovered.push_back(count > paths.outerStart[l + 1] - paths.outerStart[l]);
  }
  Detail detail;
  if (all <= most)
    return detail;
  detail.last = extent.last;
  detail.closed = extent.isWhole() && view.hiddenKinds == 0 && !view.sectionOn && view.beads;
  const auto isAffordable = [&](int layer) { return fineCount(layer) <= most / kFullShare; };
  detail.fineFrom = extent.last + 1;
  while (detail.fineFrom > extent.first && extent.last - detail.fineFrom + 1 < kFullLayers &&
         isAffordable(detail.fineFrom - 1))
    --detail.fineFrom;
  if (currentLayer >= extent.first && currentLayer <= extent.last && isAffordable(currentLayer))
    detail.fineLayer = currentLayer;
  for (const auto& [level, everyLayer] : kDetails) {
    detail.level = level;
    detail.everyLayer = everyLayer;
    const std::vector<std::size_t>& start = paths.coarse[level];
    std::size_t count = 0;
    for (int layer = extent.first; layer <= extent.last; ++layer) {
      const std::size_t n = kBeadSights * static_cast<std::size_t>(layer);
      if (detail.isFine(layer))
        count += fineCount(layer);
      else if (detail.isDrawn(layer))
        count +=
            start[n + (detail.closed ? 1 : 2)] - start[n] +
            (uncovered[static_cast<std::size_t>(layer - extent.first)] ? start[n + 3] - start[n + 2]
                                                                       : 0);
    }
    if (count <= most)
      break;
  }
  return detail;
}

} // namespace

VisibleBeads visibleBeads(const PathsDrawing& paths, const ViewState& view) {
  const Extent extent(paths, view);
  const int currentLayer = layerBeingPrinted(paths, view, extent);
  VisibleBeads shown;
  const auto add = [&](int layer, std::size_t from, std::size_t to) {
    const std::size_t end = shownUpTo(paths.arrival, from, to, extent.limit(layer));
    const bool inMaterial = view.materialColour && layer != currentLayer;
    if (view.hiddenKinds == 0) {
      appendStretch(shown.stretches, {2 * from, 2 * (end - from), inMaterial});
      return;
    }
    for (std::size_t first = from; first < end; ++first) {
      std::size_t last = first;
      while (last < end && !isHidden(paths, view, last))
        ++last;
      if (last > first)
        appendStretch(shown.stretches, {2 * first, 2 * (last - first), inMaterial});
      first = last;
    }
  };
  // Calls f(first, end) for the chunks of a layer that are not covered.
  const auto forOpenChunks = [&](int layer, auto&& f) {
    const auto l = static_cast<std::size_t>(layer);
    for (std::size_t c = paths.chunkStart[l]; c < paths.chunkStart[l + 1]; ++c)
      if (const BeadChunk& chunk = paths.chunks[c];
          // Beads of a hidden kind may have covered it.
          view.hiddenKinds != 0 || !extent.hides(chunk) || isCutOpen(chunk, view))
        f(chunk.first, chunk.first + chunk.count);
  };
  const auto addFine = [&](int layer) {
    const auto l = static_cast<std::size_t>(layer);
    add(layer, paths.outerStart[l], paths.outerStart[l + 1]);
  };
  const auto addOpenChunks = [&](int layer) {
    forOpenChunks(layer, [&](std::size_t from, std::size_t to) { add(layer, from, to); });
  };
  const Detail detail =
      view.dragging ? detailFor(paths, view, extent, currentLayer, forOpenChunks) : Detail{};
  // The uppermost layer first: from above it hides the others, which then take less time.
  const auto layerAt = [&](int i) { return view.dragging ? extent.first + extent.last - i : i; };
  if (detail.isFull()) {
    for (int i = extent.first; i <= extent.last; ++i)
      addFine(layerAt(i));
    for (int i = extent.first; i <= extent.last; ++i)
      addOpenChunks(layerAt(i));
    return shown;
  }
  shown.everyLayer = detail.everyLayer;
  const std::vector<std::size_t>& start = paths.coarse[detail.level];
  for (int i = extent.first; i <= extent.last; ++i) {
    const int layer = layerAt(i);
    const std::size_t n = kBeadSights * static_cast<std::size_t>(layer);
    if (detail.isFine(layer)) {
      addFine(layer);
      addOpenChunks(layer);
    } else if (detail.isDrawn(layer)) {
      add(layer, start[n], start[n + 1]);
      if (!detail.closed)
        add(layer, start[n + 1], start[n + 2]);
      bool uncovered = false;
      forOpenChunks(layer, [&](std::size_t, std::size_t) { uncovered = true; });
      if (uncovered)
        add(layer, start[n + 2], start[n + 3]);
    }
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
