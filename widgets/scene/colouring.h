// What colours mean: the quantities that layers and paths can be coloured by, their maps, and the
// legend that says so.
#pragma once

#include "base/text.h"
#include "scene/theme.h"

#include <string>
#include <string_view>
#include <vector>

namespace voluta::scene {

enum class ColourBy {
  Layer,
  Group,
  Kind,
  Height,
  Width,
  Speed,
  Time,
  Direction,
  Spacing,    // layers: thickness about the nominal height
  GrowthStep, // voxels: when they are laid
  Peeling     // voxels: when the source's peeling takes them off
};
inline constexpr int kColourByCount = 11;

struct ColourByRow {
  ColourBy colourBy;
  std::string_view id;   // on the command line: "layer"
  base::Text label;      // "Layer"
  std::string_view unit; // of the legend's numbers: "mm", "" for none
  bool categorical;      // a colour a value, not a scale
};

// One row a quantity, in the order of ColourBy.
const std::vector<ColourByRow>& colourByTable();
// Throws Error{Usage} for an unknown id, naming the nearest.
ColourBy colourByOf(std::string_view id);

// Sequential map, dark blue to yellow, even in lightness and safe for colour-blind eyes. t is
// clamped to [0, 1].
Colour sequentialColour(double t);
// Diverging map, blue over nearly white (t = 1/2) to brown, safe for colour-blind eyes. t is
// clamped to [0, 1].
Colour divergingColour(double t);
// Thickness that the process cannot lay: much lighter than the map's ends, which they follow.
Colour tooThinColour();
Colour tooThickColour();
Colour supportColour(); // of voxels laid as support
// Of the piece at that place in print order: hues and lightnesses that colour-blind eyes tell
// apart, darker beyond their number; neither red nor the colour of what needs support. index >= 0.
Colour pieceColour(int index);
// Okabe and Ito's colours without the red one, repeated beyond their number. index >= 0.
Colour categoricalColour(int index);

struct LegendEntry {
  double value;      // scale: the number at this stop; categories: their index
  base::Value label; // the number as text (without unit), or the category's name
  Colour colour;
  base::Value note = {}; // said after the label: what is special about it, or how many there are

  base::Message text() const {
    return note.empty() ? base::message("{label}"_text, label)
                        : base::message("{label} ({note})"_text, label, note);
  }
};

// Neither entries nor marks: nothing shown needs a legend. The title is that of the entries.
struct Legend {
  base::Text title; // the label of the row of colourByTable()
  std::string unit;
  bool categorical = false;
  bool diverging = false;
  std::vector<LegendEntry> entries; // scale: ascending, evenly spaced in colour
  std::vector<LegendEntry> marks;   // colours beside the scale, each with a meaning of its own

  // Of a scale, t in [0, 1] from the first entry to the last.
  Colour scaleColour(double t) const {
    return diverging ? divergingColour(t) : sequentialColour(t);
  }
};

} // namespace voluta::scene
