// Figures of a part milled out of a block: its report.json has the sections of a printed part's
// that both have, and one for milling (docs/design.md, Report).
#pragma once

#include "project/report.h"

#include <Eigen/Core>
#include <string>
#include <vector>

namespace voluta::project {

// How the part was turned before it was milled.
struct LaidDownReport {
  std::vector<double> quaternion = {1.0, 0.0, 0.0, 0.0}; // w x y z
  int rounds = 0;                                        // 0: it keeps its orientation
  double scrapBeforeMm3 = 0.0, scrapMm3 = 0.0;
};

struct MillingReport {
  std::string material;
  double cutterMm = 0.0;
  int teeth = 0;
  double rpm = 0.0, feedMmPerMin = 0.0, lineMm = 0.0, finePassMm = 0.0;
  Eigen::Vector3d blockMm = Eigen::Vector3d::Zero();
  LaidDownReport millingOrientation;
  std::size_t moves = 0; // of the program
  double removedMm3 = 0.0, deepestMm = 0.0, residueMm = 0.0;
  bool complete = false; // nothing is left in space that should be free
  double leftMm3 = 0.0, leftThickestMm = 0.0;
  Eigen::Vector3d leftAtMm = Eigen::Vector3d::Zero();
  double cornersMm3 = 0.0;
};

struct MilledReport : VerdictReport {
  ModelReport model;
  MillingReport milling;
  std::vector<ProgramReport> programs;
  ReplayReport replay;
  plan::Findings findings;
  Timings timings;
  double peakRssMb = 0.0;
  int threads = 1;
};

// Returns the report as JSON text. Figures that are not a number are null: a milled part has none.
std::string reportJson(const MilledReport& report);

} // namespace voluta::project
