#include "program/program_options.h"

#include "base/error.h"
#include "base/key_text.h"

namespace voluta::program {

namespace {
constexpr std::string_view kMotionsPerFile = "motionsPerFile";
} // namespace

base::ParameterSpec motionsPerFileOption() {
  return base::integerParameter(std::string(kMotionsPerFile), 0, 0, 1000000, "Programs"_text,
                                "motions per file"_text,
                                "Longer programs are split into files to run one after "
                                "the other. 0: the format's default (URScript and RAPID "
                                "5000, KRL 2500, MELFA 6500, SPEL+ one file)."_text);
}

base::ParameterSpec programResolution() {
  return base::numberParameter(
      "programResolutionMm", "mm", 0.0, 0.0, 0.05, "Programs"_text, "resolution"_text,
      "Points of beads are omitted if the path, the nozzle's direction, the bead's section and the speed stay within tolerance without them; this is the tolerance of the path. 0: all points are written. Cells with external axes keep all points."_text);
}

base::ParameterSpec arcFitting() {
  return base::booleanParameter(
      "arcFitting", false, "Programs"_text, "arc fitting"_text,
      "Beads along circles are written as arcs (G2 and G3, movec, MoveC, CIRC), within the resolution or 0.02 mm."_text);
}

std::size_t motionsPerFile(const ProgramOptions& options, std::size_t usual) {
  return options.motionsPerFile > 0 ? options.motionsPerFile : usual;
}

namespace {
template <typename T>
const T& valueOf(const base::ParameterSpec& option, const ProgramOptions& options) {
  const auto chosen = options.own.find(option.key);
  const base::ParameterValue& value =
      chosen == options.own.end() ? option.defaultValue : chosen->second;
  base::require(std::holds_alternative<T>(value), "an option of that type");
  return std::get<T>(value);
}
} // namespace

std::string chosenOf(const base::ParameterSpec& option, const ProgramOptions& options) {
  base::require(option.type == base::ParameterType::Choice, "an option that is a choice");
  return valueOf<std::string>(option, options);
}

bool isOn(const base::ParameterSpec& option, const ProgramOptions& options) {
  return valueOf<bool>(option, options);
}

double numberOf(const base::ParameterSpec& option, const ProgramOptions& options) {
  return valueOf<double>(option, options);
}

ProgramOptions optionsAmong(const std::vector<base::ParameterSpec>& specs,
                            const ProgramOptions& options) {
  ProgramOptions among;
  for (const base::ParameterSpec& spec : specs)
    if (spec.key == kMotionsPerFile)
      among.motionsPerFile = options.motionsPerFile;
    else if (const auto chosen = options.own.find(spec.key); chosen != options.own.end())
      among.own.insert(*chosen);
  return among;
}

ProgramOptions optionsOf(const std::vector<base::ParameterSpec>& specs,
                         const base::ParameterValues& values) {
  ProgramOptions options;
  for (const base::ParameterSpec& spec : specs)
    if (spec.key == kMotionsPerFile)
      options.motionsPerFile = static_cast<std::size_t>(values.integer(spec.key));
    else if (const auto change = values.changes().find(spec.key); change != values.changes().end())
      options.own.insert(*change);
  // A default value typed by the user counts as not chosen.
  for (const base::ParameterSpec& spec : specs)
    if (const auto own = options.own.find(spec.key);
        own != options.own.end() && own->second == spec.defaultValue)
      options.own.erase(own);
  return options;
}

std::string keyOf(const ProgramOptions& options) {
  base::KeyText key;
  key.add(options.motionsPerFile);
  for (const auto& [name, value] : options.own)
    key.add(name).add(base::formatParameter(value));
  return key.text();
}

} // namespace voluta::program
