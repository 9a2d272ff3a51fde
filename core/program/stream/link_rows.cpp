#include "program/stream/link_rows.h"

#include "base/units.h"
#include "program/common/program_text.h"
#include "program/common/text_rows.h"
#include "program/krl/krl_speeds.h"
#include "program/melfa/melfa_values.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace voluta::program {

namespace {

constexpr int kSpeedDigits = 7, kFlowDigits = 4;
constexpr double kMaxJointDeg = 5000.0, kMaxMmPerS = 1e5, kMaxDegPerS = 1e5, kMaxSeconds = 1e6,
                 kMaxBlendMm = 1e4, kMaxKg = 1e5;
constexpr double kSame = 1e-4; // mm, degrees: resolution of the lines
constexpr std::size_t kHeaderBegins = 15;

class LinkReader {
public:
  LinkReader(const LinkForm& form, ProgramBuilder& out, const base::RunContext& ctx)
      : form_(form), out_(out), ctx_(ctx) {}

  LinkRead read(std::string_view text) {
    const RowsForm rows{form_.header, "not the header of lines for a data link"_text,
                        "the line that ends the stream is missing: the file is truncated"_text};
    LinkRead read;
    read.complete = readEachRow(
        text, rows,
        [this](std::string_view line) {
          if (!frame(line))
            take(line);
          return ended_;
        },
        out_, ctx_);
    if (nozzle_ && form_.inFrame)
      out_.program().base_T_nozzle = nozzle_;
    else if (nozzle_)
      seeFromHeldWork(out_.program(), *nozzle_);
    if (tool_ && start_)
      read.link = {*tool_, nozzleNumbers_, base_, load_, *start_};
    return read;
  }

private:
  void defect(base::Message reason) { out_.defect(std::move(reason)); }
  void notUnderstood(std::string_view line) {
    defect(base::message("not understood: '{code}'"_text, line.substr(0, 60)));
  }

  std::optional<LinkFrame>* frameNamed(std::string_view name) {
    if (name == kLinkTool)
      return &tool_;
    if (name == kLinkNozzle)
      return &nozzleNumbers_;
    if (form_.inFrame && name == kLinkBase)
      return &base_;
    return form_.inFrame && name == kLinkLoad ? &load_ : nullptr;
  }

  // Returns false for a line of another kind.
  bool frame(std::string_view line) {
    const std::size_t comma = std::min(line.find(','), line.size());
    const std::string_view name = trimmed(line.substr(0, comma));
    std::optional<LinkFrame>* known = frameNamed(name);
    if (!known)
      return false;
    LinkFrame numbers = {};
    if (*known || last_ || comma == line.size() || !parseNumbers(line.substr(comma + 1), numbers) ||
        (name == kLinkLoad ? !loads(numbers) : !places(name, numbers)))
      notUnderstood(line);
    else
      *known = numbers;
    return true;
  }
  bool loads(const LinkFrame& numbers) {
    if (!(numbers[0] >= 0.0 && numbers[0] < kMaxKg))
      return false;
    out_.load(kLinkLoad, numbers[0], Eigen::Vector3d(numbers.data() + 1));
    return true;
  }
  bool places(std::string_view name, const LinkFrame& numbers) {
    const auto pose = poseOf(numbers);
    if (!pose)
      return false;
    if (name == kLinkTool) {
      out_.program().flange_T_tcp = *pose;
    } else if (name == kLinkBase) {
      base_T_poses_ = *pose;
    } else {
      nozzle_ = *pose;
      out_.program().nozzleAt = {out_.file, out_.line};
    }
    return true;
  }
  std::optional<Eigen::Isometry3d> poseOf(const std::array<double, 6>& numbers) const {
    return form_.pose(Eigen::Vector3d(numbers.data()), Eigen::Vector3d(numbers.data() + 3));
  }

  void take(std::string_view line) {
    LinkRow row;
    if (!parseLinkRow(line, form_, row)) {
      notUnderstood(line);
      return;
    }
    if (!start_)
      begin(row);
    outputs(row);
    if (row.moves())
      motion(row);
    else
      stands(row);
    last_ = row;
  }

  void begin(const LinkRow& row) {
    start_ = row;
    if (!tool_ || (form_.inFrame && !load_))
      defect("a position before the tool is defined"_text);
    if (form_.inFrame && base_.has_value() == nozzle_.has_value())
      defect("either a base or a fixed nozzle has to be defined"_text);
    if (!row.moves() || !row.byJoints())
      defect("the first line is not a joint motion to the start"_text);
  }

  void outputs(const LinkRow& row) {
    const bool on = row.flow > 0.0, was = last_ && last_->moves() && last_->flow > 0.0;
    if (on && row.moves() && row.byJoints())
      defect("the extruder is on in a joint motion"_text);
    if (last_ && last_->blend > 0.0 && (on != was || row.byJoints() || !row.moves()))
      defect("the arm does not stop before this line"_text);
    out_.flow(row.flow / form_.fullFlow);
    out_.setExtruder(on);
  }

  void stands(const LinkRow& row) {
    if (!last_ || !std::ranges::equal(row.target, last_->target,
                                      [](double a, double b) { return std::abs(a - b) <= kSame; }))
      defect("the arm waits at another target than the previous one"_text);
    else if (row.speed < 0.0 && row.blend != last_->blend)
      defect("a line for a wait differs from the line before in its last number"_text);
    if (row.speed < 0.0) {
      out_.pauseByOutputs(-row.speed);
      out_.setExtruder(false);
      return;
    }
    ended_ = true;
    if (row.flow > 0.0)
      defect("the extruder's outputs are not off at the end"_text);
  }

