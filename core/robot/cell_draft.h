// A cell's file during editing (its keys: robot/cell/cell_reader.cpp). A value type: every edit
// returns a new draft, so that the previous one can be kept. It need not be a valid cell;
// Cell::readText() reports its errors. Keys that no edit concerns stay unchanged.
#pragma once

#include "robot/cell.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace voluta::robot {

// An item with a frame of its own in a cell's file.
struct DraftBody {
  enum class Kind { Nozzle, Platform, PurgePlace, Axis, Obstacle };
  Kind kind = Kind::Nozzle;
  std::size_t index = 0; // among the axes, or the obstacles
  std::string name;      // of an axis or obstacle
  // In the flange (bodies on the arm), the base (fixed bodies), the axis before it, or the last
  // axis (a platform that axes carry). An obstacle's is its own, or else that of its first shape. A
  // place for purges has no rotation.
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  bool onFlange = false;
  bool underRobot = false; // an axis that carries the robot
  // Edge lengths of an obstacle that is a single box [mm].
  std::optional<Eigen::Vector3d> sizeMm = {};

  bool sameAs(const DraftBody& other) const { return kind == other.kind && index == other.index; }
};

class CellDraft {
public:
  // Throws Error{UnreadableFile, UnusableInput} if the text is not the JSON of a cell, regardless
  // of its values.
  explicit CellDraft(std::string text);

  const std::string& text() const { return text_; }
  std::string id() const;
  std::string label() const;
  std::string robot() const;
  std::string extruder() const;            // default "outputs"
  std::optional<double> carriedKg() const; // none: assumed
  // Returns nozzle, platform, place for purges if there is one, axes from the base on, obstacles.
  std::vector<DraftBody> bodies() const;

  CellDraft named(const std::string& id, const std::string& label) const;
  // Replaces the arm at the same place. The home joints are kept as far as its limits allow (0 for
  // additional ones); pairs without check are dropped if they name missing links, and the travel
  // acceleration if it exceeds the new arm's.
  CellDraft withRobot(const RobotModel& robot) const;
  CellDraft withExtruder(const std::string& id) const;
  CellDraft withCarriedKg(double kg) const;
  // rad, mm; one value per joint of the arm.
  CellDraft withHome(const JointVector& armJoints, const std::vector<JointLimits>& limits) const;
  // Adds the place for purges [mm, in the world], or moves it there.
  CellDraft withPurgePlace(const Eigen::Vector3d& worldMm) const;
  // Moves the body to the pose; an obstacle with all its shapes, the place for purges without the
  // rotation.
  CellDraft withPose(const DraftBody& body, const Eigen::Isometry3d& pose) const;
  // Preconditions: an obstacle that is a single box; edges > 0.
  CellDraft withSize(const DraftBody& box, const Eigen::Vector3d& sizeMm) const;
  // Adds an obstacle in the base's frame, named `name` or, if that is taken, `name` with a number.
  CellDraft withBox(const std::string& name, const Eigen::Isometry3d& pose,
                    const Eigen::Vector3d& sizeMm) const;
  // The solids are in the obstacle's own frame. Preconditions: at least one, no prism.
  CellDraft withSolids(const std::string& name, const Eigen::Isometry3d& pose,
                       const std::vector<Shape>& shapes) const;
  // Removes an obstacle and the pairs that name it, or the place for purges. Precondition: one of
  // them.
  CellDraft without(const DraftBody& body) const;

  friend bool operator==(const CellDraft& a, const CellDraft& b) { return a.text_ == b.text_; }

private:
  std::string text_;
};

// `choice`: an id, or the text of a cell's file. Throws Error{Usage} if no cell has that id, naming
// the nearest.
CellDraft draftOfCell(const std::string& choice);

// Returns whether the program ships a cell with that id.
bool isShippedCell(const std::string& id);
// Returns the file of the user's own cell with that id. Throws Error{Usage} if there is no folder
// for it, a shipped cell has that id, or the id has other characters than letters, digits, dashes
// and dots.
std::filesystem::path ownCellFile(const std::string& id);
// Writes the draft completely or not at all, creating the folder, and returns the file. Throws as
// ownCellFile(); Error{CannotWrite}.
std::filesystem::path saveOwnCell(const CellDraft& draft);

} // namespace voluta::robot
