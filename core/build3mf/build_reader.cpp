#include "build3mf/build_reader.h"

#include "base/error.h"
#include "base/lower_case.h"
#include "base/run_context.h"
#include "build3mf/build_layer_reader.h"
#include "build3mf/build_names.h"
#include "build3mf/build_profiles.h"
#include "geometry/formats/threemf_package.h"
#include "geometry/formats/xml_scan.h"
#include "geometry/formats/zip_package.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace voluta::build3mf {

using base::Error;
using base::ErrorCode;
using Eigen::Vector3d;
using geometry::XmlAttributes;
using geometry::XmlName;

namespace {

// Extensions that do not affect tool-paths, or are supported.
constexpr std::array<std::string_view, 3> kKnownSpaces{
    kProductionSpace, kToolpathSpace,
    "http://schemas.microsoft.com/3dmanufacturing/material/2015/02"};

struct Resource {
  double unitFactor = 1.0;
  std::string type = "planar";
  Profiles profiles;
  struct Layer {
    std::string path; // As given
    std::optional<long long> top;
  };
  std::vector<Layer> layers;
  long long bottom = 0; // Of the first layer, if they are planar
  bool workFrame = false;
};
struct Model {
  std::string unit = "millimeter";
  std::vector<std::pair<long long, Resource>> resources; // By id, in the file's order
  std::optional<long long> chosen;                       // By the build
  bool items = false;                                    // Whether the build uses an object
};

class ModelReader {
public:
  Model read(std::string_view text, const std::string& where) {
    geometry::XmlHandler handler;
    handler.begin = [&](XmlName name, const XmlAttributes& attributes) { begin(name, attributes); };
    handler.end = [&](XmlName name) { end(name); };
    handler.declares = [&](std::string_view prefix, std::string_view space) {
      spaces_[std::string(prefix)] = space;
    };
    handler.cdata = [&] {
      if (inData_ > 0)
        throw Error(ErrorCode::UnreadableFile, "unparsed text in a tool-path's data"_text);
    };
    geometry::scanXml(text, where, handler);
    return std::move(model_);
  }

private:
  void begin(XmlName name, const XmlAttributes& attributes) {
    if (inData_ > 0) {
      ++inData_;
      if (name == XmlName{kOwnSpace, "plan"} && attributes.text("frame") == "work")
        resource().workFrame = true;
      return;
    }
    if (name == XmlName{kCoreSpace, "model"}) {
      if (const std::string_view unit = attributes.text("unit"); !unit.empty())
        model_.unit = unit;
      require(attributes.text("requiredextensions"));
    } else if (name == XmlName{kCoreSpace, "build"}) {
      if (attributes.has("toolpathid", kToolpathSpace))
        model_.chosen = attributes.integer("toolpathid", kToolpathSpace);
    } else if (name == XmlName{kCoreSpace, "item"}) {
      model_.items = true;
    } else if (name.space == kToolpathSpace) {
      toolpath(name.word, attributes);
    }
  }

  void toolpath(std::string_view word, const XmlAttributes& attributes) {
    if (word == "toolpathresource") {
      model_.resources.emplace_back(attributes.integer("id"), Resource{});
      resource().unitFactor = attributes.number("unitfactor");
      if (!(resource().unitFactor > 0.0))
        throw Error(ErrorCode::UnreadableFile, "'unitfactor' is not above 0"_text);
      if (attributes.has("toolpathtype"))
        resource().type = attributes.text("toolpathtype");
      return;
    }
    if (model_.resources.empty())
      throw Error(ErrorCode::UnreadableFile,
                  base::message("'{element}' outside tool-paths"_text, word));
    if (word == "toolpathprofile") {
      const std::string uuid = base::lowerCase(attributes.text("uuid"));
      const auto [at, isNew] = resource().profiles.emplace(uuid, profileOf(attributes));
      if (!isNew)
        throw Error(ErrorCode::UnreadableFile,
                    base::message("duplicate profile '{uuid}'"_text, uuid));
      profile_ = &at->second;
    } else if (word == "modifier") {
      if (!profile_)
        throw Error(ErrorCode::UnreadableFile, "a modifier outside a profile"_text);
      addModifier(*profile_, attributes);
    } else if (word == "toolpathlayers") {
      if (attributes.has("zbottom"))
        resource().bottom = attributes.integer("zbottom");
    } else if (word == "toolpathlayer") {
      resource().layers.push_back({std::string(attributes.text("path")), std::nullopt});
      if (attributes.has("ztop"))
        resource().layers.back().top = attributes.integer("ztop");
    } else if (word == "toolpathdata") {
      inData_ = 1;
    }
  }

