// Several parts on a plate: distances, order, arrangement.
#include "base/error.h"
#include "geometry/meshes_meet.h"
#include "helpers/loaded_box.h"
#include "helpers/shapes.h"
#include "pipeline/items/part_arrangement.h"
#include "pipeline/items/plate_parts.h"
#include "pipeline/items/print_sequence.h"
#include "plan/finding_kinds.h"
#include "process/process.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <gtest/gtest.h>
#include <memory>
#include <random>

using namespace voluta;
using Eigen::Vector2d;
using Eigen::Vector3d;
using pipeline::Footprint;

namespace {

// 5 mm wide up to a height of 20, 30 mm wide above.
const process::HeadShape kHead{{{0.0, 5.0}, {20.0, 5.0}, {20.0, 30.0}, {80.0, 30.0}}};

Footprint square(double x, double y, double side, double height, bool leans = false) {
  return {{{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}}, height, leans};
}

TEST(Footprint, IsTheHullSeenFromAbove) {
  const Footprint part = pipeline::footprintOf(test::box({1, 2, 0}, {4, 6, 7}), false);
  EXPECT_EQ(part.outline.size(), 4u);
  EXPECT_EQ(part.heightMm, 7.0);
}

TEST(Footprint, GapsAreKnown) {
  EXPECT_DOUBLE_EQ(pipeline::gapBetween(square(0, 0, 10, 1), square(13, 0, 10, 1)), 3.0);
  EXPECT_DOUBLE_EQ(pipeline::gapBetween(square(0, 0, 10, 1), square(13, 14, 10, 1)), 5.0);
  EXPECT_DOUBLE_EQ(pipeline::gapBetween(square(0, 0, 10, 1), square(9, 9, 10, 1)), 0.0);
  EXPECT_DOUBLE_EQ(pipeline::gapBetween(square(0, 0, 10, 1), square(4, 4, 1, 1)), 0.0);
}

TEST(Footprint, ATallNeighbourMeetsTheWidePartOfTheHead) {
  EXPECT_EQ(pipeline::headNeedsMm(kHead, square(0, 0, 1, 50), square(0, 0, 1, 10)), 5.0);
  EXPECT_EQ(pipeline::headNeedsMm(kHead, square(0, 0, 1, 10), square(0, 0, 1, 50)), 30.0);
  EXPECT_EQ(pipeline::headNeedsMm(kHead, square(0, 0, 1, 10, true), square(0, 0, 1, 1)), 30.0);
}

TEST(Footprint, ALowNeighbourMeetsThePartOfAConeUpToItsHeight) {
  const process::HeadShape cone{{{0.0, 1.0}, {10.0, 11.0}}};
  EXPECT_DOUBLE_EQ(pipeline::headNeedsMm(cone, square(0, 0, 1, 50), square(0, 0, 1, 5)), 6.0);
  EXPECT_DOUBLE_EQ(pipeline::headNeedsMm(cone, square(0, 0, 1, 50), square(0, 0, 1, 20)), 11.0);
}

TEST(PrintSequence, PrintsALowPartBeforeATallOneBesideIt) {
  const std::vector<Footprint> parts{square(0, 0, 10, 50), square(20, 0, 10, 10)};
  const pipeline::PrintSequence found = pipeline::printSequence(parts, kHead);
  EXPECT_EQ(found.order, (std::vector<std::size_t>{1, 0}));
  EXPECT_FALSE(found.blocked);
}

TEST(PrintSequence, KeepsTheGivenOrderWhereItIsFree) {
  const std::vector<Footprint> parts{square(0, 0, 10, 50), square(60, 0, 10, 10),
                                     square(120, 0, 10, 50)};
  EXPECT_EQ(pipeline::printSequence(parts, kHead).order, (std::vector<std::size_t>{0, 1, 2}));
}

TEST(PrintSequence, NamesThePairThatBlocks) {
  const std::vector<Footprint> parts{square(0, 0, 10, 50), square(20, 0, 10, 60)};
  const pipeline::PrintSequence found = pipeline::printSequence(parts, kHead);
  ASSERT_TRUE(found.blocked);
  EXPECT_EQ(found.blocked->first, 0u);
  EXPECT_EQ(found.blocked->second, 1u);
  EXPECT_DOUBLE_EQ(found.blocked->gapMm, 10.0);
  EXPECT_DOUBLE_EQ(found.blocked->neededMm, 30.0);
  EXPECT_EQ(found.order.size(), 2u);
}

// Random parts, 300 plates: arranged parts can be printed one after another.
TEST(Arrangement, LeavesTheHeadItsRoom) {
  std::mt19937 random(7);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int plate = 0; plate < 300; ++plate) {
    std::vector<Footprint> parts;
    const int count = 2 + plate % 9;
    for (int i = 0; i < count; ++i)
      parts.push_back(square(between(-50, 50), between(-50, 50), between(5, 40), between(2, 100)));
    pipeline::ArrangeOptions options;
    if (plate % 2 == 0)
      options.plate = {{-200, -150}, {200, -150}, {200, 150}, {-200, 150}};
    const auto moves = pipeline::arranged(parts, kHead, options);
    if (!moves) {
      EXPECT_FALSE(options.plate.empty()) << "there is always room without a plate";
      continue;
    }
    for (std::size_t i = 0; i < parts.size(); ++i)
      for (Vector2d& p : parts[i].outline)
        p += (*moves)[i];
    EXPECT_FALSE(pipeline::printSequence(parts, kHead).blocked) << plate;
    for (const Footprint& part : parts)
      for (const Vector2d& p : part.outline)
        if (!options.plate.empty()) {
          EXPECT_LE(std::abs(p.x()), 197.0);
          EXPECT_LE(std::abs(p.y()), 147.0);
        }
  }
}

