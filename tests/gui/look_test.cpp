// The looks of the window: their colours can be told apart, and the menu chooses one.
#include "forms/colours.h"
#include "gui/window_fixture.h"
#include "helpers/shapes.h"
#include "window/picture_area.h"
#include "window/window_theme.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QSettings>
#include <QStyleFactory>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <memory>

namespace voluta::test {
namespace {

using window::Appearance;

// Contrast of two colours as in WCAG 2.1: 1 to 21.
double contrast(const QColor& a, const QColor& b) {
  const auto luminance = [](const QColor& colour) {
    const auto linear = [](double c) {
      return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
           0.0722 * linear(colour.blueF());
  };
  const double first = luminance(a), second = luminance(b);
  return (std::max(first, second) + 0.05) / (std::min(first, second) + 0.05);
}

QColor colourOf(const scene::Colour& c) {
  return QColor::fromRgbF(static_cast<float>(c[0]), static_cast<float>(c[1]),
                          static_cast<float>(c[2]));
}

struct Pair {
  QPalette::ColorRole text, ground;
};
constexpr Pair kPairs[] = {{QPalette::WindowText, QPalette::Window},
                           {QPalette::Text, QPalette::Base},
                           {QPalette::Text, QPalette::AlternateBase},
                           {QPalette::ButtonText, QPalette::Button},
                           {QPalette::ToolTipText, QPalette::ToolTipBase},
                           {QPalette::HighlightedText, QPalette::Highlight},
                           {QPalette::Link, QPalette::Base},
                           {QPalette::LinkVisited, QPalette::Base},
                           {QPalette::PlaceholderText, QPalette::Base},
                           {QPalette::PlaceholderText, QPalette::Window}};

void expectContrast(Appearance look, double least) {
  const QPalette p = window::paletteOf(look);
  for (const Pair& pair : kPairs)
    EXPECT_GE(contrast(p.color(pair.text), p.color(pair.ground)), least)
        << pair.text << " on " << pair.ground;
  for (const QPalette::ColorRole ground : {QPalette::Base, QPalette::Window})
    for (const QColor& colour :
         {forms::blockedColour(p), forms::goodColour(p), forms::mutedColour(p)})
      EXPECT_GE(contrast(colour, p.color(ground)), least) << colour.name().toStdString();
  EXPECT_GE(contrast(p.color(QPalette::Text), forms::matchColour(p)), least);
}

// AA asks for 4.5 of texts, AAA for 7.
TEST(Looks, TextsOfHighContrastReachAaa) {
  expectContrast(Appearance::HighContrast, 7.0);
  const QPalette p = window::paletteOf(Appearance::HighContrast);
  EXPECT_GE(contrast(forms::warningColour(p), p.color(QPalette::Base)), 7.0);
  EXPECT_TRUE(forms::isHighContrast(p));
  EXPECT_TRUE(forms::isDark(p));
  // Disabled texts can be read as well, and the outlines and the selection are no shades.
  for (const QPalette::ColorRole role :
       {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    EXPECT_GE(contrast(p.color(QPalette::Disabled, role), p.color(QPalette::Window)), 4.5);
  EXPECT_GE(contrast(p.color(QPalette::Highlight), p.color(QPalette::Window)), 7.0);
  EXPECT_GE(contrast(p.color(QPalette::Mid), p.color(QPalette::Window)), 7.0);
  const scene::Theme theme = scene::highContrastTheme();
  const QColor ground = colourOf(theme.backgroundTop);
  for (const scene::Colour& colour :
       {theme.text, theme.part, theme.platformEdges, theme.grid, theme.marker, theme.travel,
        theme.material, theme.blocked, theme.axisX, theme.axisY, theme.axisZ})
    EXPECT_GE(contrast(colourOf(colour), ground), 4.5) << colourOf(colour).name().toStdString();
}

TEST(Looks, TextsOfTheOthersReachAa) {
  for (const Appearance look : {Appearance::Light, Appearance::Dark}) {
    SCOPED_TRACE(window::appearanceName(look).toStdString());
    expectContrast(look, 4.5);
    EXPECT_FALSE(forms::isHighContrast(window::paletteOf(look)));
  }
}

TEST(Looks, AreStoredByTheirNames) {
  for (const Appearance look : {Appearance::Light, Appearance::Dark, Appearance::HighContrast})
    EXPECT_EQ(window::appearanceNamed(window::appearanceName(look)), look);
  EXPECT_EQ(window::appearanceNamed("none"), Appearance::Light);
}

class LookTest : public WindowTest {
protected:
  void TearDown() override {
    WindowTest::TearDown();
    window::applyAppearance(application(), Appearance::Light);
  }
};

// Share of the pixels along the edge of a picture that have the colour. Texts do not reach it.
double shareOfEdge(const QImage& image, const QColor& colour) {
  int there = 0, all = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const bool isEdge = x == 0 || y == 0 || x == image.width() - 1 || y == image.height() - 1;
      all += isEdge ? 1 : 0;
      there += isEdge && image.pixelColor(x, y) == colour ? 1 : 0;
    }
  return all > 0 ? static_cast<double>(there) / all : 0.0;
}

TEST_F(LookTest, HighContrastIsChosenInTheMenu) {
  openPart(writePart("plinth.stl", box({0, 0, 0}, {24, 18, 6})));
  const QImage light = picture();
  QTest::qWait(100);
  const auto choose = [&](const char* name) {
    QAction* action = find<QAction>(name);
    ASSERT_TRUE(action->isEnabled());
    action->trigger();
    QTest::qWait(100);
    EXPECT_TRUE(action->isChecked());
  };
  choose("highContrast");
  EXPECT_FALSE(find<QAction>("light")->isChecked());
  EXPECT_EQ(QApplication::palette().color(QPalette::Window), Qt::black);
  EXPECT_EQ(QSettings().value("window/appearance").toString(), "highContrast");
  const QImage strong = picture();
  EXPECT_GT(differingShare(light, strong), 0.5);
  EXPECT_EQ(strong.pixelColor(strong.width() / 2, 3), Qt::black);
  for (const char* page : {Page::Prepare, Page::Layers, Page::Export}) {
    choosePage(page);
    QTest::qWait(50);
    keepPicture(window(), (std::string("high-contrast-") + page).c_str());
  }
  // Fields have outlines on all sides.
  choosePage(Page::Prepare);
  int fields = 0;
  for (QWidget* field : window().findChildren<QWidget*>())
    if (field->isVisible() && field->isEnabled() &&
        (field->inherits("QComboBox") || field->inherits("QAbstractSpinBox")) && fields < 8) {
      ++fields;
      const QColor expected =
          field->palette().color(field->hasFocus() ? QPalette::Highlight : QPalette::WindowText);
      EXPECT_GT(shareOfEdge(field->grab().toImage(), expected), 0.98)
          << field->objectName().toStdString();
    }
  EXPECT_GT(fields, 2);
  // The measure tells them from fields without.
  const std::unique_ptr<QStyle> fusion(QStyleFactory::create("Fusion"));
  QComboBox plain(&window());
  plain.setStyle(fusion.get());
  plain.addItem("Outline");
  plain.resize(160, 28);
  EXPECT_LT(shareOfEdge(plain.grab().toImage(), plain.palette().color(QPalette::WindowText)), 0.5);
  choose("dark");
  choose("light");
  EXPECT_LT(differingShare(light, picture()), 1e-3);
}

} // namespace
} // namespace voluta::test
