// Conversion of values to colours, and their legend.
#pragma once

#include "scene/drawing_data.h"

#include <cstdint>
#include <vector>

namespace voluta::scene {

// Returns the drawn colouring for a requested one: Layer if its values are missing.
ColourBy shownColouring(const ColourValues& values, ColourBy asked);

// Precondition: shownColouring(values, colourBy) == colourBy.
Legend legendOf(const ColourValues& values, ColourBy colourBy);

// Returns three bytes per item, each item `repeat` times.
std::vector<std::uint8_t> coloursOf(const ColourValues& values, ColourBy colourBy, int repeat);

// Returns the legend of a drawing of voxels; includes growth's colours only while growth is
// replayed.
Legend voxelLegend(const VoxelDrawing& voxels, const Theme& theme);

} // namespace voluta::scene
