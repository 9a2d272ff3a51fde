// Arms that print side by side: without marks they collide, with marks they do not.
#include "base/error.h"
#include "base/files.h"
#include "box_request.h"
#include "helpers/temporary_folder.h"
#include "pipeline/checked_program.h"
#include "pipeline/placed_programs.h"
#include "pipeline/resume.h"
#include "pipeline/station_check.h"
#include "pipeline/station_plan.h"
#include "pipeline/station_resume.h"
#include "plan/finding_kinds.h"
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

// Small boxes on a plate, `placesMm` from its middle, layer by layer.
PlanResult plannedBoxes(const std::vector<double>& placesMm) {
  PlanRequest request;
  project::Choices& choices = request.choices;
  choices.cell = "ur5-moving";
  choices.formats = {"urscript"};
  choices.printOrder = layers::PrintOrder::ByLayer;
  choices.item().mode = "flat";
  choices.item().automatic = false;
  choices.item().platform = project::Platform("rect:200x200");
  choices.item().platformStays = true;
  choices.items.resize(placesMm.size(), choices.item());
  request.items.resize(placesMm.size());
  for (std::size_t k = 0; k < placesMm.size(); ++k) {
    request.items[k].loaded = test::loadedBox({-6, -6, 0}, {6, 6, 3});
    choices.items[k].placement.centreMm = {placesMm[k], 0.0};
  }
  return planPart(request, kCtx);
}

// One at the border between the machines, one away from it.
const PlanResult& towers() {
  static const PlanResult kTowers = plannedBoxes({80.0, -80.0});
  return kTowers;
}
const PlanResult& borderBox() {
  static const PlanResult kBox = plannedBoxes({80.0});
  return kBox;
}

// All programs without their marks.
replay::SharedRun unmarked(const StationResult& result) {
  std::vector<plan::ReadProgram> read;
  for (const PlanResult& plan : result.plans) {
    const CheckedProgram& checked = *plan.checked.front();
    read.push_back(
        program::readProgram(checked.program.format, checked.program.files, plan.tooling(), kCtx));
    std::erase_if(read.back().facts, [](const plan::StatedFact& fact) {
      return fact.kind == plan::FactKind::MarkSet || fact.kind == plan::FactKind::MarkAwaited;
    });
  }
  std::vector<replay::PlacedProgram> machines;
  for (std::size_t k = 0; k < read.size(); ++k)
    machines.push_back({read[k], *result.plans[k].cell, result.plans[k].tooling().first().process,
                        result.shared_T_world[k]});
  return replay::runTogether(machines, kCtx);
}

StationResult together(const PlanResult& first, const PlanResult& second, const char* place) {
  project::Station station;
  station.machines = {{"first", first.job}, {"second", second.job, parsedMachinePlace(place)}};
  return planStation(std::move(station), kCtx);
}

template <typename T> std::string why(const T& result) {
  const plan::Finding* refusal = firstBlocking(result.findings);
  return refusal ? plan::englishReason(*refusal) : "";
}

plan::Findings notesOf(const StationResult& result) {
  plan::Findings notes = result.findings;
  std::erase_if(notes, [](const plan::Finding& finding) { return finding.blocking; });
  return notes;
}

// A pair that has to wait for each other, planned once.
const StationResult& pair() {
  static const StationResult kPair = together(towers(), towers(), kOpposite);
  return kPair;
}

std::size_t marksOf(const PlanResult& plan) {
  return static_cast<std::size_t>(std::ranges::count(
      plan.job.trajectory->events, plan::EventKind::Mark, &plan::TrajectoryEvent::kind));
}

TEST(Together, MarksKeepTwoArmsApart) {
  const StationResult& result = pair();
  ASSERT_TRUE(result.work.order) << why(result);
  EXPECT_GT(result.work.order->meetings.size(), 0u);
  ASSERT_TRUE(result.replay);
  EXPECT_TRUE(passed(result));
  EXPECT_EQ(result.replay->collisions, 0u);
  EXPECT_GE(result.replay->minDistanceMm, 10.0);
  for (const replay::MachineClock& clock : result.replay->clock.machines)
    EXPECT_EQ(clock.meetings().size(), result.work.order->meetings.size());
  EXPECT_GT(unmarked(result).collisions, 0u);
  EXPECT_TRUE(notesOf(result).empty()) << "the plates meet at their edges";
}

