#include "document/recent_files.h"

#include "document/recovery.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>

namespace voluta::document {

namespace {
constexpr int kMax = 10;
const QString kKey = QStringLiteral("recentFiles");
} // namespace

RecentFiles::RecentFiles(QObject* parent) : QObject(parent) {}

// Recovery copies are removed with the program that made them, and their names are meaningless.
QStringList RecentFiles::files() const {
  QStringList list = QSettings().value(kKey).toStringList();
  const QString copies = QDir::cleanPath(recoveryFolder());
  list.removeIf([&](const QString& file) { return QFileInfo(file).absolutePath() == copies; });
  return list;
}

void RecentFiles::add(const QString& file) {
  if (file.isEmpty() || file.startsWith(QStringLiteral("sample:")))
    return;
  const QString absolute = QDir::cleanPath(QFileInfo(file).absoluteFilePath());
  QStringList list = files();
  list.removeAll(absolute);
  list.prepend(absolute);
  QSettings().setValue(kKey, QVariant(list.mid(0, kMax)));
  emit changed();
}

void RecentFiles::clear() {
  QSettings().remove(kKey);
  emit changed();
}

bool RecentFiles::check(const QString& file) {
  if (QFileInfo::exists(file))
    return true;
  QStringList list = files();
  list.removeAll(file);
  QSettings().setValue(kKey, QVariant(list));
  emit changed();
  emit dead(
      file,
      tr("%1 no longer exists. It was removed from the list.").arg(QDir::toNativeSeparators(file)));
  return false;
}

} // namespace voluta::document
