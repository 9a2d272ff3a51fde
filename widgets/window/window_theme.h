// Light and dark themes, with one palette each for the whole window.
#pragma once

#include <QString>

class QApplication;
class QPalette;

namespace voluta::window {

enum class Appearance { Light, Dark };

QPalette paletteOf(Appearance appearance);
// Sets the style, the palette and the few rules that a palette cannot express.
void applyAppearance(QApplication& app, Appearance appearance);
QString appearanceName(Appearance appearance);   // As stored in the settings: "light", "dark"
Appearance appearanceNamed(const QString& name); // Any other name: Light

} // namespace voluta::window
