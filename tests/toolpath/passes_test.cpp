// The contract of every pass over unsupported beads.
#include "toolpath/unsupported/passes.h"

#include "base/error.h"
#include "one_pass.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <string>

using namespace voluta;
using namespace voluta::test;
using Eigen::Vector3d;
using toolpath::PassChange;
using toolpath::PassPhase;
using toolpath::UnsupportedPass;

namespace {

// Plans with unsupported beads. Every pass has to change at least one of them, so that its contract
// is tested: a new pass may need another plan here.
std::map<std::string, plan::ToolPlan> samples() {
  std::map<std::string, plan::ToolPlan> plans;
  plan::ToolPlan& low = plans["a little above the bead below"];
  addPath(low, -15, 15, 0, 0.8, 0);
  addPath(low, -15, 15, 0, 1.7, 1, 0.4f);
  plan::ToolPlan& foot = plans["beside a foot"];
  addPath(foot, -15, 15, 0, 0.8, 0);
  addPath(foot, -15, 15, 2.4, 1.6, 1);
  addPath(foot, -15, 15, 0, 1.6, 1);
  plan::ToolPlan& beside = plans["a wall beside the bead below"];
  addPath(beside, -15, 15, 0, 0.8, 0);
  addPath(beside, -12, 12, 1.4, 1.6, 1);
  plan::ToolPlan& gap = plans["over a gap"];
  addPath(gap, -15, -5, 0, 0.8, 0);
  addPath(gap, 5, 15, 0, 0.8, 0);
  addPath(gap, -15, 15, 0, 1.6, 1);
  // High above the plate and not upright, so that beads can be pressed against their neighbours.
  plan::ToolPlan& ledge = plans["a ledge"];
  for (int layer = 0; layer < 20; ++layer)
    addPath(ledge, -15, 15, 0, 0.8 * (layer + 1), layer);
  for (const double offset : {3.5, 2.35, 1.2, 0.0})
    addPath(ledge, -12, 12, offset, 0.8 * 21, 20);
  ledge.direction.front() = Vector3d(0.01, 0.0, 1.0).normalized();
  for (auto& [name, plan] : plans) {
    plan.paths.front().kind = plan::PathKind::Infill;
    plan.fill = {{1.5, 2.5}};
    for (std::size_t p = 0; p < plan.paths.size(); ++p)
      plan.paths[p].item = plan.paths[p].group = static_cast<int>(p % 2);
    for (std::size_t i = 0; i < plan.waypointCount(); ++i)
      plan.speedMmPerS[i] = 15.0f + 0.01f * static_cast<float>(i);
  }
  return plans;
}

bool isSamePath(const plan::ToolPath& a, const plan::ToolPath& b) {
  return a.count == b.count && a.kind == b.kind && a.layer == b.layer && a.patch == b.patch &&
         a.group == b.group && a.closed == b.closed && a.item == b.item && a.tool == b.tool;
}

// Whether a path is printed as another one is, forwards or backwards.
bool isSameBead(const plan::ToolPlan& a, const plan::ToolPath& pathA, const plan::ToolPlan& b,
                const plan::ToolPath& pathB, bool turned) {
  if (!isSamePath(pathA, pathB))
    return false;
  for (std::size_t k = 0; k < pathA.count; ++k) {
    const std::size_t i = pathA.first + k, j = pathB.first + (turned ? pathB.count - 1 - k : k);
    if (a.position[i] != b.position[j] || a.direction[i] != b.direction[j] ||
        a.widthMm[i] != b.widthMm[j] || a.heightMm[i] != b.heightMm[j])
      return false;
    // A speed is that of the segment that ends there.
    if (k > 0 && a.speedMmPerS[i] != b.speedMmPerS[turned ? j + 1 : j])
      return false;
  }
  return true;
}

void expectWhole(const toolpath::UnsupportedBeads& beads, PassPhase phase) {
  const plan::ToolPlan& plan = beads.plan;
  const std::size_t n = plan.waypointCount();
  EXPECT_EQ(plan.direction.size(), n);
  EXPECT_EQ(plan.widthMm.size(), n);
  EXPECT_EQ(plan.heightMm.size(), n);
  EXPECT_EQ(plan.speedMmPerS.size(), n);
  EXPECT_EQ(beads.unsupported.size(), n);
  EXPECT_EQ(beads.clearDirection.size(), phase == PassPhase::BeforeDirections ? n : 0);
  EXPECT_EQ(beads.middle.size(), phase == PassPhase::WithDirections ? n : 0);
  std::size_t next = 0;
  for (const plan::ToolPath& path : plan.paths) {
    EXPECT_EQ(path.first, next);
    EXPECT_GE(path.count, 2u);
    next = path.first + path.count;
  }
  EXPECT_EQ(next, n);
  for (std::size_t i = 0; i < beads.middle.size(); ++i)
    EXPECT_TRUE(beads.middle[i].isApprox(
        plan.position[i] - 0.5 * static_cast<double>(plan.heightMm[i]) * plan.direction[i], 1e-9));
}

void expectSameWaypoints(const toolpath::UnsupportedBeads& before,
                         const toolpath::UnsupportedBeads& after, PassPhase phase) {
  ASSERT_EQ(after.plan.paths.size(), before.plan.paths.size());
  for (std::size_t p = 0; p < before.plan.paths.size(); ++p) {
    EXPECT_EQ(after.plan.paths[p].first, before.plan.paths[p].first);
    EXPECT_TRUE(isSamePath(after.plan.paths[p], before.plan.paths[p]));
  }
  for (std::size_t i = 0; i < before.unsupported.size(); ++i)
    EXPECT_LE(after.unsupported[i], before.unsupported[i]);
  EXPECT_EQ(after.clearDirection, before.clearDirection);
  EXPECT_EQ(after.plan.widthMm, before.plan.widthMm);
  if (phase != PassPhase::AfterDirections)
    return;
  EXPECT_EQ(after.plan.position, before.plan.position);
  EXPECT_EQ(after.plan.direction, before.plan.direction);
  EXPECT_EQ(after.plan.heightMm, before.plan.heightMm);
}

void expectOnlySupportsAdded(const toolpath::UnsupportedBeads& before,
                             const toolpath::UnsupportedBeads& after) {
  std::size_t p = 0; // of before
  const auto& paths = before.plan.paths;
  for (const plan::ToolPath& path : after.plan.paths) {
    if (p < paths.size() && isSameBead(after.plan, path, before.plan, paths[p], false)) {
      for (std::size_t k = 0; k < path.count; ++k)
        EXPECT_LE(after.unsupported[path.first + k], before.unsupported[paths[p].first + k]);
      ++p;
      continue;
    }
    ASSERT_LT(p, paths.size());
    EXPECT_EQ(path.kind, plan::PathKind::Support);
    EXPECT_EQ(path.patch, paths[p].patch);
    EXPECT_TRUE(p == 0 || paths[p - 1].patch != path.patch);
    for (std::size_t i = path.first; i < path.first + path.count; ++i)
      EXPECT_EQ(after.unsupported[i], 0);
  }
  EXPECT_EQ(p, paths.size());
}

void expectOnlyOrderChanged(const toolpath::UnsupportedBeads& before,
                            const toolpath::UnsupportedBeads& after) {
  const auto &was = before.plan.paths, &now = after.plan.paths;
  ASSERT_EQ(now.size(), was.size());
  std::set<std::size_t> found;
  for (std::size_t p = 0; p < now.size(); ++p) {
    EXPECT_EQ(now[p].patch, was[p].patch);
    for (std::size_t q = 0; q < was.size(); ++q)
      for (const bool turned : {false, true})
        if (!found.contains(q) && isSameBead(after.plan, now[p], before.plan, was[q], turned)) {
          found.insert(q);
          for (std::size_t k = 0; k < now[p].count; ++k)
            EXPECT_EQ(after.unsupported[now[p].first + k],
                      before.unsupported[was[q].first + (turned ? was[q].count - 1 - k : k)]);
        }
  }
  EXPECT_EQ(found.size(), was.size());
}

class EveryPass : public testing::TestWithParam<UnsupportedPass> {};

INSTANTIATE_TEST_SUITE_P(Unsupported, EveryPass,
                         testing::ValuesIn(toolpath::unsupportedPasses().begin(),
                                           toolpath::unsupportedPasses().end()),
                         [](const auto& tested) { return std::string(tested.param.id); });

} // namespace

