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

// Of layers 0 ... layers - 1.
Legend layerLegend(int layers);

} // namespace voluta::scene
