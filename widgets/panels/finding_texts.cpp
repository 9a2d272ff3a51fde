#include "panels/finding_texts.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <vector>

namespace voluta::panels {

namespace {
// Sentences of the modes that slice along planes; what changes in them is numbered. Seen by
// lupdate.
constexpr const char* kSentences[] = {
    QT_TRANSLATE_NOOP("Findings", "%1 mm2 lean over by more than %2 degrees"),
    QT_TRANSLATE_NOOP("Findings", "%1 smaller places lean over too far, %2 mm2 together; this is "
                                  "the largest of them"),
    QT_TRANSLATE_NOOP("Findings", "%1 of %2 pieces: something printed before is in the head's way"),
    QT_TRANSLATE_NOOP("Findings", "all pieces are held to the plate by %1 mm2, of %2 that the part "
                                  "stands on uncut"),
    QT_TRANSLATE_NOOP("Findings", "%1 of %2 voxels have nothing printed under them"),
    QT_TRANSLATE_NOOP("Findings", "%1 mm2 hang where a support has nothing to stand on"),
    QT_TRANSLATE_NOOP("Findings", "%1 pieces of layers are too small for a bead or would begin in "
                                  "the air, %2 mm3 of %3: they are not laid"),
    QT_TRANSLATE_NOOP("Findings", "%1 pieces of layers have nothing under them"),
    QT_TRANSLATE_NOOP("Findings", "planes of layers miss the part: %1"),
    QT_TRANSLATE_NOOP("Findings", "pieces of layers are narrower than half a bead and stay empty"),
    QT_TRANSLATE_NOOP("Findings", "the print head would cut into material printed before, whatever "
                                  "way it leans"),
    QT_TRANSLATE_NOOP("Findings", "turn the part (orient=leastRisky), add supports, or use planar "
                                  "or curved mode"),
    QT_TRANSLATE_NOOP("Findings",
                      "turn the part (orient=leastRisky), or use planar or curved mode"),
    QT_TRANSLATE_NOOP("Findings", "add supports (supports=auto), cut there, or use curved mode"),
    QT_TRANSLATE_NOOP("Findings", "give other cuts (cutPlanes), turn the part, or use curved mode"),
    QT_TRANSLATE_NOOP("Findings", "lay the part on a larger face, or give other cuts (cutPlanes)"),
    QT_TRANSLATE_NOOP("Findings", "use a larger platform (fit:MARGIN), or turn the part"),
    QT_TRANSLATE_NOOP("Findings", "use a finer nozzle, or print the part larger"),
    QT_TRANSLATE_NOOP("Findings", "use a slimmer head, turn the part, or print it larger"),
    QT_TRANSLATE_NOOP("Findings", "move them, or leave them out"),
    QT_TRANSLATE_NOOP("Findings", "the part reaches %1 mm from the rod's axis, the cell prints up "
                                  "to %2 mm"),
    QT_TRANSLATE_NOOP("Findings", "print the part smaller (scale)"),
    QT_TRANSLATE_NOOP("Findings", "%1 of %2 mm3 of the part are in no layer"),
    QT_TRANSLATE_NOOP("Findings", "choose layers that reach all of it (layerShape, layerCentre, "
                                  "endSurface)"),
    QT_TRANSLATE_NOOP("Findings", "let the part rise from the rod at a gentler slope there"),
    QT_TRANSLATE_NOOP("Findings", "let the part rise from the surface at a gentler slope there"),
};

struct Sentence {
  const char* english;
  QRegularExpression pattern; // groups are what changes
};

std::vector<Sentence> patterns() {
  static const QRegularExpression number(QStringLiteral("%\\d"));
  std::vector<Sentence> all;
  for (const char* english : kSentences) {
    QStringList fixed;
    for (const QString& part : QString::fromUtf8(english).split(number))
      fixed << QRegularExpression::escape(part);
    all.push_back({english, QRegularExpression(QRegularExpression::anchoredPattern(
                                fixed.join(QStringLiteral("(.+?)"))))});
  }
  return all;
}

// "7.03" as "7,03" where the language writes it so.
QString localNumber(const QString& text) {
  static const QRegularExpression decimal(QStringLiteral("^-?\\d+\\.\\d+$"));
  return decimal.match(text).hasMatch() ? QString(text).replace('.', QLocale().decimalPoint())
                                        : text;
}

QString translated(const QString& english) {
  static const std::vector<Sentence> known = patterns();
  for (const Sentence& sentence : known) {
    const QRegularExpressionMatch match = sentence.pattern.match(english);
    if (!match.hasMatch())
      continue;
    QString text = QCoreApplication::translate("Findings", sentence.english);
    for (int i = match.lastCapturedIndex(); i > 0; --i)
      text.replace(QStringLiteral("%%1").arg(i), localNumber(match.captured(i)));
    return text;
  }
  return english;
}
} // namespace

QString findingText(const std::string& english) {
  static const QRegularExpression power(QStringLiteral("\\bmm([23])\\b"));
  QString text = translated(QString::fromStdString(english));
  for (auto match = power.match(text); match.hasMatch(); match = power.match(text))
    text.replace(match.capturedStart(1), 1,
                 match.captured(1) == QLatin1String("2") ? QStringLiteral("²")
                                                         : QStringLiteral("³"));
  return text;
}

} // namespace voluta::panels