TEST_P(EveryPass, LeavesPlansWithoutUnsupportedWaypoints) {
  const UnsupportedPass& pass = GetParam();
  for (const auto& [name, plan] : samples()) {
    PassInput input(pass, plan, kPlate);
    std::ranges::fill(input.beads.unsupported, 0);
    EXPECT_FALSE(resultOf(pass, input, kPlate)) << name;
  }
}

TEST_P(EveryPass, ChangesOnlyItsShareOfThePlan) {
  const UnsupportedPass& pass = GetParam();
  std::size_t changed = 0;
  for (const auto& [name, plan] : samples()) {
    SCOPED_TRACE(name);
    const PassInput input(pass, plan, kPlate);
    expectWhole(input.beads, pass.phase);
    const auto result = resultOf(pass, input, kPlate);
    if (!result)
      continue;
    ++changed;
    expectWhole(result->beads, pass.phase);
    EXPECT_EQ(result->beads.plan.fillOf(0).shellMm, plan.fillOf(0).shellMm);
    EXPECT_EQ(result->beads.plan.fillOf(0).openMm3, plan.fillOf(0).openMm3);
    switch (pass.changes) {
    case PassChange::Waypoints:
      expectSameWaypoints(input.beads, result->beads, pass.phase);
      break;
    case PassChange::Supports:
      expectOnlySupportsAdded(input.beads, result->beads);
      break;
    case PassChange::Order:
      expectOnlyOrderChanged(input.beads, result->beads);
      break;
    }
    EXPECT_EQ(result->addedMm3 > 0.0, pass.changes == PassChange::Supports);
    if (pass.phase != PassPhase::WithDirections) {
      EXPECT_FALSE(result->findingOfDirections);
    } else if (result->findingOfDirections) {
      // No bead keeps a tilt, or all do.
      EXPECT_FALSE(result->findingOfDirections(plan, plan.direction));
      EXPECT_TRUE(result->findingOfDirections(plan, result->beads.plan.direction));
    }
  }
  EXPECT_GT(changed, 0u) << "add a sample that this pass changes";
}

