#include "forms/colours.h"

namespace voluta::forms {

bool isDark(const QPalette& palette) {
  return palette.color(QPalette::WindowText).lightness() >
         palette.color(QPalette::Window).lightness();
}

bool isHighContrast(const QPalette& palette) {
  return palette.color(QPalette::Active, QPalette::Window) == Qt::black &&
         palette.color(QPalette::Active, QPalette::WindowText) == Qt::white;
}

QColor mixed(const QColor& from, const QColor& to, double share) {
  const auto mix = [share](int a, int b) { return static_cast<int>(a + share * (b - a)); };
  return {mix(from.red(), to.red()), mix(from.green(), to.green()), mix(from.blue(), to.blue())};
}

QColor blockedColour(const QPalette& palette) {
  return isHighContrast(palette) ? QColor(0xff, 0x8a, 0x80)
         : isDark(palette)       ? QColor(0xff, 0x6b, 0x60)
                                 : QColor(0xc6, 0x28, 0x28);
}

QColor warningColour(const QPalette& palette) {
  return isDark(palette) ? QColor(0xff, 0xbf, 0x47) : QColor(0xb2, 0x6a, 0x00);
}

QColor goodColour(const QPalette& palette) {
  return isHighContrast(palette) ? QColor(0x80, 0xff, 0x90)
         : isDark(palette)       ? QColor(0x6c, 0xc9, 0x70)
                                 : QColor(0x2e, 0x7d, 0x32);
}

QColor mutedColour(const QPalette& palette) {
  if (isHighContrast(palette))
    return {0xdd, 0xdd, 0xdd};
  // Mixing in a third of the background keeps the contrast of small text above 4.5.
  const QColor text = palette.color(QPalette::Text), ground = palette.color(QPalette::Base);
  const auto mix = [](int a, int b) { return (2 * a + b) / 3; };
  return QColor(mix(text.red(), ground.red()), mix(text.green(), ground.green()),
                mix(text.blue(), ground.blue()));
}

QColor matchColour(const QPalette& palette) {
  return isHighContrast(palette) ? QColor(0x55, 0x48, 0x00)
         : isDark(palette)       ? QColor(0x6b, 0x5a, 0x12)
                                 : QColor(0xff, 0xe5, 0x8a);
}

} // namespace voluta::forms
