#include "window/status_line.h"

#include <QCoreApplication>

namespace voluta::window {

namespace {
// What core reports while it works; seen by lupdate.
[[maybe_unused]] const char* const kTexts[] = {
    QT_TRANSLATE_NOOP("Stages", "load"),
    QT_TRANSLATE_NOOP("Stages", "repair"),
    QT_TRANSLATE_NOOP("Stages", "repair: check"),
    QT_TRANSLATE_NOOP("Stages", "repair: diagnosis"),
    QT_TRANSLATE_NOOP("Stages", "repair: holes"),
    QT_TRANSLATE_NOOP("Stages", "repair: orientation"),
    QT_TRANSLATE_NOOP("Stages", "repair: self-intersections"),
    QT_TRANSLATE_NOOP("Stages", "voxelise"),
    QT_TRANSLATE_NOOP("Stages", "voxels"),
    QT_TRANSLATE_NOOP("Stages", "orientation"),
    QT_TRANSLATE_NOOP("Stages", "supports"),
    QT_TRANSLATE_NOOP("Stages", "growth"),
    QT_TRANSLATE_NOOP("Stages", "peeling"),
    QT_TRANSLATE_NOOP("Stages", "front"),
    QT_TRANSLATE_NOOP("Stages", "field"),
    QT_TRANSLATE_NOOP("Stages", "cutting layers from the field"),
    QT_TRANSLATE_NOOP("Stages", "trimming layers on the part"),
    QT_TRANSLATE_NOOP("Stages", "ending layers on the surface"),
    QT_TRANSLATE_NOOP("Stages", "take the rod out of the part"),
    QT_TRANSLATE_NOOP("Stages", "take the surface out of the part"),
    QT_TRANSLATE_NOOP("Stages", "cutting layers"),
    QT_TRANSLATE_NOOP("Stages", "ordering layers"),
    QT_TRANSLATE_NOOP("Stages", "pieces"),
    QT_TRANSLATE_NOOP("Stages", "cutting"),
    QT_TRANSLATE_NOOP("Stages", "skeleton"),
    QT_TRANSLATE_NOOP("Stages", "slicing"),
    QT_TRANSLATE_NOOP("Stages", "checking layers"),
    QT_TRANSLATE_NOOP("Stages", "directions"),
    QT_TRANSLATE_NOOP("Stages", "tool-paths"),
    QT_TRANSLATE_NOOP("Stages", "motion"),
    QT_TRANSLATE_NOOP("Stages", "laying beads"),
    QT_TRANSLATE_NOOP("Stages", "checking the motion"),
    QT_TRANSLATE_NOOP("Stages", "running the program"),
    QT_TRANSLATE_NOOP("Stages", "looking for collisions"),
    QT_TRANSLATE_NOOP("Stages", "measuring the beads"),
    QT_TRANSLATE_NOOP("Stages", "looking beneath the beads"),
    QT_TRANSLATE_NOOP("Stages", "comparing with the plan"),
    QT_TRANSLATE_NOOP("Stages", "replayed"),
    QT_TRANSLATE_NOOP("Stages", "write files"),
    QT_TRANSLATE_NOOP("Stages", "write"),
    QT_TRANSLATE_NOOP("Stages", "replay"),
};
} // namespace

QString stageText(const QString& coreName) {
  // "write urscript": the format's id stays as it is.
  for (const char* verb : {"write", "replay"})
    if (coreName.startsWith(QString(verb) + ' ') && coreName != "write files")
      return QCoreApplication::translate("Stages", verb) + coreName.mid(qstrlen(verb));
  return QCoreApplication::translate("Stages", coreName.toUtf8().constData());
}

} // namespace voluta::window
