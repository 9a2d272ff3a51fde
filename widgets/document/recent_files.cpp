#include "document/recent_files.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>

namespace voluta::document {

namespace {
constexpr int kMost = 10;
const QString kKey = QStringLiteral("recentFiles");
} // namespace

RecentFiles::RecentFiles(QObject* parent) : QObject(parent) {}

QStringList RecentFiles::files() const {
  return QSettings().value(kKey).toStringList();
}

void RecentFiles::add(const QString& file) {
  if (file.startsWith(QStringLiteral("sample:")))
    return;
  const QString absolute = QDir::cleanPath(QFileInfo(file).absoluteFilePath());
  QStringList list = files();
  list.removeAll(absolute);
  list.prepend(absolute);
  QSettings().setValue(kKey, QVariant(list.mid(0, kMost)));
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
  emit dead(file, tr("%1 is not there any more. It was taken off the list.")
                      .arg(QDir::toNativeSeparators(file)));
  return false;
}

} // namespace voluta::document
