// Joints over time as rows of text, for controllers to which a computer streams: the contents of a
// stream's file, independent of the receiver.
//
//   kind,seconds,j1_rad,...,j6_rad,extruder,flow
//   1,0,...         motion to the start, after confirmation by the operator
//   3,0.2,...,1,0.4 the arm waits for this time, at the joints of the previous row
//   2,0.033,...     a motion of this duration, each joint at a constant speed
//   0,0,...,0,0     the end
//
// extruder: on (1) or off from the beginning of the row; flow: then a share of the full flow.
// Remarks begin with '#', on their own line or after a row.
#pragma once

#include "base/run_context.h"
#include "program/program_builder.h"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

inline constexpr std::size_t kRowJoints = 6;
inline constexpr std::string_view kRowHeader =
    "kind,seconds,j1_rad,j2_rad,j3_rad,j4_rad,j5_rad,j6_rad,extruder,flow";

enum class RowKind { End, Start, Move, Wait };

struct JointRow {
  RowKind kind = RowKind::End;
  double seconds = 0.0;
  std::array<double, kRowJoints> joints = {}; // rad
  bool on = false;
  double flow = 0.0; // 0..1
};

// Returns the row with values rounded as written.
JointRow asWritten(JointRow row);
// With a line end.
void appendRow(std::string& out, const JointRow& row);
// Parses a line without its remark. Returns false if it is no row.
bool parseRow(std::string_view line, JointRow& row);

// Speed and acceleration of the motion to the start, for the joint with the largest displacement.
struct StartMotion {
  double radPerS, radPerS2;
};

struct RowsRead {
  bool complete = false; // its end was found
  std::vector<JointRow> rows;
};
// Reads one file of rows into `out`, whose file is set. Lines that are no rows, waits at other
// joints than those of the previous row, and rows after the end are defects. Throws Cancelled.
RowsRead readRows(std::string_view text, const StartMotion& start, ProgramBuilder& out,
                  const base::RunContext& ctx);
// Returns whether a text begins with the header of rows.
bool looksLikeRows(std::string_view text);
// Returns whether the arm waits in the row while the extruder runs (the prime):
// Dialect::mayBeMissing.
bool isWaitingRow(const std::vector<std::string>& lines, std::size_t i);

} // namespace voluta::program
