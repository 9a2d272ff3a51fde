// Joints over time as rows of text, for controllers that a computer beside them streams to: what a
// stream's file says, whoever receives it.
//
//   kind,seconds,j1_rad,...,j6_rad,extruder,flow
//   1,0,...         the way to the start, behind a question to the operator
//   3,0.2,...,1,0.4 the arm stands for so long, at the joints of the row before
//   2,0.033,...     a motion of so long, each joint at a steady speed
//   0,0,...,0,0     the end
//
// extruder: on (1) or off from where the row begins; flow: then a share of the full one. Remarks
// begin with '#', in lines of their own or behind a row.
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

// Rounded as it is written.
JointRow asWritten(JointRow row);
// With a line end.
void appendRow(std::string& out, const JointRow& row);
// A line without its remark; false: no row.
bool parseRow(std::string_view line, JointRow& row);

// How the way to the start goes, by the joint that goes furthest.
struct StartMotion {
  double radPerS, radPerS2;
};

struct RowsRead {
  bool complete = false; // its end was found
  std::vector<JointRow> rows;
};
// Reads one file of rows into `out`, whose file is set. What is no row, waits elsewhere than it
// stands or comes behind the end is a defect. Throws Cancelled.
RowsRead readRows(std::string_view text, const StartMotion& start, ProgramBuilder& out,
                  const base::RunContext& ctx);
// Does a text's first row head rows?
bool looksLikeRows(std::string_view text);
// Rows in which the arm stands and the extruder runs, the prime: Dialect::mayBeMissing.
bool isWaitingRow(const std::vector<std::string>& lines, std::size_t i);

} // namespace voluta::program
