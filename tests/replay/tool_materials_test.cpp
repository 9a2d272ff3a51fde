// Each tool of a job by its own material: heat, flow of purges and shots, mass.
#include "plan/finding_kinds.h"
#include "plan/waypoints.h"
#include "replay/event_programs.h"
#include "replay/told.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <regex>

namespace voluta::replay {
namespace {

constexpr double kChangeMm3 = 50.0, kChangeS = 4.0;

// A box of two layers, by PLA at 210 °C and PETG at 240 °C.
class ToolMaterials : public EventPrograms {
protected:
  void SetUp() override {
    scene_ = test::boxScene(2);
    process::Process other = scene_.process;
    other.id = "other";
    other.material = process::loadMaterial("petg");
    ASSERT_NE(other.material.nozzleC, scene_.process.material.nozzleC);
    tooling_ = process::Tooling({{scene_.process}, {other}});
  }
  // The second tool prints the second layer.
  void changeTool() {
    plan::Trajectory& t = scene_.trajectory;
    std::size_t point = 1;
    const auto isFirst = [&](std::size_t i) {
      if (t.move[i + 1] != plan::MoveKind::Print || t.move[i] == plan::MoveKind::Print)
        return false;
      return plan::pathOf(scene_.plan, t.waypoint[i])->layer > 0;
    };
    while (!isFirst(point))
      ++point;
    for (plan::ToolPath& path : scene_.plan.paths)
      path.tool = path.layer > 0 ? 1 : 0;
    test::moveSideways(t, scene_.cell, point - 1);
    t.events = {{.point = point, .kind = plan::EventKind::Pause},
                {.point = point, .kind = plan::EventKind::ToolChange, .tool = 1},
                {.point = point,
                 .kind = plan::EventKind::Purge,
                 .seconds = kChangeS,
                 .volumeMm3 = kChangeMm3}};
  }
  static std::vector<std::string> formats() {
    std::vector<std::string> ids{"gcode"};
    for (const std::string_view id : formatsWith(plan::EventKind::ToolChange))
      ids.emplace_back(id);
    return ids;
  }
  static std::size_t replace(test::ProgramText& text, const std::string& pattern,
                             const std::string& by) {
    std::size_t last = 0;
    for (std::size_t i = 0; i < text.lines.size(); ++i) {
      const std::string now = std::regex_replace(text.lines[i], std::regex(pattern), by);
      if (now != text.lines[i])
        last = i + 1;
      text.lines[i] = now;
    }
    return last;
  }
  static bool isAt(const Verification& v, plan::FindingKind kind, std::size_t line) {
    for (std::size_t i = 0; i < v.findings.size(); ++i)
      if (v.findings[i].kind == kind && v.places[i].line == line)
        return true;
    return false;
  }
};

TEST_F(ToolMaterials, TheHeatOfAnotherMaterialIsRefused) {
  changeTool();
  for (const std::string format : {"gcode-extended", "gcode"}) {
    const test::ProgramText whole = test::textOf(programFor(format));
    EXPECT_TRUE(verify(read(whole)).passed) << findingsText(verify(read(whole)));
    const struct {
      const char *first, *second;
    } edits[] = {{"240", "210"}, {"240", "240"}, {"210", "210"}, {"210", "230"}, {"218", "240"}};
    for (const auto& edit : edits) {
      SCOPED_TRACE(format + ": " + edit.first + ", " + edit.second);
      test::ProgramText text = whole;
      const std::size_t first = replace(text, "(M10[49] T0) S[1-9][0-9]*",
                                        std::string("$1 S") + edit.first),
                        second = replace(text, "(M10[49] T1) S[1-9][0-9]*",
                                         std::string("$1 S") + edit.second);
      const Verification v = verify(read(text));
      const bool isEdited[] = {edit.first != std::string("210"), edit.second != std::string("240")};
      EXPECT_EQ(v.passed, !isEdited[0] && !isEdited[1]);
      if (isEdited[0]) {
        EXPECT_TRUE(isAt(v, plan::FindingKind::StatementChanged, first)) << findingsText(v);
      }
      if (isEdited[1]) {
        EXPECT_TRUE(isAt(v, plan::FindingKind::StatementChanged, second)) << findingsText(v);
      }
    }
    // A few degrees are the operator's own matter.
    test::ProgramText tuned = whole;
    replace(tuned, "T0 S210", "T0 S214");
    replace(tuned, "T1 S240", "T1 S236");
    EXPECT_TRUE(verify(read(tuned)).passed) << findingsText(verify(read(tuned)));
  }
}

TEST_F(ToolMaterials, APurgeAboveTheGreatestFlowIsRefusedAtItsLine) {
  changeTool();
  plan::Trajectory& t = scene_.trajectory;
  std::size_t shot = t.events[0].point + 1;
  while (t.move[shot] == plan::MoveKind::Print)
    ++shot;
  t.events.push_back(
      {.point = shot + 1, .kind = plan::EventKind::Shot, .seconds = 2.0, .volumeMm3 = 20.0});
  for (const std::string& format : formats()) {
    SCOPED_TRACE(format);
    const plan::ReadProgram whole = read(test::textOf(programFor(format)));
    // The shot has no pocket to fill.
    EXPECT_EQ(verify(whole).deviations, 0u) << findingsText(verify(whole));
    const double maximum = process::flowLimit(tooling_.at(1).process);
    std::size_t edited = 0;
    for (std::size_t p = 0; p < whole.pauses.size(); ++p) {
      if (whole.pauses[p].volumeMm3 < 5.0)
        continue;
      ++edited;
      for (const double times : {1.2, 1000.0}) {
        plan::ReadProgram program = whole;
        program.pauses[p].durationS = program.pauses[p].volumeMm3 / (times * maximum);
        const Verification v = verify(program);
        EXPECT_FALSE(v.passed);
        EXPECT_TRUE(isAt(v, plan::FindingKind::Flow, program.pauses[p].line)) << findingsText(v);
      }
    }
    EXPECT_GE(edited, 2u);
  }
  test::ProgramText text = test::textOf(programFor("gcode"));
  const std::size_t line = replace(text, "^(G1 E[0-9.]+ F)[0-9.]+$", "$0199780");
  EXPECT_TRUE(isAt(verify(read(text)), plan::FindingKind::Flow, line));
}

// Half a box of each: the mass on the flange is that of both materials.
TEST_F(ToolMaterials, ThePayloadHasBothDensities) {
  process::Process heavy = tooling_.at(1).process;
  heavy.material.densityGPerCm3 = 8.0;
  tooling_ = process::Tooling({{scene_.process}, {heavy}});
  changeTool();
  const double light = scene_.process.material.densityGPerCm3;
  const double mm3 = scene_.trajectory.extrudedMm3.back();
  EXPECT_NEAR(tooling_.printedG(scene_.trajectory), 0.5e-3 * mm3 * (light + 8.0), 1e-3 * mm3);
  // As planned, beads are rounded at their sides; these of the box are walked with that section.
  EXPECT_NEAR(tooling_.printedG(scene_.plan), tooling_.printedG(scene_.trajectory),
              0.02 * tooling_.printedG(scene_.trajectory));
  const double planned = scene_.cell.carriedKg() + 1e-3 * tooling_.printedG(scene_.trajectory);
  std::size_t stated = 0;
  for (const std::string& format : formats()) {
    const plan::ReadProgram read = this->read(test::textOf(programFor(format)));
    if (!read.load)
      continue;
    ++stated;
    EXPECT_NEAR(read.load->kg, planned, 6e-4) << format;
  }
  EXPECT_GE(stated, 4u);
}

} // namespace
} // namespace voluta::replay
