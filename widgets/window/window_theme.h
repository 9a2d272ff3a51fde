// The looks of the window, with one palette each: light, dark, high contrast.
#pragma once

#include <QString>

class QApplication;
class QPalette;

namespace voluta::window {

enum class Appearance { Light, Dark, HighContrast };

QPalette paletteOf(Appearance appearance);
// Sets the style, the palette and the few rules that a palette cannot express.
void applyAppearance(QApplication& app, Appearance appearance);
// As stored in the settings: "light", "dark", "highContrast"
QString appearanceName(Appearance appearance);
Appearance appearanceNamed(const QString& name); // Any other name: Light

} // namespace voluta::window
