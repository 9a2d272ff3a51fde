#include "sliced/gcode_machine.h"

#include "base/error.h"
#include "base/far_places.h"
#include "base/run_context.h"
#include "program/common/program_text.h"
#include "program/gcode/gcode_line.h"
#include "sliced/gcode_arc.h"
#include "sliced/gcode_command.h"
#include "sliced/purge_lines.h"
#include "sliced/slicer_comments.h"
#include "sliced/table_axes.h"
#include "sliced/unused_commands.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <utility>

namespace voluta::sliced {

namespace {
using base::Error;
using base::ErrorCode;
using Eigen::Vector3d;
using program::GcodeWords;

constexpr double kInchMm = 25.4, kMinLengthMm = 1e-6;
constexpr double kThinnestMm = 0.01, kThickestMm = 1000.0; // Layers
constexpr std::size_t kMaxPoints = 20'000'000;

// Filament that was retracted has to return before any is extruded.
class Filament {
public:
  // Moves the filament by `length`. Returns what leaves the nozzle.
  double push(double length) {
    const double out = std::max(0.0, length - retracted_);
    retracted_ = std::max(0.0, retracted_ - length);
    return out;
  }

private:
  double retracted_ = 0.0;
};

class Machine {
public:
  Machine(std::string_view text, const std::string& name, const base::RunContext& ctx)
      : text_(text), name_(name), ctx_(ctx) {}

  SlicedFile run() {
    file_.header = headerOf(text_);
    file_.volumetric = file_.header.volumetric;
    program::LineReader lines(text_);
    std::string_view line;
    for (std::string_view next; lines.next(next);) {
      line = next;
      line_ = lines.number();
      if (line_ % 4096 == 0)
        ctx_.checkpoint();
      GcodeCommand command = commandOf(line);
      if (!command.remark.empty())
        remark(command.remark);
      for (; !command.text.empty(); command = commandOf(command.next)) {
        if (!command.next.empty())
          requireSeparate(command);
        execute(command);
      }
    }
    endPath();
    file_.cutLine = isCutIn(line) ? line_ : 0;
    for (const auto& [tool, amounts] : amountAt_)
      file_.nozzleC[tool] =
          std::ranges::max_element(amounts, {}, [](const auto& at) { return at.second; })->first;
    file_.stops = unused_.stops();
    file_.unused = unused_.notes(lastBeadLine_);
    leaveOutPurgeLines(file_);
    return std::move(file_);
  }

private:
  [[noreturn]] void fail(base::Message what, base::Message remedy) const {
    throw Error(ErrorCode::UnreadableFile, std::move(what),
                base::lineOf(name_, static_cast<long long>(line_)), std::move(remedy));
  }

  void remark(std::string_view comment) {
    table_.note(comment);
    const CommentFacts facts = factsOf(comment);
    if (facts.layerChange) {
      ++layer_;
      heightMm_ = 0.0;
    }
    if (facts.heightMm)
      heightMm_ =
          *facts.heightMm >= kThinnestMm && *facts.heightMm <= kThickestMm ? *facts.heightMm : 0.0;
    if (facts.feature)
      feature_ = facts.feature;
  }

  // Controllers differ in the order in which they take a line's commands, and in which of them
  // takes its words, except where modes and tools come first and have none.
  void requireSeparate(const GcodeCommand& command) const {
    const bool isMotion = command.letter == 'G' && command.number <= 4.0;
    std::string_view rest = command.text.substr(1);
    double number = 0.0;
    program::takeDecimal(rest, number);
    while ((rest = program::trimmed(rest)).starts_with('(')) {
      const std::size_t end = rest.find(')');
      rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
    }
    if (isMotion || (command.letter != 'M' && !rest.empty()))
      fail(base::message("two commands in one line: '{code}' and '{next}'"_text,
                         command.text.substr(0, 40), command.next.substr(0, 40)),
           "write each command in a line of its own"_text);
  }

  // Slicers end each line, and state M commands behind the last bead, which switch the heat off. A
  // file that was written by hand may lack its last line end.
  bool isCutIn(std::string_view lastLine) const {
    if (text_.empty() || text_.ends_with('\n') || text_.ends_with('\r'))
      return false;
    const GcodeCommand last = commandOf(lastLine);
    const bool isMotion = last.letter == 'G' && last.number <= 3.0;
    const bool hasEnd = lastMLine_ > lastBeadLine_;
    return isMotion || !hasEnd;
  }

