// Two UR5 that print side by side: without marks they collide, with marks they do not.
#include "base/error.h"
#include "box_request.h"
#include "helpers/temporary_folder.h"
#include "pipeline/resume.h"
#include "pipeline/together.h"
#include "program/dialect.h"

#include <algorithm>
#include <gtest/gtest.h>

using namespace voluta;
using namespace voluta::pipeline;

namespace {

const base::RunContext kCtx;
constexpr const char* kOpposite = "1040,0,0,180"; // plates of 200 mm meet at their edges

// Two small boxes, at the border between the machines and away from it, layer by layer.
PlanResult towers(bool nearFirst) {
  PlanRequest request;
  project::Choices& choices = request.choices;
  choices.cell = "ur5-moving";
  choices.formats = {"urscript"};
  choices.printOrder = layers::PrintOrder::ByLayer;
  choices.item().mode = "flat";
  choices.item().automatic = false;
  choices.item().platform = project::Platform("rect:200x200");
  choices.item().platformStays = true;
  choices.items.push_back(choices.item());
  request.items.resize(2);
  for (std::size_t k = 0; k < 2; ++k) {
    request.items[k].loaded = test::loadedBox({-6, -6, 0}, {6, 6, 3});
    choices.items[k].placement.centreMm = {(k == 0) == nearFirst ? 80.0 : -80.0, 0.0};
  }
  return planPart(request, kCtx);
}

// Both programs without their marks.
replay::TwoMachines unmarked(const TogetherResult& result) {
  std::array<plan::ReadProgram, 2> read;
  for (std::size_t k = 0; k < 2; ++k) {
    const CheckedProgram& checked = *result.plans[k].checked.front();
    read[k] = program::readProgram(checked.program.format, checked.program.files,
                                   *result.plans[k].tooling, kCtx);
    std::erase_if(read[k].facts, [](const plan::StatedFact& fact) {
      return fact.kind == plan::FactKind::MarkSet || fact.kind == plan::FactKind::MarkAwaited;
    });
  }
  const auto machine = [&](std::size_t k) {
    return replay::RunningMachine{read[k], *result.plans[k].cell,
                                  result.plans[k].tooling->first().process,
                                  result.shared_T_world[k]};
  };
  return replay::runTogether(machine(0), machine(1), kCtx);
}

TogetherResult together(const PlanResult& first, const PlanResult& second, const char* place) {
  TogetherRequest request;
  request.jobs = {first.job, second.job};
  request.first_T_second = parsedMachinePlace(place);
  return planTogether(std::move(request), kCtx);
}

TEST(Together, MarksKeepTwoArmsApart) {
  const PlanResult towers = ::towers(true);
  ASSERT_TRUE(nothingBlocks(towers.job.report));
  const TogetherResult result = together(towers, towers, kOpposite);
  ASSERT_TRUE(result.work.schedule)
      << (result.obstruction ? base::english(*result.obstruction) : "");
  EXPECT_GT(result.work.schedule->marks(), 0u);
  ASSERT_TRUE(result.replay);
  EXPECT_TRUE(passed(result));
  EXPECT_EQ(result.replay->collisions, 0u);
  EXPECT_GE(result.replay->leastDistanceMm, 10.0);
  for (const replay::MachineClock& clock : result.replay->clock.machines)
    EXPECT_EQ(clock.marks, result.work.schedule->marks());
  EXPECT_GT(unmarked(result).collisions, 0u);
}

TEST(Together, FarApartBothWorkAllTheTime) {
  const PlanResult towers = ::towers(true);
  const TogetherResult result = together(towers, towers, "3000,0,0,180");
  ASSERT_TRUE(result.replay);
  EXPECT_TRUE(passed(result));
  EXPECT_EQ(result.work.schedule->marks(), 0u);
  EXPECT_DOUBLE_EQ(result.replay->clock.machines[0].waitS, 0.0);
  // Without marks the programs are those of the jobs alone, byte for byte.
  for (std::size_t k = 0; k < 2; ++k)
    EXPECT_EQ(result.plans[k].checked.front()->program.files.front().text,
              towers.checked.front()->program.files.front().text);
}

TEST(Together, MachinesInOnePlaceHaveAReason) {
  const PlanResult towers = ::towers(true);
  const TogetherResult result = together(towers, towers, "0,0,0,0");
  EXPECT_FALSE(passed(result));
  ASSERT_TRUE(result.obstruction);
  EXPECT_NE(base::english(*result.obstruction).find("further apart"), std::string::npos);
}

TEST(Together, AMarkedJobIsReadAgain) {
  const PlanResult towers = ::towers(true);
  TogetherResult result = together(towers, towers, kOpposite);
  ASSERT_TRUE(result.work.schedule);
  const test::TemporaryFolder folder;
  writeTogether(result, folder.path(), kCtx);
  const std::filesystem::path job = folder.path() / "first" / "job.voluta";
  const VerifyResult again = verifyProgram(
      folder.path() / "first" / result.plans[0].checked.front()->program.files.front().name, job,
      kCtx);
  EXPECT_TRUE(again.replay.passed);
  // Its rest would count other marks than the second machine.
  ResumeRequest rest;
  rest.job = job;
  rest.bead = 3;
  EXPECT_THROW(resumePrint(rest, kCtx), base::Error);
  // Joined again, the old marks are dropped.
  const TogetherResult same =
      together(resultOf(jobToJoin(job)),
               resultOf(jobToJoin(folder.path() / "second" / "job.voluta")), kOpposite);
  ASSERT_TRUE(same.work.schedule);
  EXPECT_EQ(same.work.schedule->marks(), result.work.schedule->marks());
}

TEST(Together, PlacesThatAreNoneAreRefused) {
  for (const char* const text : {"", "1,2,3", "a,0,0,0", "1,2,3,4,5"})
    EXPECT_THROW(parsedMachinePlace(text), base::Error) << text;
  EXPECT_NEAR(parsedMachinePlace("10,20,30,90").linear()(1, 0), 1.0, 1e-12);
}

} // namespace
