#include "window/project_files.h"

#include "base/data_files.h"
#include "document/document.h"
#include "document/planning.h"
#include "document/recovery.h"
#include "forms/discard.h"
#include "forms/file_patterns.h"
#include "forms/save_file.h"
#include "plan/trajectory.h"
#include "project/station.h"
#include "window/cell/arm_import_dialog.h"
#include "window/together/together_dialog.h"

#include <QEventLoop>
#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <utility>

namespace voluta::window {

using document::Opening;

namespace {
constexpr const char* kOpenFolder = "open/folder";
constexpr const char* kSaveFolder = "save/folder";

QString nameOf(const QString& path) {
  return QFileInfo(path).fileName();
}

bool isPart(const QString& path) {
  return !path.endsWith(".voluta", Qt::CaseInsensitive) &&
         !path.endsWith(".urdf", Qt::CaseInsensitive);
}
} // namespace

ProjectFiles::ProjectFiles(document::Document& document, document::Planning& planning,
                           QWidget& window)
    : document_(document), planning_(planning), window_(window), opening_(document, planning),
      saving_(document), autosave_(std::make_unique<document::Autosave>(document)) {
  listen();
}

ProjectFiles::~ProjectFiles() = default;

void ProjectFiles::listen() {
  connect(&opening_, &Opening::started, this,
          [this](const QString& path) { emit said(tr("Opening %1").arg(nameOf(path))); });
  connect(&opening_, &Opening::opened, this, &ProjectFiles::noteOpened);
  opening_.setAsOneQuestion([this](const QString& path, const QString& first,
                                   const QString& second) { return asOne(path, first, second); });
  connect(&opening_, &Opening::repaired, this, [this] {
    emit said(tr("Ready. Press Plan."));
    planning_.plan(project::Stage::Load);
    addNext();
  });
  connect(&opening_, &Opening::cancelled, this, [this] {
    toAdd_.clear();
    pendingSample_ = nullptr;
    emit said(tr("Cancelled."));
  });
  connect(&opening_, &Opening::failed, this, [this](const QString& path, const QString& message) {
    toAdd_.clear();
    pendingSample_ = nullptr;
    emit said(message);
    emit messageRaised(tr("%1 cannot be opened").arg(nameOf(path)), message);
  });
  connect(&saving_, &document::Saving::saved, this, [this](const QString& file) {
    recent_.add(file);
    emit said(tr("Saved %1").arg(nameOf(file)));
    if (auto then = std::exchange(afterSave_, nullptr))
      then();
  });
  connect(&saving_, &document::Saving::failed, this,
          [this](const QString& file, const QString& message) {
            afterSave_ = nullptr;
            emit messageRaised(tr("%1 is not saved").arg(nameOf(file)), message);
          });
  connect(autosave_.get(), &document::Autosave::failed, this, &ProjectFiles::said);
  connect(&recent_, &document::RecentFiles::changed, this, &ProjectFiles::showRecent);
  connect(&recent_, &document::RecentFiles::dead, this,
          [this](const QString&, const QString& message) {
            emit messageRaised(tr("Open recent"), message);
          });
}

std::vector<Command> ProjectFiles::sampleCommands() {
  std::vector<Command> commands;
  for (const Sample& sample : samples())
    commands.push_back({sample.id, "samplesMenu", 0, sample.text, sample.tip, {}, [this, &sample] {
                          openSample(sample);
                        }});
  return commands;
}

std::vector<Command> ProjectFiles::commands() {
  return {
      {"new",
       "fileMenu",
       0,
       QT_TRANSLATE_NOOP("Commands", "&New project"),
       QT_TRANSLATE_NOOP("Commands", "Start without a part"),
       {QKeySequence::New},
       [this] { newProject(); }},
      {"open",
       "fileMenu",
       0,
       QT_TRANSLATE_NOOP("Commands", "&Open…"),
       QT_TRANSLATE_NOOP("Commands", "Open a mesh or a project"),
       {QKeySequence::Open},
       [this] { choose(); },
       {},
       {},
       "open",
       BarGroup::File},
      {"addPart",
       "fileMenu",
       0,
       QT_TRANSLATE_NOOP("Commands", "A&dd part…"),
       QT_TRANSLATE_NOOP("Commands", "Adds a part beside the others"),
       {QKeySequence("Ctrl+I")},
       [this] { chooseToAdd(); },
       [this] { return document_.partCount() > 0; },
       {},
       "add-part",
       BarGroup::Parts},
      {"importArm",
       "fileMenu",
       0,
       QT_TRANSLATE_NOOP("Commands", "Import robot &arm…"),
       QT_TRANSLATE_NOOP("Commands", "Your own robot from its URDF, with a cell"),
       {},
       [this] { chooseArm(); }},
      {"save",
       "fileMenu",
       1,
       QT_TRANSLATE_NOOP("Commands", "&Save"),
       QT_TRANSLATE_NOOP("Commands", "Save the project"),
       {QKeySequence::Save},
       [this] { save(); },
       {},
       {},
       "save",
       BarGroup::File},
      {"saveAs",
       "fileMenu",
       1,
       QT_TRANSLATE_NOOP("Commands", "Save &as…"),
       QT_TRANSLATE_NOOP("Commands", "Save the project under a new name"),
       {QKeySequence("Ctrl+Shift+S")},
       [this] { saveAs(); }},
  };
}

void ProjectFiles::setRecentMenu(QMenu* menu) {
  recentMenu_ = menu;
  showRecent();
}

void ProjectFiles::showRecent() {
  if (!recentMenu_)
    return;
  for (QAction* action : recentMenu_->actions())
    forms::discard(action);
  for (const QString& file : recent_.files()) {
    QAction* action = recentMenu_->addAction(nameOf(file).replace('&', "&&"));
    action->setToolTip(file);
    connect(action, &QAction::triggered, this, [this, file] {
      if (recent_.check(file))
        open(file);
    });
  }
  recentMenu_->setEnabled(!recentMenu_->isEmpty());
}

void ProjectFiles::open(const QString& path, const QStringList& more) {
  if (path.endsWith(".urdf", Qt::CaseInsensitive)) {
    importArm(path);
    return;
  }
  if (project::isStationFile(path.toStdString())) {
    openStation(path);
    return;
  }
  startOpening(path, more, nullptr);
}

void ProjectFiles::startOpening(const QString& path, const QStringList& more,
                                const Sample* sample) {
  const auto start = [this, path, more, sample] {
    planning_.cancel();
    toAdd_ = more;
    pendingSample_ = sample;
    opening_.open(path);
  };
  // Undo can restore a replaced part, but opening another project clears the undo stack.
  if (path.endsWith(".voluta", Qt::CaseInsensitive) || document_.hasUnsavedWork())
    afterSaved(start);
  else
    start();
}

void ProjectFiles::openSample(const Sample& sample) {
  startOpening(sample.path(), {}, &sample);
}

void ProjectFiles::choose() {
  const QString file = QFileDialog::getOpenFileName(
      &window_, tr("Open"), QSettings().value(kOpenFolder).toString(),
      tr("Parts and projects (%1);;All files (*)")
          .arg(forms::filePatterns(project::NamedFiles::Parts) + QStringLiteral(" *.voluta")));
  if (file.isEmpty())
    return;
  QSettings().setValue(kOpenFolder, QFileInfo(file).absolutePath());
  open(file);
}

void ProjectFiles::chooseToAdd() {
  const QString file = QFileDialog::getOpenFileName(
      &window_, tr("Add part"), QSettings().value(kOpenFolder).toString(),
      tr("Parts (%1);;All files (*)").arg(forms::filePatterns(project::NamedFiles::Parts)));
  if (file.isEmpty())
    return;
  QSettings().setValue(kOpenFolder, QFileInfo(file).absolutePath());
  add({file});
}

void ProjectFiles::add(const QStringList& paths) {
  toAdd_ = paths;
  addNext();
}

void ProjectFiles::addNext() {
  if (toAdd_.isEmpty())
    return;
  planning_.cancel();
  opening_.addPart(toAdd_.takeFirst());
}

void ProjectFiles::drop(const QStringList& paths) {
  const QString& path = paths.first();
  if (!isPart(path)) {
    open(path);
    return;
  }
  QStringList more = paths.mid(1);
  erase_if(more, [](const QString& file) { return !isPart(file); });
  if (document_.partCount() == 0) {
    open(path, more);
    return;
  }
  QMessageBox box(
      QMessageBox::Question, tr("Add or replace?"),
      tr("Add “%1” beside “%2”, or open it instead?").arg(nameOf(path), document_.name()),
      QMessageBox::NoButton, &window_);
  box.setObjectName("dropBox");
  const QPushButton* added = box.addButton(tr("Add"), QMessageBox::AcceptRole);
  const QPushButton* replaced = box.addButton(tr("Replace"), QMessageBox::DestructiveRole);
  box.addButton(QMessageBox::Cancel);
  box.exec();
  if (box.clickedButton() == added)
    add(QStringList(path) + more);
  else if (box.clickedButton() == replaced)
    open(path, more);
}

bool ProjectFiles::asOne(const QString& path, const QString& first, const QString& second) {
  QMessageBox box(QMessageBox::Question, tr("One part?"),
                  tr("“%1” and “%2” in “%3” touch. Open the file as one part?")
                      .arg(first, second, nameOf(path)),
                  QMessageBox::NoButton, &window_);
  box.setObjectName("asOneBox");
  const QPushButton* one = box.addButton(tr("One part"), QMessageBox::AcceptRole);
  box.addButton(tr("Several parts"), QMessageBox::RejectRole);
  box.exec();
  return box.clickedButton() == one;
}

void ProjectFiles::chooseArm() {
  const QString file = QFileDialog::getOpenFileName(
      &window_, tr("Import a robot arm"), QSettings().value(kOpenFolder).toString(),
      tr("Robot descriptions (*.urdf *.xml);;All files (*)"));
  if (file.isEmpty())
    return;
  QSettings().setValue(kOpenFolder, QFileInfo(file).absolutePath());
  importArm(file);
}

void ProjectFiles::openStation(const QString& file) {
  auto* dialog = new TogetherDialog({}, &window_);
  dialog->open();
  dialog->addFile(file);
}

void ProjectFiles::importArm(const QString& urdf) {
  const std::filesystem::path folder = base::userDataFolder();
  if (folder.empty()) {
    emit messageRaised(tr("Import a robot arm"), tr("No folder for your own robots: set HOME."));
    return;
  }
  ArmImportDialog dialog(urdf, QString::fromStdString(folder.string()), &window_);
  if (dialog.exec() != QDialog::Accepted)
    return;
  project::Choices choices = document_.choices();
  choices.cell = dialog.cell().toStdString();
  if (choices.cell == document_.choices().cell)
    document_.filesChanged(); // Imported again under the same name
  else
    document_.setChoices(choices, tr("cell"));
  emit said(tr("Imported: cell %1").arg(dialog.cell()));
}

void ProjectFiles::resume(std::size_t point) {
  const auto motion = document_.result(project::Stage::Motion);
  if (!motion || !document_.upToDate(project::Stage::Motion))
    return;
  const plan::Trajectory& t = *motion->job.trajectory;
  const double whole = t.extrudedMm3.back();
  const double printed = whole > 0.0 ? 100.0 * t.extrudedMm3[point] / whole : 0.0;
  QMessageBox box(QMessageBox::Question, tr("Resume from here?"),
                  tr("%1 % of the material counts as printed. The rest of “%2” opens as a "
                     "new project.")
                      .arg(QLocale().toString(printed, 'f', 1), document_.name()),
                  QMessageBox::NoButton, &window_);
  box.setObjectName("resumeBox");
  const QPushButton* resume = box.addButton(tr("Resume"), QMessageBox::AcceptRole);
  box.addButton(QMessageBox::Cancel);
  box.exec();
  if (box.clickedButton() != resume)
    return;
  afterSaved([this, point] {
    planning_.cancel();
    if (document_.upToDate(project::Stage::Motion))
      opening_.resume(point);
  });
}

void ProjectFiles::noteOpened(const QString& path, bool project) {
  if (!path.startsWith("sample:"))
    recent_.add(path);
  if (project)
    emit said(tr("Opened %1").arg(document_.name()));
  if (const Sample* sample = std::exchange(pendingSample_, nullptr))
    document_.setChoices(sample->required(document_.choices()), tr("settings of the sample"));
  emit opened(project);
}

void ProjectFiles::newProject() {
  afterSaved([this] {
    planning_.startAfresh();
    opening_.cancel();
    document_.clear();
    emit said({}); // Clear the message of the last run
    emit cleared();
  });
}

void ProjectFiles::save() {
  if (document_.projectFile().isEmpty())
    saveAs();
  else
    saving_.save();
}

void ProjectFiles::saveAs() {
  QSettings settings;
  const QString folder = settings.value(kSaveFolder).toString();
  const QString file =
      forms::saveFile(&window_, tr("Save the project"),
                      (folder.isEmpty() ? QString() : folder + '/') + document_.name() + ".voluta",
                      tr("Voluta projects (*.voluta)"));
  if (file.isEmpty()) {
    afterSave_ = nullptr;
    return;
  }
  settings.setValue(kSaveFolder, QFileInfo(file).absolutePath());
  saving_.saveAs(file);
}

void ProjectFiles::offerRecovered() {
  const std::vector<document::Recovered> left = document::recoverable();
  if (left.empty())
    return;
  const document::Recovered& latest = left.front();
  QMessageBox box(QMessageBox::Question, tr("Recover unsaved work"),
                  tr("Voluta ended unexpectedly. A copy of “%1” was saved on %2.")
                      .arg(latest.name, QLocale().toString(latest.time, QLocale::ShortFormat)),
                  QMessageBox::NoButton, &window_);
  box.setObjectName("recoverBox");
  QPushButton* recover = box.addButton(tr("Recover"), QMessageBox::AcceptRole);
  QPushButton* discard = box.addButton(tr("Discard"), QMessageBox::DestructiveRole);
  box.addButton(tr("Later"), QMessageBox::RejectRole);
  box.exec();
  if (box.clickedButton() == recover) {
    // Keep the copy until the document has adopted it.
    const auto adopts = connect(&opening_, &Opening::opened, autosave_.get(),
                                [this, latest] { autosave_->adopt(latest); });
    // Another file, such as that of the command line, waits: it would replace the request, and its
    // part the copy.
    QEventLoop reading;
    connect(&opening_, &Opening::opened, &reading, &QEventLoop::quit);
    connect(&opening_, &Opening::failed, &reading, &QEventLoop::quit);
    connect(&opening_, &Opening::cancelled, &reading, &QEventLoop::quit);
    opening_.openRecovered(latest);
    reading.exec();
    disconnect(adopts);
  } else if (box.clickedButton() == discard) {
    document::discardRecovered(latest);
  }
}

void ProjectFiles::afterSaved(std::function<void()> then) {
  if (!document_.dirty()) {
    then();
    return;
  }
  QMessageBox box(QMessageBox::Warning, tr("Unsaved changes"),
                  tr("“%1” has unsaved changes.").arg(document_.name()),
                  QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &window_);
  box.setObjectName("unsavedBox");
  box.setDefaultButton(QMessageBox::Save);
  const int answer = box.exec();
  if (answer == QMessageBox::Discard) {
    then();
  } else if (answer == QMessageBox::Save) {
    afterSave_ = std::move(then);
    save();
  }
}

void ProjectFiles::end() {
  opening_.cancel();
  autosave_.reset();
}

} // namespace voluta::window
