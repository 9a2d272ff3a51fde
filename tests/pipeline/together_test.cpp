// Arms that print side by side: without marks they collide, with marks they do not.
#include "base/error.h"
#include "base/files.h"
#include "box_request.h"
#include "helpers/temporary_folder.h"
#include "pipeline/checked_program.h"
#include "pipeline/joined_jobs.h"
#include "pipeline/resume.h"
#include "pipeline/together_check.h"
#include "program/dialect.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sstream>

using namespace voluta;
using namespace voluta::pipeline;

namespace {

const base::RunContext kCtx;
constexpr const char* kOpposite = "1040,0,0,180"; // plates of 200 mm meet at their edges

// Two small boxes, at the border between the machines and away from it, layer by layer.
PlanResult plannedTowers() {
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
    choices.items[k].placement.centreMm = {k == 0 ? 80.0 : -80.0, 0.0};
  }
  return planPart(request, kCtx);
}

const PlanResult& towers() {
  static const PlanResult kTowers = plannedTowers();
  return kTowers;
}

// All programs without their marks.
replay::SharedRun unmarked(const TogetherResult& result) {
  std::vector<plan::ReadProgram> read;
  for (const PlanResult& plan : result.plans) {
    const CheckedProgram& checked = *plan.checked.front();
    read.push_back(
        program::readProgram(checked.program.format, checked.program.files, *plan.tooling, kCtx));
    std::erase_if(read.back().facts, [](const plan::StatedFact& fact) {
      return fact.kind == plan::FactKind::MarkSet || fact.kind == plan::FactKind::MarkAwaited;
    });
  }
  std::vector<replay::RunningMachine> machines;
  for (std::size_t k = 0; k < read.size(); ++k)
    machines.push_back({read[k], *result.plans[k].cell, result.plans[k].tooling->first().process,
                        result.shared_T_world[k]});
  return replay::runTogether(machines, kCtx);
}

TogetherResult together(const PlanResult& first, const PlanResult& second, const char* place) {
  TogetherRequest request;
  request.machines = {{first.job}, {second.job, parsedMachinePlace(place)}};
  return planTogether(std::move(request), kCtx);
}

// A pair that has to wait for each other, planned once.
const TogetherResult& pair() {
  static const TogetherResult kPair = together(towers(), towers(), kOpposite);
  return kPair;
}

std::size_t marksOf(const PlanResult& plan) {
  return static_cast<std::size_t>(std::ranges::count(
      plan.job.trajectory->events, plan::EventKind::Mark, &plan::TrajectoryEvent::kind));
}

TEST(Together, MarksKeepTwoArmsApart) {
  const TogetherResult& result = pair();
  ASSERT_TRUE(result.work.order) << (result.obstruction ? base::english(*result.obstruction) : "");
  EXPECT_GT(result.work.order->meetings.size(), 0u);
  ASSERT_TRUE(result.replay);
  EXPECT_TRUE(passed(result));
  EXPECT_EQ(result.replay->collisions, 0u);
  EXPECT_GE(result.replay->leastDistanceMm, 10.0);
  for (const replay::MachineClock& clock : result.replay->clock.machines)
    EXPECT_EQ(clock.meetings().size(), result.work.order->meetings.size());
  EXPECT_GT(unmarked(result).collisions, 0u);
  EXPECT_TRUE(result.notes.empty()) << "the plates meet at their edges";
}

TEST(Together, FarApartBothWorkAllTheTime) {
  const TogetherResult result = together(towers(), towers(), "3000,0,0,180");
  ASSERT_TRUE(result.replay);
  EXPECT_TRUE(passed(result));
  EXPECT_TRUE(result.work.order->meetings.empty());
  EXPECT_DOUBLE_EQ(result.replay->clock.machines[0].waitS(), 0.0);
  // Without marks the programs are those of the jobs alone, byte for byte.
  for (std::size_t k = 0; k < 2; ++k)
    EXPECT_EQ(result.plans[k].checked.front()->program.files.front().text,
              towers().checked.front()->program.files.front().text);
}

TEST(Together, MachinesInOnePlaceHaveAReason) {
  const TogetherResult result = together(towers(), towers(), "0,0,0,0");
  EXPECT_FALSE(passed(result));
  ASSERT_TRUE(result.obstruction);
  EXPECT_NE(base::english(*result.obstruction).find("further apart"), std::string::npos);
  const std::string note = "the plates of machine 1 (ur5-moving) and machine 2 (ur5-moving) "
                           "overlap by 200.0 mm (40000 mm2)";
  ASSERT_EQ(result.notes.size(), 1u);
  EXPECT_EQ(base::english(result.notes.front()), note);
  EXPECT_EQ(nlohmann::json::parse(togetherJson(result)).at("notes"), nlohmann::json{note});
}

