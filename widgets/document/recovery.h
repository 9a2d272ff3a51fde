// Copies of projects that outlived their program.
#pragma once

#include <QDateTime>
#include <QString>
#include <vector>

namespace voluta::document {

// A project whose program ended without closing it.
struct Recovered {
  QString file;         // the copy, a project file
  QString name;         // as in the title
  QString originalPath; // where the project was saved to; may be empty
  QDateTime time;       // of the copy
};

// VOLUTA_STATE_DIR if set, else QStandardPaths::AppLocalDataLocation; "/recovery" below it. Not
// made here.
QString recoveryFolder();
// Copies whose program is gone, the latest first; those of running programs are left alone. What
// such programs left half written is swept away.
std::vector<Recovered> recoverable(const QString& folder = recoveryFolder());
// Removes a copy and what belongs to it.
void discardRecovered(const Recovered& recovered);

// The file beside a copy that says whose it is.
QString ownerFileOf(const QString& copy);
// Its bytes, for a copy of this process.
QByteArray ownerBytes(const QString& name, const QString& originalPath);

} // namespace voluta::document
