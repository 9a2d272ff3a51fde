#include "curved/vti_writer.h"

#include "helpers/vtk_array.h"

#include <gtest/gtest.h>

using namespace voluta;

namespace {

TEST(VtiWriter, HoldsRanksAndThePlatform) {
  curved::Decomposition d;
  d.grid.size = {2, 1, 1};
  d.rank = {3, -1};
  d.platform = {{0, 0}, {1, 0}, {0, 1}};
  d.epsilonMm = 0.4;
  const std::string text = curved::voxelsVti(d);
  EXPECT_EQ(test::vtkArray<std::int32_t>(text, "rank"), (std::vector<std::int32_t>{3, -1}));
  EXPECT_EQ(test::vtkArray<std::uint8_t>(text, "kind"), (std::vector<std::uint8_t>{0, 0}));
  EXPECT_EQ(test::vtkArray<double>(text, "platform"), (std::vector<double>{0, 0, 1, 0, 0, 1}));
  EXPECT_EQ(test::vtkArray<double>(text, "epsilon"), std::vector<double>{0.4});
  EXPECT_NE(text.find("WholeExtent=\"0 2 0 1 0 1\""), std::string::npos);
}

} // namespace
