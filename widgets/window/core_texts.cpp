#include "window/core_texts.h"

#include <QCoreApplication>

namespace voluta::window {

namespace {
// Seen by lupdate.
[[maybe_unused]] const char* const kTexts[] = {
    QT_TRANSLATE_NOOP("Core", "Curved layers"),
    QT_TRANSLATE_NOOP("Core", "auto"),
    QT_TRANSLATE_NOOP("Core", "reverse"),
    QT_TRANSLATE_NOOP("Core", "greedy"),
    QT_TRANSLATE_NOOP("Core", "Extended G-code (nozzle direction as nX nY nZ)"),
    QT_TRANSLATE_NOOP("Core", "Joint table (CSV)"),
};

QString translated(const char* text) {
  return QCoreApplication::translate("Core", text);
}
} // namespace

QString coreLabel(std::string_view english) {
  return translated(std::string(english).c_str());
}

QString platformText(const std::string& platform) {
  const QString text = QString::fromStdString(platform);
  const QString size = text.section(':', 1);
  if (text.startsWith("fit"))
    return size.isEmpty() || size == "0"
               ? QCoreApplication::translate("Core", "contact area")
               : QCoreApplication::translate("Core", "contact area + %1 mm").arg(size);
  if (text.startsWith("disc"))
    return QCoreApplication::translate("Core", "disc, %1 mm").arg(size);
  if (text.startsWith("rect"))
    return QCoreApplication::translate("Core", "%1 mm")
        .arg(QString(size).replace('x', QString::fromUtf8(" × ")));
  return text;
}

} // namespace voluta::window
