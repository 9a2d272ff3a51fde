// Colours of all drawings. Red is reserved for blocked objects.
#pragma once

#include <array>

namespace voluta::scene {

// sRGB, each in [0, 1].
using Colour = std::array<double, 3>;

struct Theme {
  Colour backgroundTop, backgroundBottom;
  Colour text, axisX, axisY, axisZ;
  Colour part, partEdges, partInside; // inside: faces visible in a section
  Colour otherPart, otherPartEdges;   // beside the active one
  Colour partBeyond;                  // where it is partly out of reach
  Colour platform, platformEdges, grid;
  Colour robotLight, robotDark, head, obstacle; // links alternate between light and dark
  Colour material;                              // beads without a colouring
  Colour travel;
  Colour marker;  // place of a finding
  Colour blocked; // not printable or not reachable: shadowed voxels
  // voxels missed for other reasons: not connected, or above shadowed ones
  Colour unreached, cascade;
  Colour risky;                 // faces of pieces that need support
  Colour current, ghost, front; // growth: the current step, later ones, the convex front
  Colour insert;                // put into the part
  Colour regionSettings, regionLayers, regionCut, regionLoad; // bodies of regions, by their use
};

Theme lightTheme();
Theme darkTheme();
Theme highContrastTheme(); // white and yellow on black

} // namespace voluta::scene
