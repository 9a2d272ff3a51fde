#include "program/stream/joint_table.h"

#include "base/error.h"
#include "program/common/motion_targets.h"
#include "program/common/program_text.h"
#include "program/common/walk.h"
#include "program/job_head.h"
#include "program/program_builder.h"

#include <algorithm>
#include <cmath>

namespace voluta::program {

namespace {
constexpr int kDegreeDecimals = 7; // 2e-9 rad
constexpr std::string_view kEnd = "# end";

std::string_view nameOf(plan::MoveKind move) {
  switch (move) {
  case plan::MoveKind::Print:
    return "print";
  case plan::MoveKind::Linear:
    return "linear";
  case plan::MoveKind::Wipe:
    return "wipe";
  case plan::MoveKind::Joint:
    break;
  }
  return "joint";
}

std::string columnOf(std::size_t joint, robot::JointKind kind) {
  return joined(
      {",j", std::to_string(joint + 1), kind == robot::JointKind::Sliding ? "_mm" : "_deg"});
}

// Parses "time_s,j1_deg,...,extruded_mm3,waypoint,move" and returns the kinds of its joints; empty
// if it is no such header.
std::vector<robot::JointKind> jointsOfHeader(std::string_view line) {
  using enum robot::JointKind;
  constexpr std::string_view kFront = "time_s", kBack = ",extruded_mm3,waypoint,move";
  if (!line.starts_with(kFront) || !line.ends_with(kBack))
    return {};
  line.remove_prefix(kFront.size());
  std::vector<robot::JointKind> joints;
  while (line != kBack && joints.size() < 8) {
    const bool slides = line.starts_with(columnOf(joints.size(), Sliding));
    const std::string column = columnOf(joints.size(), slides ? Sliding : Turning);
    if (!line.starts_with(column))
      return {};
    line.remove_prefix(column.size());
    joints.push_back(slides ? Sliding : Turning);
  }
  return line == kBack ? joints : std::vector<robot::JointKind>();
}

class JointTableReader {
public:
  JointTableReader(const process::Tooling& tooling, const base::RunContext& ctx)
      : ctx_(ctx), out_("csv", tooling) {}

  plan::ReadProgram read(const std::vector<plan::ProgramFile>& files) {
    out_.expectMotionsOf(files);
    for (out_.file = 0; out_.file < files.size(); ++out_.file)
      readFile(files[out_.file].text);
    return out_.take(complete_);
  }

private:
  void defect(base::Message reason) { out_.defect(std::move(reason)); }

  void readFile(std::string_view text) {
    LineReader lines(text);
    std::string_view line;
    bool ended = false;
    joints_.clear();
    headed_ = false;
    while (lines.next(line)) {
      out_.line = lines.number();
      if (out_.line % 4096 == 0)
        ctx_.checkpoint();
      line = trimmed(line);
      if (line.empty())
        continue;
      if (ended)
        defect("text after the end"_text);
      if (line.front() == '#')
        ended = ended || line == kEnd;
      else if (joints_.empty())
        header(line);
      else
        row(line);
    }
    if (joints_.empty())
      defect("the header line is missing"_text);
    if (!ended)
      defect("the line '# end' is missing: the file is truncated"_text);
    complete_ = ended && headed_ && (out_.file == 0 || complete_);
  }

  void header(std::string_view line) {
    joints_ = jointsOfHeader(line);
    headed_ = !joints_.empty();
    if (!headed_) {
      defect("not the header of a joint table"_text);
      // Rows can still be read if their column count matches a possible header.
      const auto commas = static_cast<std::size_t>(std::count(line.begin(), line.end(), ','));
      joints_.assign(commas > 3 && commas - 3 <= 8 ? commas - 3 : 0, robot::JointKind::Turning);
    }
  }

