#include "base/error.h"
#include "base/units.h"
#include "program/common/motion_targets.h"
#include "program/common/program_text.h"
#include "program/common/walk.h"
#include "program/gcode/gcode_bc.h"
#include "program/gcode/gcode_text.h"
#include "program/gcode/table_of_cell.h"
#include "program/gcode/table_winding.h"
#include "program/gcode/tilting_table.h"
#include "program/job_head.h"
#include "program/stream/joint_pieces.h"
#include "robot/plate.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>

namespace voluta::program {

namespace {

constexpr int kAngleDecimals = 5; // 1e-7 rad
constexpr double kAboveMm = 10.0; // above everything that the table can lift when it turns
constexpr double kStartDegPerS = 10.0, kWindDegPerS = 180.0, kMinS = 1e-3;
constexpr double kTwoPi = 2.0 * base::kPi;
constexpr std::string_view kCounts = "count", kWinds = "wind";

class TableWriter : private ProgramEmitter {
public:
  TableWriter(const ProgramInput& input, const base::RunContext& ctx)
      : in_(input), ctx_(ctx), targets_(motionTargets(input, ctx)), table_(tableOf(input.cell)),
        frame_(table_ ? table_->frame
                      : TableFrame{numberOf(tableXMm(), input.options),
                                   numberOf(tableZMm(), input.options)}),
        sense_(chosenOf(tableSense(), input.options) == "tool" ? -1.0 : 1.0),
        maxRevolutions_(numberOf(tableTurns(), input.options)),
        winds_(chosenOf(tableUnwind(), input.options) == kWinds) {
    program_.format = "gcode-bc";
    program_.foreign = input.foreign;
    findStations();
    if (winds_)
      findWindings();
    else if (!(maxRevolutions_ > 0.0))
      maxRevolutions_ = 1.0;
    upMm_ = heightAbove();
  }

  plan::Program write() {
    walkTrajectory(in_, {"gcode-bc", cutsOf(in_, 0)}, *this, ctx_);
    return std::move(program_);
  }

private:
  // A point of the trajectory, or one in between where the arm would move by joints.
  struct Station {
    Eigen::Vector3d tip;
    double seconds = 0.0;
  };

  void findStations() {
    std::vector<TableStation> directions;
    const auto add = [&](const MotionTarget& target, double s, bool prints) {
      stations_.push_back({target.tipMm, s});
      directions.push_back({target.direction, s, prints});
    };
    firstOf_.reserve(targets_.size() + 1);
    for (std::size_t i = 0; i < targets_.size(); ++i) {
      if (i % 4096 == 0)
        ctx_.checkpoint();
      firstOf_.push_back(stations_.size());
      // All axes of the cell's own table move linearly, as in the plan.
      const bool byJoints = !table_ && i > 0 && in_.trajectory.move[i] == plan::MoveKind::Joint;
      const int pieces = byJoints ? jointPieces(in_, i) : 1;
      const double s = motionSeconds(in_.trajectory, i) / pieces;
      for (int k = 1; k < pieces; ++k)
        add(jointPiece(in_, i, static_cast<double>(k) / pieces), s, false);
      add(targets_[i], s, isPrint(in_.trajectory, i));
      if (table_)
        angles_.push_back(table_->angles(
            Eigen::Map<const Eigen::VectorXd>(in_.trajectory.at(i), in_.trajectory.dof),
            in_.cell.armDof()));
    }
    firstOf_.push_back(stations_.size());
    if (!table_)
      angles_ = tableAngles(directions);
    for (TableAngles& a : angles_)
      a = {rounded(a.tilt), rounded(a.rotation)};
  }

