// Figures that the stages of a plan measured (docs/design.md, Report); listed in report_fields.h.
#pragma once

#include "plan/finding.h"
#include "plan/statistics.h"

#include <Eigen/Geometry>
#include <string>
#include <vector>

namespace voluta::project {

struct ModelReport {
  std::string file;
  double scale = 1.0;
  std::size_t triangles = 0;
  bool watertight = false;
  double volumeMm3 = 0.0;
  Eigen::AlignedBox3d boundsMm;
  std::vector<base::Message> repairs;
};

// One piece of planar mode, in print order.
struct PieceReport {
  int parent = -1; // index of the supporting piece; -1: the plate
  double volumeMm3 = 0.0, riskyAreaMm2 = 0.0;
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ(); // print direction
  std::string material;
};

struct DecompositionReport {
  std::string mode, growth;
  double voxelMm = 0.0;
  std::size_t voxels = 0;
  int layers = 0;
  std::size_t missedVoxels = 0, shadowedVoxels = 0, unreachedVoxels = 0, missedAfterSupports = 0;
  double supportVolumeMm3 = 0.0;
  int pieces = 0;
  double riskyAreaMm2 = 0.0, riskyAreaBeforeMm2 = 0.0;
  std::vector<PieceReport> pieceList;
};

struct MotionReport : plan::MotionStatistics {
  std::string robot, cell;
};

struct ProgramReport {
  std::string format;
  bool foreign = false;
  std::vector<std::string> files;
  std::size_t bytes = 0;
  double maxDeviationMm = 0.0, maxDeviationRad = 0.0;
  double durationS = 0.0, flowErrorFraction = 0.0, massRatio = 0.0; // on its controller
  // In report.json, where `files` has the written ones only: "released", "refused" (written on
  // request) or "notWritten".
  std::string state = {};
};

// The limits that a replay must keep to pass.
struct ThresholdsReport {
  double covered = 0.0, unsupported = 0.0, overfill = 0.0, mass = 0.0, deviationMm = 0.0;
  double flowError = 0.0, thin = 0.0;
  std::size_t collisions = 0, limitViolations = 0;
  std::string quality = {}, accepted = {}; // as parameters `quality` and `accept`
};

// Of one item among several.
struct ItemReplayReport {
  double coveredFraction = 0.0, unsupportedFraction = 0.0, massRatio = 0.0, thinFraction = 0.0;
};

struct ReplayReport {
  bool passed = false;    // safe to run, and prints the part as asked
  bool safeToRun = false; // false in older reports: passed implies it
  double coveredFraction = 0.0, unsupportedFraction = 0.0, overfillFraction = 0.0, massRatio = 0.0;
  double thinFraction = 0.0, thinMm3 = 0.0; // open because narrower than the narrowest bead
  double halfCarriedFraction = 0.0, longestUnsupportedMm = 0.0;
  std::size_t collisions = 0, limitViolations = 0;
  double maxDeviationMm = 0.0;
  double controllerDurationS = 0.0, flowErrorFraction = 0.0;
  // Time between a bead and the one that covers it, at the controller's own speeds
  double shortestLayerTimeS = 0.0, meanLayerTimeS = 0.0, longestLayerTimeS = 0.0;
  double tapeMm3 = 0.0;             // of continuous fibre, apart from the mass
  std::vector<double> layerTimesMm; // bead length by that time (replay/covering_times.h)
  ThresholdsReport thresholds;
  std::vector<ItemReplayReport> items; // empty: the job has one item
};

// A way of building that mode auto tried.
struct TriedReport {
  std::string strategy = {}; // its id; empty: a mode that is not in mode auto's table
  base::Message name = {};   // "flat layers with supports"
  std::string mode, platform;
  bool passed = false, taken = false;
  std::string stage = {};    // in which it ended
  base::Message reason = {}; // the finding that blocks there; empty: none
};

// How the part is built and with which values: from the user's choices, the mode's defaults or the
// way that mode auto chose.
struct ChosenReport {
  std::string strategy = {}; // of mode auto; empty: chosen by hand
  base::Message name = {};
  std::string mode, platform;
  std::string supports = {}; // empty: the mode has no supports
  double layerHeightMm = 0.0;
};

// Wall-clock seconds; the entries do not overlap.
struct Timings {
  double load = 0, repair = 0, voxelise = 0, peel = 0, grow = 0, smooth = 0, extract = 0, trim = 0,
         decompose = 0, toolpath = 0, orient = 0, ik = 0, graph = 0, jerk = 0, collision = 0,
         transfer = 0, write = 0, replay = 0, total = 0;

  Timings& operator+=(const Timings& more);
};

// What was planned for one item.
struct ItemReport {
  ModelReport model;
  DecompositionReport decomposition;
  plan::LayerStatistics layers;
  ChosenReport chosen;
  std::vector<TriedReport> tried; // in the order they were tried
};

// The verdict on the whole plan, in report.json (pipeline/plan_verdict.h): "passed", "differs",
// "unchecked", "blocked", "refused"; "notReplayed": there is no program to judge.
struct VerdictReport {
  std::string verdict = "notReplayed";
  bool safeToRun = false, printsAsAsked = false; // as asked: and safe
};

struct Report : VerdictReport {
  std::vector<ItemReport> items = {ItemReport{}}; // one or more, as the job's
  plan::ToolpathStatistics toolpath;
  MotionReport motion;
  std::vector<ProgramReport> programs;
  ReplayReport replay;
  plan::Findings findings;
  Timings timings;
  double peakRssMb = 0.0;
  int threads = 1;

  ItemReport& item(std::size_t i = 0) { return items.at(i); }
  const ItemReport& item(std::size_t i = 0) const { return items.at(i); }
};

// Returns the report as JSON text with all keys, in the order of docs/design.md, Report.
std::string reportJson(const Report& report);
// Parses such a text. Throws Error{UnreadableFile} if keys are missing or of another type.
Report readReportJson(const std::string& text);

} // namespace voluta::project