  void execute(const GcodeCommand& command) {
    if (command.letter == 'M')
      lastMLine_ = line_;
    if (command.letter == ' ')
      refuseBareWord(command.text);
    if (endsProgram(command)) {
      if (endLine_ == 0)
        endLine_ = line_;
      return;
    }
    const bool isUsed = command.letter == 'T'   ? changeTool(command.number)
                        : command.letter == 'M' ? executeM(command.number, command.text)
                        : command.letter == 'G' ? executeG(command.number, command.text)
                                                : false;
    if (!isUsed)
      takeUnused(command);
  }

  // The print goes on behind a stop with a path of its own.
  void takeUnused(const GcodeCommand& command) {
    if (unused_.take(command, line_, lastBeadLine_ > 0))
      endPath();
  }

  // M30 with a name deletes a file.
  static bool endsProgram(const GcodeCommand& command) {
    if (command.letter != 'M' || command.number != 30.0)
      return command.letter == 'M' && (command.number == 2.0 || command.number == 112.0);
    std::string_view name = command.text.substr(1);
    double number = 0.0;
    program::takeDecimal(name, number);
    name = program::trimmed(name);
    return name.empty() || name.front() == '(';
  }

  void refuseBeadBehindEnd() const {
    if (endLine_ > 0)
      throw Error(ErrorCode::UnreadableFile,
                  base::message("the program ends here, beads that follow in line {line} would not "
                                "be printed"_text,
                                line_),
                  base::lineOf(name_, static_cast<long long>(endLine_)),
                  "remove the end (M2, M30, M112), or everything that follows it"_text);
  }

  void refuseBareWord(std::string_view text) const {
    const auto letter = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
    std::string_view rest = text.substr(1);
    double value = 0.0;
    if ((letter == 'X' || letter == 'Y' || letter == 'Z' || letter == 'E') &&
        program::takeDecimal(rest, value))
      fail("a position without G0 or G1"_text, "write the command in each line"_text);
  }

  // These return whether the command is acted on, or means nothing for the print.
  bool changeTool(double number) {
    if (const std::optional<int> tool = toolNumber(number);
        tool && *tool != std::exchange(tool_, *tool))
      endPath();
    return true;
  }

  GcodeWords words(std::string_view text) const {
    GcodeWords words;
    if (!program::wordsOf(text, words))
      fail(base::message("not understood: '{code}'"_text, text.substr(0, 60)),
           "the file may be damaged; export it again"_text);
    return words;
  }

  bool executeM(double m, std::string_view text) {
    constexpr std::array kUsed{6.0, 82.0, 83.0, 104.0, 109.0, 140.0, 190.0, 200.0, 220.0, 221.0};
    if (std::ranges::find(kUsed, m) == kUsed.end())
      return false;
    GcodeWords w = words(text);
    if (m == 6.0) // The change to the tool that T names
      return w['T'] ? changeTool(*w['T']) : true;
    if (m == 82.0 || m == 83.0)
      relativeE_ = m == 83.0;
    else if (m < 200.0)
      heat(m, w, text);
    else if (m == 200.0 && w['D'])
      setVolumetric(*w['D'] > 0.0);
    else if (m > 200.0 && w['S'])
      (m == 220.0 ? speedShare_ : flowShares_[toolOf(w)]) = shareOf(*w['S']);
    return true;
  }

  // The tool that a command names; the one in use if it names none.
  int toolOf(GcodeWords& w) const { return w['T'] ? toolNumber(*w['T']).value_or(tool_) : tool_; }

  double shareOf(double percent) const {
    if (!(percent > 0.0))
      fail("a share that is not positive"_text, "give S in percent"_text);
    return percent / 100.0;
  }

  double flowShare() const {
    const auto stated = flowShares_.find(tool_);
    return stated == flowShares_.end() ? 1.0 : stated->second;
  }

  void setVolumetric(bool isVolume) {
    if (isVolume != std::exchange(file_.volumetric, isVolume) && lastBeadLine_ > 0)
      fail("M200 changes the meaning of E between beads"_text,
           "export the whole file with lengths of filament, or with volumes"_text);
  }

