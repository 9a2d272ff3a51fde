#include "program/stream/extruder_stream.h"

#include "program/common/extruder_outputs.h"
#include "program/common/language_words.h"
#include "program/common/motion_targets.h"
#include "program/common/program_text.h"
#include "program/common/tcp_motions.h"
#include "program/extruder.h"
#include "program/filament.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace voluta::program {

namespace {

constexpr std::string_view kTitle = "# E stream beside ", kEnd = "end";
constexpr int kSecondDecimals = 6;

class StreamReader {
public:
  StreamReader(std::size_t file, plan::ReadProgram& program)
      : program_(program), defects_(program.defects), file_(file),
        stated_(program.motions.size(), false), pauseStated_(program.pauses.size(), false) {}

  void read(std::string_view text) {
    LineReader lines(text);
    bool ended = false;
    for (std::string_view line; lines.next(line);) {
      line_ = lines.number();
      line = trimmed(line);
      noteDiameter(line);
      if (line.empty() || line.front() == '#')
        continue;
      if (ended || (on_ && line == kEnd))
        defect(base::message("not understood: '{code}'"_text, line.substr(0, 60)));
      else if (line == kEnd)
        ended = true;
      else
        take(line);
    }
    line_ = lines.number();
    if (!ended || on_) {
      defect("the filament stream has no end: the file is truncated"_text);
      program_.complete = false;
    }
    reportMissing();
  }

private:
  void defect(base::Message reason) { defects_.add(file_, line_, std::move(reason)); }

  void noteDiameter(std::string_view line) {
    const std::size_t at = line.find(kDiameterNote);
    if (at == std::string_view::npos || line.front() != '#')
      return;
    std::string_view rest = line.substr(at + kDiameterNote.size());
    double mm = 0.0;
    if (takeNumber(rest, mm) && mm > 0.1 && mm < 20.0)
      mm2_ = filamentArea(mm);
    else
      defect("the filament diameter is out of range"_text);
  }

  static bool takeCount(std::string_view& text, std::size_t& count) {
    double value = 0.0;
    text = trimmed(text);
    if (!takeNumber(text, value) || !(value >= 0.0 && value < 1e9) ||
        value != static_cast<double>(static_cast<std::size_t>(value)))
      return false;
    count = static_cast<std::size_t>(value);
    return true;
  }

  void take(std::string_view line) {
    const std::string_view whole = line;
    std::size_t motion = 0;
    const bool on = line.starts_with("on "), off = line.starts_with("off ");
    if (on || off)
      line.remove_prefix(on ? 3 : 4);
    if (!takeCount(line, motion)) {
      defect(base::message("not understood: '{code}'"_text, whole.substr(0, 60)));
      return;
    }
    if (on || off) {
      if (on == on_.has_value() || !trimmed(line).empty() ||
          (off ? motion != motion_ : started_ && motion < motion_))
        defect("the extruder is switched on or off where that is not possible"_text);
      on_ = on ? std::optional(motion) : std::nullopt;
      motion_ = motion;
      seconds_ = mm_ = 0.0;
      started_ = true;
      return;
    }
    double seconds = 0.0, mm = 0.0;
    line = trimmed(line);
    const bool both = takeNumber(line, seconds) && (line = trimmed(line), takeNumber(line, mm));
    if (!both || !trimmed(line).empty() || !on_) {
      defect(base::message("not understood: '{code}'"_text, whole.substr(0, 60)));
      return;
    }
    step(motion, seconds, mm);
  }

  void step(std::size_t motion, double seconds, double mm) {
    const double dt = seconds - seconds_, volume = (mm - mm_) * mm2_;
    const bool stands = motion == motion_;
    if (!stands && motion != motion_ + 1)
      defect("a motion is missing or repeated in the filament stream"_text);
    if (!(dt > 0.0))
      defect("time decreases in the filament stream"_text);
    else if (stands)
      stand(dt, volume);
    else if (volume < 0.0)
      defect("the filament position decreases"_text);
    else
      move(motion, dt, volume);
    motion_ = motion;
    seconds_ = seconds;
    mm_ = mm;
  }

  void stand(double seconds, double volume) {
    for (std::size_t p = 0; p < pauseStated_.size(); ++p)
      if (plan::ProgramPause& pause = program_.pauses[p];
          pause.before == motion_ && !pauseStated_[p] && pause.durationS > 0.0) {
        pauseStated_[p] = true;
        const double before = drawnMm3_;
        std::tie(pause.volumeMm3, drawnMm3_) =
            pushedOut(volume / seconds * pause.durationS, drawnMm3_);
        pause.drawnMm = std::abs(drawnMm3_ - before) / mm2_;
        if (drawnMm3_ > kMaxDrawnBackMm * mm2_)
          defect(base::message("{length:.0f} of filament retracted: out of the hot end"_text,
                               base::mm(drawnMm3_ / mm2_)));
        return;
      }
    defect("the extruder runs where the program does not pause"_text);
  }
  void move(std::size_t motion, double seconds, double volume) {
    if (motion == 0 || motion > stated_.size() || !program_.motions[motion - 1].extruding) {
      defect("the extruder runs where the program has switched it off"_text);
      return;
    }
    if (std::exchange(drawnMm3_, 0.0) > kDrawnBackLeftMm3)
      defect("the retracted filament is not returned before the bead"_text);
    stated_[motion - 1] = true;
    program_.motions[motion - 1].flowMm3PerS = volume / seconds;
  }

