#include "replay/required_bead_words.h"

#include "plan/finding_kinds.h"

#include <algorithm>
#include <map>

namespace voluta::replay {

namespace {

using enum plan::FindingKind;
using plan::FactKind, plan::StatedFact;

class WordComparer {
public:
  WordComparer(const plan::ReadProgram& program, const plan::Trajectory& trajectory,
               const Alignment& alignment, const process::Tooling& tooling)
      : program_(program), trajectory_(trajectory), alignment_(alignment), tooling_(tooling) {}

  std::vector<TextFinding> compare() {
    std::map<std::size_t, std::vector<const StatedFact*>> stated;
    for (const StatedFact& fact : program_.facts)
      if (fact.kind == FactKind::BeadStartWord || fact.kind == FactKind::BeadEndWord)
        stated[fact.before].push_back(&fact);
    std::size_t last = kUnmatched;
    for (std::size_t m = program_.firstMotion; m < program_.motions.size(); ++m) {
      const std::size_t point = alignment_.pointAhead(m);
      // Of the motions that lead to a point, the first one follows the statements.
      const auto planned = point == last ? std::vector<std::string>() : plannedAt(m, point);
      last = point;
      const auto at = stated.find(m);
      compareAt(m, planned,
                at == stated.end() ? std::vector<const StatedFact*>() : std::move(at->second));
    }
    for (const StatedFact* fact : stated[program_.motions.size()])
      unplanned(*fact);
    return std::move(findings_);
  }

private:
  bool prints(std::size_t point) const { return trajectory_.move[point] == plan::MoveKind::Print; }

  std::vector<std::string> plannedAt(std::size_t motion, std::size_t point) const {
    if (point == kUnmatched || point == 0 || prints(point) == prints(point - 1))
      return {};
    // A bead ends with the tool that printed it.
    const int tool = program_.motions[prints(point) || motion == 0 ? motion : motion - 1].tool;
    const process::BeadWords* words = tooling_.at(tool).process.wordsFor(program_.format);
    if (!words)
      return {};
    return prints(point) ? words->start : words->end;
  }

  void compareAt(std::size_t motion, const std::vector<std::string>& planned,
                 const std::vector<const StatedFact*>& stated) {
    std::size_t s = 0;
    for (const std::string& statement : planned)
      if (s < stated.size() && stated[s]->word == statement)
        ++s;
      else
        findings_.push_back(textFinding(program_, StatementMissing, placeOf(program_, motion),
                                        {{"statement", statement}}));
    for (; s < stated.size(); ++s)
      unplanned(*stated[s]);
  }

  void unplanned(const StatedFact& fact) {
    findings_.push_back(textFinding(program_, StatementChanged, {fact.file + 1U, fact.line},
                                    {{"statement", fact.word},
                                     {"found", base::Message("one"_text)},
                                     {"planned", base::Message("none"_text)}}));
  }

  const plan::ReadProgram& program_;
  const plan::Trajectory& trajectory_;
  const Alignment& alignment_;
  const process::Tooling& tooling_;
  std::vector<TextFinding> findings_;
};

} // namespace

std::vector<TextFinding> compareBeadWords(const plan::ReadProgram& program,
                                          const plan::Trajectory& trajectory,
                                          const Alignment& alignment,
                                          const process::Tooling& tooling) {
  const bool has = std::ranges::any_of(tooling.tools(), [&](const process::Tool& tool) {
    return tool.process.wordsFor(program.format) != nullptr;
  });
  if (!has || program.motions.empty())
    return {};
  return WordComparer(program, trajectory, alignment, tooling).compare();
}

} // namespace voluta::replay
