// Recovery copies of projects whose program has crashed.
#pragma once

#include <QDateTime>
#include <QString>
#include <vector>

namespace voluta::document {

// A project whose program ended without closing it.
struct Recovered {
  QString file;         // the copy, a project file
  QString name;         // as in the title
  QString originalPath; // the file to which the project was saved; may be empty
  QDateTime time;       // of the copy
};

// VOLUTA_STATE_DIR if set, else QStandardPaths::AppLocalDataLocation; "/recovery" below it. Not
// created here.
QString recoveryFolder();
// Returns copies whose program has ended, the latest first; ignores those of running programs.
// Deletes partial files of ended programs.
std::vector<Recovered> recoverable(const QString& folder = recoveryFolder());
// Removes a copy and its other files.
void discardRecovered(const Recovered& recovered);

// Returns the file beside a copy that identifies its owner.
QString ownerFileOf(const QString& copy);
// Returns its contents, for a copy of this process.
QByteArray ownerBytes(const QString& name, const QString& originalPath);

} // namespace voluta::document