TEST(Together, FarApartBothWorkAllTheTime) {
  const StationResult result = together(towers(), towers(), "3000,0,0,180");
  ASSERT_TRUE(result.replay);
  EXPECT_TRUE(passed(result));
  EXPECT_TRUE(result.work.order->meetings.empty());
  EXPECT_DOUBLE_EQ(result.replay->clock.machines[0].waitS(), 0.0);
  // Without marks the programs are those of the jobs alone, byte for byte.
  for (std::size_t k = 0; k < 2; ++k)
    EXPECT_EQ(result.plans[k].checked.front()->program.files.front().text,
              towers().checked.front()->program.files.front().text);
}

// A machine whose part differs keeps nobody from working.
TEST(Together, AnAmberMachineMakesAnAmberStation) {
  PlanResult amber = towers();
  amber.job.report.findings.insert(
      amber.job.report.findings.begin(),
      plan::makeFinding(plan::FindingKind::NoPathTo, {{"place", "bead 3"_name}, {"pieces", 1}}));
  ++amber.job.stages[project::indexOf(project::Stage::Load)].findings;
  StationResult result = together(towers(), amber, "3000,0,0,180");
  ASSERT_TRUE(result.replay) << why(result);
  EXPECT_EQ(verdictOf(result), PlanVerdict::NotAsAsked);
  EXPECT_FALSE(passed(result));
  const plan::Finding* first = firstBlocking(result.findings);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->kind, plan::FindingKind::MachineDiffers);
  EXPECT_EQ(why(result), "machine 2 is safe to run, but does not print its part as asked: bead 3: "
                         "no collision-free transfer to 1 piece of a path");
  const test::TemporaryFolder folder;
  writeStationOutputs(result, folder.path(), kCtx);
  const std::string json = base::readFile(folder / "together.json");
  EXPECT_NE(json.find("\"verdict\": \"differs\",\n  \"safeToRun\": true"), std::string::npos)
      << json;
  const StationCheck check = verifyStation(folder.path(), kCtx);
  ASSERT_TRUE(firstBlocking(check.findings));
  EXPECT_EQ(firstBlocking(check.findings)->kind, plan::FindingKind::MachineDiffers);
}

TEST(Together, MachinesInOnePlaceHaveAReason) {
  const StationResult result = together(towers(), towers(), "0,0,0,0");
  EXPECT_FALSE(passed(result));
  const plan::Finding* refusal = firstBlocking(result.findings);
  ASSERT_TRUE(refusal);
  EXPECT_NE(plan::englishRemedy(*refusal).find("further apart"), std::string::npos);
  EXPECT_TRUE(refusal->where);
  const std::string note = "the plates of machine 1 (ur5-moving) and machine 2 (ur5-moving) "
                           "overlap by 200.0 mm (40000 mm2)";
  ASSERT_EQ(notesOf(result).size(), 1u);
  EXPECT_EQ(plan::englishReason(notesOf(result).front()), note);
  EXPECT_EQ(nlohmann::json::parse(stationJson(result)).at("findings").at(0).at("reason"), note);
}

project::Job jobIn(const std::filesystem::path& file) {
  return plannedStation(file).machines.front().job;
}

TEST(Together, AMarkedJobIsReadAgain) {
  StationResult result = pair();
  const test::TemporaryFolder folder;
  writeStationOutputs(result, folder.path(), kCtx);
  const std::filesystem::path job = folder.path() / machineFolder(0) / "job.voluta";
  // Its rest would count other marks than the second machine.
  ResumeRequest rest;
  rest.job = job;
  rest.bead = 3;
  EXPECT_THROW(resumePrint(rest, kCtx), base::Error);
  // Joined again, the old marks are dropped.
  const StationResult same =
      together(resultOf(jobIn(job)),
               resultOf(jobIn(folder.path() / machineFolder(1) / "job.voluta")), kOpposite);
  ASSERT_TRUE(same.work.order);
  EXPECT_EQ(same.work.order->meetings.size(), result.work.order->meetings.size());
}

