// Buttons of dialogs with forms.
#pragma once

#include <QDialogButtonBox>
#include <QPushButton>

namespace voluta::forms {

// Keeps the dialog open on Enter, which commits a number.
inline void keepOpenOnEnter(const QDialogButtonBox& buttons) {
  for (QAbstractButton* button : buttons.buttons())
    static_cast<QPushButton*>(button)->setAutoDefault(false);
}

} // namespace voluta::forms
