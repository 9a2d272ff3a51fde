#include "program/gcode/gcode_bc.h"

#include "base/units.h"
#include "program/common/program_text.h"
#include "program/gcode/gcode_reader.h"
#include "program/gcode/tilting_table.h"

#include <cmath>
#include <optional>

namespace voluta::program {

namespace {

constexpr double kSameRevolution = 1e-6; // of a turn; rounding of C

class TableReader : public GcodeReader {
public:
  using GcodeReader::GcodeReader;

private:
  bool isTargetWord(char letter) const override { return letter == 'B' || letter == 'C'; }
  // P counts seconds on the controllers that know G93 (LinuxCNC), not milliseconds as in Marlin.
  double dwellS(GcodeWords& w) const override {
    return w['S'].value_or(0.0) + w['P'].value_or(0.0);
  }
  bool movesBeside(GcodeWords& w) const override { return w.any("BC"); }

  // Accepts a change of C's count by whole turns.
  bool setsCount(GcodeWords& w) override {
    if (w['A'] || w['B'] || !w['C'] || !rotation_)
      return false;
    const double back =
        (base::radiansToDegrees(sense_ * *rotation_) - countedDeg_ - *w['C']) / 360.0;
    if (std::abs(back - std::round(back)) > kSameRevolution || !(std::abs(back) < 1e6))
      return false;
    countedDeg_ += 360.0 * std::round(back);
    return true;
  }

  bool command(double g) override {
    if (g != 93.0 && g != 94.0)
      return false;
    if (inverseTime_ != (g == 93.0))
      perS_ = 0.0; // the unit of F changes here
    inverseTime_ = g == 93.0;
    statesUnit_ = true;
    return true;
  }

  void note(std::string_view comment) override {
    if (comment == kReversedNote)
      sense_ = -1.0;
    if (!comment.starts_with(kTableNote))
      return;
    comment.remove_prefix(kTableNote.size());
    double x = 0.0, z = 0.0;
    if (comment.starts_with('X') && takeLetter(comment, x) && comment.starts_with(" Z") &&
        takeLetter(comment = trimmed(comment), z) && comment.empty() && std::abs(x) < 1e5 &&
        std::abs(z) < 1e5)
      frame_ = {x, z}, ours_ = true;
    else
      defect("invalid plate position relative to the tilt axis"_text);
  }
  static bool takeLetter(std::string_view& text, double& value) {
    text.remove_prefix(1);
    return takeNumber(text, value);
  }

  // Words of G28 are a point to which LinuxCNC goes first, zero too.
  bool isHomeNumber(double) const override { return false; }

  void requireUnitOfSpeed() {
    if (ours_ && !statesUnit_)
      defect("G94 is missing before this motion: after a run that was stopped its F would be read "
             "as a time"_text);
    statesUnit_ = true; // said once
  }

  double secondsOf(GcodeWords& w, double filamentMm) override {
    requireUnitOfSpeed();
    if (!inverseTime_)
      return GcodeReader::secondsOf(w, filamentMm);
    return w['F'] ? 1.0 / perS_ : 0.0;
  }

  bool target(GcodeWords& w, double g, bool extruding, plan::ProgramMotion& m) override {
    requireUnitOfSpeed();
    if (w.any("BC") && !knows('Z')) {
      defect("table motion before Z is known: the nozzle may be down"_text);
      return false;
    }
    if (w.any("XY") && !(tilt_ && rotation_)) {
      defect("X or Y motion before B and C are known"_text);
      return false;
    }
    const bool isAbove = knows('X') && knows('Y') && tilt_ && rotation_;
    const std::optional<double> tilt = tilt_, rotation = rotation_;
    if (w['B'])
      tilt_ = sense_ * base::degreesToRadians(*w['B']);
    if (w['C'])
      rotation_ = sense_ * base::degreesToRadians(*w['C'] + countedDeg_);
    if (inverseTime_ && g == 0.0)
      defect("a G0 under G93 has no defined time"_text);
    else if (inverseTime_ && !w['F'])
      defect("a motion without F: under G93 each motion needs its own"_text);
    const TablePose last = pose_;
    const Eigen::Vector3d from = position_;
    const bool allKnown = takePosition(w) && tilt_ && rotation_;
    const bool isIntermediate = ours_ && !placed_ && !inverseTime_ && !w.any("ZBC");
    if (!allKnown || isIntermediate) {
      if (extruding)
        defect("material before X, Y, Z, B and C are all known"_text);
      if (inverseTime_)
        defect("under G93 a way from an unknown place has no speed"_text);
      approach(w);
      return false;
    }
    if (!placed_ && tilt && rotation && (tilt != tilt_ || rotation != rotation_))
      defect("the table turns while the nozzle goes to its start"_text);
    if (ours_ && !placed_ && !isAbove)
      defect("the nozzle is not above its start: its way has no speed"_text);
    if (ours_ && !inverseTime_)
      defect("a motion without G93: its F is not a time"_text);
    pose_ = {position_, {*tilt_, *rotation_}};
    const plan::NozzlePoint nozzle = nozzleAt(frame_, pose_);
    m.position = nozzle.position;
    m.direction = nozzle.direction;
    // The starting point of the first motion is not on the part.
    m.durationS = placed_ ? secondsTo(last) : 0.0;
    if (!placed_ && isAbove && inverseTime_)
      m.speedMmPerS = (position_ - from).norm() * perS_;
    if (placed_)
      m.viaPoints = pathOnPart(frame_, last, pose_);
    placed_ = true;
    poses_.push_back(pose_);
    return true;
  }

