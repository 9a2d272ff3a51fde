// What a robot's links look like: a table of lofted solids with colours, "shape" in its file.
//   shape                 {colours, solids}
//   colours               {name: "#rrggbb"}, the maker's
//   solids                a list of {frame, colour, fromMm, axis, turnedMm | sectionsMm, across,
//                         roundMm, count}
//     frame               as of links; the flange is on the last link
//     colour              a name of colours
//     fromMm, axis        the line that it is lofted along, in the frame: a point, a direction
//     turnedMm            round solids: a list of [along the line, radius]
//     sectionsMm          others: a list of [along the line, [[x, y, radius], ...]], hulls of
//                         discs, counter-clockwise; x is `across`, y completes the right-handed
//                         frame
//     across              needed with sectionsMm: a direction, not along the axis
//     roundMm             radius of its edges; 2 where it is not given
//     count, about        optional: so many of them, evenly about that axis ([x, y, z]) through the
//                         frame's origin: bolts
// No key of a stage knows the shape (robot/planning_text.h).
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
  int frame = 0; // as Body::frame
  Rgb colour{};
  Loft loft;
};

// Throws Error{UnusableInput} naming file and key. `lastFrame`: the largest that a solid may have.
std::vector<ShapeSolid> readArmShape(const base::JsonNode& shape, int lastFrame);

} // namespace voluta::robot
