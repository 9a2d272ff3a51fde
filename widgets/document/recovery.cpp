#include "document/recovery.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSet>
#include <QStandardPaths>
#include <algorithm>
#include <optional>

namespace voluta::document {

namespace {
const QString kCopyEnding = QStringLiteral(".voluta");
const QString kOwnerEnding = QStringLiteral(".json");

// Start time of a process, in the kernel's ticks: process ids are reused, but not with the same
// start time. Empty if there is no such process.
QString beginningOf(qint64 process) {
  QFile stat(QStringLiteral("/proc/%1/stat").arg(process));
  if (!stat.open(QIODevice::ReadOnly))
    return {};
  // The second field is a name in brackets with arbitrary contents; the start time is the 22nd.
  const QByteArray text = stat.readAll();
  const QList<QByteArray> fields = text.mid(text.lastIndexOf(')') + 2).split(' ');
  return fields.size() > 19 ? QString::fromLatin1(fields[19]) : QString();
}

QJsonObject ownerOf(const QString& copy) {
  QFile file(ownerFileOf(copy));
  return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).object()
                                        : QJsonObject();
}

bool ownerRuns(const QJsonObject& owner) {
  const QString began = owner.value(QStringLiteral("began")).toString();
  return !began.isEmpty() && beginningOf(owner.value(QStringLiteral("pid")).toInteger(-1)) == began;
}

// Removes the copy, its owner's file and partial writes of both.
void removeAll(const QString& copy) {
  QFile::remove(copy);
  QFile::remove(ownerFileOf(copy));
  const QFileInfo info(copy);
  QDir folder = info.dir();
  for (const QString& rest : folder.entryList(
           {QStringLiteral(".%1.*").arg(info.completeBaseName())}, QDir::Files | QDir::Hidden))
    folder.remove(rest);
}

// Ids of all copies of which the folder has any file, even if they were never written completely.
QSet<QString> idsIn(const QDir& folder) {
  QSet<QString> ids;
  for (const QString& name : folder.entryList(QDir::Files | QDir::Hidden))
    ids.insert(name.mid(name.startsWith('.') ? 1 : 0).section('.', 0, 0));
  return ids;
}
} // namespace

QString recoveryFolder() {
  const QString chosen = qEnvironmentVariable("VOLUTA_STATE_DIR");
  const QString base = chosen.isEmpty()
                           ? QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation)
                           : chosen;
  return base + QStringLiteral("/recovery");
}

QString ownerFileOf(const QString& copy) {
  const QFileInfo info(copy);
  return info.dir().filePath(info.completeBaseName() + kOwnerEnding);
}

QByteArray ownerBytes(const QString& name, const QString& originalPath) {
  const qint64 process = QCoreApplication::applicationPid();
  const QJsonObject owner{
      {QStringLiteral("name"), name},
      {QStringLiteral("originalPath"), originalPath},
      {QStringLiteral("time"), QDateTime::currentDateTimeUtc().toString(Qt::ISODateWithMs)},
      {QStringLiteral("pid"), process},
      {QStringLiteral("began"), beginningOf(process)}};
  return QJsonDocument(owner).toJson();
}

std::vector<Recovered> recoverable(const QString& folder) {
  std::vector<Recovered> found;
  const QDir dir(folder);
  for (const QString& id : idsIn(dir)) {
    const QString copy = dir.filePath(id + kCopyEnding);
    const QJsonObject owner = ownerOf(copy);
    if (ownerRuns(owner))
      continue;
    if (!QFile::exists(copy)) {
      removeAll(copy);
      continue;
    }
    const QDateTime stated =
        QDateTime::fromString(owner.value(QStringLiteral("time")).toString(), Qt::ISODateWithMs);
    found.push_back({copy, owner.value(QStringLiteral("name")).toString(id),
                     owner.value(QStringLiteral("originalPath")).toString(),
                     stated.isValid() ? stated : QFileInfo(copy).lastModified()});
  }
  std::sort(found.begin(), found.end(),
            [](const Recovered& a, const Recovered& b) { return a.time > b.time; });
  return found;
}

void discardRecovered(const Recovered& recovered) {
  removeAll(recovered.file);
}

} // namespace voluta::document
