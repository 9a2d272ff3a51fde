#include "robot/cell_draft.h"

#include "base/data_files.h"
#include "base/error.h"
#include "base/files.h"
#include "base/json_node.h"
#include "base/units.h"
#include "robot/cell/json_output.h"
#include "robot/cell/json_pose.h"
#include "robot/cell/shape_reader.h"
#include "robot/shape/shape_moves.h"

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>

namespace voluta::robot {

namespace {

using Json = nlohmann::ordered_json;
using Kind = DraftBody::Kind;

constexpr const char* kName = "cell.json"; // in error messages
constexpr const char* kPurgePlace = "purgeMm";

Json parsed(const std::string& text) {
  return Json::parse(text);
}

std::string textOf(const Json& json) {
  return json.dump(2) + "\n";
}

const char* keyOf(Kind kind) {
  switch (kind) {
  case Kind::Nozzle:
    return "nozzle";
  case Kind::Platform:
    return "platform";
  case Kind::PurgePlace:
    return kPurgePlace;
  case Kind::Axis:
    return "externalAxes";
  case Kind::Obstacle:
    break;
  }
  return "obstacles";
}

Json& entryOf(Json& cell, const DraftBody& body) {
  Json& entry = cell.at(keyOf(body.kind));
  return body.kind == Kind::Axis || body.kind == Kind::Obstacle ? entry.at(body.index) : entry;
}

Eigen::Isometry3d placeOf(const Shape& shape) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  if (const auto* box = std::get_if<Box>(&shape))
    return box->frame_T_box;
  if (const auto* capsule = std::get_if<Capsule>(&shape))
    pose.translation() = capsule->p0;
  if (const auto* frustum = std::get_if<Frustum>(&shape))
    pose.translation() = frustum->p0;
  return pose;
}

std::vector<Shape> shapesOf(const std::string& text, std::size_t obstacle) {
  return readShapes(
      base::JsonNode::parse(text, kName).at("obstacles").items().at(obstacle).at("shapes"));
}

// Drops the pairs that name a missing body.
void keepPairs(Json& cell, const std::function<bool(const std::string&)>& isThere) {
  if (!cell.contains("neverMeet"))
    return;
  Json kept = Json::array();
  for (const Json& row : cell.at("neverMeet"))
    if (isThere(row.at("pair").at(0)) && isThere(row.at("pair").at(1)))
      kept.push_back(row);
  cell["neverMeet"] = std::move(kept);
}

// Adds an obstacle with a free name. `how`: its other keys.
std::string withObstacle(const std::string& text, const std::string& name, const Json& how) {
  Json cell = parsed(text);
  std::set<std::string> taken{"holder", "head", "platform"};
  for (const Json& obstacle : cell.at("obstacles"))
    taken.insert(obstacle.at("name"));
  for (const Json& axis : cell.at("externalAxes"))
    for (const Json& body : axis.value("bodies", Json::array()))
      taken.insert(body.at("name"));
  try {
    for (const Body& link : loadRobot(cell.at("robot")).links)
      taken.insert(link.name);
  } catch (const base::Error&) {
    // An unknown robot: its link names are unknown, and the cell cannot be read anyway.
  }
  std::string free = name;
  for (int n = 2; taken.contains(free); ++n)
    free = name + " " + std::to_string(n);
  Json obstacle{{"name", free}};
  obstacle.update(how);
  cell.at("obstacles").push_back(std::move(obstacle));
  return textOf(cell);
}

} // namespace

CellDraft::CellDraft(std::string text) : text_(std::move(text)) {
  const base::JsonNode top = base::JsonNode::parse(text_, kName);
  for (const char* key : {"id", "label", "robot"})
    top.at(key).text();
  for (const char* key : {"nozzle", "platform"}) {
    top.at(key).at("mount").text();
    readPose(top.at(key).at("pose"));
  }
  for (const base::JsonNode& axis : top.at("externalAxes").items()) {
    axis.at("name").text();
    readPose(axis.at("pose"));
  }
  for (const base::JsonNode& obstacle : top.at("obstacles").items()) {
    obstacle.at("name").text();
    readShapes(obstacle.at("shapes"));
    if (obstacle.has("pose"))
      readPose(obstacle.at("pose"));
  }
  if (top.has(kPurgePlace))
    readVector3(top.at(kPurgePlace));
  if (top.has("extruder"))
    top.at("extruder").text();
  for (const char* key : {"carriedKg", "travelAccelerationDegPerS2"})
    if (top.has(key))
      top.at(key).number();
  for (const base::JsonNode& joint : top.at("homeDeg").items())
    joint.number();
  if (top.has("neverMeet"))
    for (const base::JsonNode& row : top.at("neverMeet").items()) {
      const std::vector<base::JsonNode> pair = row.at("pair").items();
      if (pair.size() != 2)
        row.at("pair").fail("must have two names"_text);
      for (const base::JsonNode& name : pair)
        name.text();
    }
}

