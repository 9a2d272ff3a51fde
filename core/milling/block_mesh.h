// The surface of a block, for pictures.
#pragma once

#include "geometry/triangle_mesh.h"
#include "milling/stock.h"

#include <cstddef>

namespace voluta::milling {

// Returns the surface through the middles of the block's columns, facing outward. Takes every
// second, third, ... column of a block with more than `maxColumns`. Columns without three
// neighbours of a square are left out. Precondition: maxColumns >= 4.
geometry::TriangleMesh meshOf(const Stock& stock, std::size_t maxColumns);

} // namespace voluta::milling
