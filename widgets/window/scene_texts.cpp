#include "window/scene_texts.h"

#include <QCoreApplication>

namespace voluta::window {

namespace {
// Seen by lupdate; a test compares them with the tables they come from.
[[maybe_unused]] const char* const kTexts[] = {
    QT_TRANSLATE_NOOP("Scene", "Layer"),    QT_TRANSLATE_NOOP("Scene", "Group"),
    QT_TRANSLATE_NOOP("Scene", "Kind"),     QT_TRANSLATE_NOOP("Scene", "Height"),
    QT_TRANSLATE_NOOP("Scene", "Width"),    QT_TRANSLATE_NOOP("Scene", "Speed"),
    QT_TRANSLATE_NOOP("Scene", "Time"),     QT_TRANSLATE_NOOP("Scene", "Tilt of the nozzle"),
    QT_TRANSLATE_NOOP("Scene", "Wall"),     QT_TRANSLATE_NOOP("Scene", "Infill"),
    QT_TRANSLATE_NOOP("Scene", "Gap fill"), QT_TRANSLATE_NOOP("Scene", "Skirt"),
    QT_TRANSLATE_NOOP("Scene", "Support"),  QT_TRANSLATE_NOOP("Scene", "Missed"),
};
} // namespace

QString sceneText(std::string_view english) {
  return QCoreApplication::translate("Scene", std::string(english).c_str());
}

} // namespace voluta::window
