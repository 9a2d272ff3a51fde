#include "base/vtk_xml.h"

#include "helpers/vtk_array.h"

#include <gtest/gtest.h>

namespace voluta::base {
namespace {

TEST(VtkXml, ArraysAreAtTheOffsetsOfTheHeader) {
  VtkXml file("PolyData", {{"Key", "value"}});
  file.open("FieldData");
  file.field("two", std::vector<double>{1, 2, 3, 4}, 2);
  file.close();
  file.open("Piece", {{"NumberOfPoints", "0"}});
  file.array("none", std::vector<float>{});
  file.array("last", std::vector<std::int64_t>{-5});
  const std::string text = file.finish();
  EXPECT_EQ(test::vtkArray<double>(text, "two"), (std::vector<double>{1, 2, 3, 4}));
  EXPECT_TRUE(test::vtkArray<float>(text, "none").empty());
  EXPECT_EQ(test::vtkArray<std::int64_t>(text, "last"), std::vector<std::int64_t>{-5});
  EXPECT_EQ(text.substr(0, text.find("<AppendedData")), R"(<?xml version="1.0"?>
<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64">
<PolyData Key="value">
<FieldData>
<DataArray type="Float64" Name="two" NumberOfComponents="2" NumberOfTuples="2" format="appended" offset="0"/>
</FieldData>
<Piece NumberOfPoints="0">
<DataArray type="Float32" Name="none" NumberOfComponents="1" format="appended" offset="40"/>
<DataArray type="Int64" Name="last" NumberOfComponents="1" format="appended" offset="48"/>
</Piece>
</PolyData>
)");
}

} // namespace
} // namespace voluta::base
