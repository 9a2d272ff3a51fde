// A kind of platform: its textual form and its geometry.
#pragma once

#include "base/text.h"
#include "platform/rod_shape.h"

#include <Eigen/Core>
#include <string_view>
#include <vector>

namespace voluta::project {

// What a platform can be used as: a plate, the rod of a lathe, or any body.
enum class PlatformUse { Plate, Rod, Body };

// A length of a kind [mm]; both limits are allowed values.
struct PlatformField {
  std::string_view name; // "DIAMETER", as in "disc:DIAMETER"
  base::Text label;      // "Diameter"
  double minimum, maximum, usual;
};

struct PlatformKind {
  struct As {
    PlatformUse use;
    base::Text label;  // its name in that use
    bool sized = true; // false: the fields are not used
  };

  std::string_view word; // before the colon
  std::vector<As> uses;  // the first is the default
  base::Text shown;      // short text with a placeholder for the sizes or the file name
  base::Text plain = {}; // the text if all fields are 0; empty: use `shown`
  std::vector<PlatformField> fields = {}; // after the colon, separated by x
  bool bare = false;                      // the word alone means the default sizes
  bool madeForPart = false;   // its first field is the margin around the part's contact points
  bool ofCell = false;        // one of the cell's plates, chosen to fit the part
  std::string_view file = {}; // "FILE": a path after the colon instead of fields; empty: none

  // For a plate: returns its corners about the origin [mm], convex, counter-clockwise. `standing`:
  // points of the part on the plate; used only by plates made for the part, which need at least
  // one. For the cell's plates: the corners of the chosen plate. Null: not a plate.
  std::vector<Eigen::Vector2d> (*plate)(const std::vector<double>& sizesMm,
                                        std::vector<Eigen::Vector2d> standing) = nullptr;
  // For a rod: returns its shape with this number of sides (0: cylinder). Null: no rod of its own;
  // used as a rod, the kind means the cell's.
  platform::RodShape (*rod)(const std::vector<double>& sizesMm, int sides) = nullptr;
};

} // namespace voluta::project
