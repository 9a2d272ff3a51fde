#include "window/core_texts.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace voluta::window {

namespace {
// Seen by lupdate.
[[maybe_unused]] const char* const kTexts[] = {
    QT_TRANSLATE_NOOP("Core", "Curved layers"),
    QT_TRANSLATE_NOOP("Core", "Planar pieces"),
    QT_TRANSLATE_NOOP("Core", "Flat layers"),
    QT_TRANSLATE_NOOP("Core", "Around a rod"),
    QT_TRANSLATE_NOOP("Core", "On a given surface"),
    QT_TRANSLATE_NOOP("Core", "Extended G-code (nozzle direction as nX nY nZ)"),
    QT_TRANSLATE_NOOP("Core", "Joint table (CSV)"),
};

struct GrowthText {
  std::string_view id;
  const char *label, *help;
};
constexpr GrowthText kGrowths[] = {
    {"auto", QT_TRANSLATE_NOOP("Core", "Automatic"),
     QT_TRANSLATE_NOOP("Core", "Peels the part and keeps the best of several passes")},
    {"reverse", QT_TRANSLATE_NOOP("Core", "Peeling, turned round"),
     QT_TRANSLATE_NOOP("Core", "Takes voxels off from outside while the rest keeps its support; "
                               "printed in the opposite order")},
    {"guided", QT_TRANSLATE_NOOP("Core", "Guided by peeling"),
     QT_TRANSLATE_NOOP("Core", "Grows from the platform, held back by the peeling field")},
    {"adaptive", QT_TRANSLATE_NOOP("Core", "Halved layers"),
     QT_TRANSLATE_NOOP("Core", "Grows from the platform; a layer that would cut voxels off is "
                               "halved until it does not")},
    {"incremental", QT_TRANSLATE_NOOP("Core", "Voxel by voxel"),
     QT_TRANSLATE_NOOP("Core", "Grows from the platform; a layer takes each voxel that cuts off "
                               "no other")},
    {"greedy", QT_TRANSLATE_NOOP("Core", "Greedy"),
     QT_TRANSLATE_NOOP("Core", "Grows from the platform by whole layers, whatever they cut off")},
};

struct RemedyHelp {
  std::string_view id;
  const char *label, *help; // the label is that of pipeline::remedies()
};
constexpr RemedyHelp kRemedies[] = {
    {"dropToPlate", QT_TRANSLATE_NOOP("Core", "Drop to plate"),
     QT_TRANSLATE_NOOP("Core", "Lowest point on the plate")},
    {"shrinkPlatform", QT_TRANSLATE_NOOP("Core", "Shrink platform"),
     QT_TRANSLATE_NOOP("Core", "To the area that the part stands on: the front spans less")},
    {"addSupports", QT_TRANSLATE_NOOP("Core", "Add supports"),
     QT_TRANSLATE_NOOP("Core", "Thin columns that break off, as few as can be")},
    {"widenPlatform", QT_TRANSLATE_NOOP("Core", "Widen the platform"),
     QT_TRANSLATE_NOOP("Core", "By 20 mm all round, so that supports have something to stand on")},
    {"adaptLayers", QT_TRANSLATE_NOOP("Core", "Adapt the layers"),
     QT_TRANSLATE_NOOP("Core", "Lower ones where the surface leans: steps leave less of it empty")},
    {"turnLeastRisky", QT_TRANSLATE_NOOP("Core", "Turn the part"),
     QT_TRANSLATE_NOOP("Core", "Searches the way to lie in which least area needs support")},
    {"turnPart", QT_TRANSLATE_NOOP("Core", "Turn the part"),
     QT_TRANSLATE_NOOP("Core", "Searches the way to lie in which fewest voxels are missed")},
    {"narrowVoxels", QT_TRANSLATE_NOOP("Core", "Use voxel width %1 mm"),
     QT_TRANSLATE_NOOP("Core", "Narrow enough for this wall; narrower voxels take longer")},
};

QString translated(const char* text) {
  return QCoreApplication::translate("Core", text);
}
} // namespace

QString coreLabel(std::string_view english) {
  return translated(std::string(english).c_str());
}

GrowthTexts growthTexts(std::string_view id) {
  for (const GrowthText& row : kGrowths)
    if (row.id == id)
      return {translated(row.label), translated(row.help)};
  return {coreLabel(id), {}};
}

RemedyTexts remedyTexts(const pipeline::Offer& offer) {
  QString label = coreLabel(offer.label), help;
  if (!offer.cure.value.empty() && label.contains("%1"))
    label = label.arg(QString::fromStdString(offer.cure.value));
  for (const RemedyHelp& row : kRemedies)
    if (row.id == offer.id)
      help = translated(row.help);
  return {label, help};
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
  if (text.startsWith("rod"))
    return QCoreApplication::translate("Core", "rod, %1 mm")
        .arg(QString(size).replace('x', QString::fromUtf8(" × ")));
  if (text.startsWith("mesh"))
    return QFileInfo(size).fileName();
  return text;
}

} // namespace voluta::window
