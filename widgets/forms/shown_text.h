// The text of a label, a button or a command as it is read.
#pragma once

#include <QRegularExpression>
#include <QString>
#include <QTextDocumentFragment>

namespace voluta::forms {

// Returns the text without mnemonics, marks of rich text and the bullet of a changed value.
inline QString shownText(QString text) {
  static const QRegularExpression kAppended(QStringLiteral("\\(&[^)]\\)"));
  static const QRegularExpression kMnemonic(QStringLiteral("&(.)"));
  if (Qt::mightBeRichText(text)) {
    text = QTextDocumentFragment::fromHtml(text).toPlainText();
  } else {
    text.remove(kAppended);
    text.replace(kMnemonic, QStringLiteral("\\1"));
  }
  if (text.startsWith(QChar(0x2022)))
    text.remove(0, 1);
  return text.trimmed();
}

} // namespace voluta::forms
