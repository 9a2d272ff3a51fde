#include "robot/urdf/urdf_tree.h"

#include "base/error.h"
#include "base/files.h"
#include "geometry/formats/text_scanner.h"
#include "geometry/formats/xml_scan.h"

#include <cmath>

namespace voluta::robot {

namespace {

using base::Error;
using base::ErrorCode;
using Eigen::Vector3d;
using geometry::XmlAttributes;

constexpr double kMmInMetre = 1000.0;
constexpr double kLargest = 1e6; // [m], [rad], or a scale

Vector3d vectorOf(const XmlAttributes& attributes, std::string_view word,
                  const Vector3d& otherwise) {
  if (!attributes.has(word))
    return otherwise;
  std::vector<std::string_view> words;
  geometry::LineScanner line(attributes.text(word));
  line.nextFilledLine(words);
  Vector3d vector;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto number = words.size() == 3 ? geometry::numberOf(words[i]) : std::nullopt;
    if (!number || !std::isfinite(*number))
      throw Error(ErrorCode::UnreadableFile,
                  base::message("'{attribute}' must be three numbers: '{text}'"_text, word,
                                attributes.text(word)));
    if (std::abs(*number) > kLargest)
      throw Error(ErrorCode::UnreadableFile,
                  base::message("'{attribute}' is NaN or out of range: '{text}'"_text, word,
                                attributes.text(word)));
    vector[static_cast<Eigen::Index>(i)] = *number;
  }
  return vector;
}

Eigen::Isometry3d poseOf(const XmlAttributes& attributes) {
  const Vector3d xyz = vectorOf(attributes, "xyz", Vector3d::Zero());
  const Vector3d rpy = vectorOf(attributes, "rpy", Vector3d::Zero());
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = (Eigen::AngleAxisd(rpy.z(), Vector3d::UnitZ()) *
                   Eigen::AngleAxisd(rpy.y(), Vector3d::UnitY()) *
                   Eigen::AngleAxisd(rpy.x(), Vector3d::UnitX()))
                      .toRotationMatrix();
  pose.translation() = kMmInMetre * xyz;
  return pose;
}

std::string nameIn(const XmlAttributes& attributes, std::string_view word) {
  const std::string_view name = attributes.text(word);
  if (name.empty())
    throw Error(ErrorCode::UnreadableFile, base::message("'{attribute}' is missing"_text, word));
  return std::string(name);
}

// Handles elements by the path that leads to them; elements with other paths are ignored.
class Builder {
public:
  void begin(const geometry::XmlName& name, const XmlAttributes& attributes) {
    if (name.space.find("xacro") != std::string_view::npos)
      throw Error(ErrorCode::UnreadableFile, "is a xacro file"_text, {},
                  "expand it first: xacro FILE > arm.urdf"_text);
    path_ += "/" + std::string(name.word);
    if (!path_.starts_with("/robot"))
      throw Error(ErrorCode::UnreadableFile,
                  base::message("is not a URDF: it begins with <{element}>"_text, name.word));
    if (path_ == "/robot")
      tree.name = attributes.text("name");
    else if (path_ == "/robot/link")
      tree.links.push_back({nameIn(attributes, "name"), {}, {}, {}});
    else if (path_.starts_with("/robot/link/collision"))
      solid(path_.substr(std::string_view("/robot/link/collision").size()), attributes);
    else if (path_.starts_with("/robot/link/visual"))
      solid(path_.substr(std::string_view("/robot/link/visual").size()), attributes);
    else if (path_ == "/robot/joint")
      tree.joints.push_back({.name = nameIn(attributes, "name"),
                             .type = nameIn(attributes, "type"),
                             .parent = {},
                             .child = {},
                             .limit = {},
                             .softLimit = {},
                             .follows = {}});
    else if (path_.starts_with("/robot/joint/"))
      joint(path_.substr(std::string_view("/robot/joint/").size()), attributes, tree.joints.back());
  }
  void end(const geometry::XmlName& name) {
    path_.resize(path_.size() - name.word.size() - 1);
    // Pose and shape may come in either order.
    if (path_ == "/robot/link" && (name.word == "collision" || name.word == "visual") && shape_) {
      UrdfLink& link = tree.links.back();
      (name.word == "collision" ? link.collision : link.visual).push_back({pose_, *shape_});
    }
  }

  UrdfTree tree;

private:
  void solid(const std::string& at, const XmlAttributes& attributes) {
    if (at.empty()) {
      pose_.setIdentity();
      shape_.reset();
    } else if (at == "/origin")
      pose_ = poseOf(attributes);
    else if (at == "/geometry/box")
      shape_ = UrdfBox{kMmInMetre * vectorOf(attributes, "size", Vector3d::Zero())};
    else if (at == "/geometry/cylinder")
      shape_ = UrdfCylinder{kMmInMetre * attributes.number("radius"),
                            kMmInMetre * attributes.number("length")};
    else if (at == "/geometry/sphere")
      shape_ = UrdfSphere{kMmInMetre * attributes.number("radius")};
    else if (at == "/geometry/mesh")
      shape_ =
          UrdfMesh{nameIn(attributes, "filename"), vectorOf(attributes, "scale", Vector3d::Ones())};
    else if (constexpr std::string_view kShape = "/geometry/";
             at.starts_with(kShape) && at.find('/', kShape.size()) == std::string::npos)
      tree.links.back().unknownShapes.push_back(at.substr(kShape.size()));
  }
  static void joint(const std::string& at, const XmlAttributes& attributes, UrdfJoint& joint) {
    if (at == "origin")
      joint.parent_T_joint = poseOf(attributes);
    else if (at == "parent")
      joint.parent = nameIn(attributes, "link");
    else if (at == "child")
      joint.child = nameIn(attributes, "link");
    else if (at == "axis")
      joint.axis = vectorOf(attributes, "xyz", Vector3d::UnitX());
    else if (at == "limit")
      joint.limit = UrdfLimit{attributes.numberOr("lower", 0.0), attributes.numberOr("upper", 0.0),
                              attributes.numberOr("velocity", 0.0)};
    else if (at == "safety_controller" &&
             (attributes.has("soft_lower_limit") || attributes.has("soft_upper_limit")))
      joint.softLimit = UrdfSoftLimit{attributes.numberOr("soft_lower_limit", 0.0),
                                      attributes.numberOr("soft_upper_limit", 0.0)};
    else if (at == "mimic")
      joint.follows = nameIn(attributes, "joint");
  }

  std::string path_;
  Eigen::Isometry3d pose_ = Eigen::Isometry3d::Identity();
  std::optional<decltype(UrdfSolid::shape)> shape_;
};

} // namespace

UrdfTree readUrdfTree(const std::filesystem::path& file) {
  Builder builder;
  geometry::XmlHandler handler;
  handler.begin = [&](const geometry::XmlName& name, const XmlAttributes& attributes) {
    builder.begin(name, attributes);
  };
  handler.end = [&](const geometry::XmlName& name) { builder.end(name); };
  geometry::scanXml(base::readFile(file), file.filename().string(), handler);
  return std::move(builder.tree);
}

} // namespace voluta::robot
