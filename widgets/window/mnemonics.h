// Letters that reach the fields and buttons of a dialog, pressed with Alt.
#pragma once

#include <QStringList>
#include <QWidget>

namespace voluta::window {

// Returns the text with a mnemonic that is not among `used`, if possible at the beginning of a
// word, and adds its letter to them. A text that has one keeps it; one without Latin letters gets
// one in brackets. Once all its letters are used, it shares its first one.
QString withMnemonic(const QString& text, QString& used);

// Gives one to all buttons with words and all labels of fields in the dialog; visible ones first.
void giveMnemonics(QWidget& dialog);

} // namespace voluta::window
