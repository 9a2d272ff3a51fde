// Infill along fields: alignment by an own count, cover by painting, on closed forms and on
// random fields.
#include "base/error.h"
#include "base/run_context.h"
#include "base/units.h"
#include "toolpath/coverage/cover_patch.h"
#include "toolpath/infill/sample_tree.h"
#include "toolpath/infill/strand_text.h"
#include "toolpath/painter.h"
#include "toolpath/patch_shapes.h"
#include "toolpath/sparse/cover_layers.h"

#include "helpers/all_seeds.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <random>
#include <string>
#include <vector>

namespace {
using namespace voluta;
using Eigen::Vector2d;
using Eigen::Vector3d;

using Direction = std::function<Vector3d(const Vector3d&)>;

toolpath::ToolpathOptions along(const Direction& direction) {
  toolpath::ToolpathOptions o;
  o.infill = "field";
  o.strands = [direction](const Vector3d& p) {
    const Vector3d d = direction(p);
    return Eigen::Matrix3d(d * d.transpose());
  };
  return o;
}

// The share of the length of infill within an angle of a direction.
double aligned(const toolpath::PatchCover& cover, const Direction& direction, double withinDeg) {
  double length = 0.0, within = 0.0;
  for (const toolpath::Bead& bead : cover.beads)
    if (bead.kind == plan::PathKind::Infill)
      for (std::size_t i = 1; i < bead.points.size(); ++i) {
        const Vector3d step = bead.points[i].middle - bead.points[i - 1].middle;
        const Vector3d at = 0.5 * (bead.points[i].middle + bead.points[i - 1].middle);
        const double angle =
            std::atan2(step.cross(direction(at)).norm(), std::abs(step.dot(direction(at))));
        length += step.norm();
        within += base::radiansToDegrees(angle) <= withinDeg ? step.norm() : 0.0;
      }
  return within / length;
}

toolpath::PatchCover cover(const layers::Patch& patch, const toolpath::ToolpathOptions& o) {
  return toolpath::coverPatch(patch, process::Process{}, o, base::RunContext{});
}

Vector3d outward(const Vector3d& p) {
  return Vector3d(p.x(), p.y(), 0).normalized();
}

void expectFilled(const layers::Patch& patch, const toolpath::PatchCover& c) {
  const test::Painted p = test::paint(patch, c.beads);
  EXPECT_GE(p.coveredMm2 / p.areaMm2, 0.96);
  EXPECT_GE(c.coveredMm2 / c.areaMm2, 0.985);
  EXPECT_LE(c.overlapMm2 / c.areaMm2, 0.06);
  EXPECT_NEAR(c.beadVolumeMm3 / c.volumeMm3, 1.0, 0.015);
}

TEST(FieldInfill, FollowsOneDirection) {
  const layers::Patch patch = test::patchOver({test::rectangle(40, 30)});
  for (const double angle : {0.0, 0.4, 1.2, 2.5}) {
    const Direction direction = [&](const Vector3d&) {
      return Vector3d(std::cos(angle), std::sin(angle), 0);
    };
    const toolpath::PatchCover c = cover(patch, along(direction));
    expectFilled(patch, c);
    EXPECT_GE(aligned(c, direction, 5.0), 0.8) << angle;
  }
}

TEST(FieldInfill, GoesAroundARing) {
  const layers::Patch patch = test::patchOver({test::circle(25), test::circle(8, true)});
  const Direction around = [](const Vector3d& p) {
    return Vector3d::UnitZ().cross(p).normalized();
  };
  const toolpath::PatchCover c = cover(patch, along(around));
  expectFilled(patch, c);
  EXPECT_GE(aligned(c, around, 10.0), 0.95);
}

// Lines from the middle outwards are three times as far apart at the rim: others begin between
// them.
TEST(FieldInfill, DividesLinesThatSpread) {
  test::Loop sector;
  constexpr int kSteps = 60;
  constexpr double kOpening = 2.6;
  for (int i = 0; i <= kSteps; ++i)
    sector.emplace_back(27.0 * std::cos(kOpening * i / kSteps),
                        27.0 * std::sin(kOpening * i / kSteps));
  for (int i = kSteps; i >= 0; --i)
    sector.emplace_back(8.0 * std::cos(kOpening * i / kSteps),
                        8.0 * std::sin(kOpening * i / kSteps));
  const layers::Patch patch = test::patchOver({sector});
  const toolpath::PatchCover c = cover(patch, along(outward));
  expectFilled(patch, c);
  EXPECT_GE(aligned(c, outward, 20.0), 0.8);
}

// All around, no function has such isolines: streamlines, whose beads overlap more.
TEST(FieldInfill, LeavesTheMiddleOfARingInAllDirections) {
  const layers::Patch patch = test::patchOver({test::circle(27), test::circle(8, true)});
  const toolpath::PatchCover c = cover(patch, along(outward));
  EXPECT_GE(c.coveredMm2 / c.areaMm2, 0.985);
  EXPECT_NEAR(c.beadVolumeMm3 / c.volumeMm3, 1.0, 0.015);
  EXPECT_GE(aligned(c, outward, 20.0), 0.8);
}

TEST(FieldInfill, FollowsTheSurfaceOfCurvedLayers) {
  const layers::Patch patch = test::patchOver({test::circle(18)}, 0.8, test::onSphere(25));
  const Direction alongX = [](const Vector3d&) { return Vector3d::UnitX(); };
  const toolpath::PatchCover c = cover(patch, along(alongX));
  expectFilled(patch, c);
  const Direction inSurface = [](const Vector3d& p) {
    const Vector3d n = p.normalized();
    return Vector3d((Vector3d::UnitX() - n.x() * n).normalized());
  };
  EXPECT_GE(aligned(c, inSurface, 25.0), 0.85);
}

// Fields that matter in one place alone do not leave the rest without lines.
TEST(FieldInfill, ContinuesWhereTheFieldIsWeak) {
  const layers::Patch patch = test::patchOver({test::rectangle(60, 20)});
  toolpath::ToolpathOptions o;
  o.infill = "field";
  o.strands = [](const Vector3d& p) {
    const Vector3d x = Vector3d::UnitX();
    return Eigen::Matrix3d(p.x() < -20.0 ? Eigen::Matrix3d(x * x.transpose())
                                         : Eigen::Matrix3d::Zero());
  };
  const toolpath::PatchCover c = cover(patch, o);
  expectFilled(patch, c);
  EXPECT_GE(aligned(
                c, [](const Vector3d&) { return Vector3d::UnitX(); }, 15.0),
            0.8);
}

TEST(FieldInfill, FollowsRandomFieldsOnRandomShapes) {
  const int kFields = test::ofSeeds(20, 60);
  int followed = 0;
  for (int seed = 0; seed < kFields; ++seed) {
    std::mt19937 random(static_cast<unsigned>(seed));
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    const double a = 3.0 * any(random), b = 0.03 * any(random), d = 0.03 * any(random),
                 bend = 0.3 * any(random);
    const Direction direction = [=](const Vector3d& p) {
      const double angle = a + b * p.x() + d * p.y() + bend * std::sin(0.15 * p.x());
      return Vector3d(std::cos(angle), std::sin(angle), 0);
    };
    const layers::Patch patch =
        seed % 3 == 0   ? test::patchOver({test::rectangle(30 + 10 * any(random), 25)})
        : seed % 3 == 1 ? test::patchOver({test::ell(32, 14 + 2 * any(random))})
                        : test::patchOver({test::circle(18), test::circle(4, true, {5, 0})});
    const toolpath::PatchCover c = cover(patch, along(direction));
    SCOPED_TRACE(seed);
    expectFilled(patch, c);
    followed += aligned(c, direction, 30.0) >= 0.75 ? 1 : 0;
  }
  EXPECT_GE(followed, kFields * 95 / 100);
}

// A field across the layers says nothing within them: straight lines.
TEST(FieldInfill, FillsLayersAcrossTheField) {
  const layers::Patch patch = test::patchOver({test::circle(15)});
  const toolpath::PatchCover c =
      cover(patch, along([](const Vector3d&) { return Vector3d::UnitZ(); }));
  expectFilled(patch, c);
  EXPECT_TRUE(std::ranges::any_of(
      c.beads, [](const toolpath::Bead& bead) { return bead.kind == plan::PathKind::Infill; }));
}

TEST(FieldInfill, WithoutAFieldSaysSo) {
  toolpath::ToolpathOptions o;
  o.infill = "field";
  try {
    cover(test::patchOver({test::circle(15)}), o);
    FAIL();
  } catch (const base::Error& error) {
    EXPECT_NE(std::string(error.what()).find("infillField"), std::string::npos);
  }
}

// A field across a layer is told, and no other.
TEST(FieldInfill, SaysWhereTheFieldHasNoDirection) {
  const layers::Patch patch = test::patchOver({test::circle(15)});
  EXPECT_TRUE(cover(patch, along([](const Vector3d&) { return Vector3d::UnitZ(); })).lacksField);
  EXPECT_FALSE(cover(patch, along([](const Vector3d&) { return Vector3d(0.1, 0, 1).normalized(); }))
                   .lacksField);
  EXPECT_FALSE(cover(patch, along(outward)).lacksField);
}

// Layers of one shape are covered once, unless the field differs between them.
TEST(FieldInfill, FollowsAFieldThatChangesWithTheHeight) {
  constexpr int kLayers = 6;
  layers::LayerStack stack;
  stack.layerCount = kLayers;
  for (int i = 0; i < kLayers; ++i) {
    stack.patches.push_back(test::patchOver({test::rectangle(20, 16)}));
    layers::Patch& patch = stack.patches.back();
    patch.layer = i;
    for (Vector3d& v : patch.surface.vertices)
      v.z() += 0.8 * (i + 1);
  }
  toolpath::ToolpathOptions o;
  o.infill = "field";
  o.infillField = "0,0,0,1,0,0 0,0,4.8,0,1,0"; // from x at the bottom to y at the top
  o.strands = toolpath::strandsOf(o.infillField);
  o.rimSupports = false;
  const process::Tooling tooling{process::Process()};
  const toolpath::LayerCovers made =
      toolpath::coverLayers(stack, std::vector<toolpath::CoverRules>{{o, tooling}}, 1.0, {});
  const Direction alongX = [](const Vector3d&) { return Vector3d::UnitX(); },
                  alongY = [](const Vector3d&) { return Vector3d::UnitY(); };
  EXPECT_GT(aligned(made.covers.front(), alongX, 20.0), 0.8);
  EXPECT_GT(aligned(made.covers.back(), alongY, 20.0), 0.8);
}

// Sums over the tree are those over all samples, on samples of a plane and of a body.
TEST(SampleTree, SumsAsOverAllSamples) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (const bool isFlat : {true, false}) {
    std::vector<toolpath::FieldSample> samples;
    for (int i = 0; i < 3000; ++i) {
      const Vector3d place(60.0 * any(random), 30.0 * any(random),
                           isFlat ? 0.0 : 20.0 * any(random));
      const double angle = 0.05 * place.x() + 0.3 * any(random);
      samples.push_back({place, {std::cos(angle), std::sin(angle), 0.0}, 1.5 + any(random)});
    }
    const toolpath::SampleTree tree(samples);
    for (int i = 0; i < 200; ++i) {
      const Vector3d place(80.0 * any(random), 40.0 * any(random), 20.0 * any(random));
      const Eigen::Matrix3d all = toolpath::dyadsAt(samples, place);
      EXPECT_LT((tree.dyadsAt(place) - all).norm(), 0.03 * all.norm()) << place.transpose();
    }
    const Eigen::Matrix3d onSample = toolpath::dyadsAt(samples, samples[7].place);
    EXPECT_LT((tree.dyadsAt(samples[7].place) - onSample).norm(), 1e-4 * onSample.norm());
  }
}

