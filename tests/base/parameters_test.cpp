#include "base/error.h"
#include "base/nearest_name.h"
#include "base/parameters.h"

#include <gtest/gtest.h>

using namespace voluta::base;

namespace {

ParameterTable sampleTable() {
  return ParameterTable({
      numberParameter("voxelMm", "mm", 0.8, 0.1, 5.0, "Layers"_text, "voxel"_text,
                      "Width of a voxel."_text),
      integerParameter("walls", 2, 0, 10, "Beads"_text, "walls"_text, "Number of walls."_text),
      booleanParameter("debug", false, "Output"_text, "debug"_text,
                       "Writes what every stage made."_text),
      choiceParameter("infill", "zigzag",
                      {{"zigzag", "zigzag"_text}, {"concentric", "concentric"_text}}, "Beads"_text,
                      "infill"_text, "Pattern."_text),
  });
}

std::string messageOf(const std::function<void()>& f) {
  try {
    f();
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ErrorCode::Usage);
    return e.what();
  }
  ADD_FAILURE() << "no Error was thrown";
  return {};
}

TEST(Parameters, DefaultsThenChanges) {
  ParameterValues values(sampleTable());
  EXPECT_DOUBLE_EQ(values.number("voxelMm"), 0.8);
  EXPECT_EQ(values.integer("walls"), 2);
  EXPECT_FALSE(values.boolean("debug"));
  values.setAssignment("voxelMm=1.08");
  values.setAssignment("debug=true");
  values.set("infill", "concentric");
  EXPECT_DOUBLE_EQ(values.number("voxelMm"), 1.08);
  EXPECT_TRUE(values.boolean("debug"));
  EXPECT_EQ(values.text("infill"), "concentric");
  EXPECT_TRUE(values.changed("infill"));
  EXPECT_FALSE(values.changed("walls"));
}

TEST(Parameters, ErrorsNameTheNearestAndTheRange) {
  ParameterValues values(sampleTable());
  EXPECT_NE(messageOf([&] { values.setAssignment("voxelmm=1"); }).find("voxelMm"),
            std::string::npos);
  EXPECT_NE(messageOf([&] { values.setAssignment("voxelMm=50"); }).find("0.1 to 5 mm"),
            std::string::npos);
  EXPECT_NE(messageOf([&] { values.setAssignment("infill=zigzak"); }).find("zigzag"),
            std::string::npos);
  for (const char* wrong : {"voxelMm", "=1", "voxelMm=", "voxelMm=1x", "voxelMm=nan", "walls=1.5",
                            "walls=99", "debug=maybe"})
    EXPECT_FALSE(messageOf([&] { values.setAssignment(wrong); }).empty()) << wrong;
}

TEST(Parameters, OldKeysSetTheRenamedParameter) {
  ParameterValues values(ParameterTable(
      {choiceParameter("rimSupports", "auto", {{"auto", "auto"_text}, {"none", "none"_text}},
                       "Beads"_text, "rims"_text, "Supports of rims."_text)}));
  values.setAssignment("underlay=none");
  EXPECT_TRUE(values.changed("rimSupports"));
  EXPECT_FALSE(values.changed("underlay"));
  EXPECT_EQ(values.text("rimSupports"), "none");
  EXPECT_EQ(english(renamedNote("underlay")), "parameter underlay was renamed to rimSupports");
  EXPECT_EQ(currentKey("walls"), "walls");
}

TEST(Parameters, AKeyTwiceIsAMistake) {
  ParameterTable table = sampleTable();
  EXPECT_THROW(table.append(sampleTable()), Error);
}

TEST(Parameters, WrongTypeIsAMistake) {
  const ParameterValues values(sampleTable());
  EXPECT_THROW(values.boolean("walls"), Error);
  EXPECT_THROW(values.number("none"), Error);
}

TEST(NearestName, ByEditDistance) {
  EXPECT_EQ(nearestName("ur5-fixd", {"ur3", "ur5-fixed", "lathe"}), "ur5-fixed");
  EXPECT_EQ(nearestName("CURVED", {"planar", "curved"}), "curved");
  EXPECT_EQ(nearestName("x", {}), "");
}

} // namespace