  void end(XmlName name) {
    if (inData_ > 0)
      --inData_;
    else if (name == XmlName{kToolpathSpace, "toolpathprofile"})
      profile_ = nullptr;
  }

  // `prefixes`: of extensions that readers must support.
  void require(std::string_view prefixes) const {
    while (!prefixes.empty()) {
      const std::size_t space = std::min(prefixes.find(' '), prefixes.size());
      const std::string prefix(prefixes.substr(0, space));
      prefixes.remove_prefix(std::min(space + 1, prefixes.size()));
      if (prefix.empty())
        continue;
      const auto declared = spaces_.find(prefix);
      const std::string extension = declared == spaces_.end() ? prefix : declared->second;
      if (std::find(kKnownSpaces.begin(), kKnownSpaces.end(), extension) == kKnownSpaces.end())
        throw Error(ErrorCode::UnreadableFile,
                    base::message("requires the unknown extension '{name}'"_text, extension));
    }
  }

  Resource& resource() { return model_.resources.back().second; }

  Model model_;
  std::map<std::string, std::string> spaces_; // By prefix
  Profile* profile_ = nullptr;                // Profile being read
  int inData_ = 0;                            // Nesting depth within other makers' data
};

const Resource& chosenResource(const Model& model, const std::string& where,
                               std::vector<base::Message>& notes) {
  if (model.resources.empty())
    throw Error(ErrorCode::UnusableInput, "contains no tool-paths"_text, where);
  if (model.chosen) {
    for (const auto& [id, resource] : model.resources)
      if (id == *model.chosen)
        return resource;
    throw Error(ErrorCode::UnreadableFile,
                base::message("the build's tool-paths {id} are missing"_text, *model.chosen),
                where);
  }
  if (model.resources.size() > 1)
    notes.push_back(base::message("the first of {count} sets of tool-paths was taken"_text,
                                  model.resources.size()));
  return model.resources.front().second;
}

// Throws Error{UnusableInput} if the resource contains nothing that a nozzle deposits.
PathAxes axesOf(const Resource& resource, const std::string& where) {
  if (resource.type == "6axis")
    return PathAxes::Six;
  if (resource.type == "3axis")
    return PathAxes::Three;
  // Laser tool-paths are planar too, but have no beads.
  const bool beads = std::ranges::any_of(resource.profiles, [](const auto& entry) {
    const auto& nominal = entry.second.nominal;
    return std::ranges::any_of(nominal, [](double value) { return value > 0.0; });
  });
  if (resource.type != "planar" || !beads)
    throw Error(
        ErrorCode::UnusableInput,
        base::message(
            "tool-paths of type '{type}' without beads; only beads from a nozzle are supported"_text,
            resource.type),
        where);
  return PathAxes::Planar;
}

// Returns the package member of an absolute path. Throws Error{UnreadableFile} if it is not
// absolute or leaves the package.
std::string layerMember(const std::string& path, const std::string& where) {
  const auto leaves = [](std::string_view rest) {
    while (!rest.empty()) {
      const std::size_t slash = std::min(rest.find('/'), rest.size());
      const std::string_view step = rest.substr(0, slash);
      if (step.empty() || step == "." || step == ".." || step.find('\\') != step.npos)
        return true;
      rest.remove_prefix(std::min(slash + 1, rest.size()));
    }
    return false;
  };
  if (!path.starts_with('/') || leaves(std::string_view(path).substr(1)))
    throw Error(ErrorCode::UnreadableFile,
                base::message("'{path}' is not the name of a part in the package"_text, path),
                where);
  return geometry::memberOf(path);
}

// Returns whether the directions point against the growth of the material. Tool frames with z into
// the part are as common as those with z out of it; the extension does not specify it.
bool looksInward(const plan::ToolPlan& plan) {
  struct Sum {
    Vector3d place = Vector3d::Zero(), direction = Vector3d::Zero();
    double count = 0.0;
  };
  std::map<int, Sum> layers;
  Sum all;
  for (const plan::ToolPath& path : plan.paths)
    for (std::size_t i = path.first; i < path.first + path.count; ++i)
      for (Sum* sum : {&layers[path.layer], &all}) {
        sum->place += plan.position[i];
        sum->direction += plan.direction[i];
        sum->count += 1.0;
      }
  double along = 0.0, length = 0.0;
  const Sum* before = nullptr;
  for (const auto& [layer, sum] : layers) {
    if (before) {
      const Vector3d step = sum.place / sum.count - before->place / before->count;
      along += step.dot((sum.direction + before->direction).normalized());
      length += step.norm();
    }
    before = &sum;
  }
  constexpr double kClear = 0.3; // Share of the path
  if (std::abs(along) > kClear * length)
    return along < 0.0;
  // Layers around one centre: outward is away from it.
  const Vector3d middle = all.place / std::max(all.count, 1.0);
  double out = 0.0, distance = 0.0;
  for (std::size_t i = 0; i < plan.waypointCount(); ++i) {
    out += (plan.position[i] - middle).dot(plan.direction[i]);
    distance += (plan.position[i] - middle).norm();
  }
  if (std::abs(out) > kClear * distance)
    return out < 0.0;
  return all.direction.z() < -kClear * all.count;
}

} // namespace

