#include "window/scene_texts.h"

#include <QCoreApplication>

namespace voluta::window {

namespace {
// Seen by lupdate; a test compares them with the tables they come from.
[[maybe_unused]] const char* const kTexts[] = {
    QT_TRANSLATE_NOOP("Scene", "Layer"),
    QT_TRANSLATE_NOOP("Scene", "Group"),
    QT_TRANSLATE_NOOP("Scene", "Kind"),
    QT_TRANSLATE_NOOP("Scene", "Height"),
    QT_TRANSLATE_NOOP("Scene", "Width"),
    QT_TRANSLATE_NOOP("Scene", "Speed"),
    QT_TRANSLATE_NOOP("Scene", "Time"),
    QT_TRANSLATE_NOOP("Scene", "Tilt of the nozzle"),
    QT_TRANSLATE_NOOP("Scene", "Wall"),
    QT_TRANSLATE_NOOP("Scene", "Infill"),
    QT_TRANSLATE_NOOP("Scene", "Gap fill"),
    QT_TRANSLATE_NOOP("Scene", "Skirt"),
    QT_TRANSLATE_NOOP("Scene", "Support"),
    QT_TRANSLATE_NOOP("Scene", "Layer spacing"),
    QT_TRANSLATE_NOOP("Scene", "Growth step"),
    QT_TRANSLATE_NOOP("Scene", "Peeling rank"),
    QT_TRANSLATE_NOOP("Scene", "Step being laid"),
    QT_TRANSLATE_NOOP("Scene", "Convex front"),
    QT_TRANSLATE_NOOP("Scene", "Missed, shadowed"),
    QT_TRANSLATE_NOOP("Scene", "Missed, unreached"),
    QT_TRANSLATE_NOOP("Scene", "Missed, cascade"),
    QT_TRANSLATE_NOOP("Scene", "Too thin to lay"),
    QT_TRANSLATE_NOOP("Scene", "Too thick to lay"),
    QT_TRANSLATE_NOOP("Scene", "Piece"),
    QT_TRANSLATE_NOOP("Scene", "on the plate"),
    QT_TRANSLATE_NOOP("Scene", "Needs support"),
    QT_TRANSLATE_NOOP("Scene", "limit"),
    QT_TRANSLATE_NOOP("Scene", "nominal"),
};
} // namespace

QString sceneText(std::string_view english) {
  return QCoreApplication::translate("Scene", std::string(english).c_str());
}

} // namespace voluta::window