  void row(std::string_view line) {
    plan::ProgramMotion m;
    m.target = plan::TargetKind::Joints;
    m.joints.resize(joints_.size());
    double time = 0.0, extruded = 0.0, waypoint = 0.0;
    std::string_view rest = line;
    bool good = takeField(rest, time);
    for (std::size_t k = 0; k < joints_.size(); ++k) {
      good = good && takeField(rest, m.joints[k]);
      m.joints[k] = robot::ofShownValue(joints_[k], m.joints[k]);
    }
    good = good && takeField(rest, extruded) && takeField(rest, waypoint);
    m.jointInterpolated = rest == "joint";
    if (!good || !(rest == "print" || rest == "linear" || rest == "wipe" || rest == "joint")) {
      defect("not a row of the table"_text);
      return;
    }
    if (waypoint < -1.0 || waypoint != std::floor(waypoint))
      defect("a waypoint number has to be an integer of at least -1"_text);
    m.durationS = time - time_;
    m.volumeMm3 = extruded - extruded_;
    if (m.durationS < 0.0 || time < 0.0)
      defect("time decreases"_text);
    if (m.volumeMm3 < 0.0 || extruded < 0.0)
      defect("the extruded volume decreases"_text);
    m.durationS = std::max(0.0, m.durationS);
    m.volumeMm3 = std::max(0.0, m.volumeMm3);
    m.extruding = rest == "print" || m.volumeMm3 > 0.0;
    time_ = time;
    extruded_ = extruded;
    out_.motion(std::move(m));
  }

  // Parses the number before the next comma; `rest` advances past the comma.
  static bool takeField(std::string_view& rest, double& value) {
    const std::size_t comma = rest.find(',');
    if (comma == std::string_view::npos || !parseNumber(trimmed(rest.substr(0, comma)), value) ||
        std::abs(value) > 1e9)
      return false;
    rest = trimmed(rest.substr(comma + 1));
    return true;
  }

  const base::RunContext& ctx_;
  ProgramBuilder out_;
  std::vector<robot::JointKind> joints_;
  bool headed_ = false, complete_ = false;
  double time_ = 0.0, extruded_ = 0.0;
};

class JointTableWriter : private ProgramEmitter {
public:
  explicit JointTableWriter(const ProgramInput& input) : in_(input) { checkInput(input); }

  plan::Program write(const base::RunContext& ctx) {
    walkTrajectory(in_, {"csv", cutsOf(in_, 0)}, *this, ctx);
    return std::move(program_);
  }

private:
  void beginFile(std::size_t) override {
    program_.format = "csv";
    out_.reserve(in_.trajectory.pointCount() * 110 + 512);
    out_ += "# joint table\n";
    for (const std::string& head : headLines(in_))
      out_ += joined({"# ", head, "\n"});
    out_ += "time_s";
    for (std::size_t k = 0; k < in_.cell.limits().size(); ++k)
      out_ += columnOf(k, in_.cell.limits()[k].kind);
    out_ += ",extruded_mm3,waypoint,move\n";
  }
  void endFile(std::size_t) override {
    out_ += kEnd;
    out_ += '\n';
    program_.files.push_back({identifierOf(in_.name) + ".csv", std::move(out_)});
  }

  void jointMotion(std::size_t i) override { row(i); }
  void straightMotion(std::size_t i, bool) override { row(i); }

  void row(std::size_t i) {
    const plan::Trajectory& t = in_.trajectory;
    appendFixed(out_, t.timeS[i], 6);
    for (int k = 0; k < t.dof; ++k) {
      out_ += ',';
      const robot::JointKind kind = in_.cell.limits()[static_cast<std::size_t>(k)].kind;
      appendFixed(out_, robot::shownValue(kind, t.at(i)[k]), kDegreeDecimals);
    }
    out_ += ',';
    appendFixed(out_, t.extrudedMm3[i], 5);
    out_ += ',';
    out_ += t.waypoint[i] == plan::kNoWaypoint ? "-1" : std::to_string(t.waypoint[i]);
    out_ += ',';
    out_ += nameOf(t.move[i]);
    out_ += '\n';
  }

  const ProgramInput& in_;
  plan::Program program_;
  std::string out_;
};

} // namespace

plan::Program writeJointTable(const ProgramInput& input, const base::RunContext& ctx) {
  return JointTableWriter(input).write(ctx);
}

plan::ReadProgram readJointTable(const std::vector<plan::ProgramFile>& files,
                                 const process::Tooling& tooling, const base::RunContext& ctx) {
  return JointTableReader(tooling, ctx).read(files);
}

bool looksLikeJointTable(std::string_view text) {
  LineReader lines(text.substr(0, 16384));
  std::string_view line;
  while (lines.next(line)) {
    line = trimmed(line);
    if (!line.empty() && line.front() != '#')
      return line.starts_with("time_s,");
  }
  return false;
}

} // namespace voluta::program
