// A kind of platform: what a user types of it, and the body that comes of it.
#pragma once

#include "base/text.h"
#include "platform/rod_shape.h"

#include <Eigen/Core>
#include <string_view>
#include <vector>

namespace voluta::project {

// What may carry a part: a plate, the rod of a lathe, or any body.
enum class PlatformUse { Plate, Rod, Body };

// A length that goes with a kind, mm, both limits among what is allowed.
struct PlatformField {
  std::string_view name; // "DIAMETER", as in "disc:DIAMETER"
  base::Text label;      // "Diameter"
  double least, most, usual;
};

struct PlatformKind {
  struct As {
    PlatformUse use;
    base::Text label;  // what it is called there
    bool sized = true; // false: the fields mean nothing there
  };

  std::string_view word; // before the colon
  std::vector<As> uses;  // the first is what it is without a word about it
  base::Text shown;      // in few words, with a place for the sizes or the file's name
  base::Text plain = {}; // the same where all fields are 0; empty: no other
  std::vector<PlatformField> fields = {}; // after the colon, with an x between
  bool bare = false;                      // the word alone has the usual sizes
  bool madeForPart = false;   // its first field is the margin around what of the part stands on it
  bool ofCell = false;        // one of the plates that the cell comes with, whichever fits the part
  std::string_view file = {}; // "FILE": a path after the colon instead of fields; empty: none

  // Of a plate, about the origin: its corners, convex, counter-clockwise, mm. `standing`: points of
  // the part on the plate; only those that are made for the part ask for them, and these for at
  // least one. Of the cell: the corners of the plate that was taken. Null: no plate.
  std::vector<Eigen::Vector2d> (*plate)(const std::vector<double>& sizesMm,
                                        std::vector<Eigen::Vector2d> standing) = nullptr;
  // Of a rod, with so many sides (0: round). Null: no rod of its own; where it is used as one, it
  // stands for the cell's.
  platform::RodShape (*rod)(const std::vector<double>& sizesMm, int sides) = nullptr;
};

} // namespace voluta::project
