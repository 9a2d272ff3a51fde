// Layers of a sliced file by the height of its beads.
#pragma once

#include "sliced/sliced_file.h"

#include <vector>

namespace voluta::sliced {

// Returns whether a path with upright nozzles rises or falls along its way by more than the
// rounding of its file.
bool isRising(const SlicedPath& path);

class LayerHeights {
public:
  explicit LayerHeights(const SlicedFile& file);

  struct Layer {
    int index = 0;         // From 0 at the lowest
    double heightMm = 0.0; // Above the layer below, or above z = 0; 0: not known
  };
  // Returns the layer of a path. One that rises or tilts gets the height that the file states.
  Layer of(const SlicedPath& path) const;

private:
  double stated(double topMm) const;

  SlicedHeader header_;
  std::vector<double> part_, other_; // Tops of layers, ascending: of the part, of supports
};

} // namespace voluta::sliced
