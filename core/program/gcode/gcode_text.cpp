#include "program/gcode/gcode_text.h"

#include "base/units.h"
#include "plan/fitted_tools.h"
#include "program/common/arc.h"
#include "program/common/motion_targets.h"
#include "program/common/program_text.h"
#include "program/common/tape_cut.h"
#include "program/common/walk.h"
#include "program/job_head.h"
#include "program/own_lines.h"
#include "program/stream/joint_pieces.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace voluta::program {

namespace {
class StraightWriter : private ProgramEmitter {
public:
  StraightWriter(const StraightGcode& kind, const ProgramInput& input, const base::RunContext& ctx)
      : kind_(kind), in_(input), ctx_(ctx), targets_(motionTargets(input, ctx)) {
    program_.format = kind.format;
    program_.foreign = input.foreign;
  }

  plan::Program write() {
    walkTrajectory(in_, {kind_.format, cutsOf(in_, 0)}, *this, ctx_);
    return std::move(program_);
  }

private:
  void beginFile(std::size_t) override {
    text_.out.reserve(targets_.size() * 90 + 1024);
    text_.head(in_, kind_.title, kind_.question, kind_.notes);
  }
  void endFile(std::size_t) override {
    text_.end();
    program_.files.push_back(
        {joined({identifierOf(in_.name), ".", kind_.extension}), std::move(text_.out)});
  }

  void selectTool(int tool) override { text_.line(joined({"T", std::to_string(tool)})); }
  void awaitHeat(int tool) override { text_.awaitHeat(in_, tool); }
  void coolTool(int tool) override { text_.cool(in_, tool); }
  void pause(std::string_view message) override { text_.stop(message); }
  void purge(double filamentMm, double seconds) override {
    text_.purge(filamentMm, filamentMm / seconds * 60.0);
  }
  void cut() override {
    const std::string pin = joined({"M42 P", std::to_string(kGcodeCutPin), " S"});
    // M42 acts at once, while motions and waits are queued.
    text_.line("M400");
    text_.line(joined({pin, fixedText(kGcodeFullPin, 0), " ; cuts the tape"}));
    text_.wait(kCutPulseS);
    text_.line("M400");
    text_.line(pin + "0");
  }
  // As M42 of the cutter; a statement of the user's own may act at once, too.
  void ownLine(std::string_view code) override {
    text_.line(kGcodeSettles);
    ProgramEmitter::ownLine(code);
  }
  void wait(double seconds) override { text_.wait(seconds); }
  void remark(std::string_view text) override { text_.remark(text); }
  void fan(double share) override { text_.fan(share); }
  void retract(double filamentMm) override { text_.retract(filamentMm, 60.0 * kDrawnMmPerS); }
  // The nozzle's path is not straight, so it is written in pieces.
  void jointMotion(std::size_t i) override {
    const int pieces = i == 0 ? 1 : jointPieces(in_, i);
    for (int k = 1; k < pieces; ++k)
      line("G0", jointPiece(in_, i, static_cast<double>(k) / pieces),
           motionSeconds(in_.trajectory, i) / pieces);
    motion(i, pieces);
  }
  void straightMotion(std::size_t i, bool) override { motion(i); }

  void motion(std::size_t i, int pieces = 1) {
    const std::optional<double> filamentMm = GcodeText::filamentMm(in_.trajectory, i);
    const auto via = std::ranges::lower_bound(in_.arcs, i, {}, &ArcVia::point);
    const bool isArc = via != in_.arcs.end() && via->point == i;
    line(filamentMm ? "G1" : "G0", targets_[i], motionSeconds(in_.trajectory, i) / pieces,
         filamentMm, isArc ? &*via : nullptr);
  }

  // Returns the arc from the last tip, in the plane of X and Y.
  std::optional<Arc> arcTo(const Eigen::Vector3d& tip, const ArcVia& via) const {
    const auto level = [&](const Eigen::Vector3d& p) {
      return Eigen::Vector3d(p.x(), p.y(), tip.z());
    };
    return arcThrough(level(lastTip_), level(via.tipMm), tip);
  }

