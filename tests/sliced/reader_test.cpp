// From amounts to sections: seeded random paths written in the manner of slicers come back with
// their length and volume; features, layers and heights as the comments or heights state them.
#include "base/error.h"
#include "base/run_context.h"
#include "base/units.h"
#include "geometry/measures.h"
#include "geometry/repair/diagnosis.h"
#include "process/bead_model.h"
#include "sliced/gcode_machine.h"
#include "sliced/layer_solid.h"
#include "sliced/plan_measures.h"
#include "sliced/sliced_reader.h"
#include "sliced/sliced_sections.h"
#include "sliced/slicer_comments.h"
#include "sliced/slicer_writer.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <set>

using namespace voluta;
using Eigen::Vector3d;
using plan::PathKind;
using test::Manner;

namespace {

const base::RunContext kCtx;

void addPath(plan::ToolPlan& plan, PathKind kind, int layer, const std::vector<Vector3d>& points,
             double width, double height, int ring = 0) {
  plan::ToolPath path;
  path.first = plan.waypointCount();
  path.count = points.size();
  path.kind = kind;
  path.layer = layer;
  path.ring = ring;
  for (const Vector3d& p : points) {
    plan.position.push_back(p);
    plan.direction.push_back(Vector3d::UnitZ());
    plan.widthMm.push_back(static_cast<float>(width));
    plan.heightMm.push_back(static_cast<float>(height));
    plan.speedMmPerS.push_back(30.0f);
  }
  plan.paths.push_back(path);
}

std::vector<Vector3d> square(const Vector3d& centre, double half) {
  const auto at = [&](double x, double y) { return Vector3d(centre + Vector3d(x, y, 0.0)); };
  return {at(-half, -half), at(half, -half), at(half, half), at(-half, half), at(-half, -half)};
}

// A block: two walls and rows of infill every `spacing` hatches, solid in the first and last layer.
plan::ToolPlan block(double side, int layers, double width, double height, double spacing) {
  plan::ToolPlan plan;
  const double hatch = process::hatchOf(width, height);
  for (int layer = 0; layer < layers; ++layer) {
    const Vector3d centre(100.0, 90.0, (layer + 1) * height);
    addPath(plan, PathKind::Wall, layer, square(centre, 0.5 * (side - hatch)), width, height);
    addPath(plan, PathKind::Wall, layer, square(centre, 0.5 * (side - 3.0 * hatch)), width, height,
            1);
    const double half = 0.5 * (side - 5.0 * hatch);
    const double apart = layer == 0 || layer + 1 == layers ? 1.0 : spacing;
    const int rows = static_cast<int>(std::round(2.0 * half / (hatch * apart)));
    std::vector<Vector3d> zigzag;
    for (int row = 0; row <= rows; ++row)
      for (const double along : {-half, half}) {
        const double across = -half + 2.0 * half * row / rows, l = row % 2 ? -along : along;
        zigzag.push_back(centre + (layer % 2 ? Vector3d(across, l, 0) : Vector3d(l, across, 0)));
      }
    addPath(plan, apart > 1.0 ? PathKind::SparseInfill : PathKind::Infill, layer, zigzag, width,
            height);
  }
  return plan;
}

// Random open polylines in a box, layer by layer.
plan::ToolPlan randomPaths(std::mt19937& random) {
  std::uniform_real_distribution<double> at(10.0, 60.0), width(0.4, 0.9), step(-4.0, 4.0);
  std::uniform_int_distribution<int> layers(1, 5), paths(1, 6), points(2, 12), kind(0, 2);
  constexpr PathKind kKinds[] = {PathKind::Wall, PathKind::Infill, PathKind::SparseInfill};
  plan::ToolPlan plan;
  const int count = layers(random);
  for (int layer = 0; layer < count; ++layer)
    for (int p = paths(random); p > 0; --p) {
      std::vector<Vector3d> distance{{at(random), at(random), 0.2 * (layer + 1)}};
      for (int k = points(random); k > 1; --k) {
        Vector3d next = distance.back() + Vector3d(step(random), step(random), 0.0);
        distance.push_back(next.cwiseMax(Vector3d::Constant(0.2)));
        distance.back().z() = distance.front().z();
      }
      addPath(plan, kKinds[kind(random)], layer, distance, width(random), 0.2);
    }
  return plan;
}

TEST(SlicedReader, LengthAndVolumeAreTheFiles) {
  std::mt19937 random(7);
  for (int round = 0; round < 120; ++round) {
    const plan::ToolPlan plan = randomPaths(random);
    const Manner manner = test::kManners[round % 3];
    const double filamentMm = round % 2 ? 1.75 : 2.85;
    const test::Written written = test::writtenBy(manner, plan, filamentMm);
    const sliced::SlicedFile file = sliced::followGcode(written.text, "part.gcode", kCtx);
    EXPECT_DOUBLE_EQ(file.header.filamentMm > 0.0 ? file.header.filamentMm : 1.75, filamentMm);
    const plan::ToolPlan read = sliced::beadsOf(file, base::kPi / 4.0 * filamentMm * filamentMm);
    EXPECT_NEAR(test::lengthOf(read), written.lengthMm, 1e-6 * written.lengthMm) << round;
    EXPECT_NEAR(sliced::beadsMm3(read), written.volumeMm3, 1e-5 * written.volumeMm3) << round;
    ASSERT_EQ(read.paths.size(), plan.paths.size()) << round;
    for (std::size_t p = 0; p < plan.paths.size(); ++p) {
      EXPECT_EQ(read.paths[p].layer, plan.paths[p].layer) << round;
      if (manner != Manner::Slic3r) {
        EXPECT_EQ(read.paths[p].kind, plan.paths[p].kind) << round;
      }
      const std::size_t i = read.paths[p].first, j = plan.paths[p].first;
      EXPECT_NEAR(read.heightMm[i], 0.2, 1e-6);
      // Amounts have five decimals.
      const double distance = (plan.position[j + 1] - plan.position[j]).norm();
      EXPECT_NEAR(read.widthMm[i], plan.widthMm[j], 0.002 + 1e-3 / std::max(distance, 1e-3))
          << round;
    }
  }
}

TEST(SlicedReader, AStepOfTheSectionStaysLocal) {
  const sliced::ReadSliced read = sliced::readSliced(
      "; filament_diameter = 1.75\n; layer_height = 0.2\nG28\nM83\nG1 X0 Y0 Z.2 F600\n"
      "G1 X20 E0.8\nG1 X40 E1.6\n",
      "part.gcode", kCtx);
  const double mm2 = base::kPi / 4.0 * 1.75 * 1.75;
  EXPECT_NEAR(read.volumeMm3, 2.4 * mm2, 1e-4);
  for (std::size_t i = 0; i < read.plan.waypointCount(); ++i) {
    const double area = process::beadArea(read.plan.widthMm[i], read.plan.heightMm[i]);
    const double x = read.plan.position[i].x();
    if (std::abs(x - 20.0) > 0.3) {
      EXPECT_NEAR(area, (x < 20.0 ? 0.04 : 0.08) * mm2, 1e-6) << x;
    }
  }
}

TEST(SlicedReader, SolidIsTheBlockAndItsOpenVolumeTheRestOfTheInfill) {
  for (const Manner manner : test::kManners)
    for (const double spacing : {1.0, 4.0}) {
      const plan::ToolPlan plan = block(14.0, 5, 0.6, 0.3, spacing);
      const test::Written written = test::writtenBy(manner, plan);
      const sliced::ReadSliced read = sliced::readSliced(written.text, "part.gcode", kCtx);
      EXPECT_TRUE(geometry::isWatertight(read.solid));
      const double volume = geometry::volume(read.solid);
      EXPECT_NEAR(volume, 14.0 * 14.0 * 1.5, 0.02 * volume) << nameOf(manner) << spacing;
      EXPECT_EQ(read.plan.isSolid(), spacing == 1.0) << nameOf(manner) << spacing;
      if (spacing > 1.0) {
        EXPECT_NEAR(read.plan.fillOf(0).openMm3, volume - written.volumeMm3, 1e-3 * volume);
      }
      // Without comments closed paths are walls, and rows far apart are sparse.
      for (const plan::ToolPath& path : read.plan.paths)
        EXPECT_EQ(path.kind,
                  plan.paths[static_cast<std::size_t>(&path - read.plan.paths.data())].kind)
            << nameOf(manner) << spacing;
    }
}

TEST(SlicedReader, SparseInfillThatShowsIsNotSolid) {
  plan::ToolPlan plan = block(14.0, 4, 0.6, 0.3, 4.0);
  while (plan.paths.back().layer == 3) // Without its last layer
    plan.paths.pop_back();
  const std::size_t kept = plan.paths.back().first + plan.paths.back().count;
  plan.position.resize(kept);
  plan.direction.resize(kept);
  plan.widthMm.resize(kept);
  plan.heightMm.resize(kept);
  plan.speedMmPerS.resize(kept);
  const test::Written written = test::writtenBy(Manner::Cura, plan);
  const sliced::ReadSliced read = sliced::readSliced(written.text, "part.gcode", kCtx);
  EXPECT_NEAR(geometry::volume(read.solid), written.volumeMm3, 0.05 * written.volumeMm3);
}

TEST(SlicedReader, HolesStayOpen) {
  // Two loops, infill between them only.
  plan::ToolPlan plan;
  for (int layer = 0; layer < 4; ++layer) {
    const Vector3d centre(50.0, 50.0, 0.3 * (layer + 1));
    addPath(plan, PathKind::Wall, layer, square(centre, 9.7), 0.63, 0.3);
    addPath(plan, PathKind::Wall, layer, square(centre, 4.3), 0.63, 0.3);
    addPath(plan, PathKind::Infill, layer,
            {centre + Vector3d(-9, -7, 0), centre + Vector3d(9, -7, 0)}, 0.63, 0.3);
  }
  const sliced::ReadSliced read =
      sliced::readSliced(test::writtenBy(Manner::Cura, plan).text, "part.gcode", kCtx);
  EXPECT_NEAR(geometry::volume(read.solid), (20.0 * 20.0 - 8.0 * 8.0) * 1.2, 12.0);
}

TEST(SlicedReader, ASpiralIsOnePathOfTheStatedHeight) {
  std::string text =
      "; filament_diameter = 1.75\n; layer_height = 0.4\nG28\nM83\nG1 X10 Y0 Z0 F600\n";
  for (int k = 1; k <= 360; ++k)
    text += "G1 X" + std::to_string(10.0 * std::cos(0.1 * k)) + " Y" +
            std::to_string(10.0 * std::sin(0.1 * k)) + " Z" +
            std::to_string(0.4 * 0.1 * k / (2.0 * base::kPi)) + " E0.1\n";
  const sliced::ReadSliced read = sliced::readSliced(text, "vase.gcode", kCtx);
  ASSERT_EQ(read.plan.paths.size(), 1u);
  EXPECT_NEAR(read.plan.heightMm[100], 0.4, 0.005);
  EXPECT_TRUE(geometry::isWatertight(read.solid));
}

TEST(SlicedReader, EverySlicersFeaturesAreKnown) {
  const struct {
    const char* comment;
    PathKind kind;
  } kCases[] = {
      {"TYPE:External perimeter", PathKind::Wall},
      {"TYPE:Overhang perimeter", PathKind::Wall},
      {"TYPE:Internal infill", PathKind::SparseInfill},
      {"TYPE:Top solid infill", PathKind::Infill},
      {"TYPE:Bridge infill", PathKind::Bridge},
      {"TYPE:Gap fill", PathKind::GapFill},
      {"TYPE:Support material interface", PathKind::Support},
      {"TYPE:Outer wall", PathKind::Wall},
      {" FEATURE: Sparse infill", PathKind::SparseInfill},
      {"TYPE:WALL-OUTER", PathKind::Wall},
      {"TYPE:SKIN", PathKind::Infill},
      {"TYPE:FILL", PathKind::SparseInfill},
      {"TYPE:SKIRT", PathKind::Skirt},
      {" feature outer perimeter", PathKind::Wall},
  };
  for (const auto& c : kCases) {
    const sliced::CommentFacts facts = sliced::factsOf(c.comment);
    ASSERT_TRUE(facts.feature) << c.comment;
    EXPECT_EQ(facts.feature->kind, c.kind) << c.comment;
  }
  EXPECT_TRUE(sliced::factsOf("LAYER:12").layerChange);
  EXPECT_TRUE(sliced::factsOf("LAYER_CHANGE").layerChange);
  EXPECT_TRUE(sliced::factsOf(" layer 3, Z = 0.6").layerChange);
  EXPECT_FALSE(sliced::factsOf(" layer_height = 0.2").layerChange);
  EXPECT_FALSE(sliced::factsOf("LAYER_COUNT:12").layerChange);
}

std::string refusal(const std::string& text) {
  try {
    sliced::readSliced(text, "part.gcode", kCtx);
  } catch (const base::Error& e) {
    EXPECT_NE(e.code(), base::ErrorCode::Internal) << e.what();
    return e.what();
  }
  return "";
}

TEST(SlicedReader, FilesWithoutBeadsAreRefused) {
  EXPECT_NE(refusal("GCDE\1").find("is binary G-code"), std::string::npos);
  EXPECT_NE(refusal("G28\nG1 X10 F600\n").find("no motion extrudes"), std::string::npos);
  EXPECT_NE(refusal("").find("no motion extrudes"), std::string::npos);
  EXPECT_NE(
      refusal("; layer_height = 0.3\nM83\n;LAYER:0\nG1 X1 Y1 Z0.3 F600\nG1 X5 E5000\n;LAYER:1\n"
              "G1 Z0.6\nG1 X9 E1\n")
          .find("wide"),
      std::string::npos);
  EXPECT_NE(refusal("G28\nM83\nG1 X1 Y1 Z0 F600\nG1 X9 E1\nG1 X8 E1").find("not known"),
            std::string::npos);
}

} // namespace
