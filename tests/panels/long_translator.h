// A made-up language: every text a third longer, with marks that distinguish it from English.
#pragma once

#include <QTranslator>

namespace voluta::gallery {

class LongTranslator : public QTranslator {
public:
  using QTranslator::QTranslator;

  bool isEmpty() const override { return false; }
  QString translate(const char* context, const char* text, const char*, int) const override {
    // Qt's own texts have their own translations.
    if (QByteArray(context).startsWith('Q'))
      return {};
    const QString source = QString::fromUtf8(text);
    return QStringLiteral("«") + source + QString(source.size() / 3, QLatin1Char('x')) +
           QStringLiteral("»");
  }
};

} // namespace voluta::gallery