TEST(Arrangement, OfOnePartCentresIt) {
  const std::vector<Footprint> parts{square(100, 30, 10, 50)};
  const auto moves = pipeline::arranged(parts, kHead, {});
  ASSERT_TRUE(moves);
  EXPECT_LT(((*moves)[0] - Vector2d(-105, -35)).norm(), 1e-9);
}

TEST(Arrangement, RefusesPartsThatDoNotFit) {
  const std::vector<Footprint> parts{square(0, 0, 60, 5), square(0, 0, 60, 5)};
  pipeline::ArrangeOptions options;
  options.plate = {{-50, -50}, {50, -50}, {50, 50}, {-50, 50}};
  EXPECT_FALSE(pipeline::arranged(parts, kHead, options));
}

// The outline of a ring is the hull of all that is in it.
geometry::TriangleMesh ring(double inner, double outer) {
  geometry::TriangleMesh mesh;
  for (const double low : {-outer, inner})
    for (const bool along : {false, true}) {
      const double high = low + outer - inner;
      test::append(mesh, along ? test::box({-inner, low, 0}, {inner, high, 5})
                               : test::box({low, -outer, 0}, {high, outer, 5}));
    }
  return mesh;
}

TEST(PartsOnAPlate, RingsInEachOtherAreAsFarApartAsTheyAre) {
  const auto inner = std::make_shared<const geometry::TriangleMesh>(ring(6.0, 10.0)),
             outer = std::make_shared<const geometry::TriangleMesh>(ring(14.0, 18.0));
  project::Choices choices;
  choices.items.resize(2);
  for (project::ItemChoices& item : choices.items) {
    item.automatic = false;
    item.mode = "flat";
  }
  const plan::Findings findings = pipeline::findingsBetween(
      {inner, outer}, choices, process::loadProcess("fdm-1.0"), {"inner", "outer"});
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].kind, plan::FindingKind::PartsBlock);
  EXPECT_NE(plan::englishReason(findings[0]).find("they are 4.0 mm apart"), std::string::npos)
      << plan::englishReason(findings[0]);
}

TEST(MeshesMeet, PartsThatTouchShareNothing) {
  const auto box = test::box({0, 0, 0}, {10, 10, 10});
  constexpr double kDepthMm = 0.02;
  const auto shared = [&](const geometry::TriangleMesh& other) {
    return geometry::sharedPoint(box, other, kDepthMm).has_value();
  };
  EXPECT_FALSE(shared(test::box({10, 0, 0}, {20, 10, 10}))) << "a whole face";
  EXPECT_FALSE(shared(test::box({2, 3, 10}, {7, 8, 15}))) << "on top";
  EXPECT_FALSE(shared(test::box({10, 10, 0}, {20, 20, 10}))) << "an edge";
  EXPECT_FALSE(shared(test::box({9.99, 0, 0}, {20, 10, 10}))) << "less than it counts";
  EXPECT_TRUE(shared(box)) << "the same";
  EXPECT_TRUE(shared(test::box({5, 0, 0}, {15, 10, 10}))) << "edges on faces";
  EXPECT_TRUE(shared(test::box({9.9, 0, 0}, {20, 10, 10})));
  EXPECT_TRUE(shared(test::box({4, 4, 4}, {5, 5, 5}))) << "swallowed";
  EXPECT_TRUE(shared(test::box({-5, 4, 4}, {15, 5, 5}))) << "a cross";
  EXPECT_TRUE(shared(test::box({-5, 0, 0}, {15, 10, 10}))) << "longer";
  EXPECT_TRUE(geometry::sharedPoint(test::box({-5, -5, 0}, {15, 15, 10}), box, kDepthMm));
}

TEST(MeshesMeet, DistancesAreThoseOfTheSurfaces) {
  const auto box = test::box({0, 0, 0}, {10, 10, 10});
  EXPECT_NEAR(geometry::distanceBetween(box, test::box({13, 14, 0}, {20, 20, 9})), 5.0, 1e-9);
  EXPECT_NEAR(geometry::distanceBetween(ring(6.0, 10.0), ring(14.0, 18.0)), 4.0, 1e-9);
  EXPECT_NEAR(geometry::distanceBetween(box, test::box({10, 0, 0}, {20, 10, 10})), 0.0, 1e-9);
}

