#include "program/link_rows.h"

#include "base/units.h"
#include "program/joint_rows.h"
#include "program/melfa.h"
#include "program/melfa_motions.h"
#include "program/melfa_values.h"
#include "program/text.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace voluta::program {

namespace {

constexpr int kSpeedDigits = 7, kBlendDecimals = 3;
constexpr double kMostJointDeg = 5000.0, kMostMmPerS = 1e5, kMostSeconds = 1e6, kMostBlendMm = 1e4;
constexpr double kSame = 1e-4; // mm, degrees: as near as they are written
constexpr std::size_t kNumbers = 9;

// Numbers between commas, all of them.
bool parseNumbers(std::string_view line, std::span<double> numbers) {
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const bool last = k + 1 == numbers.size();
    const std::size_t comma = line.find(',');
    if (last != (comma == std::string_view::npos) ||
        !parseNumber(trimmed(line.substr(0, comma)), numbers[k]))
      return false;
    line.remove_prefix(last ? line.size() : comma + 1);
  }
  return true;
}

std::optional<Eigen::Isometry3d> poseOf(const std::array<double, 6>& numbers) {
  return melfaPose(Eigen::Vector3d(numbers.data()), Eigen::Vector3d(numbers.data() + 3));
}

class LinkReader {
public:
  LinkReader(ProgramBuilder& out, const base::RunContext& ctx) : out_(out), ctx_(ctx) {}

  LinkRead read(std::string_view text) {
    out_.beginOutputs();
    LineReader lines(text);
    for (std::string_view line; lines.next(line);) {
      out_.line = lines.number();
      if (out_.line % 4096 == 0)
        ctx_.checkpoint();
      line = rowOf(line);
      if (line.empty())
        continue;
      if (read_.complete)
        defect("text behind the end"_text);
      else if (!headed_)
        header(line);
      else if (!frame(line))
        take(line);
    }
    if (!headed_)
      defect("the header line is missing"_text);
    if (!read_.complete)
      defect("the line that ends the stream is missing: the file was cut short"_text);
    if (nozzle_)
      seeFromHeldWork(out_.program(), *nozzle_);
    return std::move(read_);
  }

private:
  void defect(base::Message reason) { out_.defect(std::move(reason)); }
  void notUnderstood(std::string_view line) {
    defect(base::message("not understood: '{code}'"_text, line.substr(0, 60)));
  }

  void header(std::string_view line) {
    headed_ = true;
    if (line == kLinkHeader)
      return;
    defect("not the header of lines for a data link"_text);
    if (!frame(line))
      take(line);
  }

  // false: a line of another kind.
  bool frame(std::string_view line) {
    const std::size_t comma = std::min(line.find(','), line.size());
    const std::string_view name = trimmed(line.substr(0, comma));
    if (name != kLinkTool && name != kLinkNozzle)
      return false;
    LinkFrame numbers = {};
    std::optional<LinkFrame>& known = name == kLinkTool ? read_.tool : read_.nozzle;
    const auto pose = comma < line.size() && parseNumbers(line.substr(comma + 1), numbers)
                          ? poseOf(numbers)
                          : std::nullopt;
    if (!pose || known || last_) {
      notUnderstood(line);
      return true;
    }
    known = numbers;
    if (name == kLinkTool)
      out_.program().flange_T_tcp = *pose;
    else
      nozzle_ = *pose;
    return true;
  }

  void take(std::string_view line) {
    LinkRow row;
    if (!parseLinkRow(line, row)) {
      notUnderstood(line);
      return;
    }
    if (!read_.start) {
      read_.start = row;
      if (!read_.tool)
        defect("a position before the tool: whose is it?"_text);
      if (!row.moves() || !row.byJoints())
        defect("the first line is no motion by joints to the start"_text);
    }
    outputs(row);
    if (row.moves())
      motion(row);
    else
      stands(row);
    last_ = row;
  }

  void outputs(const LinkRow& row) {
    const bool on = row.flow > 0.0, was = last_ && last_->moves() && last_->flow > 0.0;
    if (on && row.moves() && row.byJoints())
      defect("the extruder is on in a motion by joints"_text);
    if (last_ && last_->blend > 0.0 && (on != was || row.byJoints() || !row.moves()))
      defect("the arm does not stand where this line begins"_text);
    out_.flow(row.flow / kMelfaFullFlow);
    out_.turn(on);
  }