TEST(Together, AMarkedJobIsReadAgain) {
  TogetherResult result = pair();
  const test::TemporaryFolder folder;
  writeTogether(result, folder.path(), kCtx);
  const std::filesystem::path job = folder.path() / togetherFolder(0) / "job.voluta";
  // Its rest would count other marks than the second machine.
  ResumeRequest rest;
  rest.job = job;
  rest.bead = 3;
  EXPECT_THROW(resumePrint(rest, kCtx), base::Error);
  // Joined again, the old marks are dropped.
  const TogetherResult same =
      together(resultOf(jobToJoin(job)),
               resultOf(jobToJoin(folder.path() / togetherFolder(1) / "job.voluta")), kOpposite);
  ASSERT_TRUE(same.work.order);
  EXPECT_EQ(same.work.order->meetings.size(), result.work.order->meetings.size());
}

// A mark of a program on disk as lines of its text.
class WrittenPair : public ::testing::Test {
protected:
  void SetUp() override {
    TogetherResult result = pair();
    writeTogether(result, folder_.path(), kCtx);
    file_ = folder_.path() / togetherFolder(0) /
            replayedTogether(result.plans[0])->program.files.front().name;
    std::istringstream text(base::readFile(file_));
    for (std::string line; std::getline(text, line);)
      lines_.push_back(line);
  }
  // Returns the lines of the n-th mark behind the start mark, counted from 0: remark, and twice a
  // signal and three lines that wait.
  std::size_t markAt(std::size_t n) const {
    for (std::size_t i = 0; i < lines_.size(); ++i)
      if (lines_[i].find("# mark ") != std::string::npos && n-- == 0)
        return i;
    ADD_FAILURE() << "no such mark";
    return 0;
  }
  TogetherCheck verified() const {
    std::string text;
    for (const std::string& line : lines_)
      text += line + "\n";
    base::writeFile(file_, text);
    return verifyTogether(folder_.path(), kCtx);
  }
  static bool isAtLine(const TogetherCheck& check, std::size_t first, std::size_t last) {
    return std::ranges::any_of(check.machines[0].alone.findings, [&](const plan::Finding& f) {
      return f.blocking && f.program.line >= first && f.program.line <= last;
    });
  }
  static constexpr std::size_t kLines = 9; // of a mark

  test::TemporaryFolder folder_;
  std::filesystem::path file_;
  std::vector<std::string> lines_;
};

TEST_F(WrittenPair, PassesFromDisk) {
  const TogetherCheck check = verified();
  EXPECT_FALSE(refusal(check)) << base::english(*refusal(check));
  EXPECT_EQ(check.replay.collisions, 0u);
  EXPECT_EQ(check.replay.clock.machines[0].meetings().size(), pair().work.order->meetings.size());
  EXPECT_NEAR(check.replay.makespanS, pair().replay->makespanS, 0.1);
}

TEST_F(WrittenPair, ARemovedMarkIsRefusedAtItsLine) {
  const std::size_t at = markAt(1);
  lines_.erase(lines_.begin() + static_cast<std::ptrdiff_t>(at),
               lines_.begin() + static_cast<std::ptrdiff_t>(at + kLines));
  const TogetherCheck check = verified();
  ASSERT_TRUE(refusal(check));
  EXPECT_NE(base::english(*refusal(check)).find("machine 1"), std::string::npos);
  EXPECT_TRUE(isAtLine(check, at, at + kLines + 1));
  EXPECT_TRUE(check.replay.clock.stuck || check.replay.collisions > 0);
}

TEST_F(WrittenPair, ASignalWithdrawnTooEarlyIsRefusedAtItsLine) {
  const std::size_t at = markAt(0);
  std::swap(lines_[at + 1], lines_[at + 5]); // on, and off again
  const TogetherCheck check = verified();
  ASSERT_TRUE(refusal(check));
  EXPECT_TRUE(isAtLine(check, at + 1, at + kLines + 1));
}