  // Returns the number of motions with which the table is wound back here (up, by whole turns, down
  // again); 0 if it is not.
  std::size_t windingAt(std::size_t first) {
    const auto differs = [&](std::size_t m, bool z, bool rotation) {
      const TablePose &a = poses_[m - 1], &b = poses_[m];
      const double turns = (b.angles.rotation - a.angles.rotation) / (2.0 * base::kPi);
      return !out_.program().motions[m].extruding && a.axesMm.head<2>() == b.axesMm.head<2>() &&
             a.angles.tilt == b.angles.tilt && (a.axesMm.z() != b.axesMm.z()) == z &&
             (rotation ? std::abs(std::abs(turns) - 1.0) <= kSameRevolution : turns == 0.0);
    };
    std::size_t m = first;
    if (!differs(m, true, false) || poses_[m].axesMm.z() < poses_[m - 1].axesMm.z())
      return 0;
    while (m + 1 < poses_.size() && differs(m + 1, false, true))
      ++m;
    return m > first && m + 1 < poses_.size() && differs(m + 1, true, false) &&
                   poses_[m + 1].axesMm.z() == poses_[first - 1].axesMm.z()
               ? m + 2 - first
               : 0;
  }
  void finish() override {
    out_.program().tableAxisMm = {frame_.xMm, frame_.zMm};
    if (ours_ && inverseTime_ && !poses_.empty()) {
      const plan::ProgramMotion& last = out_.program().motions.back();
      out_.file = last.file;
      out_.line = last.line + 1;
      defect("G94 is missing after the last motion: the next program would read F as "
             "times"_text);
    }
    std::vector<plan::ProgramMotion>& motions = out_.program().motions;
    for (std::size_t m = 1; m < poses_.size() && poses_.size() == motions.size();)
      if (const std::size_t count = windingAt(m)) {
        for (std::size_t k = 0; k < count; ++k, ++m) {
          motions[m].detour = true;
          if (k > 0 && k + 1 < count)
            out_.program().approaches.push_back({.file = motions[m].file,
                                                 .line = motions[m].line,
                                                 .heightMm = poses_[m].axesMm.z()});
        }
      } else {
        ++m;
      }
  }

  double secondsTo(const TablePose& last) const {
    if (!(perS_ > 0.0))
      return 0.0;
    if (inverseTime_)
      return 1.0 / perS_;
    const double distance = (pose_.axesMm - last.axesMm).norm();
    const double rotation = std::hypot(pose_.angles.tilt - last.angles.tilt,
                                       pose_.angles.rotation - last.angles.rotation);
    return (distance > 0.0 ? distance : base::radiansToDegrees(rotation)) / perS_;
  }

  TableFrame frame_;
  TablePose pose_;
  std::vector<TablePose> poses_; // of each motion
  double sense_ = 1.0;
  double countedDeg_ = 0.0; // whole turns removed from C's count
  std::optional<double> tilt_, rotation_;
  bool inverseTime_ = false, placed_ = false;
  bool statesUnit_ = false; // has G93 or G94 been stated
  bool ours_ = false;       // Voluta's head was read: every motion states its time
};

} // namespace

plan::ReadProgram readTableGcode(const std::vector<plan::ProgramFile>& files,
                                 const process::Tooling& tooling, const base::RunContext& ctx) {
  return TableReader("gcode-bc", tooling, ctx).read(files);
}

bool looksLikeTableGcode(std::string_view text) {
  return kindOfGcode(text) == GcodeKind::Table;
}

} // namespace voluta::program