// A mark of a program on disk as lines of its text.
class WrittenPair : public ::testing::Test {
protected:
  void SetUp() override {
    StationResult result = pair();
    writeStationOutputs(result, folder_.path(), kCtx);
    file_ = folder_.path() / machineFolder(0) /
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
  StationCheck verified() const {
    std::string text;
    for (const std::string& line : lines_)
      text += line + "\n";
    base::writeFile(file_, text);
    return verifyStation(folder_.path(), kCtx);
  }
  static bool isAtLine(const StationCheck& check, std::size_t first, std::size_t last) {
    return std::ranges::any_of(check.alone[0].findings, [&](const plan::Finding& f) {
      return f.blocking && f.program.line >= first && f.program.line <= last;
    });
  }
  static constexpr std::size_t kLines = 9; // of a mark

  test::TemporaryFolder folder_;
  std::filesystem::path file_;
  std::vector<std::string> lines_;
};

TEST_F(WrittenPair, PassesFromDisk) {
  const StationCheck check = verified();
  EXPECT_FALSE(firstBlocking(check.findings)) << why(check);
  EXPECT_EQ(check.replay.collisions, 0u);
  EXPECT_EQ(check.replay.clock.machines[0].meetings().size(), pair().work.order->meetings.size());
  EXPECT_NEAR(check.replay.makespanS, pair().replay->makespanS, 0.1);
}

TEST_F(WrittenPair, ARemovedMarkIsRefusedAtItsLine) {
  const std::size_t at = markAt(1);
  lines_.erase(lines_.begin() + static_cast<std::ptrdiff_t>(at),
               lines_.begin() + static_cast<std::ptrdiff_t>(at + kLines));
  const StationCheck check = verified();
  ASSERT_TRUE(firstBlocking(check.findings));
  EXPECT_NE(why(check).find("machine 1"), std::string::npos);
  EXPECT_TRUE(isAtLine(check, at, at + kLines + 1));
  EXPECT_TRUE(check.replay.clock.stuck || check.replay.collisions > 0);
}

TEST_F(WrittenPair, ASignalWithdrawnTooEarlyIsRefusedAtItsLine) {
  const std::size_t at = markAt(0);
  std::swap(lines_[at + 1], lines_[at + 5]); // on, and off again
  const StationCheck check = verified();
  ASSERT_TRUE(firstBlocking(check.findings));
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
  const StationCheck check = verified();
  ASSERT_TRUE(firstBlocking(check.findings));
  EXPECT_TRUE(check.replay.unsafeStart);
}

TEST(Station, AFolderWithoutProgramsIsRefused) {
  const test::TemporaryFolder folder;
  EXPECT_THROW(verifyStation(folder.path(), kCtx), base::Error);
  project::Station station{{{"one", towers().job}}, {}};
  project::writeStation(folder.path() / project::kStationFile, station);
  EXPECT_THROW(verifyStation(folder.path(), kCtx), base::Error) << "one machine";
  station.machines.push_back(station.machines.front());
  project::writeStation(folder.path() / project::kStationFile, station);
  EXPECT_THROW(verifyStation(folder.path(), kCtx), base::Error) << "no programs";
}

// ---- one project of all machines

std::vector<std::string> textsOf(const PlanResult& plan) {
  std::vector<std::string> texts;
  for (const auto& checked : plan.checked)
    for (const plan::ProgramFile& file : checked->program.files)
      texts.push_back(file.text);
  return texts;
}

TEST(Station, ReopenedAndPlannedAgainItsProgramsAreTheSame) {
  StationResult result = pair();
  const test::TemporaryFolder folder;
  writeStationOutputs(result, folder.path(), kCtx);
  project::Station read = plannedStation(folder.path() / project::kStationFile);
  ASSERT_EQ(read.machines.size(), 2u);
  EXPECT_EQ(read.machines[1].name, "second");
  EXPECT_TRUE(read.machines[1].shared_T_world.isApprox(parsedMachinePlace(kOpposite), 1e-12));
  EXPECT_EQ(project::stationBytes(read), project::stationBytes(stationOf(result)));
  const StationResult again = planStation(std::move(read), kCtx);
  EXPECT_TRUE(passed(again)) << why(again);
  for (std::size_t k = 0; k < 2; ++k)
    EXPECT_EQ(textsOf(again.plans[k]), textsOf(pair().plans[k]));
}

TEST(Station, ItsOrderOfWorkIsTakenFromTheCache) {
  StageCache cache;
  project::Station station = stationOf(pair());
  planStation(station, kCtx, &cache);
  EXPECT_TRUE(cache.find<StationStage>(stationKey(station), "station"));
  station.rules.clearanceMm += 5.0;
  EXPECT_FALSE(cache.find<StationStage>(stationKey(station), "station"));
  station.rules.clearanceMm -= 5.0;
  station.machines[1].shared_T_world.translation().y() += 1.0;
  EXPECT_FALSE(cache.find<StationStage>(stationKey(station), "station"));
}

TEST(Station, DamagedFilesAreRefused) {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / project::kStationFile;
  const std::string bytes = project::stationBytes(stationOf(pair()));
  for (const std::size_t length :
       {std::size_t{3}, std::size_t{16}, std::size_t{40}, bytes.size() / 2, bytes.size() - 1}) {
    base::writeFile(file, std::string_view(bytes).substr(0, length));
    EXPECT_THROW(plannedStation(file), base::Error) << length;
  }
  for (std::size_t at = 20; at < bytes.size(); at += bytes.size() / 25) {
    std::string damaged = bytes;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x55);
    base::writeFile(file, damaged);
    EXPECT_THROW(plannedStation(file), base::Error) << at;
  }
  base::writeFile(file, bytes + "x");
  EXPECT_THROW(plannedStation(file), base::Error) << "longer";
  base::writeFile(file, bytes);
  EXPECT_EQ(plannedStation(file).machines.size(), 2u);
  EXPECT_THROW(project::readJob(file, allParameters()), base::Error) << "not of one job";
}

