#include "program/full_flow.h"

#include "program/common/program_text.h"
#include "program/job_head.h"

#include <cstdint>
#include <optional>
#include <utility>

namespace voluta::program {

namespace {

constexpr std::string_view kBegins = "extruder", kFlow = "flow: ", kEquals = " = ",
                           kUnit = " mm3/s";

// Parses "..., ATFULL = NUMBER mm3/s..."; returns nullopt for a comment of another form.
std::optional<plan::StatedFact> factIn(std::string_view text) {
  plan::StatedFact fact;
  fact.kind = plan::FactKind::FullFlow;
  const std::size_t equals = text.find(kEquals);
  if (equals == std::string_view::npos)
    return std::nullopt;
  const std::string_view before = text.substr(0, equals);
  const std::size_t comma = before.rfind(", ");
  fact.word = trimmed(comma == std::string_view::npos ? before : before.substr(comma + 1));
  std::string_view rest = text.substr(equals + kEquals.size());
  double mm3PerS = 0.0;
  if (takeNumber(rest, mm3PerS) && rest.starts_with(kUnit))
    fact.number = mm3PerS;
  return fact;
}

} // namespace

std::string fullFlowText(std::string_view atFull, const process::Tooling& tooling) {
  return joined({atFull, kEquals, fixedText(tooling.fullFlowMm3PerS(), 3), kUnit});
}

std::vector<plan::StatedFact> statedFullFlow(const std::vector<plan::ProgramFile>& files) {
  std::vector<plan::StatedFact> facts;
  for (std::size_t f = 0; f < files.size(); ++f) {
    LineReader lines(files[f].text);
    for (std::string_view line; lines.number() < kHeadLines && lines.next(line);) {
      const auto note = behindMark(line, kBegins);
      const std::size_t flow = note ? note->find(kFlow) : std::string_view::npos;
      if (flow == std::string_view::npos)
        continue;
      std::optional<plan::StatedFact> fact = factIn(note->substr(flow + kFlow.size()));
      if (!fact)
        continue;
      facts.push_back(std::move(*fact));
      facts.back().file = static_cast<std::uint32_t>(f);
      facts.back().line = static_cast<std::uint32_t>(lines.number());
    }
  }
  return facts;
}

} // namespace voluta::program