TEST(StrandText, ReadsDirectionsSamplesAndCurves) {
  const auto strongest = [](const std::string& text, const Vector3d& at) {
    const Eigen::Matrix3d dyads = toolpath::strandsOf(text)(at);
    return Eigen::Matrix3d(dyads / dyads.trace());
  };
  EXPECT_NEAR(strongest("0,2,0", {5, 5, 5})(1, 1), 1.0, 1e-12);
  EXPECT_GT(strongest("0,0,0,1,0,0 10,0,0,0,1,0", {1, 0, 0})(0, 0), 0.9);
  EXPECT_GT(strongest("0,0,0,1,0,0,0.001\n2,0,0,0,1,0,5", {1, 0, 0})(1, 1), 0.99)
      << "the heavier sample holds";
  EXPECT_GT(strongest("0,0 50,0; 0,20 0,70", {25, 1, 0})(0, 0), 0.9) << "curves";
  for (const char* bad : {"1,0", "1,2,3,4", "0,0,0", "0,0,0,1,0,0,-1", "a,b,c", "0,0,0,0,0,0",
                          "1,0,0 ; ; x", "0,0,0,1,0,0,1,1"})
    EXPECT_THROW(toolpath::strandsOf(bad), base::Error) << bad;
  for (const char* bad : {"1,0,nan", "inf,0,0", "0,0,0", "1,0,1e999"})
    try {
      toolpath::strandsOf(bad);
      ADD_FAILURE() << bad;
    } catch (const base::Error& error) {
      EXPECT_EQ(error.code(), base::ErrorCode::Usage);
      EXPECT_NE(std::string(error.what()).find("'" + std::string(bad) + "' is no direction"),
                std::string::npos)
          << error.what();
    }
  EXPECT_NEAR(strongest("1e300,0,0", {5, 5, 5})(0, 0), 1.0, 1e-12) << "of any length";
}

} // namespace
