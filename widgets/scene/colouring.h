// What colours mean: the quantities that layers and paths can be coloured by, their maps, and the
// legend that says so.
#pragma once

#include "scene/theme.h"

#include <string>
#include <string_view>
#include <vector>

namespace voluta::scene {

enum class ColourBy { Layer, Group, Kind, Height, Width, Speed, Time, Direction };
inline constexpr int kColourByCount = 8;

struct ColourByRow {
  ColourBy colourBy;
  std::string_view id;    // on the command line: "layer"
  std::string_view label; // English: "Layer"
  std::string_view unit;  // of the legend's numbers: "mm", "" for none
  bool categorical;       // a colour a value, not a scale
};

// One row a quantity, in the order of ColourBy.
const std::vector<ColourByRow>& colourByTable();
// Throws Error{Usage} for an unknown id, naming the nearest.
ColourBy colourByOf(std::string_view id);

// Sequential map, dark blue to yellow, even in lightness and safe for colour-blind eyes. t is
// clamped to [0, 1].
Colour sequentialColour(double t);
// Okabe and Ito's colours without the red one, repeated beyond their number. index >= 0.
Colour categoricalColour(int index);

struct LegendEntry {
  double value;      // scale: the number at this stop; categories: their index
  std::string label; // the number as text (without unit), or the category's name
  Colour colour;
};

// Empty entries: nothing shown needs a legend.
struct Legend {
  std::string title, unit; // English; title is the label of the row of colourByTable()
  bool categorical = false;
  std::vector<LegendEntry> entries; // scale: ascending, evenly spaced
};

} // namespace voluta::scene
