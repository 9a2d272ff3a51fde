#include "program/stream/joint_rows.h"

#include "program/common/program_text.h"
#include "program/common/text_rows.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace voluta::program {

namespace {

constexpr int kSecondDecimals = 6, kJointDecimals = 7, kFlowDigits = 4;
constexpr double kMaxSeconds = 1e6, kMaxRad = 1e3;
constexpr double kSameRad = 1e-5; // tolerance on a dialect's targets

class RowsReader {
public:
  RowsReader(const StartMotion& start, ProgramBuilder& out, const base::RunContext& ctx)
      : start_(start), out_(out), ctx_(ctx) {}

  RowsRead read(std::string_view text) {
    const RowsForm form{kRowHeader, "not the header of a joint stream"_text,
                        "the row that ends the stream is missing: the file is truncated"_text};
    read_.complete = readEachRow(
        text, form,
        [this](std::string_view row) {
          take(row);
          return ended_;
        },
        out_, ctx_);
    return std::move(read_);
  }

private:
  void defect(base::Message reason) { out_.defect(std::move(reason)); }

  void take(std::string_view line) {
    JointRow row;
    if (!parseRow(line, row)) {
      defect(base::message("not understood: '{code}'"_text, line.substr(0, 60)));
      return;
    }
    if (started_ == (row.kind == RowKind::Start))
      defect("a stream has exactly one motion to the start, as its first row"_text);
    started_ = true;
    read_.rows.push_back(row);
    out_.flow(row.flow);
    out_.setExtruder(row.on);
    switch (row.kind) {
    case RowKind::End:
      ended_ = true;
      if (row.on || row.flow > 0.0)
        defect("the extruder's outputs are not off at the end"_text);
      stays(row);
      return;
    case RowKind::Wait:
      if (!row.on && row.flow > 0.0)
        defect("the flow is not 0 while the extruder is off"_text);
      stays(row);
      out_.pauseByOutputs(row.seconds);
      return;
    case RowKind::Start:
    case RowKind::Move:
      motion(row);
    }
  }

  void stays(const JointRow& row) {
    if (!std::ranges::equal(row.joints, at_,
                            [](double a, double b) { return std::abs(a - b) <= kSameRad; }))
      defect("the arm waits at another target than the previous one"_text);
  }

  void motion(const JointRow& row) {
    plan::ProgramMotion m;
    m.target = plan::TargetKind::Joints;
    m.jointInterpolated = true;
    m.joints.assign(row.joints.begin(), row.joints.end());
    if (row.kind == RowKind::Move) {
      m.durationS = row.seconds;
    } else {
      m.jointSpeedRadPerS = start_.radPerS;
      m.jointAccelerationRadPerS2 = start_.radPerS2;
    }
    at_ = row.joints;
    out_.motionByOutputs(std::move(m));
  }

  const StartMotion start_;
  ProgramBuilder& out_;
  const base::RunContext& ctx_;
  RowsRead read_;
  std::array<double, kRowJoints> at_ = {};
  bool started_ = false, ended_ = false;
};

} // namespace

JointRow asWritten(JointRow row) {
  row.seconds = roundedTo(row.seconds, kSecondDecimals);
  for (double& joint : row.joints)
    joint = roundedTo(joint, kJointDecimals);
  row.flow = roundedTo(row.flow, decimalsFor(row.flow, kFlowDigits));
  return row;
}

void appendRow(std::string& out, const JointRow& row) {
  out += std::to_string(static_cast<int>(row.kind));
  out += ',';
  appendFixed(out, row.seconds, kSecondDecimals, true);
  for (const double joint : row.joints) {
    out += ',';
    appendFixed(out, joint, kJointDecimals);
  }
  out += row.on ? ",1," : ",0,";
  appendFixed(out, row.flow, decimalsFor(row.flow, kFlowDigits), true);
  out += '\n';
}

bool parseRow(std::string_view line, JointRow& row) {
  std::array<double, kRowJoints + 4> numbers = {};
  if (!parseNumbers(line, numbers))
    return false;
  const auto isAmong = [](double value, int limit) {
    return value >= 0.0 && value <= limit && value == std::floor(value);
  };
  const double kind = numbers[0], on = numbers[kRowJoints + 2];
  if (!isAmong(kind, 3) || !isAmong(on, 1))
    return false;
  row.kind = static_cast<RowKind>(static_cast<int>(kind));
  row.seconds = numbers[1];
  std::copy_n(numbers.begin() + 2, kRowJoints, row.joints.begin());
  row.on = on > 0.0;
  row.flow = numbers.back();
  const bool lasts = row.kind == RowKind::Move || row.kind == RowKind::Wait;
  return (lasts ? row.seconds > 0.0 && row.seconds < kMaxSeconds : row.seconds == 0.0) &&
         std::ranges::all_of(row.joints, [](double q) { return std::abs(q) < kMaxRad; }) &&
         row.flow >= 0.0 && row.flow <= 1.0;
}

RowsRead readRows(std::string_view text, const StartMotion& start, ProgramBuilder& out,
                  const base::RunContext& ctx) {
  return RowsReader(start, out, ctx).read(text);
}

bool looksLikeRows(std::string_view text) {
  return firstRow(text).starts_with("kind,seconds,");
}

bool isWaitingRow(const std::vector<std::string>& lines, std::size_t i) {
  return lines[i].starts_with("3,");
}

} // namespace voluta::program