std::string CellDraft::id() const {
  return parsed(text_).at("id");
}
std::string CellDraft::label() const {
  return parsed(text_).at("label");
}
std::string CellDraft::robot() const {
  return parsed(text_).at("robot");
}
std::string CellDraft::extruder() const {
  return parsed(text_).value("extruder", "outputs");
}
std::optional<double> CellDraft::carriedKg() const {
  const Json cell = parsed(text_);
  return cell.contains("carriedKg") ? std::optional(cell.at("carriedKg").get<double>())
                                    : std::nullopt;
}

std::vector<DraftBody> CellDraft::bodies() const {
  const base::JsonNode top = base::JsonNode::parse(text_, kName);
  std::vector<DraftBody> bodies;
  for (const Kind kind : {Kind::Nozzle, Kind::Platform}) {
    const base::JsonNode node = top.at(keyOf(kind));
    bodies.push_back({kind, 0, {}, readPose(node.at("pose")), node.at("mount").text() == "flange"});
  }
  if (top.has(kPurgePlace))
    bodies.push_back({Kind::PurgePlace,
                      0,
                      {},
                      Eigen::Isometry3d(Eigen::Translation3d(readVector3(top.at(kPurgePlace))))});
  const std::vector<base::JsonNode> axes = top.at("externalAxes").items();
  for (std::size_t i = 0; i < axes.size(); ++i) {
    bodies.push_back({Kind::Axis, i, axes[i].at("name").text(), readPose(axes[i].at("pose"))});
    bodies.back().underRobot = axes[i].has("carries") && axes[i].at("carries").text() == "robot";
  }
  const std::vector<base::JsonNode> obstacles = top.at("obstacles").items();
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    const std::vector<Shape> shapes = readShapes(obstacles[i].at("shapes"));
    const bool posed = obstacles[i].has("pose");
    DraftBody body{Kind::Obstacle, i, obstacles[i].at("name").text(),
                   posed ? readPose(obstacles[i].at("pose")) : placeOf(shapes.front())};
    if (const auto* box = std::get_if<Box>(&shapes.front()); box && shapes.size() == 1 && !posed)
      body.sizeMm = 2.0 * box->half;
    bodies.push_back(std::move(body));
  }
  return bodies;
}

CellDraft CellDraft::named(const std::string& id, const std::string& label) const {
  Json cell = parsed(text_);
  cell["id"] = id;
  cell["label"] = label;
  return CellDraft(textOf(cell));
}

CellDraft CellDraft::withRobot(const RobotModel& robot) const {
  Json cell = parsed(text_);
  Json home = Json::array();
  for (std::size_t i = 0; i < robot.limits.size(); ++i) {
    const JointLimits& limit = robot.limits[i];
    const double wanted = i < cell.at("homeDeg").size()
                              ? ofShownValue(limit.kind, cell.at("homeDeg").at(i).get<double>())
                              : 0.0;
    home.push_back(tidy(shownValue(limit.kind, std::clamp(wanted, limit.min, limit.max))));
  }
  std::set<std::string> oldLinks;
  try {
    for (const Body& link : loadRobot(cell.at("robot")).links)
      oldLinks.insert(link.name);
  } catch (const base::Error&) {
    // An unknown robot has no link names to remove.
  }
  std::set<std::string> links;
  for (const Body& link : robot.links)
    links.insert(link.name);
  keepPairs(cell, [&](const std::string& name) {
    return links.contains(name) || !oldLinks.contains(name);
  });
  // The acceleration given for the other arm may exceed this one's limits.
  constexpr const char* kTravel = "travelAccelerationDegPerS2";
  for (const JointLimits& limit : robot.limits)
    if (cell.contains(kTravel) &&
        cell.at(kTravel).get<double>() >
            base::radiansToDegrees(asAngle(limit.kind, limit.acceleration)))
      cell.erase(kTravel);
  cell["robot"] = robot.id;
  cell["homeDeg"] = std::move(home);
  return CellDraft(textOf(cell));
}

CellDraft CellDraft::withExtruder(const std::string& id) const {
  Json cell = parsed(text_);
  cell["extruder"] = id;
  return CellDraft(textOf(cell));
}

CellDraft CellDraft::withCarriedKg(double kg) const {
  Json cell = parsed(text_);
  cell["carriedKg"] = tidy(kg);
  return CellDraft(textOf(cell));
}

