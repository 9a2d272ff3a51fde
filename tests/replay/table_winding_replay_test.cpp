// A table that is wound back in a travel is no deviation from the plan; motions that only look like
// it are.
#include "program/program_fixture.h"

#include "base/run_context.h"
#include "replay/approach.h"
#include "replay/comparison.h"
#include "replay/executed_path.h"

#include <algorithm>
#include <sstream>

namespace voluta::replay {
namespace {

class TableWinding : public test::Programs {
protected:
  struct Compared {
    std::vector<TextFinding> findings;
    PathDeviation off;
    double seconds = 0.0;
    std::size_t detours = 0;
  };
  Compared compare(const std::vector<plan::ProgramFile>& files) const {
    const base::RunContext ctx;
    const plan::ReadProgram program =
        program::readProgram("gcode-bc", files, process::Tooling(process_));
    const ExecutedPath path = executeProgram(program, *cell_, ctx);
    const PlannedNozzle planned = plannedNozzle(trajectory_, *cell_, ctx);
    const Alignment alignment = alignProgram(program, path, planned, trajectory_, *cell_, ctx);
    Compared c;
    c.findings =
        compareWithPlan(program, path, planned, trajectory_, alignment, ComparisonOptions{});
    for (TextFinding& low : judgeApproach(program, plan_, {}, process::Tooling(process_)))
      c.findings.push_back(std::move(low));
    c.off = pathDeviation(path, planned, trajectory_, program, alignment, ctx);
    c.seconds = path.totalS();
    for (std::size_t m = 0; m < program.motions.size(); ++m)
      if (program.motions[m].detour) {
        ++c.detours;
        EXPECT_EQ(alignment.pointOf[m], kUnmatched);
      }
    return c;
  }
};

TEST_F(TableWinding, IsNoDeviation) {
  appendTurning(2, 20);
  const PlannedNozzle planned = plannedNozzle(trajectory_, *cell_, {});
  for (std::size_t i = 0; i < trajectory_.pointCount(); ++i)
    if (trajectory_.waypoint[i] != plan::kNoWaypoint)
      plan_.position[trajectory_.waypoint[i]] = planned.tip[i];
  program::ProgramInput in = input();
  in.options.own["tableUnwind"] = std::string("wind");
  in.options.own["tableTurns"] = 2.0;
  const plan::Program program = program::writeProgram("gcode-bc", in);
  const Compared c = compare(program.files);
  for (const TextFinding& f : c.findings)
    ADD_FAILURE() << f.place.line << ": " << plan::englishReason(f.finding);
  EXPECT_GE(c.detours, 6u);
  EXPECT_LT(c.off.mm, 0.05);
  EXPECT_GT(c.seconds, trajectory_.timeS.back() + 2.0 * static_cast<double>(c.detours / 3));

  // A winding that is not whole is motions that nobody has planned.
  std::vector<std::string> lines;
  std::istringstream text(program.files[0].text);
  for (std::string line; std::getline(text, line);)
    lines.push_back(line);
  const auto begin = std::ranges::find_if(lines, [](const std::string& l) {
    return l.find("the table is wound back") != std::string::npos;
  });
  ASSERT_NE(begin, lines.end());
  const auto first = static_cast<std::size_t>(begin - lines.begin()) + 1;
  for (std::size_t l = first; l < first + 3; ++l) {
    std::string fewer;
    for (std::size_t k = 0; k < lines.size(); ++k)
      if (k != l)
        fewer += lines[k] + "\n";
    const Compared damaged = compare({{program.files[0].name, fewer}});
    ASSERT_FALSE(damaged.findings.empty()) << lines[l];
    const auto at = std::ranges::min_element(damaged.findings, {},
                                             [](const TextFinding& f) { return f.place.line; });
    EXPECT_NEAR(static_cast<double>(at->place.line), static_cast<double>(l + 1), 3.0) << lines[l];
  }

  // The nozzle would pass through the part while the table turns.
  const auto heightIn = [](const std::string& line) {
    return std::stod(line.substr(line.find(" Z") + 2));
  };
  const double up = heightIn(lines[first]);
  std::size_t down = first;
  while (heightIn(lines[down]) == up)
    ++down;
  const double from = heightIn(lines[down]);
  ASSERT_GT(up, from + 2.0);
  std::string lower;
  for (std::size_t l = 0; l < lines.size(); ++l) {
    std::string& line = lines[l];
    if (l >= first && line.find(" Z") != std::string::npos && heightIn(line) == up)
      line.replace(line.find(" Z") + 2, line.find(' ', line.find(" Z") + 2) - line.find(" Z") - 2,
                   std::to_string(from + 1.0));
    lower += line + "\n";
  }
  const Compared low = compare({{program.files[0].name, lower}});
  ASSERT_FALSE(low.findings.empty());
  EXPECT_EQ(low.findings.front().place.line, first + 2);
}

} // namespace
} // namespace voluta::replay
