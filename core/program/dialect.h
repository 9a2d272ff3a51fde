// The registry of program formats: one row a dialect, each with its writer and its reader
// (docs/design.md, Programs). A new dialect is a file and a row.
//
// Common to all writers: they spell one walk over the trajectory (program/common/walk.h); the same
// input gives the same bytes; one motion a line; one program motion for each Trajectory point, in
// order, so that a verifier can match them one to one, and before it the pieces of a joint motion
// that a dialect cannot say. What the start, prime and end sequences add are outputs and waits,
// never motions with a target. A target that is read back is within 0.001 mm at the nozzle and 1e-5
// rad of the trajectory's, a motion's volume within 0.1 % (of motions that lay 0.05 mm3 or more),
// its time within kFlowBand.
#pragma once

#include "base/error.h"
#include "base/run_context.h"
#include "base/text.h"
#include "plan/program.h"
#include "plan/stated_facts.h"
#include "program/common/text.h"
#include "program/merged_points.h"
#include "program/program_input.h"

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

struct Dialect {
  std::string_view id;
  base::Text label;
  std::string_view extension;  // without the dot
  std::string_view controller; // RobotModel::controller it is native to; empty: any robot's
  bool needsJoints = false;    // its targets are joint values, so it is bound to the cell's robot
  // It goes straight nowhere: beads are joints at a steady speed between points, too.
  bool beadsByJoints = false;
  bool saysJointMotions = true;     // else they come in straight pieces (joint_pieces.h)
  bool supportsExternalAxes = true; // can it say where an external axis is, or what is on the part
  bool tiltsNozzle = true;          // can it say another direction than the plate's normal
  std::vector<plan::EventKind> events = {}; // that it has words for
  plan::TimeModel time = {};                // of its controller; readProgram hands it on
  MergeLimits merge = {}; // of printing motions that its controller can plan in time
  // Ids of program::extruders() that it has words for; empty: its motions tell amounts themselves.
  std::vector<std::string_view> extruders = {};
  bool forAnyCell = false; // written beside the cell's own where the user chooses no formats
  // What the user may choose about its text; nullptr: nothing. Dialects may share an option.
  std::vector<base::ParameterSpec> (*options)() = nullptr;
  // What its programs state before anything moves or flows; readProgram hands it on.
  std::vector<plan::FactKind> states = {};
  // The greatest value of its flow output, as the head says it; empty: it has none.
  std::string_view fullFlowAt = {};
  // The mechanical units that a program for this cell may name, in small letters; nullptr: the
  // language has no names for them.
  std::vector<std::string> (*units)(const robot::Cell&) = nullptr;
  // The flags that its targets have; nullptr: the language has none, or nothing depends on them.
  plan::ArmPosture (*posture)(const robot::Cell&, bool foreign, const double* joints) = nullptr;
  // What its controller takes: characters of a line, and of a text in quotation marks. 0: no limit
  // is known.
  std::size_t longestLine = 0, longestText = 0;
  // Throws Error{Internal} (preconditions of ProgramInput), Cancelled.
  plan::Program (*write)(const ProgramInput&, const base::RunContext&) = nullptr;
  // Never throws on bad text: what makes no sense is a defect with its line, and the motions are
  // those that were understood. At most kMaxDefects defects are listed. Throws Cancelled.
  plan::ReadProgram (*read)(const std::vector<plan::ProgramFile>&, const process::Process&,
                            const base::RunContext&) = nullptr;
  // Does the beginning of a text look like this dialect?
  bool (*looksLike)(std::string_view text) = nullptr;
  // Names of the files, next to it, that a file of a program goes on in; nullptr: a dialect whose
  // files stand alone.
  std::vector<std::string> (*continuationFiles)(std::string_view text) = nullptr;
  // Is a file of a program no text, but what the dialect's reader knows? nullptr: all are texts.
  bool (*isBinary)(std::string_view bytes) = nullptr;
  // Is this a word of the language, which nothing in a program may be called by? nullptr: programs
  // of this dialect name nothing.
  bool (*isWord)(std::string_view name) = nullptr;
  // For the tests that damage texts. What a line that is only a remark begins with, and whether
  // line i of a text may be missing without a change of what the program does, though it is no
  // remark (loads, heat, what holds anyway); nullptr: no such line.
  std::string_view remark;
  bool (*mayBeMissing)(const std::vector<std::string>& lines, std::size_t i) = nullptr;
};

