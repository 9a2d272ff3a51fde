// Colours of everything drawn. Red is kept for what is blocked.
#pragma once

#include <array>

namespace voluta::scene {

// sRGB, each in [0, 1].
using Colour = std::array<double, 3>;

struct Theme {
  Colour backgroundTop, backgroundBottom;
  Colour text, axisX, axisY, axisZ;
  Colour part, partEdges, partInside; // inside: what a section lays open
  Colour partBeyond;                  // where not all of it is in reach
  Colour platform, platformEdges, grid;
  Colour robotLight, robotDark, head, obstacle; // links alternate between light and dark
  Colour material;                              // laid beads without a colouring
  Colour travel;
  Colour marker;             // place of a finding
  Colour blocked;            // what cannot be printed or reached: shadowed voxels
  Colour unreached, cascade; // voxels missed for other reasons: no way there, hanging on shadowed
  Colour risky;              // faces of pieces that need support
  Colour current, ghost, front; // growth: the step being laid, later ones, the convex front
};

Theme lightTheme();
Theme darkTheme();

} // namespace voluta::scene
