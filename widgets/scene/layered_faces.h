// Faces sorted so that the visible ones for any range of layers are a few stretches.
#pragma once

#include "scene/range_mapper.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace voluta::scene {

// A face belongs to a layer and is hidden by another one. Upper sides are hidden once layer `key`
// is shown too. Lower sides store minus the layer that hides them. kNeverHidden: on the outside.
struct LayeredFace {
  std::int32_t layer = 0, key = 0;
  std::int32_t face = 0; // the owner's index
};
inline constexpr std::int32_t kNeverHidden = std::numeric_limits<std::int32_t>::max();

class LayeredFaces {
public:
  LayeredFaces() = default;
  // Sorts `faces` by layer and descending key. Face i of the sorted ones has the primitives
  // [firstPrimitive + i * primitivesAFace, ...).
  LayeredFaces(std::vector<LayeredFace>& faces, std::size_t firstPrimitive,
               std::size_t primitivesAFace);

  // Appends the primitives of faces of the layers first <= layer <= last with key > hidingKey.
  // `downwards`: the last layer comes first. From above it hides the others, which then take less
  // time.
  void append(std::vector<Stretch>& stretches, int first, int last, std::int32_t hidingKey,
              bool downwards = false) const;
  std::size_t size() const { return keys_.size(); }
  int layerCount() const { return static_cast<int>(start_.size()) - 1; }

private:
  std::vector<std::size_t> start_; // of every layer, and the end
  std::vector<std::int32_t> keys_;
  std::size_t firstPrimitive_ = 0, primitivesAFace_ = 1;
};

} // namespace voluta::scene