  // Winds the table back where a travel has lifted off, so that each stretch between two such
  // points stays within the range.
  void findWindings() {
    std::vector<AngleRange> stretches;
    std::vector<std::size_t> begins; // stations
    for (std::size_t i = 0; i < targets_.size(); ++i)
      if (i == 0 || standsClear(in_.trajectory, i))
        begins.push_back(firstOf_[i]);
    begins.push_back(stations_.size());
    for (std::size_t k = 0; k + 1 < begins.size(); ++k) {
      // Start at the end of the stretch before.
      const auto from = angles_.begin() + static_cast<std::ptrdiff_t>(begins[k] - (k > 0 ? 1 : 0)),
                 to = angles_.begin() + static_cast<std::ptrdiff_t>(begins[k + 1]);
      const auto [low, high] = std::ranges::minmax_element(from, to, {}, &TableAngles::rotation);
      stretches.push_back({low->rotation, high->rotation});
    }
    if (!(maxRevolutions_ > 0.0))
      maxRevolutions_ = minRevolutions(stretches);
    if (!fitWithin(stretches, kTwoPi * maxRevolutions_))
      throw base::Error(
          base::ErrorCode::Usage,
          base::message(
              "within a bead the table would turn by more than {turns} turns to one side"_text,
              base::number(maxRevolutions_)),
          {}, base::message("set `tableTurns` to {turns} or more"_text, minRevolutions(stretches)));
    const std::vector<int> turns = windings(stretches, kTwoPi * maxRevolutions_);
    for (std::size_t k = 0; k + 1 < begins.size(); ++k) {
      for (std::size_t s = begins[k]; s < begins[k + 1]; ++s)
        angles_[s].rotation = rounded(angles_[s].rotation + kTwoPi * turns[k]);
      if (k > 0 && turns[k] != turns[k - 1])
        windsAt_.emplace(begins[k], turns[k] - turns[k - 1]);
    }
  }
  int windsAt(std::size_t station) const {
    const auto found = windsAt_.find(station);
    return found == windsAt_.end() ? 0 : found->second;
  }

  static double rounded(double rad) {
    return base::degreesToRadians(roundedTo(base::radiansToDegrees(rad), kAngleDecimals));
  }

  TablePose poseAt(std::size_t station) const {
    return tablePose(frame_, stations_[station].tip, angles_[station]);
  }

  void beginFile(std::size_t) override {
    text_.out.reserve(stations_.size() * 90 + 2048);
    text_.head(in_,
               "Program for printing, G-code with B and C: X Y Z of the machine, zero at the "
               "plate's centre with the table at 0 0; B tilts it about y, C turns it",
               kGcodeQuestion, notes(), "G21\nG90\nG94\nM82");
    start();
  }

  std::vector<std::string> notes() const {
    double minimum = 0.0, maximum = 0.0, fastest = 0.0;
    double lowest = angles_.front().rotation, highest = lowest;
    for (std::size_t i = 0; i < angles_.size(); ++i) {
      minimum = std::min(minimum, angles_[i].tilt);
      maximum = std::max(maximum, angles_[i].tilt);
      lowest = std::min(lowest, angles_[i].rotation);
      highest = std::max(highest, angles_[i].rotation);
      if (i > 0 && stations_[i].seconds > 0.0)
        fastest = std::max(
            fastest, std::abs(angles_[i].rotation - angles_[i - 1].rotation - kTwoPi * windsAt(i)) /
                         stations_[i].seconds);
    }
    std::string table(kTableNote);
    table += "X";
    appendFixed(table, frame_.xMm, kGcodePositionDecimals, true);
    table += " Z";
    appendFixed(table, frame_.zMm, kGcodePositionDecimals, true);
    std::vector<std::string> all = {std::move(table)};
    if (sense_ < 0.0)
      all.emplace_back(kReversedNote);
    if (winds_)
      all.push_back(rangeNote());
    else
      all.push_back(joined({"C's count is set back by whole turns (G92 C) in travels beyond ",
                            fixedText(maxRevolutions_, 0),
                            ": the table does not move then, and has to turn without end"}));
    all.push_back(joined({"B goes from ", degrees(sense_ * minimum), " to ",
                          degrees(sense_ * maximum), ", C from ", degrees(sense_ * lowest), " to ",
                          degrees(sense_ * highest), " degrees, C at most at ", degrees(fastest),
                          " degrees/s: what the axes cannot follow takes longer"}));
    return all;
  }
  std::string rangeNote() const {
    std::string note = joined({"C stays within ", fixedText(maxRevolutions_, 3),
                               maxRevolutions_ == 1.0 ? " turn" : " turns", " to either side"});
    if (!windsAt_.empty())
      note += joined({": it is wound back ", std::to_string(windsAt_.size()),
                      windsAt_.size() == 1 ? " time" : " times",
                      ", amid a travel, with the nozzle at Z", fixedText(upMm_, 1)});
    return note;
  }
  static std::string degrees(double rad) {
    std::string text;
    appendFixed(text, base::radiansToDegrees(rad), 1, true);
    return text;
  }

