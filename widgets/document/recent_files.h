// The list of recently opened files.
#pragma once

#include <QObject>
#include <QStringList>

namespace voluta::document {

// At most ten, the latest first, stored in QSettings (key "recentFiles").
class RecentFiles : public QObject {
  Q_OBJECT

public:
  explicit RecentFiles(QObject* parent = nullptr);

  QStringList files() const;
  // Stores absolute paths; ignores samples and recovery copies.
  void add(const QString& file);
  void clear();
  // Returns true if the file still exists; otherwise removes it from the list and emits dead().
  bool check(const QString& file);

signals:
  void changed();
  void dead(const QString& file, const QString& message);
};

} // namespace voluta::document
