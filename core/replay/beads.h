// From an executed program to pieces of bead, and what they rest on.
#pragma once

#include "plan/program.h"
#include "plan/tool_plan.h"
#include "plan/trajectory.h"
#include "replay/depositor.h"
#include "replay/executed_path.h"
#include "replay/ground.h"
#include "replay/printed_part.h"

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::replay {

// What a program's text does not say of a motion's bead and its plan does.
struct BeadKnowledge {
  float fromHeightMm = 0.0f, toHeightMm = 0.0f;
  bool ofPart = true; // false: support, skirt or prime
  bool waste = false; // skirt or prime: whether it rests on anything is nobody's concern
};

// Material of a motion that takes so long, mm3: the amount that the text gives, else flow x time; 0
// when not extruding.
double motionVolume(const plan::ProgramMotion& motion, double seconds);
// Of motion m, as long as it takes by its text.
double motionVolume(const plan::ReadProgram& program, const ExecutedPath& path, std::size_t m);

// Per motion, from the points it was matched to (alignment.h: pointOf). A motion without a point
// goes on with the height of the one before it; `defaultHeightMm` where there was none.
std::vector<BeadKnowledge> beadKnowledge(const std::vector<std::size_t>& pointOf,
                                         const plan::Trajectory& trajectory,
                                         const plan::ToolPlan& plan, double defaultHeightMm);

// Straight pieces of about a millimetre over the samples of every extruding motion, volume by
// length. A motion that extrudes on the spot gives a piece without length (which the depositor
// counts as excess).
// Precondition: volume (motionVolume) and knowledge per motion.
std::vector<BeadPiece> beadPieces(const std::vector<double>& volumeMm3, const ExecutedPath& path,
                                  const std::vector<BeadKnowledge>& knowledge);

// Waste that is laid over nothing before anything else is, falls: takes it out of the pieces.
void dropFallen(std::vector<BeadPiece>& pieces, const GroundProbe& ground);

// What is asked of a piece once it is laid and judged.
struct LaidPiece {
  std::uint32_t motion = 0, run = 0;
  float runMm = 0.0f;    // as of the piece
  float recentMm = 0.0f; // of its bead, still soft under the nozzle at its end: two widths
};
// Widths as sectionOf() has them.
std::vector<LaidPiece> laidPieces(const std::vector<BeadPiece>& pieces, double widthMaxMm);

// The index of the first piece of motion m or of a later one; motions + 1 entries.
std::vector<std::uint32_t> firstPieceOfMotions(const std::vector<LaidPiece>& pieces,
                                               std::size_t motions);

struct SupportedBeads {
  double lengthMm = 0.0, unsupportedMm = 0.0;
  double halfCarriedMm = 0.0;             // carried on less than half their width
  std::vector<std::uint32_t> unsupported; // pieces, in order
  // The longest stretch of one bead that is carried on none of its width, and its first piece.
  double longestUnsupportedMm = 0.0;
  std::uint32_t longestFrom = 0;
  // First piece of the longest run of unsupported pieces, and of half-carried ones.
  std::optional<std::uint32_t> unsupportedFrom, halfCarriedFrom;
};

// A piece is supported where, at its middle, the ground or material laid before lies beneath the
// bead within 1.25 heights of the tip: looked for at depths of 1.05 to 1.25 heights below the tip,
// up to 0.7 heights aside (a cone of 35 degrees about the build direction; what lies beside the
// bead in its own layer is no support). Stricter, it is carried where the ground or such material
// lies right beneath: looked for at eight places across its width, 1.05 to 1.25 heights below the
// tip. What the same bead laid over its last 3 mm or two widths does not count. Waste is not looked
// at. Throws Cancelled.
SupportedBeads findSupport(const std::vector<BeadPiece>& pieces, const PrintedPart& printed,
                           const GroundProbe& ground, const base::RunContext& ctx);

} // namespace voluta::replay
