// A cell's file while it is edited (its keys: robot/cell/cell_reader.cpp). A value: every edit
// gives another one, so that what was before can be kept. It need not be a cell that works, nor one
// that can be read: Cell::readText() says what is wrong with it. What no edit touches stays as it
// is.
#pragma once

#include "robot/cell.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace voluta::robot {

// What has a frame of its own in a cell's file.
struct DraftBody {
  enum class Kind { Nozzle, Platform, Axis, Obstacle };
  Kind kind = Kind::Nozzle;
  std::size_t index = 0; // among the axes, or the obstacles
  std::string name;      // of an axis or obstacle
  // In the flange (what goes with the arm), the base (what stands), the axis before it or on the
  // last axis (a platform that axes carry). An obstacle's is its own, or else
  // that of its first shape.
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  bool onFlange = false;
  bool underRobot = false; // an axis that carries it
  // Of an obstacle that is one box: its edges, mm.
  std::optional<Eigen::Vector3d> sizeMm = {};

  bool sameAs(const DraftBody& other) const { return kind == other.kind && index == other.index; }
};

class CellDraft {
public:
  // Throws Error{UnreadableFile, UnusableInput} where it is not the JSON of a cell, whatever the
  // numbers in it.
  explicit CellDraft(std::string text);

  const std::string& text() const { return text_; }
  std::string id() const;
  std::string label() const;
  std::string robot() const;
  std::string extruder() const;            // "outputs" where it does not say
  std::optional<double> carriedKg() const; // none: assumed
  // Nozzle, platform, axes from the base on, obstacles.
  std::vector<DraftBody> bodies() const;

  CellDraft named(const std::string& id, const std::string& label) const;
  // Another arm at the same place: its joints at rest as near as its limits allow (0 for those that
  // the other one has not), pairs of bodies that need no check without those it has not, the
  // acceleration of travels only where it has as much.
  CellDraft withRobot(const RobotModel& robot) const;
  CellDraft withExtruder(const std::string& id) const;
  CellDraft withCarriedKg(double kg) const;
  // rad, mm; as many as the arm has joints.
  CellDraft withHome(const JointVector& armJoints, const std::vector<JointLimits>& limits) const;
  // The body there; an obstacle with all its shapes.
  CellDraft withPose(const DraftBody& body, const Eigen::Isometry3d& pose) const;
  // Preconditions: an obstacle that is one box; edges > 0.
  CellDraft withSize(const DraftBody& box, const Eigen::Vector3d& sizeMm) const;
  // An obstacle in the base's frame with a name that is free: `name`, or with a number behind it.
  CellDraft withBox(const std::string& name, const Eigen::Isometry3d& pose,
                    const Eigen::Vector3d& sizeMm) const;
  // The solids stand in a frame of the obstacle's own. Preconditions: some, none of them a prism.
  CellDraft withSolids(const std::string& name, const Eigen::Isometry3d& pose,
                       const std::vector<Shape>& shapes) const;
  // Precondition: an obstacle. Pairs with it need no check any more and are gone.
  CellDraft without(const DraftBody& obstacle) const;

  friend bool operator==(const CellDraft& a, const CellDraft& b) { return a.text_ == b.text_; }

private:
  std::string text_;
};

// `choice`: an id, or the text of a cell's file. Throws Error{Usage} where no cell has that id,
// naming the nearest.
CellDraft draftOfCell(const std::string& choice);

// Is there a cell of the program's own of that id?
bool isShippedCell(const std::string& id);
// Where the user's own cell of that id is kept. Throws Error{Usage}: no folder for it, an id that a
// cell of the program's own has, or that is not letters, digits, dashes and dots.
std::filesystem::path ownCellFile(const std::string& id);
// Writes it whole or not at all, making the folder, and gives the file. Throws as ownCellFile();
// Error{CannotWrite}.
std::filesystem::path saveOwnCell(const CellDraft& draft);

} // namespace voluta::robot