TEST(MeshesMeet, FindsCrossingsAndEnclosures) {
  const auto big = test::box({0, 0, 0}, {10, 10, 10});
  EXPECT_FALSE(geometry::meetingPoint(big, test::box({10.5, 0, 0}, {20, 10, 10})));
  EXPECT_TRUE(geometry::meetingPoint(big, test::box({9, 9, 9}, {20, 20, 20})));
  EXPECT_TRUE(geometry::meetingPoint(big, test::box({4, 4, 4}, {5, 5, 5}))) << "swallowed";
  EXPECT_TRUE(geometry::meetingPoint(test::box({4, 4, 4}, {5, 5, 5}), big)) << "swallowing";
  EXPECT_TRUE(geometry::meetingPoint(big, test::box({-5, 4, 4}, {15, 5, 5}))) << "a cross";
}

std::shared_ptr<const project::LoadedPart> loadedSquare(double side, const char* name = "box.stl") {
  return test::loadedBox(Eigen::Vector3d::Zero(), {side, side, 4.0}, name);
}

pipeline::PlanRequest boxOn(const char* platform, double side = 20.0) {
  pipeline::PlanRequest request;
  request.item().loaded = loadedSquare(side);
  request.choices.item().automatic = false;
  request.choices.item().mode = "flat";
  request.choices.item().platform = project::Platform(platform);
  return request;
}

bool areApart(const pipeline::PlanRequest& request, double side) {
  for (std::size_t i = 0; i < request.items.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if ((request.choices.item(i).placement.centreMm - request.choices.item(j).placement.centreMm)
              .cwiseAbs()
              .maxCoeff() < side)
        return false;
  return true;
}

TEST(Copies, ThereAreAsManyAsAskedFor) {
  const pipeline::PlanRequest six = pipeline::withCopies(boxOn("fit"), 0, 6, {});
  ASSERT_EQ(six.items.size(), 6u);
  ASSERT_EQ(six.choices.items.size(), 6u);
  EXPECT_TRUE(areApart(six, 20.0));
  const pipeline::PlanRequest two = pipeline::withCopies(six, 3, 2, {});
  EXPECT_EQ(two.items.size(), 2u);
  pipeline::PlanRequest mixed = six;
  mixed.items.push_back({{}, loadedSquare(10.0, "other.stl")});
  mixed.choices.items.push_back(mixed.choices.item(0));
  const pipeline::PlanRequest one = pipeline::withCopies(mixed, 5, 1, {});
  ASSERT_EQ(one.items.size(), 2u) << "another part is no copy";
  EXPECT_EQ(one.items[1].loaded->name, "other.stl");
}

TEST(Copies, ThePlateIsFilledAndOneMoreHasNoRoom) {
  const pipeline::PlanRequest full =
      pipeline::withCopies(boxOn("rect:200x200"), 0, std::nullopt, {});
  EXPECT_GT(full.items.size(), 8u);
  EXPECT_TRUE(areApart(full, 20.0));
  for (const project::ItemChoices& item : full.choices.items)
    EXPECT_LE(item.placement.centreMm.cwiseAbs().maxCoeff(), 90.0);
  const pipeline::PlanRequest smaller =
      pipeline::withCopies(boxOn("rect:120x120"), 0, std::nullopt, {});
  EXPECT_LT(smaller.items.size(), full.items.size());
  pipeline::PlanRequest byLayer = boxOn("rect:200x200");
  byLayer.choices.printOrder = layers::PrintOrder::ByLayer;
  EXPECT_GT(pipeline::withCopies(byLayer, 0, std::nullopt, {}).items.size(), full.items.size())
      << "the head needs no room between parts that grow together";
}

TEST(Copies, APlateMadeForThePartsCannotBeFilled) {
  EXPECT_THROW(pipeline::withCopies(boxOn("fit"), 0, std::nullopt, {}), base::Error);
}

// The brim of one part is room for one part, however many there are.
TEST(Copies, TheBrimDoesNotAddUpOverTheParts) {
  const auto distance = [](std::size_t count) {
    pipeline::PlanRequest request = boxOn("fit");
    request.choices.printOrder = layers::PrintOrder::ByLayer;
    request.choices.parameters["brimWidthMm"] = "5";
    const pipeline::PlanRequest made =
        pipeline::withArrangedParts(pipeline::withCopies(request, 0, count, {}), {});
    double nearest = 1e9;
    for (std::size_t i = 0; i < made.items.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        nearest = std::min(nearest, (made.choices.item(i).placement.centreMm -
                                     made.choices.item(j).placement.centreMm)
                                        .norm());
    return nearest;
  };
  EXPECT_NEAR(distance(2), distance(4), 0.5);
}

} // namespace