  void stands(const LinkRow& row) {
    if (!last_ || !std::ranges::equal(row.target, last_->target,
                                      [](double a, double b) { return std::abs(a - b) <= kSame; }))
      defect("the arm waits elsewhere than where it stands"_text);
    if (row.speed < 0.0) {
      out_.pauseByOutputs(-row.speed);
      out_.turn(false);
      return;
    }
    read_.complete = true;
    if (row.flow > 0.0)
      defect("the extruder's outputs are not off at the end"_text);
  }

  void motion(const LinkRow& row) {
    plan::ProgramMotion m;
    m.jointInterpolated = row.byJoints();
    if (row.blend == kLinkByJoints) {
      m.target = plan::TargetKind::Joints;
      for (const double degrees : row.target) {
        if (!(std::abs(degrees) <= kMostJointDeg)) {
          defect("a joint value far outside any limit"_text);
          return;
        }
        m.joints.push_back(base::degreesToRadians(degrees));
      }
    } else {
      const auto pose = poseOf(row.target);
      if (!pose) {
        defect("a target that is no position in a robot's reach"_text);
        return;
      }
      m.target = plan::TargetKind::FlangePose;
      m.frame_T_tcp = *pose;
    }
    if (m.jointInterpolated) {
      // The program that takes the lines is written for one kind.
      if (row.blend != read_.start->blend)
        defect("motions by joints to joints and to poses in one stream"_text);
      m.jointSpeedRadPerS = 0.01 * row.speed * kMelfaJointRadPerS;
    } else {
      m.speedMmPerS = row.speed;
      m.blendMm = row.blend;
    }
    out_.motionByOutputs(std::move(m));
  }

  ProgramBuilder& out_;
  const base::RunContext& ctx_;
  LinkRead read_;
  std::optional<Eigen::Isometry3d> nozzle_;
  std::optional<LinkRow> last_;
  bool headed_ = false;
};

} // namespace

void appendLinkRow(std::string& out, const LinkRow& row) {
  for (std::size_t k = 0; k < row.target.size(); ++k) {
    const int decimals = row.blend == kLinkByJoints ? kMelfaFrameDecimals
                         : k < 3                    ? kMelfaMmDecimals
                                                    : kMelfaDegDecimals;
    appendFixed(out, row.target[k], decimals, true);
    out += ',';
  }
  appendFixed(out, row.speed, row.speed == 0.0 ? 0 : decimalsFor(std::abs(row.speed), kSpeedDigits),
              true);
  out += ',';
  appendFixed(out, row.flow, 0);
  out += ',';
  appendFixed(out, row.blend, kBlendDecimals, true);
  out += '\n';
}

bool parseLinkRow(std::string_view line, LinkRow& row) {
  std::array<double, kNumbers> numbers = {};
  if (!parseNumbers(line, numbers))
    return false;
  std::copy_n(numbers.begin(), row.target.size(), row.target.begin());
  row.speed = numbers[6];
  row.flow = numbers[7];
  row.blend = numbers[8];
  const double most = row.byJoints() ? 100.0 : kMostMmPerS;
  return row.speed > -kMostSeconds && row.speed <= most && row.flow >= 0.0 &&
         row.flow <= kMelfaFullFlow && row.flow == std::floor(row.flow) &&
         (row.blend == kLinkByJoints || row.blend == kLinkByJointsToPose ||
          (row.blend >= 0.0 && row.blend < kMostBlendMm));
}

void appendLinkFrame(std::string& out, std::string_view name, const LinkFrame& frame) {
  out += name;
  for (const double number : frame) {
    out += ',';
    appendFixed(out, number, kMelfaFrameDecimals, true);
  }
  out += '\n';
}

LinkRead readLinkRows(std::string_view text, ProgramBuilder& out, const base::RunContext& ctx) {
  return LinkReader(out, ctx).read(text);
}

bool looksLikeLinkRows(std::string_view text) {
  LineReader lines(text.substr(0, 16384));
  for (std::string_view line; lines.next(line);)
    if (line = rowOf(line); !line.empty())
      return line.starts_with(kLinkHeader.substr(0, 15));
  return false;
}

} // namespace voluta::program