// ---- resumed after a stop

// Both machines go on amid their prints: each first move is clear of what stands there by then.
class ResumedPair : public ::testing::Test {
protected:
  static StationResult rest(std::size_t first, std::size_t second, const std::string& folder) {
    return resumeStation(stationOf(pair()), {{.bead = first}, {.bead = second}}, folder, kCtx);
  }
  static std::size_t beads(std::size_t k) { return pair().plans[k].job.toolPlan->paths.size(); }
};

TEST_F(ResumedPair, BothGoOnTogether) {
  StationResult result = rest(beads(0) / 2, beads(1) / 3, {});
  ASSERT_TRUE(passed(result)) << why(result);
  ASSERT_TRUE(result.replay);
  EXPECT_EQ(result.replay->collisions, 0u);
  EXPECT_GE(result.replay->minDistanceMm, 10.0);
  EXPECT_LT(result.replay->makespanS, pair().replay->makespanS);
  EXPECT_GT(unmarked(result).collisions, 0u) << "the rests hinder each other";
  for (std::size_t k = 0; k < 2; ++k) {
    const project::Job& job = result.plans[k].job;
    EXPECT_GT(job.resumedAt, 0u);
    EXPECT_EQ(result.replay->clock.machines[k].marks.size(), marksOf(result.plans[k]));
    for (const plan::TrajectoryEvent& event : job.trajectory->events)
      EXPECT_TRUE(event.kind != plan::EventKind::Mark || event.point > job.resumedAt);
  }
  // Written, verified from disk, and resumed once more.
  const test::TemporaryFolder folder;
  writeStationOutputs(result, folder.path(), kCtx);
  const StationCheck check = verifyStation(folder.path(), kCtx);
  EXPECT_FALSE(firstBlocking(check.findings)) << why(check);
  EXPECT_NEAR(check.replay.makespanS, result.replay->makespanS, 0.1);
  const StationResult later =
      resumeStation(plannedStation(folder.path() / project::kStationFile),
                    {{.bead = beads(0) * 3 / 4}, {.bead = beads(1) * 3 / 4}}, folder.path(), kCtx);
  EXPECT_TRUE(passed(later)) << why(later);
  // A bead that the rest found printed: beads keep the numbers of the whole print.
  EXPECT_THROW(resumeStation(stationOf(result), {{.bead = 2}, {.bead = beads(1) / 2}}, {}, kCtx),
               base::Error);
}

// Only boxes at the border: one machine works after the other, with a mark at the end of the first.
TEST_F(ResumedPair, AMarkAtTheEndOfAMotionStaysInItsRest) {
  project::Station station{
      {{"first", borderBox().job}, {"second", borderBox().job, parsedMachinePlace(kOpposite)}}, {}};
  const StationResult whole = planStation(std::move(station), kCtx);
  ASSERT_TRUE(passed(whole)) << why(whole);
  const StationResult result =
      resumeStation(stationOf(whole), {{.bead = 6}, {.bead = 4}}, {}, kCtx);
  EXPECT_TRUE(passed(result)) << why(result);
  EXPECT_TRUE(std::ranges::any_of(result.plans, [](const PlanResult& plan) {
    const plan::Trajectory& motion = *plan.job.trajectory;
    return std::ranges::any_of(motion.events, [&](const plan::TrajectoryEvent& event) {
      return event.kind == plan::EventKind::Mark && event.point == motion.pointCount();
    });
  }));
}