CellDraft CellDraft::withHome(const JointVector& armJoints,
                              const std::vector<JointLimits>& limits) const {
  base::require(static_cast<std::size_t>(armJoints.size()) <= limits.size(), "joints with limits");
  Json cell = parsed(text_), home = Json::array();
  for (Eigen::Index i = 0; i < armJoints.size(); ++i)
    home.push_back(tidy(shownValue(limits[static_cast<std::size_t>(i)].kind, armJoints[i])));
  cell["homeDeg"] = std::move(home);
  return CellDraft(textOf(cell));
}

CellDraft CellDraft::withPurgePlace(const Eigen::Vector3d& worldMm) const {
  Json cell = parsed(text_);
  cell[kPurgePlace] = vectorJson(worldMm);
  return CellDraft(textOf(cell));
}

CellDraft CellDraft::withPose(const DraftBody& body, const Eigen::Isometry3d& pose) const {
  if (body.kind == Kind::PurgePlace)
    return withPurgePlace(pose.translation());
  Json cell = parsed(text_);
  if (body.kind == Kind::Obstacle && !entryOf(cell, body).contains("pose")) {
    std::vector<Shape> shapes = shapesOf(text_, body.index);
    const Eigen::Isometry3d by = pose * placeOf(shapes.front()).inverse(Eigen::Isometry);
    for (Shape& shape : shapes)
      shape = moved(std::move(shape), by);
    entryOf(cell, body)["shapes"] = shapesJson(shapes);
  } else {
    entryOf(cell, body)["pose"] = poseJson(pose);
  }
  return CellDraft(textOf(cell));
}

CellDraft CellDraft::withSize(const DraftBody& box, const Eigen::Vector3d& sizeMm) const {
  base::require(box.sizeMm && sizeMm.minCoeff() > 0.0, "an obstacle that is one box, with edges");
  Json cell = parsed(text_);
  entryOf(cell, box)["shapes"] = shapesJson({Box{box.pose, 0.5 * sizeMm}});
  return CellDraft(textOf(cell));
}

CellDraft CellDraft::withBox(const std::string& name, const Eigen::Isometry3d& pose,
                             const Eigen::Vector3d& sizeMm) const {
  return CellDraft(withObstacle(text_, name, {{"shapes", shapesJson({Box{pose, 0.5 * sizeMm}})}}));
}

CellDraft CellDraft::withSolids(const std::string& name, const Eigen::Isometry3d& pose,
                                const std::vector<Shape>& shapes) const {
  base::require(!shapes.empty(), "an obstacle has a shape");
  return CellDraft(
      withObstacle(text_, name, {{"pose", poseJson(pose)}, {"shapes", shapesJson(shapes)}}));
}

CellDraft CellDraft::without(const DraftBody& body) const {
  base::require(body.kind == Kind::Obstacle || body.kind == Kind::PurgePlace,
                "an obstacle or the place for purges to take away");
  Json cell = parsed(text_);
  if (body.kind == Kind::PurgePlace) {
    cell.erase(kPurgePlace);
    return CellDraft(textOf(cell));
  }
  const std::string name = entryOf(cell, body).at("name");
  cell.at("obstacles").erase(body.index);
  keepPairs(cell, [&](const std::string& other) { return other != name; });
  return CellDraft(textOf(cell));
}

CellDraft draftOfCell(const std::string& choice) {
  return CellDraft(base::dataText("cells", choice, "unknown cell '{id}'"_text).text);
}

bool isShippedCell(const std::string& id) {
  std::error_code none;
  return std::filesystem::exists(base::resourceFolder() / "cells" / (id + ".json"), none);
}

std::filesystem::path ownCellFile(const std::string& id) {
  const auto allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || c == '.';
  };
  if (id.empty() || id.front() == '.' || !std::ranges::all_of(id, allowed))
    throw base::Error(base::ErrorCode::Usage,
                      base::message("'{id}' is not a valid cell name"_text, id), {},
                      "use letters, digits, dashes and dots"_text);
  if (isShippedCell(id))
    throw base::Error(base::ErrorCode::Usage, base::message("'{id}' is a built-in cell"_text, id),
                      {}, "choose another name"_text);
  const std::filesystem::path folder = base::userDataFolder();
  if (folder.empty())
    throw base::Error(base::ErrorCode::Usage, "no folder for user-defined cells"_text, {},
                      "set HOME, or VOLUTA_DATA to a folder"_text);
  return folder / "cells" / (id + ".json");
}

std::filesystem::path saveOwnCell(const CellDraft& draft) {
  const std::filesystem::path file = ownCellFile(draft.id());
  std::error_code failed;
  std::filesystem::create_directories(file.parent_path(), failed);
  if (failed)
    throw base::Error(base::ErrorCode::CannotWrite, base::message("{why}"_text, failed.message()),
                      file.parent_path().string());
  base::writeFile(file, draft.text());
  return file;
}

} // namespace voluta::robot