  // M109 and M190 with R also wait for cooling; 0 switches off.
  void heat(double m, GcodeWords& w, std::string_view text) {
    const std::optional<double> celsius = w['S'] ? w['S'] : w['R'];
    constexpr double kHottest = 1000.0;
    if (celsius && (*celsius < 0.0 || *celsius > kHottest))
      unused_.takeNamed(std::string(text.substr(0, 40)), line_);
    else if (!celsius || *celsius == 0.0)
      return;
    else if (m == 140.0 || m == 190.0)
      file_.bedC = std::max(file_.bedC, static_cast<int>(*celsius));
    else if (const std::optional<int> tool = w['T'] ? toolNumber(*w['T']) : tool_)
      nozzleC_[*tool] = static_cast<int>(*celsius);
  }

  bool executeG(double g, std::string_view text) {
    if (g == 20.0 || g == 21.0) {
      unitMm_ = g == 20.0 ? kInchMm : 1.0;
    } else if (g == 90.0 || g == 91.0) {
      relative_ = g == 91.0;
    } else if (g == 93.0 || g == 94.0) {
      inverseTime_ = g == 93.0;
    } else if (g == 28.0) {
      home(text);
    } else if (g == 10.0 || g == 11.0) {
      return retract(g, text);
    } else if (g == 92.0) {
      GcodeWords w = words(text);
      setCounts(w);
    } else if (g >= 0.0 && g <= 3.0 && g == std::floor(g)) {
      GcodeWords w = words(text);
      move(g, w);
    } else if (g == 5.0 || g == 18.0 || g == 19.0) {
      fail(base::message("G{number} is not understood"_text, static_cast<int>(g)),
           "export straight lines, or arcs in the plane of X and Y (G2, G3)"_text);
    } else {
      return false;
    }
    return true;
  }

  // By the firmware: what it retracts, it returns. With L or P, G10 sets coordinates, or the
  // offset and the heat of a tool.
  bool retract(double g, std::string_view text) {
    GcodeWords w; // Of a text that is not understood, those before the first odd one
    program::wordsOf(text, w);
    for (const char letter : {'L', 'P'})
      if (g == 10.0 && w[letter]) {
        if (lastBeadLine_ > 0)
          unused_.takeNamed("G10 " + (letter + program::fixedText(*w[letter], 2)), line_);
        return true;
      }
    endPath();
    return true;
  }

  // Axes that the line does not name are homed if it names none.
  void home(std::string_view text) {
    GcodeWords w = words(text);
    const bool all = !w.any("XYZ");
    for (std::size_t k = 0; k < 3; ++k)
      if (all || w["XYZ"[k]]) {
        known_[k] = true;
        position_[static_cast<Eigen::Index>(k)] = 0.0;
        shift_[static_cast<Eigen::Index>(k)] = 0.0;
      }
    endPath();
  }

  void setCounts(GcodeWords& w) {
    for (std::size_t k = 0; k < 3; ++k)
      if (const std::optional<double> value = w["XYZ"[k]]) {
        const auto axis = static_cast<Eigen::Index>(k);
        shift_[axis] = position_[axis] - unitMm_ * *value;
        known_[k] = true;
      }
    if (w['C'])
      table_.setCount(*w['C']);
    if (w['E'])
      e_ = unitMm_ * *w['E'];
    else if (!w.any("XYZC"))
      e_ = 0.0;
  }

  Vector3d targetOf(GcodeWords& w) {
    Vector3d target = position_;
    for (std::size_t k = 0; k < 3; ++k)
      if (const std::optional<double> value = w["XYZ"[k]]) {
        const auto axis = static_cast<Eigen::Index>(k);
        target[axis] = unitMm_ * *value + (relative_ ? position_[axis] : shift_[axis]);
        known_[k] = known_[k] || !relative_;
      }
    if (!(target.cwiseAbs().maxCoeff() <= base::kFarthestMm))
      fail("a position more than a kilometre away"_text,
           "the file may be damaged; export it again"_text);
    return target;
  }

  // Returns the amount that leaves the nozzle.
  double extrudedBy(GcodeWords& w) {
    if (!w['E'])
      return 0.0;
    const double value = unitMm_ * *w['E'];
    const double length = relative_ || relativeE_ ? value : value - e_;
    e_ += length;
    if (!(std::abs(length) <= base::kFarthestMm))
      fail("a length of filament of more than a kilometre"_text,
           "the file may be damaged; export it again"_text);
    // What one tool draws back is no debt of another, unless their filaments share the nozzle.
    return flowShare() * file_.header.amountShare(tool_, file_.volumetric) *
           filaments_[file_.header.oneNozzle ? 0 : tool_].push(length);
  }

