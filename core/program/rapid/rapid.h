// RAPID for ABB controllers (docs/programs.md; ABB, Technical reference manual, RAPID Instructions,
// Functions and Data types).
//
// Written: a module with the tool, the work object and `main`; CR LF ends every line. mm, degrees,
// seconds. One line per point:
//   Print, Linear: MoveL [[x,y,z],[q1,q2,q3,q4],[cf1,cf4,cf6,cfx],[9E9,...]],[v,...],zone: pose of
//   the TCP in the work object. Between two poses the controller moves the TCP straight and rotates
//   it the shortest way. v = TCP path / time; where the TCP hardly moves although the nozzle does
//   on the part, \T:= overrides v.
//   Joint: MoveAbsJ [[q1...q6],[9E9,...]] with \T:=; MoveJ to a pose in a program for another
//   maker's robot. The first point is approached at 50 mm/s, after a UIMsgBox that prompts the
//   operator.
//
// Moving nozzle: the robot holds the tool, work object = the work frame. Nozzle in the world: a
// stationary tool (robhold FALSE, its frame in world) and a work object held by the flange (robhold
// TRUE), so that path, speed and zones are those of the nozzle on the part. Configurations are not
// supervised (ConfL\Off, ConfJ\Off); cf1..cf6 are the plan's.
//
// External axes that move the part are one mechanical unit (the rod's name, or Cell::externalUnit):
// ActUnit, work object [FALSE,FALSE,"rod",...] with eax_a, eax_b and so on in degrees in every
// target, counting whole turns. Positions and speeds are then those on the part, and the controller
// moves the axes and the arm together. The unit's frame has z along the last axis
// (Cell::work_T_unit). Axes that carry the robot are a separate unit (Cell::robotUnit) and come
// first: ActUnit, eax_a in every target; world is the pose of the base with them at 0, and the base
// frame must be configured as moved by them. Further external axes, and all of them elsewhere, are
// 9E9. A controller stores a number in 24 bits: eax_a to 0.008 degrees beyond 364 turns, half of
// that below.
//
// The extruder is on while the digital output doExtruder is, with a flow of aoFlow (0..1) x
// the full flow; a motion that needs more than the full flow is slowed. Zones:
// TcpMotions::blendMm for position, orientation and external axes alike. Prime: as in URScript. An
// extruder that is an external axis (program/gcode/extruder_axis.h) uses the first eax that moves
// no part, of the mechanical unit "extruder", in every target; MoveExtJ moves it while the arm
// stops, zeroExtruder sets it to 0.
//
// A program of more than kMotionsPerModule points is split into modules of about that many, each
// cut where the extruder is off (or, if it never is, at a stop); the first one loads and runs them
// in turn. The .pgf, the controller's list of files to load, is the last file.
#pragma once

#include "base/run_context.h"
#include "plan/program.h"
#include "program/common/known_words.h"
#include "program/program_input.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

inline constexpr std::size_t kMotionsPerModule = 5000;

// Minimum duration of a motion that an IRC5 plans in time [s].
inline constexpr double kRapidMotionS = 0.02;

// motionsPerFile; rapidModules: .mod (IRC5, RobotWare 6) or .modx (OmniCore, RobotWare 7), by
// default according to the robot's controllerModel; rapidFlow: aoFlow is set where motions begin
// (TriggEquip), or is proportional to the TCP's actual speed (TriggSpeed): the share of the full
// flow per mm/s, from the beginning of a motion on.
base::ParameterSpec rapidModules();
base::ParameterSpec rapidFlow();
std::vector<base::ParameterSpec> rapidOptions();

plan::Program writeRapid(const ProgramInput& input, const base::RunContext& ctx);

// Supported: a module's declarations (tooldata, wobjdata, speeddata, zonedata, robtarget,
// jointtarget and their components as literals or by name, before their use; assignments),
// procedures without arguments called in turn from main, Offs, MoveL, MoveJ, MoveAbsJ, MoveExtJ of
// the extruder's axis, SetDO, SetAO, WaitTime, ConfL\Off, ConfJ\Off, ActUnit, DeactUnit,
// rapidWords(), Load, UnLoad and calls of loaded procedures; statements spanning several lines,
// comments, letters of either case, v5..v7000, z0..z200.
//
// Everything else is a defect, and so are line ends other than CR LF, external axes other than
// those from eax_a on that move the work object or, with an active unit, the robot, a quaternion
// that is not normalised, and a tool or work object that does not match the other. Targets in a
// work object that moves are UnitPose, in one held by the flange WorkPose, else FlangePose in
// world, with the axes that carry the robot. If rotating takes longer than the path (v_ori,
// v_reax), the motion's time is that of the rotation. `complete`: every module was ended and run,
// and the extruder's outputs are off after its last motion.
plan::ReadProgram readRapid(const std::vector<plan::ProgramFile>& files,
                            const process::Tooling& tooling, const base::RunContext& ctx);
// Other words that a program may contain, and where; all further words are refused.
std::span<const KnownWord> rapidWords();
bool looksLikeRapid(std::string_view text);
bool mayBeMissingInRapid(const std::vector<std::string>& lines, std::size_t i); // Of Dialect
// Returns the modules that a list (.pgf) names, or that a module loads.
std::vector<std::string> filesOfRapid(std::string_view text);

} // namespace voluta::program
