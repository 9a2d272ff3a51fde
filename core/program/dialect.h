// The registry of program formats: one row per dialect, each with its writer and its reader
// (docs/design.md, Programs). To add a dialect, add a file and a row.
//
// Common to all writers: they share one walk over the trajectory (program/common/walk.h); the same
// input gives the same bytes. Each line has one motion, and each Trajectory point one program
// motion, in order, so that a verifier can match them one to one; before it there may be the pieces
// of a joint motion that the dialect cannot express. The start, prime and end sequences add outputs
// and waits, never motions with a target. When read back, a target is within 0.001 mm at the nozzle
// and 1e-5 rad of the trajectory's, a motion's volume within 0.1 % (for motions that deposit at
// least 0.05 mm3), and its time within kFlowBand.
#pragma once

#include "base/error.h"
#include "base/run_context.h"
#include "base/text.h"
#include "plan/program.h"
#include "plan/stated_facts.h"
#include "program/common/program_text.h"
#include "program/merged_points.h"
#include "program/program_input.h"

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

// How the controller moves between the Cartesian targets of a bead.
enum class Straight {
  OnPart, // the nozzle's tip straight on the part
  InBase, // the TCP straight in Base
  Pieces  // by rows or axes of its own: points cannot be omitted
};

struct Dialect {
  std::string_view id;
  base::Text label;
  std::string_view extension;  // without the dot
  std::string_view controller; // the RobotModel::controller it is native to; empty: any robot
  // its targets are joint values and therefore specific to the cell's robot
  bool needsJoints = false;
  // It has no straight motions: beads too are joint motions between points at constant speed.
  bool beadsByJoints = false;
  Straight straight = Straight::OnPart;
  bool hasArcs = false; // has circular motions
  // otherwise joint motions are written as straight pieces (joint_pieces.h)
  bool saysJointMotions = true;
  bool supportsExternalAxes = true; // can state positions of external axes, or poses on the part
  // whether it can state those of this cell although it does not support all; nullptr: no
  bool (*supportsAxesOf)(const robot::Cell&) = nullptr;
  bool tiltsNozzle = true;    // can state directions other than the plate's normal
  bool showsTexts = false;    // its stops show the operator a text
  bool sendsTexts = false;    // not on the pendant, but where the program is sent from
  bool waitsByMotion = false; // a wait is a point of a motion: it has none before the first one
  std::vector<plan::EventKind> events = {}; // that it has words for
  plan::TimeModel time = {};                // of its controller; readProgram passes it on
  MergeLimits merge = {}; // minimum printing motions that its controller can plan in time
  // Ids of the supported program::extruders(); empty: its motions state amounts themselves.
  std::vector<std::string_view> extruders = {};
  // written together with the cell's own format if the user chooses no formats
  bool forAnyCell = false;
  // The user's options for its text; nullptr: none. Dialects may share an option.
  std::vector<base::ParameterSpec> (*options)() = nullptr;
  // Statements its programs contain before anything moves or flows; readProgram passes them on.
  std::vector<plan::FactKind> states = {};
  // The maximum of its flow output, as stated in the head; empty: it has none.
  std::string_view fullFlowAt = {};
  // Returns the mechanical units that a program for this cell may name, in small letters; nullptr:
  // the language has no names for them.
  std::vector<std::string> (*units)(const robot::Cell&) = nullptr;
  // Returns the configuration flags of its targets; nullptr: the language has none, or nothing
  // depends on them.
  plan::ArmPosture (*posture)(const robot::Cell&, bool foreign, const double* joints) = nullptr;
  // Limits of its controller: characters per line, and per quoted text. 0: no known limit.
  std::size_t longestLine = 0, longestText = 0;
  // Throws Error{Internal} (preconditions of ProgramInput), Cancelled.
  plan::Program (*write)(const ProgramInput&, const base::RunContext&) = nullptr;
  // Never throws because of the text: whatever is not understood is a defect with its line, and the
  // result contains the remaining motions. At most kMaxDefects defects are listed. Throws
  // Cancelled.
  plan::ReadProgram (*read)(const std::vector<plan::ProgramFile>&, const process::Tooling&,
                            const base::RunContext&) = nullptr;
  // Returns whether the beginning of a text looks like this dialect.
  bool (*looksLike)(std::string_view text) = nullptr;
  // Returns the names of neighbouring files that continue a file of a program; nullptr: programs
  // are single files.
  std::vector<std::string> (*continuationFiles)(std::string_view text) = nullptr;
  // Returns whether a file of a program is binary data that the dialect's reader understands;
  // nullptr: all files are texts.
  bool (*isBinary)(std::string_view bytes) = nullptr;
  // Returns whether this is a reserved word of the language, which a program must not use as a
  // name; nullptr: programs of this dialect name nothing.
  bool (*isWord)(std::string_view name) = nullptr;
  // For tests that damage texts: the prefix of comment lines, and whether line i of a text may be
  // missing without changing the program's effect, although it is no comment (loads, heating,
  // redundant settings); nullptr: there are no such lines.
  std::string_view remark;
  bool (*mayBeMissing)(const std::vector<std::string>& lines, std::size_t i) = nullptr;
};