// In the order in which formats are listed.
const std::vector<Dialect>& dialects();
// Throws Error{Usage} for an unknown id, naming the nearest.
const Dialect& findDialect(std::string_view id);
// The dialect that a file is written in: by its text; where that leaves it open, by the extension
// of its name. nullptr: none.
const Dialect* detectDialect(std::string_view fileName, std::string_view text);

// Names of the files, next to it, that a file of a program goes on in: Dialect::continuationFiles,
// and a stream of filament.
std::vector<std::string> continuationFiles(const Dialect& dialect, std::string_view text);

// A dialect's options; all rows', each once; and what was chosen of the latter. The last throws
// nothing when `values` are over a table with programParameters().
std::vector<base::ParameterSpec> optionsOf(const Dialect& dialect);
base::ParameterTable programParameters();
ProgramOptions programOptions(const base::ParameterValues& values);

// Is a program in this dialect foreign to the cell: Cartesian, for another controller?
bool isForeign(const Dialect& dialect, const robot::Cell& cell);

// Does the program in dialect `id`, of those written in `formats`, decide on a plan? One for
// another controller, which may not be able to say a motion at all, does not where the cell's own
// robot, or any player of joints, has one.
bool decidesOnPlan(std::string_view id, const std::vector<std::string>& formats,
                   const robot::Cell& cell);

// Throws Error{Usage}: the dialect tells joints, and the cell has another maker's arm.
void requireOwnRobot(const Dialect& dialect, const robot::Cell& cell);

// Throws Error{Usage}: the cell has external axes and the dialect knows none, or none that slides.
void requireRodTurns(const Dialect& dialect, const robot::Cell& cell);

// Nearer to the plate's normal than this a nozzle counts as upright.
inline constexpr double kUprightRad = 1e-3;
// Throws Error{Usage}: one of the nozzle's directions on the part leans, and the dialect has no
// words for it.
void requireUpright(const Dialect& dialect, std::span<const Eigen::Vector3d> directions);

// Throws Error{Usage} if the trajectory has an event that the dialect has no word for.
void requireEvents(const Dialect& dialect, const plan::Trajectory& trajectory);

// Returns what one of the functions above throws for this cell, these directions (empty: not known
// yet) and this trajectory (null: not known yet); nullopt if the dialect can say all of them.
std::optional<base::Error> refusal(const Dialect& dialect, const robot::Cell& cell,
                                   std::span<const Eigen::Vector3d> directions,
                                   const plan::Trajectory* trajectory = nullptr);

// The trajectory as a program of this dialect says it: what it is written from, and held against.
MergedPoints pointsFor(std::string_view id, const ProgramInput& input,
                       const base::RunContext& ctx = {});

// findDialect(id).write / .read; the read program's `format` is the dialect's id. Writing throws as
// requireOwnRobot, requireRodTurns and requireEvents too, and as requireUpright where the nozzle
// does not go by joints; it heeds the dialect's own options only. Example:
//   const program::ProgramInput input{toolPlan, trajectory, cell, process, "part"};
//   const plan::Program program = program::writeProgram("urscript", input, ctx);
//   const plan::ReadProgram read = program::readProgram("urscript", program.files, process, ctx);
plan::Program writeProgram(std::string_view id, const ProgramInput& input,
                           const base::RunContext& ctx = {});
plan::ReadProgram readProgram(std::string_view id, const std::vector<plan::ProgramFile>& files,
                              const process::Process& process, const base::RunContext& ctx = {});

} // namespace voluta::program
