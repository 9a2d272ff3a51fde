// Opens, saves and recovers parts and projects, including the dialogs.
#pragma once

#include "document/autosave.h"
#include "document/opening.h"
#include "document/recent_files.h"
#include "document/saving.h"
#include "window/samples.h"
#include "window/window_commands.h"

#include <QObject>
#include <QString>
#include <QStringList>
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
  // The arguments must outlive this object. `window` is the parent of the dialogs.
  ProjectFiles(document::Document& document, document::Planning& planning, QWidget& window);
  ~ProjectFiles() override;

  document::Opening& opening() { return opening_; }
  std::vector<Command> commands();
  std::vector<Command> sampleCommands();
  // Fills the menu of recent files, now and whenever they change.
  void setRecentMenu(QMenu* menu);

  // Opens a part, a project or "sample:NAME", and adds the parts `more`.
  void open(const QString& path, const QStringList& more = {});
  // Opens a sample and sets the choices that it requires.
  void openSample(const Sample& sample);
  void choose();
  // Adds a part to those that are open, or opens the first one: from a file the user chooses.
  void chooseToAdd();
  // Opens files dropped onto the window: the first one, and the parts after it are added. If a part
  // is open, the user may add the first one too.
  void drop(const QStringList& paths);
  // Imports a robot arm from a URDF: asks for the required data, and selects the new cell.
  void importArm(const QString& urdf);
  // Shows the machines of a station in a dialog; the project in the window stays.
  void openStation(const QString& file);
  // Opens the rest of the print from a point of the trajectory on, after confirmation.
  void resume(std::size_t point);
  // Offers unsaved work after a crash, if there is any.
  void offerRecovered();
  // Calls `then` once the user has saved or discarded unsaved changes.
  void afterSaved(std::function<void()> then);
  // Removes the recovery copy on a regular exit.
  void end();

signals:
  void said(const QString& text);                                   // For the status line
  void messageRaised(const QString& title, const QString& message); // For a message box
  void opened(bool project);
  void cleared();

private:
  void listen();
  void startOpening(const QString& path, const QStringList& more, const Sample* sample);
  void noteOpened(const QString& path, bool project);
  void newProject();
  void chooseArm();
  bool asOne(const QString& path, const QString& first, const QString& second);
  void save();
  void saveAs();
  void add(const QStringList& paths);
  void addNext();
  void showRecent();

  document::Document& document_;
  document::Planning& planning_;
  QWidget& window_;
  document::Opening opening_;
  document::Saving saving_;
  document::RecentFiles recent_;
  std::unique_ptr<document::Autosave> autosave_;
  std::function<void()> afterSave_;
  QStringList toAdd_;                     // once the part before them is read
  const Sample* pendingSample_ = nullptr; // being opened
  QMenu* recentMenu_ = nullptr;
};

} // namespace voluta::window
