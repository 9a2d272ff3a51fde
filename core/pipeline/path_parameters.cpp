#include "pipeline/path_parameters.h"

#include "base/error.h"
#include "base/key_text.h"
#include "base/number_list.h"
#include "base/units.h"

#include <cmath>

namespace voluta::pipeline {

namespace {
using Eigen::AngleAxisd, Eigen::Vector3d;
using sliced::GroundShape;

GroundShape groundShape(const std::string& word) {
  return word == "plane"      ? GroundShape::Plane
         : word == "cylinder" ? GroundShape::Cylinder
         : word == "sphere"   ? GroundShape::Sphere
                              : GroundShape::Plate;
}

Eigen::Isometry3d frameOf(const std::string& text) {
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  if (text.empty())
    return frame;
  Vector3d at, rotation;
  if (!base::readNumbers(text, ',',
                         {&at.x(), &at.y(), &at.z(), &rotation.x(), &rotation.y(), &rotation.z()}))
    throw base::Error(
        base::ErrorCode::Usage,
        base::message("`pathsFrame` '{text}' is not a frame"_text, text.substr(0, 40)), {},
        "write x,y,z,a,b,c in mm and degrees"_text);
  frame.translation() = at;
  frame.linear() = (AngleAxisd(base::degreesToRadians(rotation.z()), Vector3d::UnitZ()) *
                    AngleAxisd(base::degreesToRadians(rotation.y()), Vector3d::UnitY()) *
                    AngleAxisd(base::degreesToRadians(rotation.x()), Vector3d::UnitX()))
                       .toRotationMatrix();
  return frame;
}

} // namespace

sliced::PathShape pathShape(const base::ParameterValues& values) {
  sliced::PathShape shape;
  shape.amountFactor = values.number("pathsFlow") / 100.0;
  shape.rotationPerLayerRad = base::degreesToRadians(values.number("pathsTurn"));
  shape.reverseMm = values.number("pathsTurnBackMm");
  shape.ground.shape = groundShape(values.text("pathsOn"));
  shape.ground.radiusMm = values.number("pathsRadiusMm");
  shape.ground.keepsAngles = values.text("pathsKeep") == "angles";
  shape.frame = frameOf(values.text("pathsFrame"));
  if (shape.ground.isCurved() && std::abs(shape.ground.radiusMm) < 1.0)
    throw base::Error(base::ErrorCode::Usage,
                      base::message("`pathsRadiusMm={radius}` is no radius of a ground"_text,
                                    base::number(shape.ground.radiusMm)),
                      {}, "give at least 1 mm, or at most -1 mm for the inside"_text);
  return shape;
}

base::ParameterTable pathShapeParameters() {
  return base::ParameterTable({
      base::numberParameter("pathsFlow", "%", 100.0, 1.0, 1000.0, "Paths of the file"_text,
                            "amount"_text,
                            "Material of the file's tool-paths, in percent of its amounts. For a "
                            "file that was read with another filament diameter: 100 times the "
                            "square of their ratio (2.85 mm instead of 1.75 mm: 265)."_text),
      base::numberParameter("pathsTurn", "deg", 0.0, -180.0, 180.0, "Paths of the file"_text,
                            "turn per layer"_text,
                            "Turns each layer of the file's tool-paths about z against the one "
                            "below; positive: counterclockwise."_text),
      base::numberParameter("pathsTurnBackMm", "mm", 0.0, 0.0, 10000.0, "Paths of the file"_text,
                            "turn back after"_text,
                            "Height after which the layers turn in the other direction, again and "
                            "again; 0: never."_text),
      base::choiceParameter(
          "pathsOn", "plate",
          {{"plate", "plate"_text},
           {"plane", "plane"_text},
           {"cylinder", "cylinder"_text},
           {"sphere", "sphere"_text}},
          "Paths of the file"_text, "ground"_text,
          "Where the file's tool-paths are printed: on the plate; on a block with a plane top, "
          "which "
          "is turned together with them; or bent onto a cylinder along x or a sphere. The "
          "block is made for the part, unless the platform is a body."_text,
          true),
      base::numberParameter("pathsRadiusMm", "mm", 100.0, -10000.0, 10000.0,
                            "Paths of the file"_text, "radius"_text,
                            "Radius of that cylinder or sphere; negative: its inside."_text, true),
      base::choiceParameter(
          "pathsKeep", "lengths", {{"lengths", "lengths"_text}, {"angles", "angles"_text}},
          "Paths of the file"_text, "bent layers keep"_text,
          "On a cylinder or sphere: each layer keeps the lengths of the file, or the "
          "angle of the layer below, so that it grows with the radius and its beads with it."_text),
      base::textParameter(
          "pathsFrame", "Paths of the file"_text, "frame"_text,
          "Moves the file's tool-paths to x,y,z,a,b,c: mm, and degrees about the fixed axes x, y "
          "and z in this order; e.g. onto a side of the platform's body. Empty: no motion."_text),
  });
}

std::string pathShapeKey(const base::ParameterValues& values) {
  std::string key;
  const base::ParameterTable table = pathShapeParameters();
  for (const base::ParameterSpec& spec : table.specs())
    if (const auto own = values.changes().find(spec.key);
        own != values.changes().end() && own->second != spec.defaultValue)
      key += base::keyText(spec.key, base::formatParameter(own->second));
  return key;
}

} // namespace voluta::pipeline
