#include "program/gcode/gcode_plain.h"

#include "program/gcode/gcode_reader.h"
#include "program/gcode/gcode_text.h"

namespace voluta::program {

namespace {

class PlainReader : public GcodeReader {
public:
  using GcodeReader::GcodeReader;

private:
  bool target(GcodeWords& w, double, bool extruding, plan::ProgramMotion& m) override {
    if (!takePosition(w)) {
      if (extruding)
        defect("material before X, Y and Z are all known"_text);
      approach(w);
      return false;
    }
    m.position = position_;
    m.speedMmPerS = perS_;
    return true;
  }

  bool hasArcs() const override { return true; }
  std::span<const KnownWord> ownWords() const override { return slicerWords(); }
  bool isMessage(std::string_view code) const override {
    // M862: the printer it is for; M486: the object that is printed.
    return GcodeReader::isMessage(code) || code.starts_with("M862.") || code.starts_with("M486");
  }
  bool isEnd(std::string_view line) const override {
    return GcodeReader::isEnd(line) || line == "; prusaslicer_config = end" ||
           line == "; CONFIG_BLOCK_END" || line == ";End of Gcode";
  }
};

} // namespace

plan::Program writePlainGcode(const ProgramInput& input, const base::RunContext& ctx) {
  return writeStraightGcode(
      {.format = "gcode",
       .extension = "gco",
       .title = "Program for printing, plain G-code: X Y Z, the nozzle along the plate's normal",
       .question = kGcodeQuestion,
       .directions = false},
      input, ctx);
}

plan::ReadProgram readPlainGcode(const std::vector<plan::ProgramFile>& files,
                                 const process::Tooling& tooling, const base::RunContext& ctx) {
  return PlainReader("gcode", tooling, ctx).read(files);
}

bool looksLikePlainGcode(std::string_view text) {
  return kindOfGcode(text) == GcodeKind::Plain;
}

} // namespace voluta::program
