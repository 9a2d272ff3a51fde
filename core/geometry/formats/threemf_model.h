// A model part of a 3MF package as data: its objects and its build items (3MF core specification
// 1.3, production extension 1.1, beam lattice extension 1.2, slice extension 1.0).
#pragma once

#include "base/text.h"
#include "geometry/formats/threemf_paint.h"

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace voluta::geometry {

// A reference to an object, by a build item or a component.
struct ThreemfUse {
  std::string path, id; // path empty: in the same model part
  Eigen::Affine3d parent_T_object = Eigen::Affine3d::Identity();
  bool printable = true;
};

// In the order of the words in the specification.
enum class ThreemfObjectType { Model, SolidSupport, Support, Surface, Other };

struct ThreemfBeam {
  std::array<long long, 2> ends{}; // vertices of the object
  std::array<double, 2> radii{};   // at the ends, in the model's unit
  std::array<bool, 2> round{};     // capped by a ball; false: flat
};

struct ThreemfObject {
  std::string name; // empty: none
  ThreemfObjectType type = ThreemfObjectType::Model;
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<long long, 3>> triangles; // indices in range
  std::vector<ThreemfUse> components;
  std::vector<ThreemfBeam> beams;
  std::map<long long, double> balls; // radius by vertex
  bool lowResolution = false;        // slices are its shape, the mesh is only a placeholder
  bool hasSlices = false;
  bool hasClippedBeams = false;
  // Cura's settings of the object (infill_mesh, extruder_nr, ...) with their values.
  std::vector<std::pair<std::string, std::string>> settings;
  std::map<std::string, ThreemfPaint> paints; // by attribute
};

struct ThreemfModel {
  std::string unit = "millimeter";
  std::map<std::string, ThreemfObject> objects;
  std::vector<ThreemfUse> build;
  std::vector<base::Message> notes; // statements that are not acted on, a sentence each

  // Returns the name of the object; empty if it has none or does not exist.
  std::string nameOf(const std::string& id) const;
};

// `name` of the file and `member` of the package are for errors and notes. A model whose root is in
// another namespace than the core's, as of Cura 4.5, which exchanges two of them, is read all the
// same, with a note. Throws Error{UnreadableFile} with the line if the text is
// not well-formed, an attribute is missing or not a number, an index is out of range, an object
// type is unknown, or the model requires an unknown extension.
ThreemfModel parseThreemfModel(std::string_view text, const std::string& name,
                               const std::string& member);

} // namespace voluta::geometry
