// Supports, seams and speeds that regions ask for, in plans.
#include "base/error.h"
#include "box_request.h"
#include "helpers/given_parameters.h"
#include "helpers/made_solids.h"
#include "helpers/shapes.h"
#include "layers/layer_stack.h"
#include "pipeline/checked_program.h"
#include "pipeline/plan_reasons.h"
#include "pipeline/road.h"
#include "plan/finding_kinds.h"
#include "plan/tool_plan.h"
#include "process/bead_model.h"
#include "project/loaded_part.h"
#include "regions/region_text.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>

namespace voluta::pipeline {
namespace {

using test::reasons;
using test::operator+;

PlanRequest requestWith(const std::vector<std::string>& regions, const std::string& density,
                        const std::string& mode = "flat") {
  PlanRequest request;
  request.item().loaded = test::loadedBox({-20, -16, 0}, {20, 16, 16});
  request.choices.item().mode = mode;
  request.choices.formats = {"gcode-extended"};
  test::giveParameters(request.choices, {{"infillDensity", density}});
  for (const std::string& text : regions)
    request.choices.item().regions.push_back(regions::parsedRegion(text, {}));
  return request;
}

std::shared_ptr<const project::LoadedPart> loadedOf(geometry::TriangleMesh mesh) {
  return project::loadedFrom("part.stl", std::make_shared<geometry::TriangleMesh>(std::move(mesh)),
                             {}, true, {});
}

double printedMm3(const plan::ToolPlan& plan) {
  double mm3 = 0.0;
  for (const plan::ToolPath& path : plan.paths)
    for (std::size_t w = path.first + 1; w < path.first + path.count && !plan::isWaste(path.kind);
         ++w)
      mm3 += (plan.position[w] - plan.position[w - 1]).norm() *
             process::beadArea(plan.widthMm[w], plan.heightMm[w]);
  return mm3;
}

// The first points of closed walls, of those that pass through a box and of the others.
struct Starts {
  std::size_t passing = 0, inside = 0, others = 0;
};
Starts startsIn(const plan::ToolPlan& plan, const Eigen::AlignedBox3d& box) {
  Starts starts;
  for (const plan::ToolPath& path : plan.paths) {
    if (!path.closed || path.kind != plan::PathKind::Wall)
      continue;
    bool passes = false;
    for (std::size_t w = path.first; w < path.first + path.count; ++w)
      passes = passes || box.contains(plan.position[w]);
    ++(passes ? starts.passing : starts.others);
    starts.inside += box.contains(plan.position[path.first]) ? 1 : 0;
  }
  return starts;
}

// Seams on a cylinder and on a box, flat: every wall that passes through the region begins in it,
// or none does. The beads are otherwise the same.
TEST(RegionMarks, SeamsAreWhereRegionsSay) {
  const Eigen::AlignedBox3d place(Eigen::Vector3d(4, -20, 0.1), Eigen::Vector3d(21, -3, 9.9));
  const std::string shape = "box:12.5,-11.5,5,17,17,9.8";
  for (const bool isRound : {true, false}) {
    const auto planned = [&](const std::vector<std::string>& regions) {
      PlanRequest request = requestWith(regions, "0.3");
      if (isRound)
        request.item().loaded = loadedOf(test::cylinder({0, 0, 0}, {0, 0, 12}, 12.0));
      else
        request.item().loaded = test::loadedBox({-12, -12, 0}, {12, 12, 12});
      const PlanResult plan = planPart(request, {});
      EXPECT_TRUE(plan.checked.at(0)->verdict.passed) << reasons(plan);
      return plan.job.toolPlan;
    };
    const auto usual = planned({}), always = planned({shape + ";seamHere=always"}),
               never = planned({shape + ";seamHere=never"});
    const Starts in = startsIn(*always, place), out = startsIn(*never, place);
    EXPECT_GT(in.passing, 15u);
    EXPECT_EQ(in.inside, in.passing);
    EXPECT_GT(in.others, 0u) << "walls above the region";
    EXPECT_EQ(out.inside, 0u);
    const double whole = printedMm3(*usual);
    for (const auto& plan : {always, never}) {
      EXPECT_EQ(plan->paths.size(), usual->paths.size()) << "nothing is divided";
      EXPECT_NEAR(printedMm3(*plan) / whole, 1.0, 2e-3);
    }
  }
}

// Seams in the curved skin of a dome.
TEST(RegionMarks, SeamsOfCurvedLayersAreWhereRegionsSay) {
  const Eigen::AlignedBox3d place(Eigen::Vector3d(0, -30, -1), Eigen::Vector3d(30, 30, 30));
  PlanRequest request = requestWith({"skin:2.4", "box:15,0,14.5,30,60,31;seamHere=always"}, "0.3");
  // A cap of a sphere on a cylinder.
  constexpr double kRadius = 42.5, kFoot = 18.0, kSide = 6.0;
  std::vector<Eigen::Vector2d> section{{0.01, 0.0}, {kFoot, 0.0}};
  for (int i = 0; i <= 16; ++i) {
    const double r = kFoot + (0.01 - kFoot) * i / 16;
    section.emplace_back(r, kSide - std::sqrt(kRadius * kRadius - kFoot * kFoot) +
                                std::sqrt(kRadius * kRadius - r * r));
  }
  request.item().loaded = loadedOf(test::turned(section, 72));
  const PlanResult plan = planPart(request, {});
  std::size_t curved = 0;
  const auto& patches = plan.job.item().layers->patches;
  for (const plan::ToolPath& path : plan.job.toolPlan->paths)
    if (path.closed && path.kind == plan::PathKind::Wall &&
        patches[static_cast<std::size_t>(path.patch)].region == 1) {
      ++curved;
      EXPECT_TRUE(place.contains(plan.job.toolPlan->position[path.first]));
    }
  EXPECT_GT(curved, 0u) << reasons(plan);
}

// Half of the speed in the region: seen in the paths, in the times and by the replay.
TEST(RegionMarks, ARegionHasItsSpeed) {
  const PlanResult usual = planPart(requestWith({"height:4.8,9.6"}, "1"), {});
  const PlanResult slow = planPart(requestWith({"height:4.8,9.6;speedFactor=0.5"}, "1"), {});
  EXPECT_TRUE(slow.checked.at(0)->verdict.passed) << reasons(slow);
  const plan::ToolPlan &a = *usual.job.toolPlan, &b = *slow.job.toolPlan;
  ASSERT_EQ(a.waypointCount(), b.waypointCount());
  std::size_t halved = 0;
  double saved = 0.0;
  for (const plan::ToolPath& path : b.paths)
    for (std::size_t w = path.first; w < path.first + path.count; ++w) {
      const double z = b.position[w].z();
      const bool isIn = z > 4.9 && z < 9.7;
      EXPECT_NEAR(b.speedMmPerS[w], (isIn ? 0.5 : 1.0) * a.speedMmPerS[w], 1e-4);
      halved += isIn ? 1 : 0;
      if (isIn && w > path.first)
        saved += (b.position[w] - b.position[w - 1]).norm() / a.speedMmPerS[w];
    }
  EXPECT_GT(halved, 100u);
  const double longer = slow.job.report.motion.durationS - usual.job.report.motion.durationS;
  EXPECT_NEAR(longer / saved, 1.0, 0.1) << "beads there take twice as long";
}

// Columns below an arm: blocked, enforced, and clear of a region that is printed later.
TEST(RegionMarks, SupportsAreWhereRegionsSay) {
  const auto planned = [&](const std::vector<std::string>& regions, const std::string& supports) {
    PlanRequest request = requestWith(regions, "1");
    request.item().loaded =
        loadedOf(test::box({0, 0, 0}, {10, 4, 20}) + test::box({9, 0, 16}, {30, 4, 20}));
    request.choices.item().platform = project::Platform("disc:200");
    test::giveParameters(request.choices, {{"infillDensity", "1"}, {"supports", supports}});
    request.until = project::Stage::Layers;
    return planPart(request, {});
  };
  const auto mm3 = [](const PlanResult& plan) {
    return plan.job.report.item().decomposition.supportVolumeMm3;
  };
  const std::string half = "box:30,0,15,20,30,40"; // from x = 20 on
  const double gap = 0.3, bead = 1.2, height = 16.0, depth = 4.0;
  EXPECT_NEAR(mm3(planned({}, "auto")) / ((20.0 - gap) * depth * height), 1.0, 0.02);
  EXPECT_EQ(mm3(planned({}, "none")), 0.0);
  EXPECT_NEAR(mm3(planned({half + ";supports=none"}, "auto")) /
                  ((10.0 - gap + 0.5 * bead) * depth * height),
              1.0, 0.02);
  EXPECT_NEAR(mm3(planned({half + ";supports=always"}, "none")) /
                  ((10.0 + 0.5 * bead) * depth * height),
              1.0, 0.02);
  const PlanResult blockedLast =
      planned({half + ";supports=always", half + ";supports=none"}, "auto");
  EXPECT_LT(mm3(blockedLast), 0.6 * mm3(planned({}, "auto")));
  EXPECT_EQ(blockedLast.job.item().layers->patches.size(),
            planned({half + ";supports=none"}, "auto").job.item().layers->patches.size())
      << "places of supports do not divide layers";
}

std::vector<plan::FindingKind> overhangsOf(const PlanResult& plan) {
  std::vector<plan::FindingKind> kinds;
  for (const plan::Finding& finding : plan.job.report.findings)
    if (plan::reportId(finding) == "overhang")
      kinds.push_back(finding.kind);
  return kinds;
}

// The plan says which overhangs stay without a column, and no others.
TEST(RegionMarks, TheOverhangsThatARegionLeavesOpenAreFound) {
  using enum plan::FindingKind;
  using Kinds = std::vector<plan::FindingKind>;
  const std::string half = "box:30,0,15,20,30,40", all = "box:15,2,10,80,80,80";
  for (const std::string mode : {"flat", "planar"}) {
    const auto planned = [&](const std::string& region, const std::string& supports,
                             const std::string& planes = {}) {
      PlanRequest request = requestWith({}, "1", mode);
      if (!region.empty())
        request.choices.item().regions.push_back(regions::parsedRegion(region, {}));
      request.item().loaded =
          loadedOf(test::box({0, 0, 0}, {10, 4, 20}) + test::box({9, 0, 16}, {30, 4, 20}));
      request.choices.item().platform = project::Platform("disc:200");
      std::map<std::string, std::string> given{{"infillDensity", "1"}, {"supports", supports}};
      if (!planes.empty())
        given["layerPlanes"] = planes;
      if (mode == "planar")
        given["cutPlanes"] = R"([{"point":[0,0,8],"normal":[0,0,1]}])";
      test::giveParameters(request.choices, given);
      request.until = project::Stage::Layers;
      return planPart(request, {});
    };
    const bool isFlat = mode == "flat";
    const Kinds open{isFlat ? OverhangOfFlat : OverhangOfPieces};
    EXPECT_EQ(overhangsOf(planned({}, "none")), open);
    EXPECT_EQ(overhangsOf(planned({}, "auto")), Kinds{});
    EXPECT_EQ(overhangsOf(planned(half + ";supports=none", "auto")), Kinds{OverhangBlocked});
    EXPECT_EQ(overhangsOf(planned(half + ";supports=always", "none")), open);
    EXPECT_EQ(overhangsOf(planned(all + ";supports=always", "none")), Kinds{});
    if (!isFlat)
      continue;
    // The voxels that would be missed, by the same rules.
    const auto missed = [&](const std::string& region, const std::string& supports) {
      return planned(region, supports).job.report.item().decomposition.missedAfterSupports;
    };
    const auto whole = missed({}, "none");
    EXPECT_GT(whole, 0u);
    EXPECT_EQ(missed({}, "auto"), 0u);
    EXPECT_EQ(missed(all + ";supports=always", "none"), 0u);
    EXPECT_GT(missed(half + ";supports=none", "auto"), 0u);
    EXPECT_LT(missed(half + ";supports=none", "auto"), whole);
    // Layers along planes have no columns.
    const std::string planes = R"([{"point":[0,0,0.4],"normal":[0,0,1]}])";
    const auto saysSo = [](const PlanResult& plan) {
      return std::ranges::count(plan.job.report.findings, PlanesWithoutSupports,
                                &plan::Finding::kind);
    };
    EXPECT_EQ(saysSo(planned(half + ";supports=always", "none", planes)), 1);
    EXPECT_EQ(saysSo(planned({}, "auto", planes)), 1);
    EXPECT_EQ(saysSo(planned(half + ";supports=none", "none", planes)), 0);
    EXPECT_EQ(overhangsOf(planned(half + ";supports=always", "none", planes)), open);
  }
}

// A plate just above its foot: beads of support carry its rim, but where a region blocks them.
TEST(RegionMarks, RimSupportsKeepOutOfBlockedRegions) {
  const auto supportPoints = [](const std::vector<std::string>& regions) {
    PlanRequest request = requestWith(regions, "0.3");
    request.item().loaded = loadedOf(test::turned(
        {{0.01, 0.0}, {12.0, 0.0}, {12.0, 2.4}, {18.0, 2.4}, {18.0, 4.8}, {0.01, 4.8}}, 48));
    request.choices.item().platform = project::Platform("disc:200"); // below the rim, too
    request.until = project::Stage::Toolpath;
    const PlanResult plan = planPart(request, {});
    std::size_t points = 0;
    for (const plan::ToolPath& path : plan.job.toolPlan->paths)
      points += path.kind == plan::PathKind::Support ? path.count : 0;
    EXPECT_TRUE(points > 0 || !regions.empty()) << reasons(plan);
    return points;
  };
  const std::size_t whole = supportPoints({});
  EXPECT_GT(whole, 50u);
  EXPECT_EQ(supportPoints({"box:0,0,1,80,80,10;supports=none"}), 0u);
  const std::size_t half = supportPoints({"box:20,0,1,40,80,10;supports=none"});
  EXPECT_GT(half, whole / 5);
  EXPECT_LT(half, whole - whole / 5);
}

TEST(RegionMarks, SupportsThatARegionCannotHaveAreRefused) {
  for (const auto& [region, mode, reason] : std::vector<std::array<std::string, 3>>{
           {"skin:2.4;supports=always", "flat", "its own layers have none"},
           {"height:2,4;supports=auto", "substrate", "which mode substrate does not have"}}) {
    try {
      planPart(requestWith({region}, "1", mode), {});
      ADD_FAILURE() << region;
    } catch (const base::Error& error) {
      EXPECT_EQ(error.code(), base::ErrorCode::Usage);
      EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
    }
  }
}

} // namespace
} // namespace voluta::pipeline
