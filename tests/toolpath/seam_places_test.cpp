// Seams that regions enforce or block, by own counts on beads in closed form.
#include "toolpath/order/place_seams.h"

#include "base/units.h"
#include "helpers/shapes.h"
#include "toolpath/unsupported/bead_tip.h"

#include <gtest/gtest.h>

namespace voluta::toolpath {
namespace {

using Eigen::Vector3d;

constexpr double kWidth = 1.2, kHeight = 0.8;
constexpr int kLayers = 25;

// A ring of a layer, on a cylinder with a tilted axis or on a box.
Bead ringBead(bool isRound, int layer, double inset) {
  Bead bead;
  bead.closed = true;
  bead.kind = plan::PathKind::Wall;
  bead.ring = inset > 1.0 ? 1 : 0;
  const double z = (layer + 1) * kHeight, half = 10.0 - inset;
  const auto add = [&](double x, double y) {
    bead.points.push_back(
        {{x, y, z - 0.5 * kHeight}, Vector3d::UnitZ(), Vector3d::UnitZ(), kWidth, kHeight});
  };
  if (isRound)
    for (int i = 0; i < 90; ++i)
      add(half * std::cos(base::kTwoPi * i / 90), half * std::sin(base::kTwoPi * i / 90));
  else
    for (const auto& [x, y] : {std::pair(-half, -half), {half, -half}, {half, half}, {-half, half}})
      add(x, y);
  bead.points.push_back(bead.points.front());
  return bead;
}

struct Rings {
  layers::LayerStack stack;
  std::vector<PatchCover> covers;
};

// Two walls a layer.
Rings rings(bool isRound) {
  Rings all;
  all.stack.layerCount = kLayers;
  for (int layer = 0; layer < kLayers; ++layer) {
    layers::Patch patch;
    patch.layer = layer;
    all.stack.patches.push_back(patch);
    PatchCover cover;
    cover.beads = {ringBead(isRound, layer, 0.6), ringBead(isRound, layer, 1.8)};
    all.covers.push_back(std::move(cover));
  }
  return all;
}

// The starts of all walls, those without a seam of their own at their first point.
std::vector<Vector3d> startsOf(const Rings& all, std::string_view seam,
                               const std::vector<SeamPlaceBody>& places) {
  const auto made = placeSeams(all.stack, all.covers, seamKind(seam),
                               {std::make_shared<const SeamPlaces>(places)});
  std::vector<Vector3d> starts;
  for (std::size_t i = 0; i < made.size(); ++i)
    for (std::size_t k = 0; k < made[i].size(); ++k)
      starts.push_back(tipOf((made[i][k] ? *made[i][k] : all.covers[i].beads[k]).points.front()));
  return starts;
}

std::size_t countIn(const std::vector<Vector3d>& starts, const Eigen::AlignedBox3d& box) {
  return static_cast<std::size_t>(
      std::ranges::count_if(starts, [&](const Vector3d& p) { return box.contains(p); }));
}

const Eigen::AlignedBox3d kCorner(Vector3d(2, -12, -1),
                                  Vector3d(12, -3, 15)); // below it, there are 18 layers

geometry::TriangleMesh meshOf(const Eigen::AlignedBox3d& box) {
  return test::box(box.min(), box.max());
}

TEST(SeamPlaces, BeadsBeginWhereTheyAreToldTo) {
  const std::size_t inside = 2 * 18;
  for (const bool isRound : {true, false})
    for (const SeamKind& kind : seamKinds()) {
      SCOPED_TRACE(kind.id);
      const Rings all = rings(isRound);
      const auto starts = startsOf(all, kind.id, {{SeamRule::Always, meshOf(kCorner)}});
      ASSERT_EQ(starts.size(), 2u * kLayers);
      EXPECT_EQ(countIn({starts.begin(), starts.begin() + static_cast<long>(inside)}, kCorner),
                inside)
          << "each bead that passes through it begins there";
    }
}

TEST(SeamPlaces, NoBeadBeginsWhereItMustNot) {
  for (const bool isRound : {true, false})
    for (const SeamKind& kind : seamKinds()) {
      SCOPED_TRACE(kind.id);
      const Rings all = rings(isRound);
      // All but a strip at the back.
      const Eigen::AlignedBox3d front(Vector3d(-15, -15, -1), Vector3d(15, 7, 40));
      const auto starts = startsOf(all, kind.id, {{SeamRule::Never, meshOf(front)}});
      EXPECT_EQ(countIn(starts, front), 0u);
      // Where there is no other place, they begin somewhere all the same.
      const Eigen::AlignedBox3d whole(Vector3d(-15, -15, -1), Vector3d(15, 15, 40));
      EXPECT_EQ(countIn(startsOf(all, kind.id, {{SeamRule::Never, meshOf(whole)}}), whole),
                2u * kLayers);
    }
}

TEST(SeamPlaces, TheLaterPlaceHolds) {
  const Rings all = rings(true);
  const Eigen::AlignedBox3d whole(Vector3d(-15, -15, -1), Vector3d(15, 15, 40));
  const auto starts = startsOf(
      all, "aligned", {{SeamRule::Always, meshOf(whole)}, {SeamRule::Never, meshOf(kCorner)}});
  EXPECT_EQ(countIn(starts, kCorner), 0u);
  const auto back = startsOf(
      all, "aligned", {{SeamRule::Never, meshOf(kCorner)}, {SeamRule::Always, meshOf(whole)}});
  EXPECT_EQ(back.size(), 2u * kLayers);
  const auto free = startsOf(all, "aligned", {});
  EXPECT_EQ(back, free) << "a place that is the whole part says nothing";
}

// An aligned seam in an enforced strip stays one line.
TEST(SeamPlaces, EnforcedSeamsAreInOneLine) {
  const Rings all = rings(true);
  const auto starts = startsOf(all, "nearest", {{SeamRule::Always, meshOf(kCorner)}});
  for (std::size_t i = 2; i < 2 * 18; ++i)
    EXPECT_LT((starts[i] - starts[i - 2]).head<2>().norm(), 1e-6);
}

} // namespace
} // namespace voluta::toolpath
