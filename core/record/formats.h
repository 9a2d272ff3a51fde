// Records of runs, one row per format (docs/programs.md, Recorded runs).
#pragma once

#include "base/text.h"
#include "record/table.h"
#include "robot/cell.h"

#include <Eigen/Core>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::record {

// A run as it was recorded, seen from the work.
struct RecordedRun {
  std::string format;               // id in recordFormats()
  std::vector<double> timeS;        // ascending, from 0
  std::vector<Eigen::Vector3d> tip; // of the nozzle, work frame [mm]
  std::vector<double> extrudedMm3;  // since the beginning; empty: not recorded
};

// What a reader knows about the machine.
struct RecordContext {
  const robot::Cell& cell;
  double fullFlowMm3PerS = 0.0; // of the analogue output; 0: unknown
};

struct RecordFormat {
  std::string_view id;
  base::Text label;
  bool (*matches)(const Table&);
  // Returns the tip at a row. Throws Error{UnusableInput} if a column is missing.
  Eigen::Vector3d (*tip)(const Table&, std::size_t row, const robot::Cell&);
  double (*secondsPerUnit)(const Table&); // of its time column
};
// Returns rtde, melfa and joints.
std::span<const RecordFormat> recordFormats();

// Reads a record of any format. Rows whose time does not increase are left out: recorders repeat
// samples. Throws Error{UnusableInput} if no format matches, a column is missing, the time runs
// backwards, or fewer than two rows are left.
RecordedRun readRecord(std::string_view text, std::string_view source,
                       const RecordContext& context);

} // namespace voluta::record