  // Returns a Z above everything that the table can lift.
  double heightAbove() const {
    double reach = 0.0;
    const auto add = [&](const Eigen::Vector3d& p) {
      reach = std::max(
          reach, std::hypot(std::hypot(p.x(), p.y()) + std::abs(frame_.xMm), p.z() + frame_.zMm));
    };
    for (const Station& s : stations_)
      add(s.tip);
    // The rest of a print turns what earlier programs have printed.
    std::ranges::for_each(in_.toolPlan.position, add);
    if (const robot::Prism* plate = robot::plateOf(in_.cell))
      for (const Eigen::Vector2d& corner : plate->polygon)
        add({corner.x(), corner.y(), 0.0});
    return std::max(reach - frame_.zMm, poseAt(0).axesMm.z()) + kAboveMm;
  }

  // Moves up first, then the table, then above the start: under G93 the first motion's speed would
  // depend on where the machine's home is.
  void start() {
    const TablePose first = poseAt(0);
    const double travel = in_.process().travelSpeedMmPerS * 60.0;
    text_.word("G1 Z", upMm_, kGcodePositionDecimals);
    text_.word(" F", travel, 3, true);
    text_.word("\nG1 B", sense_ * base::radiansToDegrees(first.angles.tilt), kAngleDecimals);
    text_.word(" C", sense_ * base::radiansToDegrees(first.angles.rotation), kAngleDecimals);
    text_.word(" F", kStartDegPerS * 60.0, 3, true);
    text_.word("\nG1 X", first.axesMm.x(), kGcodePositionDecimals);
    text_.word(" Y", first.axesMm.y(), kGcodePositionDecimals);
    text_.word(" F", travel, 3, true);
    text_.line("\nG93");
    last_ = first;
    last_.axesMm.z() = upMm_;
  }

  void endFile(std::size_t) override {
    text_.line("G94");
    text_.end();
    program_.files.push_back({identifierOf(in_.name) + ".ngc", std::move(text_.out)});
  }

  void remark(std::string_view text) override { text_.remark(text); }
  void fan(double share) override { text_.fan(share); }
  // Under G93 F is the inverse of a time.
  void retract(double filamentMm) override {
    text_.retract(filamentMm, 60.0 * kDrawnMmPerS / std::abs(filamentMm));
  }
  void purge(double filamentMm, double seconds) override {
    text_.purge(filamentMm, 60.0 / seconds);
  }
  void jointMotion(std::size_t i) override { motion(i); }
  void straightMotion(std::size_t i, bool) override { motion(i); }

  void motion(std::size_t i) {
    if (const int turns = windsAt(firstOf_[i]))
      wind(turns);
    else if (i > 0 && !isPrint(in_.trajectory, i) && !winds_)
      setCountBack();
    const std::optional<double> filamentMm = GcodeText::filamentMm(in_.trajectory, i);
    const double before =
        i > 0 && filamentMm ? in_.trajectory.extrudedMm3[i - 1] / filamentArea() : 0.0;
    for (std::size_t s = firstOf_[i]; s < firstOf_[i + 1]; ++s) {
      const TablePose from = last_, to = poseAt(s);
      const bool asPlanned = table_ && in_.trajectory.move[i] == plan::MoveKind::Joint;
      const int pieces = s == 0 || asPlanned ? 1 : tablePieces(frame_, from, to, kSagMm);
      const double seconds = s == 0 ? 0.0 : stations_[s].seconds / pieces;
      for (int k = 1; k <= pieces; ++k) {
        const double share = static_cast<double>(k) / pieces;
        std::optional<double> filament;
        if (filamentMm)
          filament = before + share * (*filamentMm - before);
        line(k == pieces ? to : tablePiece(frame_, from, to, share), seconds, filament);
      }
    }
  }

  // Moves up along the nozzle, turns the table by whole turns and moves back down: nothing has
  // changed on the part.
  void wind(int turns) {
    const TablePose at = last_;
    TablePose up = at;
    up.axesMm.z() = std::max(upMm_, at.axesMm.z());
    const double liftS = (up.axesMm.z() - at.axesMm.z()) / in_.process().travelSpeedMmPerS;
    text_.remark("the table is wound back");
    line(up, liftS, std::nullopt);
    for (int k = 1; k <= std::abs(turns); ++k) {
      up.angles.rotation = rounded(at.angles.rotation + (turns > 0 ? k : -k) * kTwoPi);
      line(up, 360.0 / kWindDegPerS, std::nullopt);
    }
    up.axesMm.z() = at.axesMm.z();
    line(up, liftS, std::nullopt);
  }