  // The motion takes `s` seconds; 0: untimed.
  void line(std::string_view command, const MotionTarget& target, double s,
            std::optional<double> filamentMm = std::nullopt, const ArcVia* via = nullptr) {
    Eigen::Vector3d tip;
    for (int k = 0; k < 3; ++k)
      tip[k] = roundedTo(target.tipMm[k], kGcodePositionDecimals);
    const std::optional<Arc> arc = via ? arcTo(tip, *via) : std::nullopt;
    if (arc)
      command = arc->u.cross(arc->v).z() > 0.0 ? "G3" : "G2";
    text_.out += command;
    text_.word(" X", tip.x(), kGcodePositionDecimals);
    text_.word(" Y", tip.y(), kGcodePositionDecimals);
    text_.word(" Z", tip.z(), kGcodePositionDecimals);
    if (kind_.directions) {
      text_.word(" nX", target.direction.x(), kDirectionDecimals);
      text_.word(" nY", target.direction.y(), kDirectionDecimals);
      text_.word(" nZ", target.direction.z(), kDirectionDecimals);
    }
    if (arc) {
      text_.word(" I", arc->centre.x() - lastTip_.x(), kGcodePositionDecimals);
      text_.word(" J", arc->centre.y() - lastTip_.y(), kGcodePositionDecimals);
    }
    if (filamentMm)
      text_.amount(*filamentMm);
    // Compute the speed from the targets as written, so that rounding does not change it.
    const double length = arc ? arc->lengthMm() : (tip - lastTip_).norm();
    double speed = s > 0.0 ? length / s : 0.0;
    if (speed < 1e-3) // at rest, or untimed
      speed = in_.process().travelSpeedMmPerS;
    text_.word(" F", speed * 60.0, 3, true);
    text_.out += '\n';
    lastTip_ = tip;
  }

  const StraightGcode& kind_;
  const ProgramInput& in_;
  const base::RunContext& ctx_;
  std::vector<MotionTarget> targets_;
  plan::Program program_;
  GcodeText text_;
  Eigen::Vector3d lastTip_ = Eigen::Vector3d::Zero();
};

} // namespace

bool endsStop(std::string_view text, std::size_t at) {
  const std::string_view behind = trimmed(text.substr(at + 1));
  return (text[at] == 'P' || text[at] == 'S') && !behind.empty() &&
         std::string_view("+-.0123456789").find(behind.front()) != std::string_view::npos;
}

std::string gcodeStopText(std::string_view message) {
  std::string text(message);
  for (std::size_t i = 0; i < text.size(); ++i)
    if (endsStop(text, i))
      text[i] = static_cast<char>(text[i] - 'A' + 'a');
  // Where a comment or a checksum begins.
  std::ranges::replace_if(
      text, [](char c) { return c == ';' || c == '*'; }, ' ');
  return text;
}

void GcodeText::word(std::string_view letters, double value, int decimals, bool trim) {
  out += letters;
  appendFixed(out, value, decimals, trim);
}

void GcodeText::line(std::string_view text) {
  out += text;
  out += '\n';
}

void GcodeText::amount(double filamentMm) {
  word(" E", filamentMm, kFilamentDecimals);
  lastMm_ = filamentMm;
}

void GcodeText::retract(double filamentMm, double f) {
  word("G1 E", lastMm_ + std::min(0.0, filamentMm), kFilamentDecimals);
  word(" F", f, 3, true);
  out += '\n';
}

void GcodeText::purge(double filamentMm, double f) {
  line("G92 E0");
  word("G1 E", filamentMm, kFilamentDecimals, true);
  word(" F", f, 3, true);
  out += '\n';
  word("G92 E", lastMm_, kFilamentDecimals, true);
  out += '\n';
}

void GcodeText::wait(double seconds) {
  out += joined({"G4 P", std::to_string(std::lround(1000.0 * seconds)), "\n"});
}