// Signals that an earlier run has left count: without its start mark a machine would go on.
TEST_F(WrittenPair, AMissingStartMarkIsRefused) {
  std::size_t from = 0;
  while (lines_.at(from).find("# start mark") == std::string::npos)
    ++from;
  std::size_t to = from + 1;
  while (lines_.at(to).find("set_standard_digital") != std::string::npos ||
         lines_.at(to).find("get_standard_digital") != std::string::npos ||
         lines_.at(to) == "    sync()" || lines_.at(to) == "  end")
    ++to;
  ASSERT_GT(to, from + 10);
  lines_.erase(lines_.begin() + static_cast<std::ptrdiff_t>(from),
               lines_.begin() + static_cast<std::ptrdiff_t>(to));
  const TogetherCheck check = verified();
  ASSERT_TRUE(refusal(check));
  EXPECT_TRUE(check.replay.unsafeStart);
}

TEST(Together, AFolderWithoutProgramsIsRefused) {
  const test::TemporaryFolder folder;
  EXPECT_THROW(verifyTogether(folder.path(), kCtx), base::Error);
  for (const char* const text : {"", "{}", R"({"machines": 3})", R"({"machines": [{}, {}]})"}) {
    base::writeFile(folder.path() / "together.json", text);
    EXPECT_THROW(verifyTogether(folder.path(), kCtx), base::Error) << text;
  }
}

// ---- four SCARAs around one plate

// A T3-401S whose arm is folded aside at home and whose plate is 320 mm ahead of it.
std::filesystem::path foldedScara(const std::filesystem::path& folder) {
  auto json = nlohmann::json::parse(base::readFile(base::resourceFolder() / "cells" / "t3.json"));
  json["id"] = "t3-folded";
  json["homeDeg"] = {-21, 138, 0, 0};
  json["platform"]["pose"]["xyzMm"] = {0, 320, -275};
  const std::filesystem::path file = folder / "t3-folded.json";
  base::writeFile(file, json.dump(2));
  return file;
}

// A quarter of one print: a box in the quarter of the plate that is next to the arm.
PlanResult quarter(const std::filesystem::path& cell) {
  PlanRequest request;
  project::Choices& choices = request.choices;
  choices.cell = base::readFile(cell);
  choices.formats = {"spel"};
  choices.item().mode = "flat";
  choices.item().automatic = false;
  choices.item().platformStays = true;
  choices.item().placement.centreMm = {-34.0, 0.0}; // towards the arm
  request.item().loaded = test::loadedBox({-9, -9, 0}, {9, 9, 2.4});
  return planPart(request, kCtx);
}

TEST(Together, FourScarasPrintFourQuartersOfOnePlate) {
  const test::TemporaryFolder folder;
  const PlanResult job = quarter(foldedScara(folder.path()));
  ASSERT_TRUE(nothingBlocks(job.job.report));
  TogetherRequest request;
  const Eigen::Vector3d centre(0.0, 320.0, 0.0);
  for (int k = 0; k < 4; ++k) {
    Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
    place.translate(centre);
    place.rotate(Eigen::AngleAxisd(k * M_PI / 2.0, Eigen::Vector3d::UnitZ()));
    place.translate(-centre);
    request.machines.push_back({job.job, place});
  }
  const TogetherResult result = planTogether(std::move(request), kCtx);
  ASSERT_TRUE(result.work.order) << (result.obstruction ? base::english(*result.obstruction) : "");
  ASSERT_TRUE(result.replay);
  EXPECT_FALSE(refusal(result)) << base::english(*refusal(result));
  EXPECT_TRUE(result.notes.empty()) << "each quarter has a plate of its own";
  EXPECT_EQ(result.replay->collisions, 0u);
  EXPECT_GT(unmarked(result).collisions, 0u);
  EXPECT_GE(result.replay->leastDistanceMm, 10.0);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_GT(marksOf(result.plans[k]), 0u);
    EXPECT_EQ(result.replay->clock.machines[k].marks.size(), marksOf(result.plans[k]));
  }
}

TEST(Together, FiveMachinesAreTooMany) {
  TogetherRequest request;
  for (int k = 0; k < 5; ++k)
    request.machines.push_back({towers().job});
  EXPECT_THROW(planTogether(std::move(request), kCtx), base::Error);
}

TEST(Together, PlacesThatAreNoneAreRefused) {
  for (const char* const text : {"", "1,2,3", "a,0,0,0", "1,2,3,4,5"})
    EXPECT_THROW(parsedMachinePlace(text), base::Error) << text;
  EXPECT_NEAR(parsedMachinePlace("10,20,30,90").linear()(1, 0), 1.0, 1e-12);
}

} // namespace
