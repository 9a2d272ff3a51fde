// The visual shape of a robot's links: a table of lofted solids with colours, "shape" in its file.
//   shape                 {colours, solids}
//   colours               {name: "#rrggbb"}, the maker's
//   solids                a list of {frame, colour, fromMm, axis, turnedMm | sectionsMm, across,
//                         roundMm, count}
//     frame               as of links; the flange is on the last link
//     colour              a name of colours
//     fromMm, axis        the line along which it is lofted, in the frame: a point, a direction
//     turnedMm            round solids: a list of [along the line, radius]
//     sectionsMm          others: a list of [along the line, [[x, y, radius], ...]], hulls of
//                         discs, counter-clockwise; x is `across`, y completes the right-handed
//                         frame
//     across              required with sectionsMm: a direction, not along the axis
//     roundMm             radius of its edges; default 2
//     count, about        optional: number of copies, evenly around that axis ([x, y, z]) through
//     the
//                         frame's origin: bolts The cache keys of stages do not include the shape
//                         (robot/planning_text.h).
#pragma once

#include "robot/shape/loft.h"

#include <array>
#include <vector>

namespace voluta::base {
class JsonNode;
}

namespace voluta::robot {

using Rgb = std::array<double, 3>; // sRGB, each in [0, 1]

struct ShapeSolid {
  int frame = 0; // As Body::frame
  Rgb colour{};
  Loft loft;
};

// Throws Error{UnusableInput} naming file and key. `lastFrame`: the largest frame index allowed.
std::vector<ShapeSolid> readArmShape(const base::JsonNode& shape, int lastFrame);

} // namespace voluta::robot
