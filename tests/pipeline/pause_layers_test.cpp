// Pauses and other events before layers, as they are asked for and as they come.
#include "base/error.h"
#include "base/files.h"
#include "helpers/temporary_folder.h"
#include "pipeline/box_request.h"
#include "pipeline/checked_program.h"
#include "pipeline/item_events.h"
#include "pipeline/outputs.h"
#include "pipeline/plan_reasons.h"
#include "pipeline/plan_result.h"
#include "pipeline/plan_verdict.h"
#include "pipeline/resume.h"
#include "pipeline/road.h"
#include "pipeline/stage_options.h"
#include "plan/finding_kinds.h"
#include "plan/tool_plan.h"
#include "plan/trajectory.h"
#include "plan/waypoints.h"
#include "project/job.h"

#include <algorithm>
#include <fmt/format.h>
#include <gtest/gtest.h>

using namespace voluta;
using namespace voluta::pipeline;

namespace {

using Parameters = std::map<std::string, std::string>;

PlanResult planned(const Parameters& parameters, std::vector<std::string> formats = {"urscript"}) {
  PlanRequest request = test::boxRequest(parameters);
  request.choices.item().mode = "flat";
  request.choices.formats = std::move(formats);
  return planPart(request, base::RunContext());
}

std::vector<plan::TrajectoryEvent> eventsOf(const PlanResult& plan, plan::EventKind kind) {
  std::vector<plan::TrajectoryEvent> events;
  std::ranges::copy_if(plan.job.trajectory->events, std::back_inserter(events),
                       [&](const plan::TrajectoryEvent& event) { return event.kind == kind; });
  return events;
}

const plan::ToolPath& pathBehind(const PlanResult& plan, const plan::TrajectoryEvent& event) {
  return *plan::pathOf(*plan.job.toolPlan, plan::waypointAhead(*plan.job.trajectory, event.point));
}

// All files of the first program.
std::string textOf(const PlanResult& plan) {
  std::string text;
  for (const plan::ProgramFile& file : plan.checked.front()->program.files)
    text += file.text;
  return text;
}

std::string refusalOf(const std::function<void()>& run) {
  try {
    run();
  } catch (const base::Error& error) {
    EXPECT_EQ(error.code(), base::ErrorCode::Usage);
    return base::english(error.whole());
  }
  return {};
}

TEST(PauseLayers, ComeBeforeTheLayersThatThePrintHas) {
  const PlanResult plan = planned({{"pauseLayers", "3, 5"}});
  const auto pauses = eventsOf(plan, plan::EventKind::Pause);
  ASSERT_EQ(pauses.size(), 2u);
  EXPECT_EQ(pathBehind(plan, pauses[0]).layer, 2);
  EXPECT_NE(pauses[0].text.find("before layer 3 of "), std::string::npos) << pauses[0].text;
  EXPECT_EQ(verdictOf(plan.job.report), PlanVerdict::Passed) << test::reasons(plan);
  const std::string text = textOf(plan);
  EXPECT_NE(text.find("popup(\"" + pauses[1].text), std::string::npos);
  EXPECT_NE(text.find("# layer 1, "), std::string::npos) << "layers count from 1";
  EXPECT_EQ(text.find("# layer 0, "), std::string::npos);
}

TEST(PauseLayers, ALayerThatThePrintLacksIsRefused) {
  EXPECT_NE(refusalOf([] {
              planned({{"pauseLayers", "3, 99"}});
            }).find("before layer 99"),
            std::string::npos);
  EXPECT_NE(refusalOf([] {
              planned({{"layerEvents", "z99 wait 5"}});
            }).find("before height 99"),
            std::string::npos);
  // The setting that is to be corrected.
  const std::string listed = refusalOf([] {
    planned({{"pauseLayers", "99"}});
  }),
                    event = refusalOf([] {
                      planned({{"layerEvents", "99 pause"}});
                    });
  EXPECT_NE(listed.find("pauseLayers"), std::string::npos) << listed;
  EXPECT_NE(event.find("layerEvents"), std::string::npos) << event;
}

PlanRequest twoBoxes() {
  PlanRequest request;
  request.items.resize(2);
  request.choices.items.resize(2);
  for (std::size_t i = 0; i < 2; ++i) {
    request.item(i).loaded = test::loadedBox({-9, -8, 0}, {9, 8, i == 0 ? 4.0 : 6.0});
    request.choices.item(i).mode = "flat";
    request.choices.item(i).placement.centreMm.x() = 70.0 * static_cast<double>(i) - 35.0;
  }
  request.choices.cell = "ur5-moving";
  request.choices.formats = {"urscript"};
  return request;
}

TEST(PauseLayers, AreThoseOfEachPart) {
  PlanRequest request = twoBoxes();
  setItemParameters(request.choices.item(1), {"pauseLayers=3"});
  PlanResult plan = planPart(request, base::RunContext());
  auto pauses = eventsOf(plan, plan::EventKind::Pause);
  ASSERT_EQ(pauses.size(), 1u);
  EXPECT_EQ(pathBehind(plan, pauses[0]).item, 1);
  EXPECT_NE(pauses[0].text.find("layer 3 of "), std::string::npos) << pauses[0].text;
  EXPECT_NE(pauses[0].text.find("of part 2"), std::string::npos) << pauses[0].text;
  const project::StageKeys with = stageKeys(request);
  setItemParameters(request.choices.item(1), {"pauseLayers=2"});
  EXPECT_NE(stageKeys(request)[project::indexOf(project::Stage::Motion)],
            with[project::indexOf(project::Stage::Motion)]);
  setItemParameters(request.choices.item(0), {"pauseLayers=2"});
  plan = planPart(request, base::RunContext());
  pauses = eventsOf(plan, plan::EventKind::Pause);
  ASSERT_EQ(pauses.size(), 2u);
  EXPECT_EQ(pathBehind(plan, pauses[0]).item, 0);
  EXPECT_EQ(pathBehind(plan, pauses[1]).item, 1);
  setItemParameters(request.choices.item(0), {"pauseLayers=50"});
  const std::string refused = refusalOf([&] { planPart(request, base::RunContext()); });
  EXPECT_NE(refused.find("before layer 50 of part 1: the part has "), std::string::npos) << refused;
}

// Every kind in one job with two tools, in every format that says them.
TEST(LayerEvents, ComeInEveryFormatThatSaysThem) {
  const std::vector<std::string> formats = {"urscript", "rapid", "krl", "melfa", "gcode-extended"};
  PlanRequest request = test::boxRequest(
      {{"layerEvents", "2 wait 20; z3 pause Put in the nut; 5 output 40 on; 6 tool 2"}});
  request.choices.item().mode = "flat";
  request.choices.cell = "ur5-moving";
  request.choices.tools = {{"fdm-1.0"}, {"fdm-1.0"}};
  request.choices.formats = formats;
  const PlanResult plan = planPart(request, base::RunContext());
  ASSERT_EQ(eventsOf(plan, plan::EventKind::Wait).size(), 1u);
  ASSERT_EQ(eventsOf(plan, plan::EventKind::Output).size(), 1u);
  const auto changes = eventsOf(plan, plan::EventKind::ToolChange);
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_EQ(pathBehind(plan, changes[0]).layer, 5);
  for (const plan::ToolPath& path : plan.job.toolPlan->paths)
    EXPECT_EQ(path.tool, path.layer >= 5 ? 1 : 0);
  const auto pauses = eventsOf(plan, plan::EventKind::Pause); // one for the tool
  ASSERT_EQ(pauses.size(), 2u);
  EXPECT_EQ(pauses[0].text.rfind("Put in the nut (layer 4", 0), 0u) << pauses[0].text;
  ASSERT_EQ(plan.checked.size(), formats.size());
  for (const auto& checked : plan.checked) {
    // URScript has outputs up to 7.
    const bool says = checked->program.format != "urscript";
    EXPECT_EQ(checked->verdict.passed, says) << checked->program.format << test::reasons(plan);
    EXPECT_EQ(checked->program.files.empty(), !says) << checked->program.format;
  }
  request.choices.item().parameters["layerEvents"] = "2 tool 3";
  EXPECT_NE(refusalOf([&] { planPart(request, base::RunContext()); }).find("has no tool 3"),
            std::string::npos);
}

TEST(LayerEvents, AnOwnStatementIsNamedAndMakesThePlanAmber) {
  PlanResult plan = planned({{"layerEvents", "3 statement urscript set_tool_voltage(24)"}});
  EXPECT_EQ(verdictOf(plan.job.report), PlanVerdict::Unchecked) << test::reasons(plan);
  EXPECT_EQ(verdictOf(*plan.checked.front(), plan.job.report), PlanVerdict::Unchecked);
  // The same in report.json and in the program's head.
  const project::VerdictReport verdict = verdictReport(plan.job.report);
  EXPECT_EQ(verdict.verdict, "unchecked");
  EXPECT_FALSE(verdict.safeToRun) << "nobody has checked the statement";
  EXPECT_FALSE(verdict.printsAsAsked);
  const std::string text = textOf(plan);
  EXPECT_NE(text.find("safe to run but for your own statements, which nothing checks\n"),
            std::string::npos)
      << text.substr(0, 1000);
  const test::TemporaryFolder folder;
  writeOutputs(plan, folder.path(), base::RunContext());
  const std::string name = plan.checked[0]->program.files[0].name;
  EXPECT_NE(base::readFile(folder / (name + ".proof.html"))
                .find("Safe to run but for your own statements, which nothing checks."),
            std::string::npos);
  EXPECT_NE(base::readFile(folder / (name + ".proof.json")).find("\"verdict\": \"unchecked\""),
            std::string::npos);
  EXPECT_EQ(verdictOf(verifyProgram(folder / name, folder / "job.voluta", base::RunContext())),
            PlanVerdict::Unchecked);
  const auto found = std::ranges::find(plan.job.report.findings, plan::FindingKind::OwnStatement,
                                       &plan::Finding::kind);
  ASSERT_NE(found, plan.job.report.findings.end());
  EXPECT_NE(plan::englishReason(*found).find("set_tool_voltage(24)"), std::string::npos);
}

// A place has a statement for each format: a program has its own, and a format without one is not
// written.
TEST(LayerEvents, AStatementOfEachFormatIsInItsProgram) {
  PlanResult plan = planned({{"layerEvents", "3 statement urscript own_call(1); 3 statement rapid "
                                             "OwnCall 1;; 3 statement rapid OwnCall 2;"}},
                            {"urscript", "rapid", "gcode-extended"});
  ASSERT_EQ(plan.checked.size(), 3u);
  const auto textOf = [&](std::size_t i) {
    std::string text;
    for (const plan::ProgramFile& file : plan.checked[i]->program.files)
      text += file.text;
    return text;
  };
  const std::string urscript = textOf(0), rapid = textOf(1);
  EXPECT_NE(urscript.find("own_call(1)"), std::string::npos);
  EXPECT_EQ(urscript.find("OwnCall"), std::string::npos);
  EXPECT_NE(rapid.find("OwnCall 1;"), std::string::npos);
  EXPECT_NE(rapid.find("OwnCall 2;"), std::string::npos);
  EXPECT_EQ(rapid.find("own_call"), std::string::npos);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_EQ(plan.checked[i]->deviations, 0u) << i << test::reasons(plan);
  EXPECT_TRUE(plan.checked[2]->program.files.empty());
  EXPECT_NE(test::reasons(plan).find("the statement 'own_call(1)' is one of format urscript, not "
                                     "of gcode-extended"),
            std::string::npos)
      << test::reasons(plan);
  // Read back, each is verified by its own; resumed, the formats are those that there are.
  const test::TemporaryFolder folder;
  writeOutputs(plan, folder.path(), base::RunContext());
  for (std::size_t i = 0; i < 2; ++i) {
    const VerifyResult read =
        verifyProgram(folder / plan.checked[i]->program.files[0].name, folder / "job.voluta", {});
    EXPECT_EQ(
        std::ranges::count(read.findings, plan::FindingKind::OwnStatement, &plan::Finding::kind),
        i == 0 ? 1 : 2);
  }
  ResumeRequest request;
  request.job = folder / "job.voluta";
  request.bead = plan.job.toolPlan->paths.size();
  const ResumeResult both = resumePrint(request, {});
  ASSERT_EQ(both.plan.checked.size(), 2u);
  EXPECT_EQ(verdictOf(both.plan.job.report), PlanVerdict::Passed) << test::reasons(both.plan);
  EXPECT_NE(test::reasons(both.plan).find("does not run your statement before its beginning"),
            std::string::npos);
  request.program = folder / plan.checked[1]->program.files[0].name;
  const ResumeResult one = resumePrint(request, {});
  ASSERT_EQ(one.plan.checked.size(), 1u);
  EXPECT_EQ(one.plan.checked[0]->program.format, "rapid");
}

TEST(LayerEvents, AStatementOfAnUnknownFormatIsRefusedBeforePlanning) {
  const std::string refused = refusalOf([] {
    planned({{"layerEvents", "3 statement urscrip own_call(1)"}});
  });
  EXPECT_NE(refused.find("unknown format 'urscrip'"), std::string::npos) << refused;
  EXPECT_NE(refused.find("urscript"), std::string::npos) << refused;
}

TEST(LayerEvents, AStatementThatMovesTheArmIsRefusedBeforePlanning) {
  const std::string refused = refusalOf([] {
    planned({{"layerEvents", "3 statement krl LIN P1"}});
  });
  EXPECT_NE(refused.find("'lin' in the statement before layer 3, 'LIN P1', moves the arm"),
            std::string::npos)
      << refused;
  EXPECT_NE(refused.find("layerEvents"), std::string::npos) << refused;
  // The program's own variables are known where it is written.
  const std::string sets = refusalOf([] {
    planned({{"layerEvents", "3 statement rapid tNozzle.robhold:=FALSE;"}}, {"rapid"});
  });
  EXPECT_NE(sets.find("sets 'tnozzle', which the program uses itself"), std::string::npos) << sets;
}

TEST(LayerEvents, AreKeptInTheProject) {
  const PlanResult plan =
      planned({{"pauseLayers", "3"}, {"layerEvents", "4 output 3 on; 5 pause Put in the nut"}});
  const test::TemporaryFolder folder;
  project::writeJob(folder / "job.voluta", plan.job);
  const project::Job again = project::readJob(folder / "job.voluta", allParameters());
  ASSERT_EQ(again.trajectory->events.size(), plan.job.trajectory->events.size());
  for (std::size_t e = 0; e < again.trajectory->events.size(); ++e) {
    EXPECT_EQ(again.trajectory->events[e].kind, plan.job.trajectory->events[e].kind);
    EXPECT_EQ(again.trajectory->events[e].text, plan.job.trajectory->events[e].text);
    EXPECT_EQ(again.trajectory->events[e].on, plan.job.trajectory->events[e].on);
    EXPECT_EQ(again.trajectory->events[e].tool, plan.job.trajectory->events[e].tool);
  }
}

// As the window does while an event is typed.
TEST(LayerEvents, AreCheckedByThemselvesAsByThePlan) {
  PlanRequest request = test::boxRequest({});
  request.choices.item().mode = "flat";
  request.choices.formats = {"urscript"};
  const auto refusalOfText = [&](const char* text) {
    const auto refusal = eventRefusal(request.choices, text);
    return refusal ? base::english(refusal->whole()) : std::string();
  };
  for (const char* sound : {"3 pause", "3 output 4 on", "3 photo 4", "2 wait 5; 3 pause Look",
                            "3 statement urscript set_flag(3, True)"})
    EXPECT_EQ(refusalOfText(sound), "") << sound;
  EXPECT_NE(refusalOfText("3 output 4000 on").find("has outputs"), std::string::npos);
  EXPECT_NE(refusalOfText("3 photo 4000").find("has outputs"), std::string::npos);
  EXPECT_NE(refusalOfText("3 wait"), "");
  EXPECT_NE(refusalOfText("3 statement urscript movej(p)"), "");
  EXPECT_NE(refusalOfText("3 statement krl own_call(1)").find("krl"), std::string::npos);
}

// A slicer's file that stops for another filament.
TEST(LayerEvents, StopsOfAFileBecomePauses) {
  std::string text = "; filament_diameter = 1.75\nG21\nG90\nM83\nG28\n";
  for (int k = 0; k < 4; ++k) {
    text += fmt::format(";LAYER_CHANGE\n;Z:{0}\n;HEIGHT:0.8\n", 0.8 * (k + 1));
    if (k == 2)
      text += "M600\n";
    for (int line = 0; line < 12; ++line)
      text +=
          fmt::format("G0 X{0} Y0 Z{1} F3000\nG1 X{0} Y20 E8 F1200\n", 1.2 * line, 0.8 * (k + 1));
  }
  const test::TemporaryFolder folder;
  base::writeFile(folder / "part.gcode", text);
  PlanRequest request;
  request.item().part = (folder / "part.gcode").string();
  request.choices.item().automatic = true;
  request.choices.formats = {"urscript"};
  const PlanResult plan = planPart(request, base::RunContext());
  const auto pauses = eventsOf(plan, plan::EventKind::Pause);
  ASSERT_EQ(pauses.size(), 1u) << test::reasons(plan);
  EXPECT_EQ(pathBehind(plan, pauses[0]).layer, 2);
  EXPECT_EQ(pauses[0].text.rfind("Change the filament (layer 3 of 4", 0), 0u) << pauses[0].text;
  EXPECT_TRUE(plan.checked.front()->safeToRun) << test::reasons(plan);
  EXPECT_NE(textOf(plan).find("Change the filament"), std::string::npos);
}

} // namespace