bool holdsToolpaths(std::string_view bytes) {
  if (!bytes.starts_with("PK"))
    return false;
  try {
    const std::string name;
    const geometry::ZipPackage package(bytes, name);
    const std::string model = package.member(geometry::mainModel(package, name));
    // A model that only declares the namespace has a mesh.
    return model.find(kToolpathSpace) != std::string::npos &&
           model.find("toolpathresource") != std::string::npos;
  } catch (const Error&) {
    return false; // The reader of its mesh reports the error
  }
}

ReadBuild readBuild(std::string_view bytes, const std::string& name, const base::RunContext& ctx) {
  const geometry::ZipPackage package(bytes, name);
  const std::string member = geometry::mainModel(package, name), where = name + ", " + member;
  const Model model = ModelReader().read(package.member(member), where);
  const std::optional<double> unit = geometry::threemfUnitMm(model.unit);
  if (!unit)
    throw Error(ErrorCode::UnreadableFile, base::message("unknown unit '{unit}'"_text, model.unit),
                where);
  ReadBuild read;
  const Resource& resource = chosenResource(model, where, read.notes);
  const PathAxes axes = axesOf(resource, where);
  read.workFrame = resource.workFrame;
  read.hasObject = model.items;
  const std::set<std::string> related = geometry::toolpathLayers(package, member, name);
  std::set<std::string> seen;
  long long below = resource.bottom;
  for (const auto& [path, top] : resource.layers) {
    ctx.checkpoint();
    const std::string layer = layerMember(path, where);
    if (axes == PathAxes::Planar && (!top || *top < below))
      throw Error(ErrorCode::UnreadableFile,
                  base::message("layer '{path}' has no height above the previous one"_text, path),
                  where);
    if (!related.contains(path))
      throw Error(ErrorCode::UnreadableFile,
                  base::message("layer '{path}' is not related to the model"_text, path), where);
    if (!seen.insert(layer).second)
      throw Error(ErrorCode::UnreadableFile, base::message("duplicate layer '{path}'"_text, path),
                  where);
    const double unitMm = resource.unitFactor * *unit;
    LayerFrame frame{resource.profiles, unitMm, axes, static_cast<int>(seen.size()) - 1};
    if (axes == PathAxes::Planar) {
      frame.topMm = unitMm * static_cast<double>(*top);
      frame.thicknessMm = unitMm * static_cast<double>(*top - std::exchange(below, *top));
    }
    readLayer(package.member(layer), name + ", " + layer, frame, read);
  }
  for (const std::string& path : related)
    if (!seen.contains(geometry::memberOf(path)))
      read.notes.push_back(base::message("not used: the layer '{path}', which is not in the list "
                                         "of layers"_text,
                                         path));
  if (read.plan.paths.empty())
    throw Error(ErrorCode::UnusableInput, "contains no tool-paths"_text, where);
  const auto waits = [](const auto& entry) { return entry.second.waits; };
  if (std::any_of(resource.profiles.begin(), resource.profiles.end(), waits))
    read.notes.emplace_back("waits before and after tool-paths are left out"_text);
  if (!read.workFrame && axes == PathAxes::Six && looksInward(read.plan)) {
    for (Vector3d& direction : read.plan.direction)
      direction = -direction;
    read.notes.emplace_back(
        "the frames of tool-paths point into the part; they were reversed"_text);
  }
  return read;
}

} // namespace voluta::build3mf
