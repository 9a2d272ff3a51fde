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
    QT_TRANSLATE_NOOP("Core", "Automatic"),
    QT_TRANSLATE_NOOP("Core", "Peels the part and keeps the best of several passes"),
    QT_TRANSLATE_NOOP("Core", "Peeling, turned round"),
    QT_TRANSLATE_NOOP("Core", "Takes voxels off from outside while the rest keeps its support; "
                              "printed in the opposite order"),
    QT_TRANSLATE_NOOP("Core", "Guided by peeling"),
    QT_TRANSLATE_NOOP("Core", "Grows from the platform, held back by the peeling field"),
    QT_TRANSLATE_NOOP("Core", "Halved layers"),
    QT_TRANSLATE_NOOP(
        "Core",
        "Grows from the platform; a layer that would cut voxels off is halved until it does not"),
    QT_TRANSLATE_NOOP("Core", "Voxel by voxel"),
    QT_TRANSLATE_NOOP("Core",
                      "Grows from the platform; a layer takes each voxel that cuts off no other"),
    QT_TRANSLATE_NOOP("Core", "Greedy"),
    QT_TRANSLATE_NOOP("Core", "Grows from the platform by whole layers, whatever they cut off"),
    QT_TRANSLATE_NOOP("Core", "Contact area, margin"),
    QT_TRANSLATE_NOOP("Core", "Rod of the cell"),
    QT_TRANSLATE_NOOP("Core", "Disc, diameter"),
    QT_TRANSLATE_NOOP("Core", "Rectangle"),
    QT_TRANSLATE_NOOP("Core", "Rod, diameter × length"),
    QT_TRANSLATE_NOOP("Core", "Body from a file"),
    QT_TRANSLATE_NOOP("Core", "Margin around what stands on the plate"),
    QT_TRANSLATE_NOOP("Core", "Diameter"),
    QT_TRANSLATE_NOOP("Core", "Width (X)"),
    QT_TRANSLATE_NOOP("Core", "Depth (Y)"),
    QT_TRANSLATE_NOOP("Core", "Length"),
    QT_TRANSLATE_NOOP("Core", "contact area"),
    QT_TRANSLATE_NOOP("Core", "contact area + %1 mm"),
    QT_TRANSLATE_NOOP("Core", "disc, %1 mm"),
    QT_TRANSLATE_NOOP("Core", "rod, %1 mm"),
    QT_TRANSLATE_NOOP("Core", "%1 mm"),
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

RemedyTexts remedyTexts(const pipeline::Offer& offer) {
  QString label = coreLabel(offer.label), help;
  if (!offer.cure.value.empty() && label.contains("%1"))
    label = label.arg(QString::fromStdString(offer.cure.value));
  for (const RemedyHelp& row : kRemedies)
    if (row.id == offer.id)
      help = translated(row.help);
  return {label, help};
}

QString platformText(const project::Platform& platform) {
  if (!platform.file().empty())
    return QFileInfo(QString::fromStdString(platform.file())).fileName();
  const project::PlatformKind& kind = platform.kind();
  QStringList sizes;
  bool sized = kind.plain.empty();
  for (const double mm : platform.sizesMm()) {
    sizes << QString::number(mm);
    sized = sized || mm != 0.0;
  }
  return sized ? coreLabel(kind.shown).arg(sizes.join(QStringLiteral(" × ")))
               : coreLabel(kind.plain);
}

} // namespace voluta::window
