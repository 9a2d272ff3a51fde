// Every row of the table of remedies: a cure changes the choices into others that can be planned.
#include "helpers/shapes.h"
#include "modes/mode_table.h"
#include "modes/part_voxels.h"
#include "pipeline/automatic.h"
#include "pipeline/larger_cell.h"
#include "pipeline/part_size.h"
#include "pipeline/remedies.h"
#include "pipeline/road.h"
#include "pipeline/stage_options.h"
#include "plan/finding_kinds.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>

using namespace voluta;
using namespace voluta::modes;
using namespace voluta::pipeline;
using namespace voluta::project;

namespace {

using plan::FindingKind;
using plan::RemedyId;

// With something at every place.
plan::Finding findingOf(FindingKind kind) {
  plan::Finding finding;
  finding.kind = kind;
  for (const std::string_view name : plan::valueNames(plan::rowOf(kind), false))
    finding.values.push_back({name, base::mm(0.5)});
  return finding;
}

// Choices of which a remedy is known to be the cure.
Choices choicesFor(RemedyId id) {
  Choices choices;
  if (id == RemedyId::ShrinkPlatform)
    choices.item().platform = project::Platform("disc:80");
  if (id == RemedyId::DropToPlate)
    choices.item().placement.liftMm = 4.0;
  if (id == RemedyId::AddSupports)
    choices.item().parameters["supports"] = "none";
  if (id == RemedyId::AdaptLayers || id == RemedyId::AddSkin)
    choices.item().mode = "flat";
  if (id == RemedyId::CentrePart)
    choices.item().placement.centreMm = {30.0, 0.0};
  if (id == RemedyId::MakePlatform)
    choices.item().platform = project::Platform("cell");
  if (id == RemedyId::UsualProcess)
    choices.tool().process = "fdm-0.35";
  if (id == RemedyId::UsualCell)
    choices.cell = "ur5-moving";
  if (id == RemedyId::PrintByLayer)
    choices.items.resize(2);
  if (id == RemedyId::PrintOnPlate) {
    choices.item().mode = "lathe";
    choices.cell = "lathe";
    choices.item().platform = project::Platform("rod:5x200");
  }
  return choices;
}

// Steps that may be taken again, until there is no more to gain.
bool isStep(RemedyId id) {
  using enum RemedyId;
  return std::set<RemedyId>{Shrink,        Enlarge,       LargerCell,    LowerLayers,
                            MoreTurns,     LessClearance, MoreClearance, ShorterMotions,
                            LongerMotions, FinerProcess}
      .contains(id);
}

StageKeys keysOf(const Choices& choices) {
  PlanRequest request;
  request.item().loaded = loadedFrom(
      "box.stl", std::make_shared<geometry::TriangleMesh>(test::box({0, 0, 0}, {9, 9, 5})), {},
      true, {});
  request.items.resize(choices.items.size(), request.item());
  request.choices = choices;
  return stageKeys(request);
}

TEST(Remedies, EveryRemedyCuresItsFindingsAndIsThenDone) {
  std::set<std::string_view> names;
  std::set<RemedyId> offered;
  for (const plan::FindingRow& row : plan::findingRows())
    offered.insert(row.remedies.begin(), row.remedies.end());
  for (const Remedy& remedy : remedies()) {
    EXPECT_TRUE(names.insert(remedy.name).second) << remedy.name << " stands twice";
    EXPECT_FALSE(remedy.label.empty() || remedy.help.empty()) << remedy.name;
    EXPECT_EQ(offered.erase(remedy.id), 1u) << remedy.name << " is for no finding";
  }
  EXPECT_TRUE(offered.empty()) << "findings name a cure that nobody knows";
  for (const plan::FindingRow& row : plan::findingRows())
    for (const Remedy& remedy : remedies()) {
      if (std::find(row.remedies.begin(), row.remedies.end(), remedy.id) == row.remedies.end())
        continue;
      const plan::Finding finding = findingOf(row.kind);
      const Choices choices = choicesFor(remedy.id);
      const std::optional<Choices> cured = remedy.cure(finding, choices);
      ASSERT_TRUE(cured) << remedy.name << " for " << row.id;
      EXPECT_NO_THROW(checkChoices(*cured)) << remedy.name;
      const StageKeys before = keysOf(choices), after = keysOf(*cured);
      EXPECT_TRUE(before != after || choices.item().automatic != cured->item().automatic)
          << remedy.name << " changes nothing";
      if (!isStep(remedy.id)) {
        EXPECT_FALSE(remedy.cure(finding, *cured)) << remedy.name << " is offered again";
      }
      Choices unchanged = *cured;
      unchanged.item().parameters = choices.item().parameters;
      unchanged.parameters = choices.parameters;
      unchanged.item().platform = choices.item().platform;
      unchanged.item().placement = choices.item().placement;
      unchanged.item().regions = choices.item().regions;
      unchanged.item().scale = choices.item().scale;
      unchanged.item().units = choices.item().units;
      unchanged.tool().process = choices.tool().process;
      unchanged.cell = choices.cell;
      unchanged.printOrder = choices.printOrder;
      unchanged.item().mode = choices.item().mode;
      unchanged.item().automatic = choices.item().automatic;
      EXPECT_EQ(keysOf(unchanged), before) << remedy.name << " changes something else too";
      for (const std::string_view name : base::placeNames(remedy.label.english()))
        EXPECT_NE(finding.value(name), nullptr) << remedy.name << " for " << row.id;
    }
}

TEST(Remedies, AreOfferedForTheirKindsOnly) {
  Choices choices;
  choices.item().platform = project::Platform("rect:90x70");
  choices.item().placement.liftMm = 2.0;
  const auto idsFor = [&](FindingKind kind) {
    std::set<RemedyId> ids;
    for (const RemedyAction& offer : remediesFor(findingOf(kind), choices))
      ids.insert(offer.remedy->id);
    return ids;
  };
  EXPECT_TRUE(idsFor(FindingKind::OtherProgram).empty());
  EXPECT_TRUE(idsFor(FindingKind::WallTooThin).empty()) << "no width is named";
  EXPECT_TRUE(idsFor(FindingKind::ShadowedUnderFacet).contains(RemedyId::ShrinkPlatform));
  EXPECT_FALSE(idsFor(FindingKind::ShadowedUnderFacet).contains(RemedyId::DropToPlate));
  EXPECT_FALSE(idsFor(FindingKind::Unreached).contains(RemedyId::ShrinkPlatform));
  EXPECT_TRUE(idsFor(FindingKind::Unreached).contains(RemedyId::DropToPlate));
  EXPECT_FALSE(idsFor(FindingKind::Uncovered).contains(RemedyId::AdaptLayers))
      << "curved layers follow the field";
  choices.item().mode = "planar";
  EXPECT_EQ(
      idsFor(FindingKind::Uncovered),
      (std::set<RemedyId>{RemedyId::AdaptLayers, RemedyId::LowerLayers, RemedyId::FinerProcess,
                          RemedyId::ChooseStrategy, RemedyId::AcceptShare}));
  EXPECT_EQ(idsFor(FindingKind::LongBridge), (std::set<RemedyId>{RemedyId::ChooseStrategy}));
  choices.item().automatic = true;
  EXPECT_TRUE(idsFor(FindingKind::LongBridge).empty()) << "it has chosen";
  EXPECT_EQ(idsFor(FindingKind::Stopped), (std::set<RemedyId>{RemedyId::DropToPlate}));
}

TEST(Remedies, ChangeTheItemOfTheFinding) {
  Choices choices;
  choices.items.resize(2);
  choices.item(0).placement.liftMm = choices.item(1).placement.liftMm = 2.0;
  plan::Finding finding = findingOf(FindingKind::Unreached);
  EXPECT_TRUE(remediesFor(finding, choices).empty()) << "no item is named";
  finding.item = 1;
  const std::vector<RemedyAction> offers = remediesFor(finding, choices);
  const auto drop = std::ranges::find(offers, RemedyId::DropToPlate,
                                      [](const RemedyAction& offer) { return offer.remedy->id; });
  ASSERT_NE(drop, offers.end());
  EXPECT_EQ(drop->choices.item(0).placement.liftMm, 2.0);
  EXPECT_EQ(drop->choices.item(1).placement.liftMm, 0.0);
}

// As a user has them who has moved the part about: in every mode, and in mode auto with each way as
// the last.
std::vector<Choices> everyMode() {
  std::vector<Choices> all;
  for (const Mode& mode : modeTable()) {
    Choices choices;
    choices.item().mode = mode.id;
    choices.cell = mode.usual.cell;
    choices.tool().process = mode.usual.process;
    choices.item().platform = mode.usual.platform;
    all.push_back(choices);
  }
  Choices automatic;
  automatic.item().automatic = true;
  automatic.item().platform = project::Platform("cell");
  for (const Choices& strategy : automaticChoices(automatic))
    all.push_back(strategy);
  for (Choices& choices : all) {
    choices.item().placement.centreMm = {30.0, 10.0};
    choices.item().placement.liftMm = 2.0;
  }
  return all;
}

// Kinds that a mode cannot come to.
bool arises(const plan::FindingRow& row, const Choices& choices) {
  using enum FindingKind;
  const Mode& mode = findMode(choices.item().mode);
  const std::set<FindingKind> rod{BeyondCell, BeyondRod, BeginsInAirOverRod};
  const std::set<FindingKind> surface{BeginsInAirOverSurface, NotPrinted};
  const std::set<FindingKind> plate{PlatformAdrift,  NoSupport,        BelowPlate,  BeginsInAir,
                                    CellCannotPrint, LargerThanPlates, StaysUpright};
  if (rod.contains(row.kind))
    return mode.aroundRod;
  if (surface.contains(row.kind))
    return mode.id == "substrate";
  if (plate.contains(row.kind) && (mode.aroundRod || mode.id == "substrate"))
    return false;
  if (row.kind == StaysUpright)
    return !mode.upright;
  return row.stage != plan::Stage::Decompose || mode.grows || plate.contains(row.kind);
}

TEST(Remedies, BlockingFindingsHaveAButtonOrAReasonInEveryMode) {
  const std::vector<Choices> all = everyMode();
  for (const plan::FindingRow& row : plan::findingRows()) {
    if (row.severity == plan::Severity::Info)
      continue;
    EXPECT_FALSE(row.remedies.empty() && row.whyNoRemedy.empty()) << row.id;
    for (const Choices& choices : all) {
      if (!arises(row, choices) || !row.whyNoRemedy.empty())
        continue;
      EXPECT_FALSE(remediesFor(findingOf(row.kind), choices).empty())
          << row.id << " in mode " << (choices.item().automatic ? "auto, " : "")
          << choices.item().mode;
    }
  }
}

TEST(Remedies, RemediesGiveValidChoicesInEveryMode) {
  for (const plan::FindingRow& row : plan::findingRows())
    for (const Choices& choices : everyMode())
      for (const RemedyAction& offer : remediesFor(findingOf(row.kind), choices)) {
        if (!arises(row, choices))
          continue;
        SCOPED_TRACE(std::string(row.id) + " in mode " + choices.item().mode + ": " +
                     std::string(offer.remedy->name));
        EXPECT_NO_THROW(checkChoices(offer.choices));
        StageKeys before, after;
        ASSERT_NO_THROW(before = keysOf(choices));
        EXPECT_NO_THROW(after = keysOf(offer.choices));
        EXPECT_TRUE(before != after || choices.item().automatic != offer.choices.item().automatic)
            << "it changes nothing";
      }
}

TEST(Remedies, APlatformThatAButtonChoseStaysInModeAuto) {
  Choices choices;
  choices.item().automatic = true;
  choices.item().platform = project::Platform("cell");
  for (const RemedyAction& offer : remediesFor(findingOf(FindingKind::ShadowedUnderFacet), choices))
    if (offer.remedy->id == RemedyId::ShrinkPlatform) {
      for (const Choices& strategy : automaticChoices(offer.choices))
        EXPECT_EQ(strategy.item().platform.text(), "fit:0");
      return;
    }
  FAIL() << "no smaller platform is offered";
}

TEST(Remedies, ChoicesThatCannotBePlannedLeaveTheOtherButtons) {
  Choices choices;
  choices.item().parameters["layerHeightMm"] = "9"; // beyond the process
  std::set<RemedyId> ids;
  for (const RemedyAction& offer : remediesFor(findingOf(FindingKind::Uncovered), choices))
    ids.insert(offer.remedy->id);
  EXPECT_FALSE(ids.contains(RemedyId::LowerLayers));
  EXPECT_TRUE(ids.contains(RemedyId::ChooseStrategy));
}

TEST(Remedies, ALargerCellHasALargerPlate) {
  Choices choices; // discs up to 250 mm under a fixed nozzle
  const Eigen::Vector2d any(0.0, 0.0);
  EXPECT_TRUE(cellWithLargerPlate(choices, any));
  EXPECT_FALSE(cellWithLargerPlate(choices, {9000.0, 9000.0})) << "no plate is as wide";
  choices.cell = "ur5-moving";
  EXPECT_NE(cellWithLargerPlate(choices, any), choices.cell);
  choices.cell = "kr10-r1100-track"; // the longest
  EXPECT_FALSE(cellWithLargerPlate(choices, any));
}

TEST(Remedies, TheContactAreaIsAsSmallAsAPlatformGets) {
  Choices choices;
  for (const char* platform : {"fit", "fit:0"}) {
    choices.item().platform = project::Platform(platform);
    for (const RemedyAction& offer :
         remediesFor(findingOf(FindingKind::ShadowedUnderFacet), choices))
      EXPECT_NE(offer.remedy->id, RemedyId::ShrinkPlatform) << platform;
  }
  choices.item().platform = project::Platform("fit:20");
  EXPECT_EQ(remediesFor(findingOf(FindingKind::ShadowedUnderFacet), choices)
                .at(0)
                .choices.item()
                .platform.text(),
            "fit:0");
}

TEST(Remedies, APartOutOfReachIsScaledToWhereTheRobotGets) {
  const auto scaleOf = [](double size, double scale) {
    const plan::Finding finding = tooLargeFinding({0.4, size}, scale);
    EXPECT_EQ(finding.kind, FindingKind::TooLarge);
    EXPECT_TRUE(finding.blocking);
    const std::vector<RemedyAction> offers = remediesFor(finding, Choices());
    EXPECT_GE(offers.size(), 1u);
    return offers.empty() ? std::string() : offers.front().choices.item().scale;
  };
  EXPECT_EQ(scaleOf(0.65, 1.0), "0.65");
  EXPECT_EQ(scaleOf(0.5, 25.4), "12.7");
  EXPECT_EQ(scaleOf(0.35, 0.7777), "0.272"); // never larger than the reach
  // No size helps, or there is no other: one sentence all the same.
  EXPECT_EQ(tooLargeFinding({0.4, std::nullopt}, 1.0).kind, FindingKind::MuchOutOfReach);
  EXPECT_EQ(tooLargeFinding({0.4, 0.5}, std::nullopt).kind, FindingKind::MuchOutOfReach);
}

TEST(Remedies, AThinWallNamesTheWidthThatHoldsIt) {
  const auto findings = thinWallFindings(test::box({0, 0, 0}, {20, 0.5, 10}), 0.8, {});
  ASSERT_FALSE(findings.empty());
  const auto offers = remediesFor(findings[0], {});
  ASSERT_EQ(offers.size(), 1U);
  EXPECT_EQ(base::english(offers[0].label), "Use voxel width 0.5 mm");
  EXPECT_EQ(offers[0].choices.item().parameters.at("voxelMm"), "0.5");
  // A wall that no voxel is narrow enough for.
  const auto foil = thinWallFindings(test::box({0, 0, 0}, {20, 0.05, 10}), 0.8, {});
  ASSERT_FALSE(foil.empty());
  EXPECT_TRUE(remediesFor(foil[0], {}).empty());
}

} // namespace