TEST_P(EveryPass, IsCancelled) {
  const UnsupportedPass& pass = GetParam();
  const base::CancelToken cancel;
  cancel.cancel();
  for (const auto& [name, plan] : samples()) {
    const PassInput input(pass, plan, kPlate);
    EXPECT_THROW(resultOf(pass, input, kPlate, base::RunContext(cancel, 2)), base::Cancelled)
        << name;
  }
}

TEST_P(EveryPass, IsTheSameForAnyNumberOfThreads) {
  const UnsupportedPass& pass = GetParam();
  for (const auto& [name, plan] : samples()) {
    const PassInput input(pass, plan, kPlate);
    const auto one = resultOf(pass, input, kPlate),
               two = resultOf(pass, input, kPlate, base::RunContext(base::CancelToken(), 2));
    ASSERT_EQ(one.has_value(), two.has_value()) << name;
    if (one) {
      EXPECT_EQ(one->beads.plan.position, two->beads.plan.position) << name;
      EXPECT_EQ(one->beads.plan.direction, two->beads.plan.direction) << name;
      EXPECT_EQ(one->beads.plan.heightMm, two->beads.plan.heightMm) << name;
      EXPECT_EQ(one->beads.plan.speedMmPerS, two->beads.plan.speedMmPerS) << name;
      EXPECT_EQ(one->addedMm3, two->addedMm3) << name;
    }
  }
}

TEST(UnsupportedPasses, AreNamedAndInTheOrderOfTheirPhases) {
  std::set<std::string_view> ids;
  PassPhase last = PassPhase::BeforeDirections;
  for (const UnsupportedPass& pass : toolpath::unsupportedPasses()) {
    EXPECT_TRUE(ids.insert(pass.id).second) << pass.id;
    EXPECT_NE(pass.run, nullptr);
    EXPECT_GE(pass.phase, last) << pass.id;
    last = pass.phase;
  }
}

TEST(UnsupportedPasses, LeaveSupportedBeadsUnchanged) {
  plan::ToolPlan plan;
  for (int layer = 0; layer < 3; ++layer)
    addPath(plan, -15, 15, 0, 0.8 * (layer + 1), layer);
  for (const PassPhase phase :
       {PassPhase::BeforeDirections, PassPhase::WithDirections, PassPhase::AfterDirections}) {
    const toolpath::PassedPlan passed = afterPhase(phase, plan);
    EXPECT_FALSE(passed.isChanged);
    EXPECT_EQ(passed.beads.plan.position, plan.position);
    EXPECT_EQ(passed.beads.plan.direction, plan.direction);
    EXPECT_EQ(passed.beads.plan.heightMm, plan.heightMm);
    EXPECT_EQ(passed.beads.plan.speedMmPerS, plan.speedMmPerS);
    EXPECT_EQ(passed.grown == nullptr, phase == PassPhase::WithDirections);
    EXPECT_TRUE(passed.findings.empty());
    EXPECT_TRUE(passed.findingsOfDirections.empty());
  }
}

TEST(UnsupportedPasses, RunOnPlatesOnlyBeforeDirections) {
  platform::PlatformSolid rod;
  rod.rod.emplace();
  const plan::ToolPlan plan = samples().at("beside a foot");
  EXPECT_TRUE(afterPhase(PassPhase::BeforeDirections, plan).isChanged);
  const toolpath::PassedPlan passed = afterPhase(PassPhase::BeforeDirections, plan, rod);
  EXPECT_FALSE(passed.isChanged);
  EXPECT_EQ(passed.beads.plan.position, plan.position);
  EXPECT_EQ(passed.beads.clearDirection.size(), plan.waypointCount());
  EXPECT_EQ(passed.grown, nullptr);
}

TEST(UnsupportedPasses, AnEmptyPlanStaysEmpty) {
  for (const UnsupportedPass& pass : toolpath::unsupportedPasses())
    EXPECT_EQ(afterPhase(pass.phase, {}).beads.plan.waypointCount(), 0u);
}
