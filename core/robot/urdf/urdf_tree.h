// The content of a URDF file: links with their solids, and joints between them, unprocessed;
// robot/urdf/urdf_reader.h makes a robot of it. Format: wiki.ros.org/urdf/XML.
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace voluta::robot {

struct UrdfBox {
  Eigen::Vector3d sizeMm;
};
struct UrdfCylinder { // Along z, centred at 0
  double radiusMm, lengthMm;
};
struct UrdfSphere {
  double radiusMm;
};
struct UrdfMesh {
  std::string file; // As written: a path, package://..., file://...
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
};
struct UrdfSolid {
  Eigen::Isometry3d link_T_solid = Eigen::Isometry3d::Identity();
  std::variant<UrdfBox, UrdfCylinder, UrdfSphere, UrdfMesh> shape;
};
struct UrdfLink {
  std::string name;
  std::vector<UrdfSolid> collision, visual;
  std::vector<std::string> unknownShapes; // Names of solids that are not read
};
struct UrdfLimit { // [rad], [rad/s]
  double lower = 0.0, upper = 0.0, velocity = 0.0;
};
struct UrdfSoftLimit { // [rad], of a safety controller
  double lower = 0.0, upper = 0.0;
};
struct UrdfJoint {
  std::string name, type, parent, child;
  Eigen::Isometry3d parent_T_joint = Eigen::Isometry3d::Identity(); // [mm]
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();                  // As written
  std::optional<UrdfLimit> limit;
  std::optional<UrdfSoftLimit> softLimit;
  std::string follows; // The joint that it mimics
};
struct UrdfTree {
  std::string name;
  std::vector<UrdfLink> links;
  std::vector<UrdfJoint> joints;
};

// Throws Error{UnreadableFile} with the line: the file is missing, not XML, not a URDF, contains
// invalid numbers, or is a xacro file that has not been expanded.
UrdfTree readUrdfTree(const std::filesystem::path& file);

} // namespace voluta::robot