void GcodeText::remark(std::string_view text) {
  out += joined({"; ", text, "\n"});
}

std::string GcodeText::heating(std::string_view command, int tool) const {
  const std::string named = tools_.back() > 0 ? " T" + std::to_string(tool) : std::string();
  return joined({command, named, " S"});
}

void GcodeText::awaitHeat(const ProgramInput& input, int tool) {
  if (const std::optional<int> celsius = input.tooling.at(tool).process.material.nozzleC)
    line(heating("M109", tool) + std::to_string(*celsius));
}

void GcodeText::cool(const ProgramInput& input, int tool) {
  if (input.tooling.at(tool).process.material.nozzleC)
    line(heating("M104", tool) + "0");
}

void GcodeText::stop(std::string_view message) {
  line(joined({"M0 ", gcodeStopText(message)}));
}

void GcodeText::head(const ProgramInput& input, std::string_view title, std::string_view question,
                     const std::vector<std::string>& notes, std::string_view modes) {
  const process::Process& p = input.process();
  remark(title);
  for (const std::string& head : headLines(input))
    remark(head);
  if (input.foreign)
    remark("FOREIGN: not the language of the cell's controller");
  for (const std::string& note : notes)
    remark(note);
  out += "; ";
  out += kDiameterNote;
  word("", kFilamentDiameterMm, 3, true);
  out += " mm\n";
  line(modes);
  // The plate is heated behind the question.
  const std::string asked =
      input.selectsTool() ? joined({kGcodeWay, " ", fittedQuestion(input), " and the way clear?"})
                          : std::string(question);
  line("M117 " + asked);
  if (input.selectsTool()) {
    stop(asked);
    line("T" + std::to_string(input.trajectory.firstTool));
  } else {
    line("M0");
  }
  tools_ = input.tooling.usedAfter(input.trajectory, 0);
  // The machine does not have the tools that the operator fits later: they are heated at their
  // change.
  std::vector<int> fitted = tools_;
  std::erase_if(fitted, [&](int tool) {
    return tool != input.trajectory.firstTool && plan::isFittedByHand(input.trajectory, tool);
  });
  bedC_ = plateC(input);
  if (bedC_ > 0)
    out += joined({"M140 S", std::to_string(bedC_), "\n"});
  for (const int tool : fitted)
    if (const process::Material& material = input.tooling.at(tool).process.material;
        material.nozzleC)
      out += joined({heating("M104", tool), std::to_string(*material.nozzleC), " ; assumed for ",
                     plainText(material.label), "\n"});
  out += "G28\n";
  if (bedC_ > 0)
    out += joined({"M190 S", std::to_string(bedC_), "\n"});
  for (const int tool : fitted)
    awaitHeat(input, tool);
  out += "M107\nG92 E0\n";
  if (primesStanding(input)) {
    const double mmPerS = process::primeFlow(p) / filamentArea();
    word("G1 E", mmPerS * p.primeS, kFilamentDecimals, true);
    word(" F", mmPerS * 60.0, 3, true);
    out += " ; prime\nG92 E0\n";
  }
}

void GcodeText::end() {
  for (const int tool : tools_)
    line(heating("M104", tool) + "0");
  if (bedC_ > 0)
    line("M140 S0");
  line("M107");
  line("M84");
  line(kGcodeEnd);
}

void GcodeText::fan(double share) {
  const long speed = std::lround(share * kGcodeFullFan);
  line(speed > 0 ? joined({"M106 S", std::to_string(speed)}) : std::string("M107"));
}

std::optional<double> GcodeText::filamentMm(const plan::Trajectory& trajectory, std::size_t point) {
  if (!isPrint(trajectory, point))
    return std::nullopt;
  return trajectory.extrudedMm3[point] / filamentArea();
}

plan::Program writeStraightGcode(const StraightGcode& kind, const ProgramInput& input,
                                 const base::RunContext& ctx) {
  return StraightWriter(kind, input, ctx).write();
}

} // namespace voluta::program
