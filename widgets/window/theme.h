// Light and dark: one palette each for the whole window.
#pragma once

#include <QString>

class QApplication;
class QPalette;

namespace voluta::window {

enum class Appearance { Light, Dark };

QPalette paletteOf(Appearance appearance);
// Style, palette and the few rules that a palette cannot say.
void applyAppearance(QApplication& app, Appearance appearance);
QString appearanceName(Appearance appearance);   // as kept in the settings: "light", "dark"
Appearance appearanceNamed(const QString& name); // anything else: Light

} // namespace voluta::window
