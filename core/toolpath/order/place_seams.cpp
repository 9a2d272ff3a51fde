#include "toolpath/order/place_seams.h"

#include "toolpath/unsupported/bead_tip.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace voluta::toolpath {

namespace {
using Eigen::Vector3d;

// A curved layer may leave out places that the layers before and after it cover.
constexpr int kLayersBelow = 3;

struct PlacedSeam {
  int layer = 0;
  Vector3d tip;
};
using WallId = std::tuple<int, int, int>; // item, group, ring

std::vector<Vector3d> seamsBelow(std::vector<PlacedSeam>& placed, int layer) {
  std::erase_if(placed, [&](const PlacedSeam& s) { return s.layer < layer - kLayersBelow; });
  std::vector<Vector3d> below;
  for (const PlacedSeam& seam : placed)
    if (seam.layer < layer)
      below.push_back(seam.tip);
  return below;
}
} // namespace

std::vector<std::vector<std::optional<Bead>>> placeSeams(const layers::LayerStack& stack,
                                                         const std::vector<PatchCover>& covers,
                                                         const SeamKind& kind,
                                                         const SeamsOfItems& ofRegions) {
  std::vector<std::vector<std::optional<Bead>>> out(covers.size());
  std::map<WallId, std::vector<PlacedSeam>> placed;
  std::map<std::pair<int, int>, std::size_t> pathsOf; // item, layer
  for (std::size_t i = 0; i < covers.size(); ++i) {
    const layers::Patch& patch = stack.patches[i];
    const std::vector<Bead>& beads = covers[i].beads;
    out[i].resize(beads.size());
    const auto item = static_cast<std::size_t>(patch.item);
    const SeamPlaces* const regions = item < ofRegions.size() ? ofRegions[item].get() : nullptr;
    if ((!kind.place && !regions) || patch.group == layers::kSupportGroup)
      continue;
    for (std::size_t k = 0; k < beads.size(); ++k) {
      const bool isWall = beads[k].kind == plan::PathKind::Wall;
      if (!beads[k].closed || (!isWall && !regions))
        continue;
      std::vector<PlacedSeam>& seams = placed[{patch.item, patch.group, beads[k].ring}];
      const std::vector<Vector3d> below = seamsBelow(seams, patch.layer);
      const SeamInput input{beads[k], patch.layer, pathsOf[{patch.item, patch.layer}]++, below};
      std::optional<SeamPlace> place;
      if (kind.place && isWall)
        place = kind.place(input);
      if (regions)
        if (const auto ruled = regions->seamOf(input, place))
          place = ruled;
      if (!place)
        continue;
      seams.push_back({patch.layer, tipAt(beads[k], *place)});
      out[i][k] = begunAt(beads[k], *place);
    }
  }
  return out;
}

} // namespace voluta::toolpath
