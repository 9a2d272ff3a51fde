#include "translation_file.h"

#include <QFile>
#include <QXmlStreamReader>
#include <stdexcept>

namespace voluta::translations {

namespace {
void readTranslation(QXmlStreamReader& xml, Message& message) {
  message.finished = !xml.attributes().hasAttribute(QStringLiteral("type"));
  if (!message.plural) {
    message.forms << xml.readElementText();
    return;
  }
  while (xml.readNextStartElement())
    message.forms << xml.readElementText();
}

Message readMessage(QXmlStreamReader& xml, const QString& context) {
  Message message;
  message.context = context;
  message.plural = xml.attributes().value(QStringLiteral("numerus")) == QStringLiteral("yes");
  while (xml.readNextStartElement()) {
    if (xml.name() == QStringLiteral("source"))
      message.source = xml.readElementText();
    else if (xml.name() == QStringLiteral("comment"))
      message.comment = xml.readElementText();
    else if (xml.name() == QStringLiteral("translation"))
      readTranslation(xml, message);
    else
      xml.skipCurrentElement();
  }
  return message;
}
} // namespace

std::vector<Message> readTranslationFile(const QString& file) {
  QFile in(file);
  if (!in.open(QIODevice::ReadOnly))
    throw std::runtime_error((file + QStringLiteral(": ") + in.errorString()).toStdString());
  QXmlStreamReader xml(&in);
  std::vector<Message> messages;
  QString context;
  xml.readNextStartElement(); // TS
  while (xml.readNextStartElement()) {
    if (xml.name() != QStringLiteral("context")) {
      xml.skipCurrentElement();
      continue;
    }
    while (xml.readNextStartElement()) {
      if (xml.name() == QStringLiteral("name"))
        context = xml.readElementText();
      else if (xml.name() == QStringLiteral("message"))
        messages.push_back(readMessage(xml, context));
      else
        xml.skipCurrentElement();
    }
  }
  if (xml.hasError())
    throw std::runtime_error(QStringLiteral("%1:%2: %3")
                                 .arg(file)
                                 .arg(xml.lineNumber())
                                 .arg(xml.errorString())
                                 .toStdString());
  return messages;
}

} // namespace voluta::translations
