// Colourings: the quantities that layers and paths can be coloured by, their colour maps and their
// legend.
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
  LayerTime, // since the bead below was printed
  Direction,
  Spacing,    // layers: thickness relative to the nominal height
  GrowthStep, // voxels: step in which they are printed
  Peeling,    // voxels: round of the published peeling that removes them
  Tool,       // paths: number of the tool in a job of several
  Part,       // index of the part in a job of several
  Region      // layers: 0 for the part's own patches, otherwise the region's number
};
inline constexpr int kColourByCount = 15;

struct ColourByRow {
  ColourBy colourBy;
  std::string_view id;   // on the command line: "layer"
  base::Text label;      // "Layer"
  std::string_view unit; // of the legend's numbers: "mm"; "" for none
  bool categorical;      // one colour per value instead of a scale
};

// Returns one row per quantity, in the order of ColourBy.
const std::vector<ColourByRow>& colourByTable();
// Throws Error{Usage} for an unknown id, suggesting the nearest.
ColourBy colourByOf(std::string_view id);

// Returns a colour of the sequential map, dark blue to yellow, with even lightness, safe for
// colour-blind eyes. t is clamped to [0, 1].
Colour sequentialColour(double t);
// Returns a colour of the diverging map, blue over nearly white (t = 1/2) to brown, safe for
// colour-blind eyes. t is clamped to [0, 1].
Colour divergingColour(double t);
// Colours of thicknesses outside the process's limits: much lighter than the adjacent ends of the
// map.
Colour tooThinColour();
Colour tooThickColour();
Colour supportColour(); // of support voxels
// Returns the colour of a piece by its place in print order: hues and lightnesses that colour-blind
// eyes distinguish, darker beyond their number; neither red nor the colour of faces that need
// support. Precondition: index >= 0.
Colour pieceColour(int index);
// Returns one of Okabe and Ito's colours without the red one, repeated beyond their number.
// Precondition: index >= 0.
Colour categoricalColour(int index);

struct LegendEntry {
  double value;      // scale: the number at this stop; categories: their index
  base::Value label; // the number as text (without unit), or the category's name
  Colour colour;
  base::Value note = {}; // shown after the label: a remark, or the number of items

  base::Message text() const {
    return note.empty() ? base::message("{label}"_text, label)
                        : base::message("{label} ({note})"_text, label, note);
  }
};

// Without entries and marks no legend is needed. The title is that of the entries.
struct Legend {
  base::Text title; // the label of the row of colourByTable()
  std::string unit;
  bool categorical = false;
  bool diverging = false;
  std::vector<LegendEntry> entries; // scale: ascending, evenly spaced in colour
  std::vector<LegendEntry> marks;   // separate colours next to the scale, each with its meaning

  // Precondition: a scale; t in [0, 1] from the first entry to the last.
  Colour scaleColour(double t) const {
    return diverging ? divergingColour(t) : sequentialColour(t);
  }
};

} // namespace voluta::scene