// In the order in which formats are listed.
const std::vector<Dialect>& dialects();
// Throws Error{Usage} for an unknown id, naming the most similar one.
const Dialect& findDialect(std::string_view id);
// Returns the dialect of a file, detected from its text, or from the file name's extension if the
// text is ambiguous; nullptr if there is none.
const Dialect* detectDialect(std::string_view fileName, std::string_view text);

// Returns the names of neighbouring files that continue a file of a program: those of
// Dialect::continuationFiles, and an extruder stream.
std::vector<std::string> continuationFiles(const Dialect& dialect, std::string_view text);

// The options of one dialect; those of all rows, without duplicates; and the chosen values of the
// latter. The last one throws nothing if `values` belong to a table with programParameters().
std::vector<base::ParameterSpec> optionsOf(const Dialect& dialect);
base::ParameterTable programParameters();
ProgramOptions programOptions(const base::ParameterValues& values);

// Returns whether a program in this dialect is foreign to the cell: Cartesian, for another
// controller.
bool isForeign(const Dialect& dialect, const robot::Cell& cell);

// Returns whether the program in dialect `id`, out of those written in `formats`, can block a plan.
// A program for another controller, which may be unable to express a motion at all, cannot if there
// is one for the cell's own robot or for any player of joint values.
bool decidesOnPlan(std::string_view id, const std::vector<std::string>& formats,
                   const robot::Cell& cell);

// Throws Error{Usage} if the dialect states joints and the cell has another maker's arm.
void requireOwnRobot(const Dialect& dialect, const robot::Cell& cell);

// Throws Error{Usage} if the cell has external axes and the dialect supports none, or no sliding
// ones.
void requireRodTurns(const Dialect& dialect, const robot::Cell& cell);

// A nozzle closer to the plate's normal than this counts as upright.
inline constexpr double kUprightRad = 1e-3;
// Throws Error{Usage} if one of the nozzle's directions on the part is tilted and the dialect
// cannot express it.
void requireUpright(const Dialect& dialect, std::span<const Eigen::Vector3d> directions);

// Returns the name of an event within a sentence, e.g. "a tool change".
base::Text nameOf(plan::EventKind kind);
// Returns whether the dialect has a word for it.
bool hasWordFor(const Dialect& dialect, plan::EventKind kind);
// Returns whether programs leave such an event out because the dialect has no word for it: a purge
// that is not that of a tool change primes the nozzle, which the operator then does.
bool leavesOut(const Dialect& dialect, plan::EventKind kind);
// Throws Error{Usage} if the trajectory has an event that the dialect has no word for, or begins
// with another tool than the first and the dialect cannot select one.
void requireEvents(const Dialect& dialect, const plan::Trajectory& trajectory);

// Returns the error that one of the functions above throws for this cell, these directions (empty:
// not known yet) and this trajectory (null: not known yet), or nullopt if the dialect can express
// all of them.
std::optional<base::Error> refusal(const Dialect& dialect, const robot::Cell& cell,
                                   std::span<const Eigen::Vector3d> directions,
                                   const plan::Trajectory* trajectory = nullptr);

// Returns the trajectory as a program of this dialect expresses it: the writer's input and the
// verifier's reference.
MergedPoints pointsFor(std::string_view id, const ProgramInput& input,
                       const base::RunContext& ctx = {});

// Calls findDialect(id).write / .read; the read program's `format` is the dialect's id. Writing
// also throws as requireOwnRobot, requireRodTurns and requireEvents, and as requireUpright for
// motions that are not joint moves; it uses the dialect's own options only.
// Example:
//   const program::ProgramInput input{toolPlan, trajectory, cell, tooling, "part"};
//   const plan::Program program = program::writeProgram("urscript", input, ctx);
//   const plan::ReadProgram read = program::readProgram("urscript", program.files, tooling, ctx);
plan::Program writeProgram(std::string_view id, const ProgramInput& input,
                           const base::RunContext& ctx = {});
plan::ReadProgram readProgram(std::string_view id, const std::vector<plan::ProgramFile>& files,
                              const process::Tooling& tooling, const base::RunContext& ctx = {});

} // namespace voluta::program