  void setCountBack() {
    const double degrees = sense_ * base::radiansToDegrees(last_.angles.rotation) - countedDeg_;
    const double turns = std::round(degrees / 360.0);
    if (std::abs(degrees) <= 360.0 * maxRevolutions_ || turns == 0.0)
      return;
    countedDeg_ += 360.0 * turns;
    text_.word("G92 C", degrees - 360.0 * turns, kAngleDecimals);
    text_.out += '\n';
  }

  // The motion takes `s` seconds; 0: untimed.
  void line(const TablePose& pose, double s, std::optional<double> filamentMm) {
    text_.word("G1 X", pose.axesMm.x(), kGcodePositionDecimals);
    text_.word(" Y", pose.axesMm.y(), kGcodePositionDecimals);
    text_.word(" Z", pose.axesMm.z(), kGcodePositionDecimals);
    text_.word(" B", sense_ * base::radiansToDegrees(pose.angles.tilt), kAngleDecimals);
    text_.word(" C", sense_ * base::radiansToDegrees(pose.angles.rotation) - countedDeg_,
               kAngleDecimals);
    if (filamentMm)
      text_.amount(*filamentMm);
    if (!(s > 0.0))
      s = std::max(kMinS, (pose.axesMm - last_.axesMm).norm() / in_.process().travelSpeedMmPerS);
    const double perMinute = 60.0 / s;
    text_.word(" F", perMinute, std::min(6, decimalsFor(perMinute, 8)), true);
    text_.out += '\n';
    last_ = pose;
  }

  const ProgramInput& in_;
  const base::RunContext& ctx_;
  std::vector<MotionTarget> targets_;
  std::optional<CellTable> table_; // the cell's own
  TableFrame frame_;
  double sense_, maxRevolutions_;
  bool winds_;
  double upMm_ = 0.0;                  // above everything that the table can lift
  std::map<std::size_t, int> windsAt_; // turns to wind back before the motion to that station
  double countedDeg_ = 0.0;            // whole turns removed from C's count
  std::vector<Station> stations_;
  std::vector<TableAngles> angles_;  // per station
  std::vector<std::size_t> firstOf_; // per point: its first station
  TablePose last_;
  plan::Program program_;
  GcodeText text_;
};

} // namespace

base::ParameterSpec tableXMm() {
  return base::numberParameter(
      "tableXMm", "mm", 0.0, -1000.0, 1000.0, "Programs"_text,
      "plate offset from the tilt axis"_text,
      "G-code with B and C: X distance of the plate's centre from the tilt axis."_text);
}

base::ParameterSpec tableZMm() {
  return base::numberParameter(
      "tableZMm", "mm", 0.0, -1000.0, 1000.0, "Programs"_text,
      "plate height above the tilt axis"_text,
      "G-code with B and C: height of the plate's top above the tilt axis."_text);
}

base::ParameterSpec tableSense() {
  return base::choiceParameter(
      "tableSense", "part", {{"part", "the part"_text}, {"tool", "the tool (ISO 841)"_text}},
      "Programs"_text, "table angles describe"_text,
      "G-code with B and C: whether B and C are the right-handed rotation of the "
      "part, or that of the tool around a fixed part."_text);
}

base::ParameterSpec tableTurns() {
  return base::numberParameter(
      "tableTurns", "", 0.0, 0.0, 1000.0, "Programs"_text, "turns until C is reset"_text,
      "G-code with B and C: beyond this number of turns to one side C is reset "
      "by whole turns during a travel. 0: the minimum the beads allow if the "
      "table is wound back, one turn if only its count is reset."_text);
}

base::ParameterSpec tableUnwind() {
  return base::choiceParameter(
      "tableUnwind", std::string(kWinds),
      {{std::string(kWinds), "the table"_text}, {std::string(kCounts), "its count (G92 C)"_text}},
      "Programs"_text, "reset of C"_text,
      "G-code with B and C: winds the table back during a travel, with the "
      "nozzle raised clear of it. For a table that turns endlessly only the "
      "count can be reset, without a motion."_text);
}

bool movesTable(const robot::Cell& cell) {
  return tableOf(cell).has_value();
}

std::vector<base::ParameterSpec> tableGcodeOptions() {
  return {tableXMm(), tableZMm(), tableSense(), tableTurns(), tableUnwind()};
}

plan::Program writeTableGcode(const ProgramInput& input, const base::RunContext& ctx) {
  return TableWriter(input, ctx).write();
}

} // namespace voluta::program
