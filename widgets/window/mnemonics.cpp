#include "window/mnemonics.h"

#include <QAbstractButton>
#include <QDialogButtonBox>
#include <QKeySequence>
#include <QLabel>
#include <QToolButton>
#include <algorithm>
#include <vector>

namespace voluta::window {

namespace {
bool isLatin(QChar letter) {
  const QChar upper = letter.toUpper();
  return upper >= u'A' && upper <= u'Z';
}

bool hasMnemonic(const QString& text) {
  return !QKeySequence::mnemonic(text).isEmpty();
}

// Qt's own buttons have mnemonics that are also letters of the dialog's fields.
bool isStandard(const QWidget& widget) {
  const auto* box = qobject_cast<const QDialogButtonBox*>(widget.parentWidget());
  auto* button = qobject_cast<QAbstractButton*>(const_cast<QWidget*>(&widget));
  return box && button && box->standardButton(button) != QDialogButtonBox::NoButton;
}

// The text of its button is the action's.
bool hasAction(const QWidget& widget) {
  const auto* button = qobject_cast<const QToolButton*>(&widget);
  return button && button->defaultAction();
}

// A label beside a text has nothing to reach.
bool isReachable(const QWidget* field) {
  return field && (field->focusPolicy() != Qt::NoFocus || field->focusProxy());
}

template <typename Widget> void give(Widget& widget, QString& used) {
  QString text = widget.text();
  const qsizetype at = text.indexOf(u'&');
  const bool isTaken = hasMnemonic(text) && at + 1 < text.size() && !text.contains(u"&&") &&
                       used.contains(text[at + 1].toUpper());
  if (!hasAction(widget) && (isStandard(widget) || isTaken))
    text.remove(u'&');
  text = withMnemonic(text, used);
  if (text != widget.text())
    widget.setText(text);
}
} // namespace

QString withMnemonic(const QString& text, QString& used) {
  if (const qsizetype at = text.indexOf(u'&'); hasMnemonic(text) && at + 1 < text.size()) {
    used += text[at + 1].toUpper();
    return text;
  }
  const auto isFree = [&](QChar letter) {
    return isLatin(letter) && !used.contains(letter.toUpper());
  };
  const auto startsWord = [&](qsizetype i) { return i == 0 || !text[i - 1].isLetterOrNumber(); };
  qsizetype best = -1, first = -1;
  for (qsizetype i = 0; i < text.size(); ++i) {
    if (first < 0 && isLatin(text[i]))
      first = i;
    if (isFree(text[i]) && (best < 0 || (startsWord(i) && !startsWord(best))))
      best = i;
  }
  if (first < 0) {
    for (QChar letter = u'A'; letter <= u'Z'; letter = QChar(letter.unicode() + 1))
      if (isFree(letter)) {
        used += letter;
        return text + QStringLiteral("(&%1)").arg(letter);
      }
    return text;
  }
  if (best < 0)
    best = first;
  used += text[best].toUpper();
  return QString(text).insert(best, u'&');
}

void giveMnemonics(QWidget& dialog) {
  std::vector<QWidget*> texts;
  for (QWidget* widget : dialog.findChildren<QWidget*>()) {
    const auto* button = qobject_cast<const QAbstractButton*>(widget);
    const auto* label = qobject_cast<const QLabel*>(widget);
    const auto hasLetters = [](const QString& text) {
      return std::ranges::any_of(text, [](QChar letter) { return letter.isLetter(); });
    };
    if ((button && hasLetters(button->text())) ||
        (label && isReachable(label->buddy()) && label->textFormat() != Qt::RichText &&
         !Qt::mightBeRichText(label->text()) && hasLetters(label->text())))
      texts.push_back(widget);
  }
  const auto textOf = [](const QWidget* widget) {
    const auto* button = qobject_cast<const QAbstractButton*>(widget);
    return button ? button->text() : static_cast<const QLabel*>(widget)->text();
  };
  // Those that have one keep it, and hidden ones share letters before visible ones do. Escape and
  // Enter press the standard ones, so that these come last.
  std::ranges::stable_sort(texts, {}, [&](const QWidget* widget) {
    return hasAction(*widget)             ? 0
           : isStandard(*widget)          ? 4
           : hasMnemonic(textOf(widget))  ? 1
           : widget->isVisibleTo(&dialog) ? 2
                                          : 3;
  });
  QString used;
  for (QWidget* widget : texts)
    if (auto* button = qobject_cast<QAbstractButton*>(widget))
      give(*button, used);
    else
      give(*static_cast<QLabel*>(widget), used);
}

} // namespace voluta::window
