#include "document/shown_names.h"

#include <QFileInfo>

namespace voluta::document {

QStringList shownNames(std::span<const std::shared_ptr<const project::LoadedPart>> parts) {
  QStringList names;
  for (const auto& part : parts) {
    const QString name = QFileInfo(QString::fromStdString(part->name)).completeBaseName();
    QString own = name;
    for (int number = 2; names.contains(own); ++number)
      own = QStringLiteral("%1 (%2)").arg(name).arg(number);
    names << own;
  }
  return names;
}

} // namespace voluta::document
