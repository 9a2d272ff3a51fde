#include "program/gcode/gcode_extended.h"

#include "program/common/program_text.h"
#include "program/common/text_rows.h"
#include "program/gcode/gcode_rapid.h"
#include "program/gcode/gcode_reader.h"
#include "program/job_head.h"

#include <cmath>
#include <utility>

namespace voluta::program {

namespace {

class ExtendedReader : public GcodeReader {
public:
  using GcodeReader::GcodeReader;

private:
  bool movesBeside(GcodeWords& w) const override { return w.anyDirection(); }

  bool target(GcodeWords& w, double, bool, plan::ProgramMotion& m) override {
    if (!takePosition(w)) {
      defect("a motion before X, Y and Z are all known"_text);
      return false;
    }
    if (w.anyDirection() && !takeDirection(w))
      return false;
    m.position = position_;
    m.direction = direction_;
    m.speedMmPerS = perS_;
    return true;
  }

  bool takeDirection(GcodeWords& w) {
    if (!w.direction[0] || !w.direction[1] || !w.direction[2]) {
      defect("a direction needs nX, nY and nZ"_text);
      return false;
    }
    const Eigen::Vector3d n(*w.direction[0], *w.direction[1], *w.direction[2]);
    const double length = n.norm();
    if (!(std::abs(length - 1.0) <= kDirectionTolerance))
      defect("a direction is not a unit vector"_text);
    if (!(length > 0.1 && length < 10.0))
      return false;
    direction_ = n / length;
    return true;
  }

  Eigen::Vector3d direction_ = Eigen::Vector3d::UnitZ();
};

} // namespace

std::vector<base::ParameterSpec> extendedGcodeOptions() {
  return {gcodeRunner()};
}

plan::Program writeExtendedGcode(const ProgramInput& input, const base::RunContext& ctx) {
  StraightGcode kind{.format = "gcode-extended",
                     .extension = "gcode",
                     .title = "Robot program for printing, extended G-code: X Y Z and the nozzle's "
                              "direction nX nY nZ in the work frame",
                     .question = kStartQuestion};
  const bool runner = wantsRapidRunner(input.options);
  if (runner)
    kind.notes.push_back(joined({kRapidGcodeNote, rapidRunnerName(input)}));
  plan::Program program = writeStraightGcode(kind, input, ctx);
  if (runner)
    program.files.push_back(rapidRunner(input, program.files.front().name, ctx));
  return program;
}

plan::ReadProgram readExtendedGcode(const std::vector<plan::ProgramFile>& files,
                                    const process::Tooling& tooling, const base::RunContext& ctx) {
  std::vector<plan::ProgramFile> own = files;
  for (plan::ProgramFile& file : own)
    if (isRapidRunner(file.text))
      file.text.clear();
  while (own.size() > 1 && own.back().text.empty())
    own.pop_back();
  plan::ReadProgram program = ExtendedReader("gcode-extended", tooling, ctx).read(own);
  ProgramBuilder beside("gcode-extended", tooling);
  for (beside.file = 0; beside.file < files.size(); ++beside.file)
    if (isRapidRunner(files[beside.file].text))
      readRapidRunner(files[beside.file].text, tooling, beside, ctx);
  for (plan::ProgramDefect& defect : beside.take(true).defects)
    program.defects.push_back(std::move(defect));
  return program;
}

std::vector<std::string> filesOfExtendedGcode(std::string_view text) {
  return namesBehind(text, {joined({"; ", kRapidGcodeNote})});
}

bool looksLikeExtendedGcode(std::string_view text) {
  return kindOfGcode(text) == GcodeKind::Extended;
}

bool mayBeMissingInExtendedGcode(const std::vector<std::string>& lines, std::size_t i) {
  // E is 0 before the prime, but not after it.
  if (lines[i] == "G92 E0")
    return lines[i - 1].find("prime") == std::string::npos;
  // M109 and M190 heat too.
  const bool heatsEarly = (lines[i].starts_with("M104 S") && lines[i] != "M104 S0") ||
                          (lines[i].starts_with("M140 S") && lines[i] != "M140 S0");
  const bool cools = lines[i].starts_with("M106") || lines[i] == "M107";
  return heatsEarly || cools || lines[i].starts_with("M117") || primes(lines, i);
}

} // namespace voluta::program
