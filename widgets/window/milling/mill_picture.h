// What the milling dialog draws: the part, the block and the cutter's moves.
#pragma once

#include "pipeline/mill_part.h"
#include "scene/line_groups.h"

#include <QString>
#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace voluta::window {

// Groups of lines, in the order in which they are listed.
enum class MillLines { Block, Rapid, RoughA, FineA, RoughB, FineB, Contour };
inline constexpr std::size_t kMillLines = 7;

struct MillPicture {
  std::shared_ptr<const scene::PartDrawing> part, milled;
  std::array<scene::LineGroup, kMillLines> lines; // by MillLines
};

// Returns the part alone, before there are passes.
MillPicture pictureOf(const geometry::TriangleMesh& part);
// Moves of sides B and Contour are drawn in the coordinates of side A.
MillPicture pictureOf(const pipeline::MilledPart& milled);

// Returns the name of a group in the window's language, and its colour.
QString millLinesName(MillLines which);
scene::Colour millLinesColour(MillLines which);

} // namespace voluta::window
