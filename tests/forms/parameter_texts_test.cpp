#include "forms/parameter_texts.h"
#include "pipeline/road.h"

#include <gtest/gtest.h>
#include <set>

using namespace voluta;

TEST(ParameterTexts, EveryTextOfTheTablesIsListedForTranslation) {
  std::set<std::string> listed;
  for (const char* text : forms::listedParameterTexts())
    EXPECT_TRUE(listed.insert(text).second) << "listed twice: " << text;
  std::set<std::string> needed;
  const base::ParameterTable table = pipeline::allParameters();
  for (const base::ParameterSpec& spec : table.specs()) {
    needed.insert({spec.group, spec.label, spec.help});
    needed.insert(spec.choices.begin(), spec.choices.end());
  }
  for (const std::string& text : needed)
    EXPECT_TRUE(listed.contains(text))
        << "add to widgets/forms/parameter_texts.cpp: QT_TRANSLATE_NOOP(\"Parameters\", \"" << text
        << "\")";
  for (const std::string& text : listed)
    EXPECT_TRUE(needed.contains(text)) << "no table says this any more: " << text;
}

TEST(ParameterTexts, NamesOfChoicesAreShownAsWords) {
  EXPECT_EQ(forms::parameterText("fewestMissed"), "Fewest missed");
  EXPECT_EQ(forms::parameterText("zigzag"), "Zigzag");
  EXPECT_EQ(forms::parameterText("Voxel width"), "Voxel width");
}

TEST(ParameterTexts, ToolTipNamesHelpRangeDefaultAndKey) {
  const auto spec =
      base::numberParameter("angle", "deg", 12.5, -30.0, 45.0, "G", "tilt", "Less than <steep>.");
  const QString tip = forms::parameterToolTip(spec);
  for (const char* expected : {"Less than &lt;steep&gt;.", "-30° to 45°", "12.5°", "angle"})
    EXPECT_TRUE(tip.contains(QString::fromUtf8(expected))) << expected << " in " << qPrintable(tip);
}
