// Conversion of an executed program to pieces of bead, and the test for their support.
#pragma once

#include "plan/program.h"
#include "plan/tool_plan.h"
#include "plan/trajectory.h"
#include "replay/depositor.h"
#include "replay/executed_path.h"
#include "replay/printed_part.h"
#include "replay/replay_ground.h"

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::replay {

// Properties of a motion's bead that the plan contains but the program text does not.
struct BeadKnowledge {
  float fromHeightMm = 0.0f, toHeightMm = 0.0f;
  bool ofPart = true; // false: support, skirt, prime or tape
  bool waste = false; // skirt or prime: its support is not checked
  std::uint8_t item = 0;
  bool tape = false; // of no plastic: thinner than the grid resolves, and not deposited
};

// Returns the material of a motion that takes `seconds` [mm3]: the amount given in the text,
// otherwise flow x time; 0 if the motion does not extrude.
double motionVolume(const plan::ProgramMotion& motion, double seconds);
// Same for motion m, with its duration by the text.
double motionVolume(const plan::ReadProgram& program, const ExecutedPath& path, std::size_t m);

// Returns the knowledge per motion, from the points the motions are matched to (alignment.h:
// pointOf). A motion without a point keeps the height of the preceding one, or `defaultHeightMm` if
// there is none.
std::vector<BeadKnowledge> beadKnowledge(const std::vector<std::size_t>& pointOf,
                                         const plan::Trajectory& trajectory,
                                         const plan::ToolPlan& plan, double defaultHeightMm);

// Splits the samples of every extruding motion into straight pieces of about 1 mm and distributes
// the volume by length. Tape gives no pieces. A motion that extrudes without moving gives a piece
// of zero length, which the depositor counts as excess. Precondition: volume (motionVolume) and
// knowledge per motion. `shotMm3`: per motion, volume that flows into a pocket where it ends;
// empty: none.
std::vector<BeadPiece> beadPieces(const std::vector<double>& volumeMm3, const ExecutedPath& path,
                                  const std::vector<BeadKnowledge>& knowledge,
                                  const std::vector<double>& shotMm3 = {});

// Removes waste pieces at the start of the print that have no ground below them and therefore fall.
void dropFallen(std::vector<BeadPiece>& pieces, const GroundProbe& ground);

// The data of a deposited piece that remain necessary after its support was checked.
struct DepositedPiece {
  std::uint32_t motion = 0, run = 0;
  float runMm = 0.0f; // as in BeadPiece
  // length of its bead that is still soft at the piece's end [mm]: two widths
  float recentMm = 0.0f;
};
// Widths as returned by sectionOf().
std::vector<DepositedPiece> depositedPieces(const std::vector<BeadPiece>& pieces,
                                            double widthMaxMm);

// Returns per motion the index of the first piece of that motion or of a later one; motions + 1
// entries.
std::vector<std::uint32_t> firstPieceOfMotions(const std::vector<DepositedPiece>& pieces,
                                               std::size_t motions);

// Support of a piece.
struct PieceSupport {
  bool supported = false;
  double carried = 0.0; // share of its width
};

struct Bridging; // bridged_spans.h

struct SupportedBeads {
  double lengthMm = 0.0, unsupportedMm = 0.0;
  // Of each item up to the last one with a bead
  std::vector<double> lengthOfItemMm, unsupportedOfItemMm;
  double halfCarriedMm = 0.0;             // supported on less than half of its width
  std::vector<std::uint32_t> unsupported; // piece indices, in order
  // The longest run of one bead without support across its whole width, and its first piece.
  double longestUnsupportedMm = 0.0;
  std::uint32_t longestFrom = 0;
  // First piece of the longest run of unsupported pieces, and of half-supported ones.
  std::optional<std::uint32_t> unsupportedFrom, halfCarriedFrom;
};

// Finds unsupported and half-supported pieces. A piece is supported if, at its middle, ground or
// earlier material is below the bead within 1.25 heights of the tip. Probes are at depths of 1.05
// to 1.25 heights below the tip and up to 0.7 heights to the side (a cone of 35 degrees about the
// build direction; material beside the bead in its own layer is no support). The stricter test for
// the carried share of the width probes directly below the bead: at eight positions across its
// width, 1.05 to 1.25 heights below the tip. Material that the same bead deposited over its last 3
// mm or two widths does not count. Waste is not checked. `bridging`: spans that count as supported
// (acceptBridgedSpans()); null: none. Throws Cancelled.
SupportedBeads findSupport(const std::vector<BeadPiece>& pieces, const PrintedPart& printed,
                           const GroundProbe& ground, const base::RunContext& ctx,
                           const Bridging* bridging = nullptr);

} // namespace voluta::replay
