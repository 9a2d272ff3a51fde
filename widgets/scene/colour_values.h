// From values to colours and their legend.
#pragma once

#include "scene/drawing_data.h"

#include <cstdint>
#include <vector>

namespace voluta::scene {

// The colouring that is drawn when `asked` is asked for: Layer where there are no such values.
ColourBy shownColouring(const ColourValues& values, ColourBy asked);

// Precondition: shownColouring(values, colourBy) == colourBy.
Legend legendOf(const ColourValues& values, ColourBy colourBy);

// Three bytes an item, each item `repeat` times.
std::vector<std::uint8_t> coloursOf(const ColourValues& values, ColourBy colourBy, int repeat);

// What the colours of a drawing of voxels say; the growth's own colours only where it is replayed.
Legend voxelLegend(const VoxelDrawing& voxels, const Theme& theme);

} // namespace voluta::scene
