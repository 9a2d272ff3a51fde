// The table of shapes that a region may have.
#pragma once

#include "base/text.h"
#include "geometry/triangle_mesh.h"

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::regions {

// A number of a shape, in mm or, where the name says so, in degrees.
struct ShapeField {
  std::string_view name; // in the form, capital letters
  base::Text label;
  double minimum = 0.0, maximum = 0.0;
  std::optional<double> usual = {}; // the field may be left out
  bool isWhole = false;             // takes whole numbers only
};

// The mesh that a region of a kind has (project::Region::mesh).
enum class ShapeMesh {
  None,
  File,   // a closed body; the form names its file
  Painted // a surface of the part
};

// What the numbers of a shape are relative to.
enum class ShapeFrame {
  File,  // the coordinates of the part's file; the shape is scaled and moved with the part
  Plate, // the work frame
  Part   // the part's surface
};

struct RegionKind {
  std::string_view word; // before the colon of the form
  base::Text label;
  std::vector<ShapeField> fields = {};
  ShapeFrame frame = ShapeFrame::File;
  ShapeMesh mesh = ShapeMesh::None;
  std::string_view usualUse = "settings"; // id in regionUses()
  // Returns the closed body, facing outward, in the shape's frame. `around`: the box of the part in
  // the work frame. nullptr: from the region's mesh, or a body that follows the part's surface.
  geometry::TriangleMesh (*body)(const std::vector<double>& numbers,
                                 const Eigen::AlignedBox3d& around) = nullptr;
};

// In the order shown to users.
const std::vector<RegionKind>& regionKinds();

// Returns whether layers can be parallel to the part's surface in a shape: it says which faces.
bool followsSurface(const RegionKind& kind);

// Returns the form of a shape, for example "sphere:X,Y,Z,DIAMETER".
std::string formOf(const RegionKind& kind);
// Returns the forms of all kinds, separated by commas.
std::string allForms();

// A shape as its text states it.
struct Shape {
  const RegionKind* kind = nullptr;
  std::vector<double> numbers; // as many as fields
  std::string file;            // of a kind from a file
};

// Throws Error{Usage} that names the nearest kind, or the form or the range of a field.
Shape parsedShape(std::string_view text);

// Returns the names of fields as a form, "X,Y[,Z]".
std::string formOf(const std::vector<ShapeField>& fields);
// Returns the numbers behind the colon of a text, usual ones for fields that are left out. Throws
// Error{Usage} with the form, or the range of a field.
std::vector<double> parsedNumbers(std::string_view text, const std::vector<ShapeField>& fields,
                                  const std::string& form);

} // namespace voluta::regions
