// Misses of the sources' growth schemes as the platform grows, beside those of uniform slicing
// (Boge 2019, tables 5.1 and 6.6, 6.2.3). One call makes the table of an object:
//   voluta-cli compare OBJECT.txt -o DIR --until decompose --modes curved,flat
//       --growths greedy,incremental --platforms fit:0,fit:20,fit:60 --set frontShape=flat
#include "pipeline/compare_figures.h"
#include "voxel/voxel_object.h"

#include <gtest/gtest.h>
#include <map>

using namespace voluta;
using namespace voluta::modes;
using namespace voluta::pipeline;
using namespace voluta::project;

namespace {

constexpr const char* kPlatforms[] = {"fit:0", "fit:20", "fit:60"};
constexpr const char* kSchemes[] = {"greedy", "incremental"};

struct Object {
  const char* name;
  Eigen::Vector3i size; // cells
  bool (*holds)(int i, int j, int k);
  std::size_t uniformMisses; // counted by hand, or from the figure's rows
  // Where the platform changes nothing, why; else empty.
  const char* exception;
};

// A stem 5 cells wide with an arm 21 cells long at right angles.
bool arm(int i, int, int k) {
  return i < 5 || (12 <= k && k < 17);
}
// A stem, an arm and a tip from its end downwards.
bool hook(int i, int, int k) {
  return i < 5 || (17 <= k) || (i >= 17 && k >= 8);
}
// Two posts under a round vault.
bool arch(int i, int, int k) {
  const double r2 = (i - 13.5) * (i - 13.5) + (k - 8.0) * (k - 8.0);
  return k < 8 ? i < 5 || i >= 23 : r2 <= 14.0 * 14.0 && r2 >= 8.6 * 8.6;
}
// A stem with four arms.
bool cross(int i, int j, int k) {
  const bool inX = 8 <= i && i < 13, inY = 8 <= j && j < 13;
  return (inX && inY) || (10 <= k && k < 14 && (inX || inY));
}
bool table(int i, int j, int k) {
  return k >= 10 || ((i < 4 || i >= 16) && (j < 4 || j >= 16));
}

constexpr const char* kBetweenPosts =
    "what is lost lies between the posts, inside the hull of what stands on them: that is as wide "
    "on any platform";

const Object kObjects[] = {
    // Each row of the arm is a cell longer than the one below: 20 + 19 + 18 + 17 + 16.
    {"arm, 2D", {26, 1, 24}, arm, 90, ""},
    // The arm as above but 17 long and 5 high: 11 + 10 + 9 + 8 + 7 between stem and tip, the tip (5
    // wide, 9 high) and the voxels over it (5 x 5): 45 + 45 + 25.
    {"hook, 2D", {22, 1, 22}, hook, 115, ""},
    {"arch, 2D", {28, 1, 20}, arch, 14, kBetweenPosts},
    // Four arms 8 long, 5 wide: (7 + 6 + 5 + 4) x 5 x 4.
    {"cross, 3D", {21, 21, 20}, cross, 440, ""},
    {"hook, 3D", {22, 5, 22}, hook, 5 * 115, ""},
    {"table, 3D", {20, 20, 14}, table, 984, kBetweenPosts},
};

std::shared_ptr<const LoadedPart> partOf(const Object& object) {
  auto cells = std::make_shared<voxel::VoxelObject>();
  cells->size = object.size;
  for (int k = 0; k < object.size.z(); ++k)
    for (int j = 0; j < object.size.y(); ++j)
      for (int i = 0; i < object.size.x(); ++i)
        cells->solid.push_back(object.holds(i, j, k) ? 1 : 0);
  return loadedFrom(std::string(object.name) + ".txt", cells, true, {});
}

class PlatformMisses : public testing::TestWithParam<Object> {};

TEST_P(PlatformMisses, GrowWithThePlatformAndStayBelowUniformSlicing) {
  CompareOptions options;
  options.plan.item().loaded = partOf(GetParam());
  options.plan.choices.item().parameters["frontShape"] = "flat"; // as the source has it
  options.plan.until = Stage::Decompose;
  options.modes = {"curved", "flat"};
  for (const char* scheme : kSchemes)
    options.growths.emplace_back(scheme);
  for (const char* platform : kPlatforms)
    options.platforms.emplace_back(platform);
  const Comparison comparison = compare(options, base::RunContext(base::CancelToken(), 2));

  std::map<std::pair<std::string, std::string>, std::size_t> missed; // scheme, platform
  for (const CompareRow& row : comparison.rows) {
    ASSERT_NE(row.state(), RowState::Failed) << base::english(row.error);
    const std::size_t count = row.report.item().decomposition.missedVoxels;
    if (row.combination.mode == "flat") {
      EXPECT_EQ(uniformMisses(row), static_cast<double>(GetParam().uniformMisses));
    } else {
      missed[{row.combination.growth->id(), row.combination.platform.text()}] = count;
    }
  }
  ASSERT_EQ(missed.size(), std::size(kSchemes) * std::size(kPlatforms));
  for (const char* scheme : kSchemes) {
    const std::size_t fit = missed[{scheme, "fit:0"}], wide = missed[{scheme, "fit:20"}],
                      widest = missed[{scheme, "fit:60"}];
    EXPECT_LE(fit, wide) << scheme;
    EXPECT_LE(wide, widest) << scheme;
    EXPECT_LT(widest, GetParam().uniformMisses) << scheme;
    if (*GetParam().exception) {
      EXPECT_EQ(fit, widest) << scheme << ": no exception any more: " << GetParam().exception;
    }
  }
  if (!*GetParam().exception) {
    EXPECT_LT((missed[{"greedy", "fit:0"}]), (missed[{"greedy", "fit:20"}]));
    EXPECT_LT((missed[{"greedy", "fit:20"}]), (missed[{"greedy", "fit:60"}]));
  }
  // Shadow prevention loses no more than whole layers do (6.2.2, "in general").
  for (const char* platform : kPlatforms)
    EXPECT_LE((missed[{"incremental", platform}]), (missed[{"greedy", platform}])) << platform;
}

INSTANTIATE_TEST_SUITE_P(Objects, PlatformMisses, testing::ValuesIn(kObjects),
                         [](const auto& instance) {
                           std::string name;
                           for (const char c : std::string(instance.param.name))
                             if (std::isalnum(static_cast<unsigned char>(c)))
                               name += c;
                           return name;
                         });

} // namespace
