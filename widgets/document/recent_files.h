// What was opened lately.
#pragma once

#include <QObject>
#include <QStringList>

namespace voluta::document {

// At most ten, the latest first, kept in QSettings (key "recentFiles").
class RecentFiles : public QObject {
  Q_OBJECT

public:
  explicit RecentFiles(QObject* parent = nullptr);

  QStringList files() const;
  // Absolute paths are kept; samples and copies for recovery are not.
  void add(const QString& file);
  void clear();
  // True when the file is still there; else it is dropped from the list and dead() says so.
  bool check(const QString& file);

signals:
  void changed();
  void dead(const QString& file, const QString& message);
};

} // namespace voluta::document
