// A robot program as data: what a writer makes and what a reader finds in its text.
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
  std::string name; // file name without folder
  std::string text;
};

struct Program {
  std::string format;             // id in the dialect registry
  bool foreign = false;           // Cartesian, for a controller that is not the cell's own
  std::vector<ProgramFile> files; // to be run in this order
};

// What a motion's target is given in.
enum class TargetKind : std::uint8_t {
  Joints,     // joint values, radians, external axes behind the arm's
  FlangePose, // base_T_tcp with the TCP that the program sets (flange_T_tcp); where external axes
              // carry the robot they are told with it, and the base is where it stands with them
              // at 0
  WorkPose, // work_T_tcp with that TCP, and the external axes that turn the work frame; or, with a
            // fixed nozzle (base_T_nozzle), the nozzle in the work object that the flange holds
  UnitPose, // as WorkPose, but in the frame of what the last external axis moves, z along that axis
  ToolPoint // nozzle tip and direction in the work frame (5 degrees of freedom)
};

// Where the nozzle is in the work frame: its tip, mm, and its direction, unit.
struct NozzlePoint {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
};

// One motion of a program that was read back. There are hundreds of thousands of them: small
// members stand together.
struct ProgramMotion {
  std::uint32_t file = 0; // index in Program::files
  std::uint32_t line = 0; // 1-based
  TargetKind target = TargetKind::Joints;
  // FlangePose, WorkPose: which way a SCARA's second joint is to stand, by its sign; 0: not given.
  std::int8_t elbow = 0;
  bool jointInterpolated = false; // between targets: joints linear, else straight
  // Part of an excursion that leads back to where it began, for the machine's own sake (a table
  // that is wound back): no point of a plan is meant by it.
  bool aside = false;
  bool extruding = false;     // is the extruder on during this motion
  std::vector<double> joints; // Joints
  // WorkPose, UnitPose, FlangePose: radians; a slide's mm are taken for degrees
  std::vector<double> externals;
  // ToolPoint: where the nozzle passes between the last target and this one, at equal steps of the
  // motion's time, where it goes straight in the axes of a machine that turns the part, and not on
  // the part. Empty: straight on the part.
  std::vector<NozzlePoint> way;
  Eigen::Isometry3d frame_T_tcp = Eigen::Isometry3d::Identity(); // FlangePose: of Base; WorkPose
  Eigen::Vector3d position = Eigen::Vector3d::Zero();            // ToolPoint, mm
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();          // ToolPoint, unit
  // Speed of what the target describes: the TCP in Base (FlangePose: with a plate on the flange
  // that is the work frame's origin, not the nozzle on the part), the nozzle's tip in the work
  // frame (WorkPose, ToolPoint). 0: not given.
  double speedMmPerS = 0.0;
  double jointSpeedRadPerS = 0.0; // leading joint, joint-interpolated motions; 0: not given
  double durationS = 0.0; // time of this motion where the text gives it (then it rules, not the
                          // speeds); 0: not given
  double accelerationMmPerS2 = 0.0;       // with speedMmPerS; 0: not given
  double jointAccelerationRadPerS2 = 0.0; // with jointSpeedRadPerS; 0: not given
  double blendMm = 0.0;                   // radius of the blend at its end
  double flowMm3PerS = 0.0;               // flow while extruding, where the dialect gives a rate
  double volumeMm3 = -1.0; // material of this motion, where the dialect gives amounts; else -1
};

// The arm stands though the program goes on: a wait, or filament pushed or drawn on the spot.
struct ProgramPause {
  std::size_t file = 0, line = 0; // as of a motion
  std::size_t before = 0;         // the motion that follows; motions.size(): none
  double durationS = 0.0;
  double volumeMm3 = 0.0; // flows meanwhile
  double drawnMm = 0.0;   // filament that is drawn back or returned meanwhile
};

// What the program says that the arm carries.
struct ProgramLoad {
  std::size_t file = 0, line = 0;
  double kg = 0.0;
};

// Something in the text that the reader could not make sense of, or that is missing at its end.
struct ProgramDefect {
  std::size_t file = 0, line = 0; // 1-based
  base::Message reason;
};

// Where in its files a program says something.
struct ProgramPlace {
  std::size_t file = 0, line = 0; // from 0; 1-based, 0: nowhere in particular
};

struct ReadProgram {
  std::string format;
  Eigen::Isometry3d flange_T_tcp = Eigen::Isometry3d::Identity(); // as the program sets it
  // A nozzle that stands, as the program sets it; flange_T_tcp is then the work object's frame.
  std::optional<Eigen::Isometry3d> base_T_nozzle;
  ProgramPlace nozzleAt; // where it sets that, or first moves by it
  std::vector<ProgramMotion> motions;
  // Those before are not of the text: what was printed before it begins.
  std::size_t firstMotion = 0;
  std::vector<ProgramPause> pauses; // in order
  bool tellsPauses = false;         // the language has words for them, so a prime is to be found
  bool tellsDirections = true;      // the language has words for the nozzle's direction
  bool beadsByJoints = false;       // between points of a bead, too, the joints go at steady speeds
  std::optional<ProgramLoad> load;
  std::vector<StatedFact> facts;       // in order
  std::vector<FactKind> neededFacts;   // what a program of this language states before it moves
  std::vector<StatedPosture> postures; // of motions, where the text gives them; in order
  TimeModel time;                      // of the dialect
  bool complete = false;               // its end sequence was found
  std::vector<ProgramDefect> defects;
};

} // namespace voluta::plan