// Beads that were printed before the stop are in the way of the other machine from the start.
TEST_F(ResumedPair, EarlierBeadsAreInTheCommonReplay) {
  const StationResult result = rest(beads(0) / 2, 1, {});
  ASSERT_TRUE(passed(result)) << why(result);
  std::vector<plan::ReadProgram> read(2);
  const auto placed = placedPrograms(read, result.plans, result.shared_T_world);
  const plan::ToolPlan& plan = *result.plans[0].job.toolPlan;
  EXPECT_EQ(placed[0].printedEarlier.size(), plan.paths[beads(0) / 2 - 1].first);
  EXPECT_LT((placed[0].printedEarlier.front() - plan.position.front()).norm(), 1.0);
  EXPECT_TRUE(placed[1].printedEarlier.empty());
}

TEST_F(ResumedPair, AMachineThatFindsNoWayIsNamedInTheReport) {
  project::Station station = stationOf(pair());
  station.machines[1].job.choices.parameters["bodyClearanceMm"] = "50"; // more than the cell has
  StationResult result = resumeStation(std::move(station), {{.bead = 2}, {.bead = 3}}, {}, kCtx);
  ASSERT_FALSE(passed(result));
  EXPECT_NE(why(result).find("machine 2"), std::string::npos) << why(result);
  const test::TemporaryFolder folder;
  writeStationOutputs(result, folder.path(), kCtx);
  const auto json = nlohmann::json::parse(base::readFile(folder.path() / "together.json"));
  EXPECT_EQ(json.at("machines").size(), 2u);
  EXPECT_FALSE(json.at("passed").get<bool>());
}

TEST_F(ResumedPair, EachMachineNeedsAPlace) {
  EXPECT_THROW(resumeStation(stationOf(pair()), {{.bead = 2}}, {}, kCtx), base::Error);
  EXPECT_THROW(rest(2, beads(1) + 1, {}), base::Error);
}

TEST_F(ResumedPair, LinesOfTheirProgramsNameThePlaces) {
  StationResult whole = pair();
  const test::TemporaryFolder folder;
  writeStationOutputs(whole, folder.path(), kCtx);
  const StationResult result = resumeStation(plannedStation(folder.path() / project::kStationFile),
                                             {{.line = 400}, {.line = 300}}, folder.path(), kCtx);
  EXPECT_TRUE(passed(result)) << why(result);
  for (const PlanResult& plan : result.plans)
    EXPECT_GT(plan.job.resumedAt, 0u);
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
  project::Station station;
  const Eigen::Vector3d centre(0.0, 320.0, 0.0);
  for (int k = 0; k < 4; ++k) {
    Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
    place.translate(centre);
    place.rotate(Eigen::AngleAxisd(k * M_PI / 2.0, Eigen::Vector3d::UnitZ()));
    place.translate(-centre);
    station.machines.push_back({"quarter", job.job, place});
  }
  StationResult result = planStation(std::move(station), kCtx);
  ASSERT_TRUE(result.work.order) << why(result);
  ASSERT_TRUE(result.replay);
  EXPECT_FALSE(firstBlocking(result.findings)) << why(result);
  EXPECT_TRUE(notesOf(result).empty()) << "each quarter has a plate of its own";
  EXPECT_EQ(result.replay->collisions, 0u);
  EXPECT_GT(unmarked(result).collisions, 0u);
  EXPECT_GE(result.replay->minDistanceMm, 10.0);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_GT(marksOf(result.plans[k]), 0u);
    EXPECT_EQ(result.replay->clock.machines[k].marks.size(), marksOf(result.plans[k]));
  }
  // One project: saved, verified, resumed after a stop.
  writeStationOutputs(result, folder.path(), kCtx);
  EXPECT_FALSE(firstBlocking(verifyStation(folder.path(), kCtx).findings));
  const std::size_t half = job.job.toolPlan->paths.size() / 2;
  const StationResult rest =
      resumeStation(plannedStation(folder.path() / project::kStationFile),
                    {{.bead = half}, {.bead = 2}, {.bead = half}, {.bead = 3}}, {}, kCtx);
  EXPECT_TRUE(passed(rest)) << why(rest);
}

TEST(Together, FiveMachinesAreTooMany) {
  project::Station station;
  for (int k = 0; k < 5; ++k)
    station.machines.push_back({"tower", towers().job});
  EXPECT_THROW(planStation(std::move(station), kCtx), base::Error);
}

TEST(Together, PlacesThatAreNoneAreRefused) {
  for (const char* const text : {"", "1,2,3", "a,0,0,0", "1,2,3,4,5", "1e300,0,0,0", "nan,0,0,0"})
    EXPECT_THROW(parsedMachinePlace(text), base::Error) << text;
  EXPECT_NEAR(parsedMachinePlace("10,20,30,90").linear()(1, 0), 1.0, 1e-12);
}

} // namespace