  void motion(const LinkRow& row) {
    plan::ProgramMotion m;
    m.jointInterpolated = row.byJoints();
    if (!(row.blend == kLinkByJoints ? joints(row, m) : pose(row, m)))
      return;
    const std::optional<Eigen::Isometry3d> from = std::exchange(
        at_, m.target == plan::TargetKind::Joints ? std::nullopt : std::optional(m.frame_T_tcp));
    if (m.jointInterpolated) {
      // The receiving program is written for one kind.
      if (row.blend != start_->blend)
        defect("joint motions with joint targets and with pose targets in one stream"_text);
      m.jointSpeedRadPerS = 0.01 * row.speed * form_.jointRadPerS;
    } else {
      m.speedMmPerS = row.speed;
      m.blendMm = row.blend;
      if (form_.turns && from)
        slowByRotation(*from, row.rotation, m);
    }
    out_.motionByOutputs(std::move(m));
  }
  bool joints(const LinkRow& row, plan::ProgramMotion& m) {
    m.target = plan::TargetKind::Joints;
    for (const double degrees : row.target) {
      if (!(std::abs(degrees) <= kMaxJointDeg)) {
        defect("a joint value far outside any limit"_text);
        return false;
      }
      m.joints.push_back(base::degreesToRadians(degrees));
    }
    return true;
  }
  bool pose(const LinkRow& row, plan::ProgramMotion& m) {
    const auto said = poseOf(row.target);
    if (!said) {
      defect("the target is not a position within a robot's reach"_text);
      return false;
    }
    const bool onWork = form_.inFrame && nozzle_;
    m.target = onWork ? plan::TargetKind::WorkPose : plan::TargetKind::FlangePose;
    m.frame_T_tcp = base_T_poses_ * *said;
    return true;
  }

  const LinkForm& form_;
  ProgramBuilder& out_;
  const base::RunContext& ctx_;
  std::optional<LinkFrame> tool_, nozzleNumbers_, base_, load_;
  std::optional<Eigen::Isometry3d> nozzle_;
  Eigen::Isometry3d base_T_poses_ = Eigen::Isometry3d::Identity();
  std::optional<LinkRow> start_, last_;
  std::optional<Eigen::Isometry3d> at_; // frame_T_tcp of the last motion, if it was a pose
  bool ended_ = false;
};

} // namespace

void appendLinkRow(std::string& out, const LinkRow& row, const LinkForm& form) {
  for (std::size_t k = 0; k < row.target.size(); ++k) {
    const int decimals = row.blend == kLinkByJoints ? form.frameDecimals
                         : k < 3                    ? form.mmDecimals
                                                    : form.degDecimals;
    appendFixed(out, row.target[k], decimals, true);
    out += ',';
  }
  const auto figure = [&](double value, int digits) {
    appendFixed(out, value, value == 0.0 ? 0 : decimalsFor(std::abs(value), digits), true);
    out += ',';
  };
  figure(row.speed, kSpeedDigits);
  if (form.turns)
    figure(row.rotation, kSpeedDigits);
  figure(row.flow, form.wholeFlow ? kSpeedDigits : kFlowDigits);
  appendFixed(out, row.blend, form.blendDecimals, true);
  out += '\n';
}

bool parseLinkRow(std::string_view line, const LinkForm& form, LinkRow& row) {
  std::array<double, 10> numbers = {};
  const std::span<double> given(numbers.data(), form.turns ? 10 : 9);
  if (!parseNumbers(line, given))
    return false;
  std::copy_n(given.begin(), row.target.size(), row.target.begin());
  row.speed = given[6];
  row.rotation = form.turns ? given[7] : 0.0;
  row.flow = given[given.size() - 2];
  row.blend = given.back();
  const double limit = row.byJoints() ? 100.0 : kMaxMmPerS;
  const bool straight = row.moves() && !row.byJoints();
  return row.speed > -kMaxSeconds && row.speed <= limit && row.flow >= 0.0 &&
         row.flow <= form.fullFlow && (!form.wholeFlow || row.flow == std::floor(row.flow)) &&
         (!form.turns ||
          (straight ? row.rotation > 0.0 && row.rotation <= kMaxDegPerS : row.rotation == 0.0)) &&
         (row.blend == kLinkByJoints || row.blend == kLinkByJointsToPose ||
          (row.blend >= 0.0 && row.blend < kMaxBlendMm));
}

LinkFrame linkFrame(const Eigen::Vector3d& mm, const Eigen::Vector3d& degrees,
                    const LinkForm& form) {
  LinkFrame frame;
  for (int k = 0; k < 3; ++k) {
    frame[static_cast<std::size_t>(k)] = roundedTo(mm[k], form.frameDecimals);
    frame[static_cast<std::size_t>(k) + 3] = roundedTo(degrees[k], form.frameDecimals);
  }
  return frame;
}

void appendLinkFrame(std::string& out, std::string_view name, const LinkFrame& frame,
                     const LinkForm& form) {
  out += name;
  for (const double number : frame) {
    out += ',';
    appendFixed(out, number, form.frameDecimals, true);
  }
  out += '\n';
}

LinkRead readLinkRows(std::string_view text, const LinkForm& form, ProgramBuilder& out,
                      const base::RunContext& ctx) {
  return LinkReader(form, out, ctx).read(text);
}

bool looksLikeLinkRows(std::string_view text, const LinkForm& form) {
  return firstRow(text).starts_with(form.header.substr(0, kHeaderBegins));
}

bool isStandingLinkRow(const std::vector<std::string>& lines, std::size_t i, const LinkForm& form) {
  LinkRow row;
  return parseLinkRow(rowOf(lines[i]), form, row) && row.speed < 0.0;
}

} // namespace voluta::program