  // `lengthMm`: of this motion; with G93 F is its inverse time.
  void takeSpeed(GcodeWords& w, double lengthMm) {
    if (!w['F'])
      return;
    if (!(*w['F'] > 0.0))
      fail("a speed that is not positive"_text, "give F in mm per minute"_text);
    speedMmPerS_ = (inverseTime_ ? lengthMm : unitMm_) * *w['F'] / 60.0;
  }

  void takeDirection(const GcodeWords& w) {
    if (!w.anyDirection())
      return;
    for (std::size_t k = 0; k < 3; ++k)
      if (w.direction[k])
        stated_[static_cast<Eigen::Index>(k)] = *w.direction[k];
    if (!(stated_.norm() > 1e-6))
      fail("a direction of length 0"_text, "give nX nY nZ as a unit vector"_text);
    direction_ = stated_.normalized();
  }

  void move(double g, GcodeWords& w) {
    if (!w.bare.empty())
      fail(base::message("the letter {letter} has no number"_text, w.bare),
           "the file may be damaged; export it again"_text);
    if (w.any("AUVW"))
      fail("a motion with a word A, U, V or W is not understood"_text,
           "give the nozzle's direction as nX nY nZ, or the table's angles as B and C"_text);
    const program::TablePose poseBefore = table_.poseAt(position_);
    const plan::NozzlePoint before = nozzle();
    const Vector3d from = before.position, fromDirection = before.direction;
    const std::array<bool, 3> knownBefore = known_;
    const Vector3d target = targetOf(w);
    takeDirection(w);
    table_.take(w);
    const double extruded = extrudedBy(w);
    position_ = target;
    const Vector3d to = nozzle().position;
    takeSpeed(w, (to - from).norm());
    const bool isArc = g > 1.0;
    if (isArc && table_.isUsed())
      fail("an arc on a table that tilts is not understood"_text, "export straight lines"_text);
    if ((to - from).norm() < kMinLengthMm && !isArc) {
      extrudeAtRest(extruded);
      return;
    }
    if (!(extruded > 0.0)) {
      endPath();
      return;
    }
    if (!std::ranges::all_of(knownBefore, std::identity()))
      fail("a bead from an unknown position"_text,
           "home the axes (G28) or travel to its start first"_text);
    if (isLeftOut()) {
      endPath();
      leaveOut(extruded);
      return;
    }
    refuseBeadBehindEnd();
    lastBeadLine_ = line_;
    if (!joins())
      beginPath(from, fromDirection);
    if (const auto set = nozzleC_.find(tool_); set != nozzleC_.end())
      amountAt_[tool_][set->second] += extruded;
    if (isArc)
      addArc(from, fromDirection, g, w, extruded);
    else if (table_.isUsed())
      addLine(poseBefore, extruded);
    else
      addPoint(to, direction_, extruded);
  }

  plan::NozzlePoint nozzle() const {
    return table_.isUsed() ? table_.nozzleAt(table_.poseAt(position_))
                           : plan::NozzlePoint{position_, direction_};
  }

  // All axes move linearly: on a table that turns meanwhile, the nozzle's way is bent.
  void addLine(const program::TablePose& from, double extruded) {
    std::vector<plan::NozzlePoint> nozzlePath = table_.path(from, table_.poseAt(position_));
    nozzlePath.push_back(nozzle());
    for (const plan::NozzlePoint& point : nozzlePath)
      addPoint(point.position, point.direction, extruded / static_cast<double>(nozzlePath.size()));
  }

  void extrudeAtRest(double extruded) {
    if (isLeftOut()) {
      leaveOut(extruded);
    } else if (extruded > 0.0) {
      file_.atRest += extruded;
      file_.outside.push_back({line_, extruded});
      if (file_.restLine == 0)
        file_.restLine = line_;
    }
  }

  void leaveOut(double extruded) {
    if (extruded > 0.0)
      file_.outside.push_back({line_, extruded});
    if (lastBeadLine_ == 0) {
      file_.inStartCode += extruded;
    } else if (extruded > 0.0) {
      file_.inOwnCode += extruded;
      if (file_.ownLine == 0)
        file_.ownLine = line_;
    }
  }

