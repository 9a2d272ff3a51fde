// The results of all items of a job, for one picture.
#pragma once

#include "geometry/triangle_mesh.h"
#include "layers/layer_stack.h"
#include "layers/print_order.h"
#include "planar/pieces.h"
#include "project/job.h"

#include <memory>
#include <optional>
#include <vector>

namespace voluta::pictures {

// Each returns the result of a single item without copying it, and null if an item has none.
std::shared_ptr<const geometry::TriangleMesh> partsOf(const project::Job& job);
std::shared_ptr<const layers::LayerStack> layersOf(const project::Job& job);

// Returns the pieces of all items that have some; empty if none has.
std::vector<planar::Piece> piecesOf(const project::Job& job);

// Returns the first item that was decomposed into voxels; none: there is none.
std::optional<std::size_t> itemWithVoxels(const project::Job& job);

} // namespace voluta::pictures
