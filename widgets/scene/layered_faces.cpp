#include "scene/layered_faces.h"

#include <algorithm>
#include <functional>
#include <tuple>

namespace voluta::scene {

LayeredFaces::LayeredFaces(std::vector<LayeredFace>& faces, std::size_t firstPrimitive,
                           std::size_t primitivesAFace)
    : firstPrimitive_(firstPrimitive), primitivesAFace_(primitivesAFace) {
  std::sort(faces.begin(), faces.end(), [](const LayeredFace& a, const LayeredFace& b) {
    return std::tie(a.layer, b.key, a.face) < std::tie(b.layer, a.key, b.face);
  });
  const int layers = faces.empty() ? 0 : faces.back().layer + 1;
  start_.assign(static_cast<std::size_t>(layers) + 1, 0);
  keys_.reserve(faces.size());
  for (const LayeredFace& f : faces) {
    ++start_[static_cast<std::size_t>(f.layer) + 1];
    keys_.push_back(f.key);
  }
  for (std::size_t i = 1; i < start_.size(); ++i)
    start_[i] += start_[i - 1];
}

void LayeredFaces::append(std::vector<Stretch>& stretches, int first, int last,
                          std::int32_t hidingKey, bool downwards) const {
  const int begin = std::max(first, 0), end = std::min(last, layerCount() - 1);
  // The key of faces that are never hidden also stands for "all layers".
  hidingKey = std::min(hidingKey, kNeverHidden - 1);
  for (int i = begin; i <= end; ++i) {
    const int layer = downwards ? begin + end - i : i;
    const auto from = keys_.begin() + static_cast<std::ptrdiff_t>(start_[layer]);
    const auto to = keys_.begin() + static_cast<std::ptrdiff_t>(start_[layer + 1]);
    const auto shown = std::lower_bound(from, to, hidingKey, std::greater<>()) - from;
    appendStretch(stretches, {firstPrimitive_ + start_[layer] * primitivesAFace_,
                              static_cast<std::size_t>(shown) * primitivesAFace_});
  }
}

} // namespace voluta::scene
