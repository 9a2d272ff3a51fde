#include "base/ascii_text.h"

#include <gtest/gtest.h>

namespace voluta::base {
namespace {

TEST(AsciiText, TranscribesLettersAndSigns) {
  EXPECT_EQ(asciiText("Größe prüfen – 5 °C"), "Groesse pruefen - 5  degC");
  EXPECT_EQ(asciiText("Élève à Łódź, Žižkov"), "Eleve a Lodz, Zizkov");
  EXPECT_EQ(asciiText("Пауза: гайка"), "Pauza: gayka");
  EXPECT_EQ(asciiText("螺 nut"), "_ nut");
  EXPECT_EQ(asciiText("a\xFFz\xC3"), "a_z_");
}

} // namespace
} // namespace voluta::base
