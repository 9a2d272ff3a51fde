#include "language/parameter_texts.h"

#include <gtest/gtest.h>

using namespace voluta;

TEST(ParameterTexts, ToolTipNamesHelpRangeDefaultAndKey) {
  const auto spec = base::numberParameter("angle", "deg", 12.5, -30.0, 45.0, "G"_text, "tilt"_text,
                                          "Less than <steep>."_text);
  const QString tip = language::parameterToolTip(spec);
  for (const char* expected : {"Less than &lt;steep&gt;.", "-30° to 45°", "12.5°", "angle"})
    EXPECT_TRUE(tip.contains(QString::fromUtf8(expected))) << expected << " in " << qPrintable(tip);
}