  // Code of the printer's own, before the first layer or marked by a comment.
  bool isLeftOut() const {
    return (feature_ && feature_->custom) || (file_.header.hasLayers && layer_ < 0) ||
           (!file_.header.hasLayers && file_.header.hasKinds && !feature_);
  }

  // Returns whether the next move continues the current path. A change of layer alone does not
  // end it: spirals rise without a stop.
  bool joins() const {
    const bool sameKind = feature_ && pathFeature_ && feature_->kind == pathFeature_->kind &&
                          feature_->ofPart == pathFeature_->ofPart;
    return open_ && (sameKind || feature_ == pathFeature_);
  }

  void beginPath(const Vector3d& from, const Vector3d& direction) {
    endPath();
    SlicedPath path;
    path.layer = layer_;
    path.tool = tool_;
    path.line = line_;
    if (feature_) {
      path.kind = feature_->kind;
      path.ofPart = feature_->ofPart;
      path.outermost = feature_->outermost;
    }
    path.points.push_back({from, direction, 0.0, speedMmPerS_ * speedShare_, heightMm_, 0});
    file_.paths.push_back(std::move(path));
    pathFeature_ = feature_;
    open_ = true;
  }

  void endPath() { open_ = false; }

  void addPoint(const Vector3d& at, const Vector3d& direction, double extruded) {
    if (++points_ > kMaxPoints)
      throw Error(ErrorCode::UnusableInput, "more tool-path points than can be planned"_text,
                  name_);
    file_.paths.back().points.push_back({at, direction, extruded, speedMmPerS_ * speedShare_,
                                         heightMm_, static_cast<std::uint32_t>(line_)});
  }

  void addArc(const Vector3d& from, const Vector3d& fromDirection, double g, GcodeWords& w,
              double extruded) {
    GcodeArc given{from, position_, g == 2.0, {}, {}};
    if (w['R'])
      given.radiusMm = unitMm_ * *w['R'];
    else if (w['I'] || w['J'])
      given.toCentre =
          Eigen::Vector2d(unitMm_ * w['I'].value_or(0.0), unitMm_ * w['J'].value_or(0.0));
    const std::optional<std::vector<Vector3d>> points = pointsOf(given);
    if (!points)
      fail("an arc that does not pass through its ends"_text,
           "give its centre (I, J) or its radius (R)"_text);
    const double share = 1.0 / static_cast<double>(points->size());
    for (std::size_t k = 0; k < points->size(); ++k) {
      const double t = static_cast<double>(k + 1) * share;
      const Vector3d turned = (1.0 - t) * fromDirection + t * direction_;
      addPoint((*points)[k], turned.norm() > 1e-6 ? turned.normalized() : direction_,
               share * extruded);
    }
  }

  std::string_view text_;
  const std::string& name_;
  const base::RunContext& ctx_;
  SlicedFile file_;
  std::size_t line_ = 0, points_ = 0, lastBeadLine_ = 0; // 0: no bead yet
  std::size_t endLine_ = 0, lastMLine_ = 0; // Of the program; of an M command; 0: not yet

  Vector3d position_ = Vector3d::Zero(), shift_ = Vector3d::Zero(); // shift_: by G92
  Vector3d direction_ = Vector3d::UnitZ(), stated_ = Vector3d::UnitZ();
  std::array<bool, 3> known_{};
  TableAxes table_;
  std::map<int, Filament> filaments_; // By nozzle
  UnusedCommands unused_;
  double e_ = 0.0, unitMm_ = 1.0, speedMmPerS_ = 0.0, speedShare_ = 1.0;
  std::map<int, double> flowShares_; // of tools
  int tool_ = 0;
  std::map<int, int> nozzleC_;                    // By tool, as set last [°C]
  std::map<int, std::map<int, double>> amountAt_; // Extruded, by tool and temperature
  bool relative_ = false, relativeE_ = false, inverseTime_ = false;

  const Feature *feature_ = nullptr, *pathFeature_ = nullptr;
  bool open_ = false; // The last move extruded
  int layer_ = -1;
  double heightMm_ = 0.0;
};

} // namespace

SlicedFile followGcode(std::string_view text, const std::string& name,
                       const base::RunContext& ctx) {
  return Machine(text, name, ctx).run();
}

} // namespace voluta::sliced