  void reportMissing() {
    for (std::size_t m = 0; m < stated_.size(); ++m)
      if (program_.motions[m].extruding && !stated_[m] && (m == 0 || stated_[m - 1])) {
        const plan::ProgramMotion& motion = program_.motions[m];
        defects_.add(motion.file, motion.line,
                     "the filament stream has no entry for this motion"_text);
      }
  }

  plan::ReadProgram& program_;
  Defects defects_;
  std::size_t file_, line_ = 0;
  std::vector<bool> stated_, pauseStated_;
  double mm2_ = filamentArea();
  std::optional<std::size_t> on_; // since this motion
  std::size_t motion_ = 0;
  double seconds_ = 0.0, mm_ = 0.0, drawnMm3_ = 0.0;
  bool started_ = false;
};

} // namespace

std::string streamName(const ProgramInput& input) {
  return identifierOf(input.name) + "_e.txt";
}

plan::ProgramFile streamFile(const ProgramInput& input, const base::RunContext& ctx) {
  const plan::Trajectory& t = input.trajectory;
  const std::vector<MotionTarget> targets = motionTargets(input, ctx);
  const TcpMotions motions(input, targets);
  std::string out = joined({kTitle, programName(input.name), "\n# ", kDiameterNote,
                            fixedText(kFilamentDiameterMm, 3), " mm\n"});
  double seconds = 0.0, mm = 0.0;
  const auto mark = [&](std::string_view word, std::size_t motion) {
    out += joined({word, " ", std::to_string(motion), "\n"});
    seconds = mm = 0.0;
  };
  const auto step = [&](std::size_t motion, double dt, double mm3) {
    seconds += dt;
    mm += mm3 / filamentArea();
    out += std::to_string(motion);
    out += ' ';
    appendFixed(out, seconds, kSecondDecimals);
    out += ' ';
    appendFixed(out, mm, kFilamentDecimals);
    out += '\n';
  };
  if (const double s = input.process().primeS; primesStanding(input)) {
    mark("on", 1);
    step(1, s, process::primeFlow(input.process()) * s);
    mark("off", 1);
  }
  const double drawMm = input.process().retractMm;
  const auto draw = [&](std::size_t motion, double forthMm) {
    mark("on", motion);
    step(motion, std::abs(forthMm) / kDrawBackMmPerS, forthMm * filamentArea());
    mark("off", motion);
  };
  std::size_t last = 0; // point of a bead
  for (std::size_t i = 0; i < t.pointCount(); ++i)
    last = isPrint(t, i) ? i : last;
  bool drawn = false;
  for (std::size_t i = 1; i < t.pointCount(); ++i) {
    for (const plan::TrajectoryEvent& event : t.eventsBefore(i))
      if (event.kind == plan::EventKind::Purge) {
        mark("on", i);
        step(i, event.seconds, event.volumeMm3);
        mark("off", i);
      }
    if (drawMm > 0.0 && !isPrint(t, i) && isPrint(t, i - 1) && i < last) {
      draw(i, -drawMm);
      drawn = true;
    }
    if (!isPrint(t, i))
      continue;
    if (std::exchange(drawn, false))
      draw(i, drawMm);
    if (!isPrint(t, i - 1))
      mark("on", i);
    step(i + 1, motions.seconds(i), motionVolumeMm3(t, i));
    if (i + 1 == t.pointCount() || !isPrint(t, i + 1))
      mark("off", i + 1);
  }
  return {streamName(input), joined({out, kEnd, "\n"})};
}

bool looksLikeStream(std::string_view text) {
  return text.starts_with(kTitle);
}

std::string streamOf(std::string_view program) {
  LineReader lines(program.substr(0, 16384));
  for (std::string_view line; lines.next(line);)
    if (const std::size_t at = line.find(kStreamNote); at != std::string_view::npos) {
      const std::string_view rest = line.substr(at + kStreamNote.size());
      return std::string(rest.substr(0, rest.find_first_of(" ,;\r")));
    }
  return {};
}

void applyStream(std::string_view stream, std::size_t file, plan::ReadProgram& program) {
  StreamReader(file, program).read(stream);
}

} // namespace voluta::program
