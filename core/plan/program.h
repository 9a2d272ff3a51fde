// A robot program as data: the files that a writer makes and the motions that a reader finds in
// them.
#pragma once

#include "base/text.h"
#include "plan/stated_facts.h"
#include "plan/time_model.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace voluta::plan {

struct ProgramFile {
  std::string name; // File name without folder
  std::string text;
};

struct Program {
  std::string format;             // Id in the dialect registry
  bool foreign = false;           // Cartesian, for another maker's controller
  std::vector<ProgramFile> files; // To be run in this order
};

// How a motion's target is given.
enum class TargetKind : std::uint8_t {
  Joints, // Joint values [rad]; external axes follow the arm's
  // base_T_tcp with the TCP that the program sets (flange_T_tcp). If external axes carry the robot,
  // their values are given too, and the base is the one with these axes at 0.
  FlangePose,
  WorkPose, // work_T_tcp with that TCP, and the external axes that turn the work frame.
            // With a fixed nozzle (base_T_nozzle): the nozzle in the work object that the flange
            // holds.
  UnitPose, // As WorkPose, but in the frame moved by the last external axis, z along that axis
  ToolPoint // Nozzle tip and direction in the work frame (5 degrees of freedom)
};

// The nozzle in the work frame: tip [mm] and unit direction.
struct NozzlePoint {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
};

// One motion of a program that was read back. Small members are grouped, since a program has
// hundreds of thousands of motions.
struct ProgramMotion {
  std::uint32_t file = 0; // Index in Program::files
  std::uint32_t line = 0; // 1-based
  TargetKind target = TargetKind::Joints;
  // FlangePose, WorkPose: the sign of a SCARA's second joint; 0: not given.
  std::int8_t elbow = 0;
  bool jointInterpolated = false; // Between targets: linear in joint space, else straight
  // Part of a detour that returns to its start for the machine's own sake (unwinding a table). It
  // corresponds to no point of the plan.
  bool detour = false;
  bool extruding = false;     // Material flows during this motion
  bool trailing = false;      // The extruder is off already, and its stop lag feeds this motion
  std::uint8_t tool = 0;      // That deposits
  std::vector<double> joints; // Joints
  // WorkPose, UnitPose, FlangePose [rad]; values of sliding axes [mm] are converted as if they were
  // degrees
  std::vector<double> externals;
  // Intermediate nozzle points (ToolPoint) or TCP positions (poses, in the frame of frame_T_tcp)
  // between the previous target and this one, at equal steps of the motion's time. Given for arcs,
  // and if the machine turns the part while its axes move linearly. Empty: straight.
  std::vector<NozzlePoint> viaPoints;
  // FlangePose: relative to Base; WorkPose
  Eigen::Isometry3d frame_T_tcp = Eigen::Isometry3d::Identity();
  Eigen::Vector3d position = Eigen::Vector3d::Zero();   // ToolPoint [mm]
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ(); // ToolPoint, unit vector
  // Speed of the point that the target describes; 0: not given. FlangePose: the TCP in Base (with a
  // plate on the flange, that is the work frame's origin, not the nozzle on the part). WorkPose,
  // ToolPoint: the nozzle's tip in the work frame.
  double speedMmPerS = 0.0;
  double jointSpeedRadPerS = 0.0; // Joint-interpolated motions: leading joint; 0: not given
  // Duration, where the text gives it (it then overrides the speeds); 0: not given
  double durationS = 0.0;
  double accelerationMmPerS2 = 0.0;       // Goes with speedMmPerS; 0: not given
  double jointAccelerationRadPerS2 = 0.0; // Goes with jointSpeedRadPerS; 0: not given
  double blendMm = 0.0;                   // Radius of the blend at the end of the motion
  double flowMm3PerS = 0.0;               // Flow while extruding, in dialects that give a rate
  double volumeMm3 = -1.0; // Material of this motion, in dialects that give amounts; else -1
};

// A stop of the arm while the program continues: a wait, or filament fed or retracted on the spot.
struct ProgramPause {
  std::size_t file = 0, line = 0; // As in ProgramMotion
  std::size_t before = 0;         // Index of the next motion; motions.size(): none
  double durationS = 0.0;
  double volumeMm3 = 0.0; // Material extruded during the pause
  double drawnMm = 0.0;   // Filament retracted or returned during the pause
  int tool = 0;           // Whose material it is
  bool cuts = false;      // The tape's cutter is out meanwhile
};

// A motion of a machine's axes that has no place on the part: before the positions of all of them
// are known, on the way from the reference (homing) run to the start; or the turn of a table that
// is wound back.
struct ProgramApproach {
  std::size_t file = 0, line = 0;      // As in ProgramMotion
  std::optional<double> heightMm = {}; // Z behind it; nullopt: that of the reference run
  double mmPerS = 0.0, radPerS = 0.0;  // 0: it does not move so, or is no way to the start
};

// The payload that the program states.
struct ProgramLoad {
  std::size_t file = 0, line = 0;
  double kg = 0.0;
  std::optional<Eigen::Vector3d> centreMm; // Its centre of mass on the flange, where it is stated
};

// Text that the reader could not interpret, or an element missing at the end of the program.
struct ProgramDefect {
  std::size_t file = 0, line = 0; // 1-based
  base::Message reason;
};

// A position in a program's files.
struct ProgramPlace {
  std::size_t file = 0, line = 0; // file: 0-based; line: 1-based, 0: no particular line
};

struct ReadProgram {
  std::string format;
  Eigen::Isometry3d flange_T_tcp = Eigen::Isometry3d::Identity(); // As the program sets it
  // The fixed nozzle, as the program sets it; flange_T_tcp is then the frame of the work object.
  std::optional<Eigen::Isometry3d> base_T_nozzle;
  ProgramPlace nozzleAt; // Where the program sets the nozzle, or first moves relative to it
  std::vector<ProgramMotion> motions;
  // Index of the first motion that the text contains. Earlier motions were printed before a resumed
  // program begins.
  std::size_t firstMotion = 0;
  std::vector<ProgramApproach> approaches;
  // x and z of the plate's centre over the tilt axis of the table that carries it [mm]
  std::optional<Eigen::Vector2d> tableAxisMm;
  std::vector<ProgramPause> pauses; // In order
  bool tellsPauses = false;         // The language expresses pauses, so a prime can be found
  bool tellsDirections = true;      // The language expresses the nozzle's direction
  bool beadsByJoints = false;       // Joint speeds are constant between the points of a bead, too
  std::optional<ProgramLoad> load;
  std::vector<StatedFact> facts; // In order
  // Facts that a program of this language must state before it moves
  std::vector<FactKind> neededFacts;
  std::vector<StatedPosture> postures; // Of the motions whose text gives a posture; in order
  TimeModel time;                      // Of the dialect
  bool complete = false;               // The end sequence was found
  std::vector<ProgramDefect> defects;
};

} // namespace voluta::plan
