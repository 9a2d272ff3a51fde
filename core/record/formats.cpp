#include "record/formats.h"

#include "base/error.h"
#include "base/lower_case.h"
#include "base/units.h"
#include "program/common/euler_angles.h"
#include "program/common/rotation_vector.h"

#include <algorithm>
#include <array>
#include <optional>

namespace voluta::record {

namespace {
using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kMmPerM = 1000.0;
constexpr double kDisorderS = 0.1; // Samples may come in another order than they were taken

[[noreturn]] void refuse(const base::Message& why, const Table& table,
                         const base::Message& remedy) {
  throw base::Error(base::ErrorCode::UnusableInput, why, table.source, remedy);
}

std::optional<std::size_t> timeColumn(const Table& table) {
  return table.column(
      {"timestamp", "timeS", "time_s", "time", "t", "time[s]", "time_ms", "time[ms]"});
}

double secondsOfTime(const Table& table) {
  const std::string name = base::lowerCase(table.names[*timeColumn(table)]);
  return name == "time_ms" || name == "time[ms]" ? 1e-3 : 1.0;
}

// The joints of a record, with what converts a value to [rad] or [mm]; the kind of a joint decides.
struct JointColumns {
  std::vector<std::size_t> at;
  bool inDegrees = false;
};

std::optional<JointColumns> jointColumns(const Table& table) {
  struct Naming {
    const char *prefix, *suffix;
    bool inDegrees;
  };
  constexpr std::array kNamings{Naming{"actual_q_", "", false}, Naming{"q", "Deg", true},
                                Naming{"j", "_deg", true},      Naming{"q", "Rad", false},
                                Naming{"j", "_rad", false},     Naming{"J", "[deg]", true},
                                Naming{"J", "", true}};
  for (const Naming& naming : kNamings) {
    JointColumns found{{}, naming.inDegrees};
    // A sliding joint has its own suffix.
    for (int k = naming.prefix == std::string_view("actual_q_") ? 0 : 1;; ++k) {
      const std::string name = naming.prefix + std::to_string(k);
      const auto column = table.column({name + naming.suffix, name + "Mm", name + "_mm"});
      if (!column)
        break;
      found.at.push_back(*column);
    }
    if (!found.at.empty())
      return found;
  }
  return std::nullopt;
}

Vector3d tipOfJoints(const Table& table, std::size_t row, const JointColumns& joints,
                     const robot::Cell& cell) {
  if (static_cast<int>(joints.at.size()) < cell.dof())
    refuse(base::message("{found} joints are recorded, the cell has {wanted} axes"_text,
                         joints.at.size(), cell.dof()),
           table, "record all axes, external ones included"_text);
  robot::JointVector q(cell.dof());
  for (int k = 0; k < cell.dof(); ++k) {
    const double value = table.at(row, joints.at[static_cast<std::size_t>(k)]);
    const bool slides =
        cell.limits()[static_cast<std::size_t>(k)].kind == robot::JointKind::Sliding;
    q[k] = joints.inDegrees && !slides ? base::degreesToRadians(value) : value;
  }
  return cell.work_T_tool(q).translation();
}

// Of the pose of the controller's TCP in the robot's base.
Vector3d tipOfTcp(const Table& table, const Isometry3d& base_T_tcp, const robot::Cell& cell) {
  if (!cell.externalAxes().empty())
    refuse("poses of the TCP do not contain the external axes"_text, table,
           "record the joints of all axes"_text);
  const Isometry3d base_T_flange = base_T_tcp * cell.flange_T_moved().inverse();
  return cell.work_T_toolOfFlange(base_T_flange, cell.home()).translation();
}

bool isRtde(const Table& table) {
  return table.column({"actual_q_0", "actual_TCP_pose_0"}).has_value();
}
Vector3d rtdeTip(const Table& table, std::size_t row, const robot::Cell& cell) {
  // Joints are better: they need neither the controller's TCP nor its calibrated arm.
  if (const auto joints = jointColumns(table))
    return tipOfJoints(table, row, *joints, cell);
  const std::vector<std::size_t> pose = table.columns("actual_TCP_pose_", "");
  if (pose.size() != 6)
    refuse("the pose of the TCP is incomplete"_text, table,
           "record actual_q or all of actual_TCP_pose"_text);
  const auto three = [&](std::size_t from) {
    return Vector3d(table.at(row, pose[from]), table.at(row, pose[from + 1]),
                    table.at(row, pose[from + 2]));
  };
  Isometry3d base_T_tcp = Isometry3d::Identity();
  base_T_tcp.translation() = kMmPerM * three(0);
  base_T_tcp.linear() = program::rotationOf(three(3)).toRotationMatrix();
  return tipOfTcp(table, base_T_tcp, cell);
}

constexpr std::array<std::array<std::string_view, 3>, 6> kMelfaPose{{{"X", "X[mm]", "x_mm"},
                                                                     {"Y", "Y[mm]", "y_mm"},
                                                                     {"Z", "Z[mm]", "z_mm"},
                                                                     {"A", "A[deg]", "a_deg"},
                                                                     {"B", "B[deg]", "b_deg"},
                                                                     {"C", "C[deg]", "c_deg"}}};

bool isMelfa(const Table& table) {
  return table.column({"X", "X[mm]", "x_mm"}) && table.column({"A", "A[deg]", "a_deg"});
}
Vector3d melfaTip(const Table& table, std::size_t row, const robot::Cell& cell) {
  if (const auto joints = jointColumns(table))
    return tipOfJoints(table, row, *joints, cell);
  std::array<double, 6> value{};
  for (std::size_t k = 0; k < value.size(); ++k) {
    const auto column = table.column({kMelfaPose[k][0], kMelfaPose[k][1], kMelfaPose[k][2]});
    if (!column)
      refuse(base::message("column '{name}' is missing"_text, kMelfaPose[k][0]), table,
             "record X, Y, Z, A, B and C, or all joints"_text);
    value[k] = table.at(row, *column);
  }
  Isometry3d base_T_tcp = Isometry3d::Identity();
  base_T_tcp.translation() = Vector3d(value[0], value[1], value[2]);
  const Vector3d angles(value[3], value[4], value[5]);
  base_T_tcp.linear() =
      program::rotationOfXyz(angles.unaryExpr(&base::degreesToRadians)).toRotationMatrix();
  return tipOfTcp(table, base_T_tcp, cell);
}

bool isJoints(const Table& table) {
  return jointColumns(table).has_value();
}
Vector3d jointsTip(const Table& table, std::size_t row, const robot::Cell& cell) {
  return tipOfJoints(table, row, *jointColumns(table), cell);
}

constexpr std::array kFormats{
    RecordFormat{"rtde", "RTDE of Universal Robots"_text, isRtde, rtdeTip, secondsOfTime},
    RecordFormat{"melfa", "monitor of MELFA"_text, isMelfa, melfaTip, secondsOfTime},
    RecordFormat{"joints", "table of joints"_text, isJoints, jointsTip, secondsOfTime}};

// The material of a record: a total, a rate, or an analogue output.
struct ExtruderColumn {
  std::size_t at = 0;
  double mm3PerS = 0.0; // per unit of a rate; 0: the column is a total [mm3]
};

std::optional<ExtruderColumn> extruderColumn(const Table& table, const RecordContext& context) {
  constexpr double kFullVolts = 10.0;
  if (const auto total = table.column({"extruded_mm3", "extrudedMm3"}))
    return ExtruderColumn{*total, 0.0};
  if (const auto rate = table.column({"flow_mm3_per_s", "flowMm3PerS"}))
    return ExtruderColumn{*rate, 1.0};
  const auto volts = table.column({"standard_analog_output0", "standard_analog_output_0"});
  if (volts && context.fullFlowMm3PerS > 0.0)
    return ExtruderColumn{*volts, context.fullFlowMm3PerS / kFullVolts};
  return std::nullopt;
}

} // namespace

std::span<const RecordFormat> recordFormats() {
  return kFormats;
}

RecordedRun readRecord(std::string_view text, std::string_view source,
                       const RecordContext& context) {
  const Table table = readTable(text, source);
  const auto format =
      std::ranges::find_if(kFormats, [&](const RecordFormat& row) { return row.matches(table); });
  if (format == kFormats.end())
    refuse("no joints and no pose of the TCP among the columns"_text, table,
           "record actual_q (RTDE), X to C (MELFA) or j1_deg, j2_deg ..."_text);
  const auto time = timeColumn(table);
  if (!time)
    refuse("no column of times"_text, table, "name it timestamp, time_s or time_ms"_text);
  const std::optional<ExtruderColumn> extruder = extruderColumn(table, context);
  RecordedRun run;
  run.format = format->id;
  const double unit = format->secondsPerUnit(table), firstS = unit * table.at(0, *time);
  double mm3 = 0.0;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const double timeS = unit * table.at(row, *time) - firstS;
    if (!run.timeS.empty() && timeS < run.timeS.back() - kDisorderS)
      throw base::Error(
          base::ErrorCode::UnusableInput,
          base::message("the time runs backwards, from {before:.3f} to {after:.3f} after the first "
                        "row"_text,
                        base::seconds(run.timeS.back()), base::seconds(timeS)),
          base::lineOf(table.source, table.lines[row]), "record one run in one file"_text);
    if (!run.timeS.empty() && timeS <= run.timeS.back())
      continue;
    if (extruder) {
      const double value = table.at(row, extruder->at);
      if (extruder->mm3PerS == 0.0)
        mm3 = value;
      else if (!run.timeS.empty())
        mm3 += value * extruder->mm3PerS * (timeS - run.timeS.back());
      run.extrudedMm3.push_back(mm3);
    }
    run.tip.push_back(format->tip(table, row, context.cell));
    run.timeS.push_back(timeS);
  }
  if (run.timeS.size() < 2)
    refuse("fewer than two samples"_text, table, "record the whole run"_text);
  return run;
}

} // namespace voluta::record
