// Parts and projects opened, saved and recovered, with what the user is asked on the way.
#pragma once

#include "document/autosave.h"
#include "document/opening.h"
#include "document/recent_files.h"
#include "document/saving.h"
#include "window/commands.h"

#include <QObject>
#include <QString>
#include <functional>
#include <memory>
#include <vector>

class QMenu;
class QWidget;

namespace voluta::document {
class Document;
class Planning;
} // namespace voluta::document

namespace voluta::window {

class ProjectFiles : public QObject {
  Q_OBJECT

public:
  // All outlives this. Dialogs stand before the window.
  ProjectFiles(document::Document& document, document::Planning& planning, QWidget& window);
  ~ProjectFiles() override;

  document::Opening& opening() { return opening_; }
  std::vector<Command> commands();
  // Fills the menu of recent files, now and whenever they change.
  void setRecentMenu(QMenu* menu);

  // A part, a project or "sample:NAME".
  void open(const QString& path);
  void choose();
  // A robot arm from a URDF: asks what it needs, and takes the cell that comes of it.
  void importArm(const QString& urdf);
  // The rest of the print, from a point of the trajectory on, once the user has said so.
  void resume(std::size_t point);
  // Offers what a crash left, if anything is there.
  void offerRecovered();
  // Runs `then` once the user has saved or given up unsaved changes.
  void afterSaved(std::function<void()> then);
  // Nothing is left to recover.
  void end();

signals:
  void said(const QString& text);                          // for the status line
  void told(const QString& title, const QString& message); // for a box
  void opened(bool project);
  void cleared();

private:
  void listen();
  void noteOpened(const QString& path, bool project);
  void newProject();
  void chooseArm();
  void save();
  void saveAs();
  void showRecent();

  document::Document& document_;
  document::Planning& planning_;
  QWidget& window_;
  document::Opening opening_;
  document::Saving saving_;
  document::RecentFiles recent_;
  std::unique_ptr<document::Autosave> autosave_;
  std::function<void()> afterSave_;
  QMenu* recentMenu_ = nullptr;
};

} // namespace voluta::window
