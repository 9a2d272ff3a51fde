#include "window/library/library_dialog.h"

#include "base/data_files.h"
#include "base/error.h"
#include "base/files.h"
#include "forms/colours.h"
#include "forms/file_patterns.h"
#include "forms/icons.h"
#include "forms/save_file.h"
#include "geometry/formats/mesh_reader.h"
#include "language/words.h"
#include "panels/head_drawing.h"
#include "panels/head_table.h"
#include "panels/item_form.h"
#include "process/head_shapes.h"
#include "window/library/compare_items_dialog.h"
#include "window/library/head_numbers_dialog.h"
#include "window/library/sizes_dialog.h"
#include "window/window_icons.h"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QSignalBlocker>
#include <QTabBar>
#include <QVBoxLayout>

namespace voluta::window {

using process::LibraryItem;
using process::Shelf;

namespace {
constexpr int kListWidth = 236, kHeadWidth = 330, kWidth = 1120, kHeight = 650;
constexpr int kIndent = 5; // Letters, of an item below the one that it inherits from

QString named(const std::string& text) {
  return QString::fromStdString(text);
}

std::string materialOf(const std::string& jobProcess) {
  try {
    return process::loadProcess(jobProcess).material.id;
  } catch (const base::Error&) {
    return {};
  }
}

QString sentence(const base::Message& message) {
  QString text = language::words(message);
  text.front() = text.front().toUpper();
  return text + QLatin1Char('.');
}

// Returns a file chosen in the folder that was used last; empty: cancelled.
QString chosenFile(QWidget* parent, const QString& title, const QString& filter) {
  const QString key = QStringLiteral("open/folder");
  const QString file =
      QFileDialog::getOpenFileName(parent, title, QSettings().value(key).toString(), filter);
  if (!file.isEmpty())
    QSettings().setValue(key, QFileInfo(file).absolutePath());
  return file;
}
} // namespace

LibraryDialog::LibraryDialog(const std::string& jobProcess, Shelf shelf, QWidget* parent)
    : QDialog(parent), jobProcess_(jobProcess),
      shelf_(shelf), shelves_{LibraryShelf(Shelf::Processes, jobProcess),
                              LibraryShelf(Shelf::Materials, {})},
      tabs_(new QTabBar(this)), list_(new QListWidget(this)), form_(new panels::ItemForm(this)),
      drawing_(new panels::HeadDrawing(this)), head_(new panels::HeadTable(this)),
      title_(new QLabel(this)), about_(new QLabel(this)), stateIcon_(new QLabel(this)),
      state_(new QLabel(this)) {
  setObjectName("library");
  setWindowTitle(tr("Processes and materials"));
  build();
  tabs_->setCurrentIndex(static_cast<int>(shelf));
  connect(tabs_, &QTabBar::currentChanged, this,
          [this](int tab) { showShelf(static_cast<Shelf>(tab)); });
  connect(list_, &QListWidget::currentRowChanged, this, &LibraryDialog::showEntry);
  connect(form_, &panels::ItemForm::edited, this, &LibraryDialog::edit);
  connect(head_, &panels::HeadTable::headChanged, this, &LibraryDialog::setHead);
  showShelf(shelf);
  resize(kWidth, kHeight);
}

LibraryDialog::~LibraryDialog() = default;

QPushButton* LibraryDialog::button(const char* name, const QString& text,
                                   void (LibraryDialog::*does)()) {
  auto* made = new QPushButton(text, this);
  made->setObjectName(name);
  made->setAutoDefault(false); // Enter commits a number
  connect(made, &QPushButton::clicked, this, does);
  return made;
}

void LibraryDialog::build() {
  auto* row = new QHBoxLayout;
  row->setSpacing(12);
  row->addWidget(buildList());
  row->addWidget(buildItem(), 1);
  row->addWidget(buildHead());
  save_ = button("librarySave", tr("Save"), &LibraryDialog::save);
  revert_ = button("libraryRevert", tr("Discard changes"), &LibraryDialog::revert);
  use_ = button("libraryUse", tr("Use in this job"), &LibraryDialog::use);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  buttons->button(QDialogButtonBox::Close)->setAutoDefault(false);
  connect(buttons, &QDialogButtonBox::rejected, this, &LibraryDialog::reject);
  auto* below = new QHBoxLayout;
  below->addWidget(button("libraryCompare", tr("Compare…"), &LibraryDialog::compare));
  below->addStretch(1);
  below->addWidget(revert_);
  below->addWidget(save_);
  below->addWidget(use_);
  below->addSpacing(12);
  below->addWidget(buttons);
  auto* column = new QVBoxLayout(this);
  column->addLayout(row, 1);
  column->addLayout(below);
}

QWidget* LibraryDialog::buildList() {
  auto* side = new QWidget(this);
  side->setFixedWidth(kListWidth);
  tabs_->setObjectName("libraryTabs");
  tabs_->setExpanding(true);
  tabs_->setDocumentMode(true);
  tabs_->addTab(tr("Processes"));
  tabs_->addTab(tr("Materials"));
  list_->setObjectName("libraryList");
  list_->setAccessibleName(tr("Processes and materials"));
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setTextElideMode(Qt::ElideRight);
  list_->setSpacing(1);
  duplicate_ = button("libraryDuplicate", tr("Duplicate"), &LibraryDialog::duplicate);
  rename_ = button("libraryRename", tr("Rename…"), &LibraryDialog::rename);
  remove_ = button("libraryDelete", tr("Delete…"), &LibraryDialog::removeEntry);
  export_ = button("libraryExport", tr("Export…"), &LibraryDialog::exportFile);
  auto* grid = new QGridLayout;
  grid->addWidget(duplicate_, 0, 0, 1, 2);
  grid->addWidget(rename_, 1, 0);
  grid->addWidget(remove_, 1, 1);
  grid->addWidget(button("libraryImport", tr("Import…"), &LibraryDialog::importFile), 2, 0);
  grid->addWidget(export_, 2, 1);
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(tabs_);
  column->addWidget(list_, 1);
  column->addLayout(grid);
  return side;
}

QWidget* LibraryDialog::buildItem() {
  auto* side = new QWidget(this);
  QFont bold = font();
  bold.setBold(true);
  title_->setFont(bold);
  title_->setObjectName("libraryTitle");
  about_->setObjectName("libraryAbout");
  about_->setWordWrap(true);
  form_->setObjectName("libraryForm");
  stateIcon_->setFixedWidth(fontMetrics().height());
  state_->setObjectName("libraryState");
  state_->setWordWrap(true);
  state_->setMinimumHeight(2 * fontMetrics().height());
  state_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  auto* line = new QHBoxLayout;
  line->addWidget(stateIcon_, 0, Qt::AlignTop);
  line->addWidget(state_, 1);
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(title_);
  column->addWidget(about_);
  column->addWidget(form_, 1);
  column->addLayout(line);
  return side;
}

QWidget* LibraryDialog::buildHead() {
  headSide_ = new QWidget(this);
  headSide_->setFixedWidth(kHeadWidth);
  drawing_->setObjectName("libraryDrawing");
  head_->setObjectName("libraryHead");
  numbers_ = button("headNumbersOpen", tr("From a few numbers…"), &LibraryDialog::headFromNumbers);
  mesh_ = button("headMeshOpen", tr("From a mesh…"), &LibraryDialog::headFromMesh);
  mesh_->setToolTip(
      tr("A drawing of the head with its nozzle pointing down: the largest radius at each height"));
  sizes_ = button("sizesOpen", tr("Sizes from a measured plate…"), &LibraryDialog::sizesFromPlate);
  sizes_->setToolTip(tr("Corrects the sizes of flat layers by those of a printed accuracy plate"));
  auto* both = new QHBoxLayout;
  both->addWidget(numbers_);
  both->addWidget(mesh_);
  auto* column = new QVBoxLayout(headSide_);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(drawing_, 3);
  column->addWidget(head_, 2);
  column->addLayout(both);
  column->addWidget(sizes_);
  return headSide_;
}

int LibraryDialog::current() const {
  return list_->currentRow();
}

void LibraryDialog::select(const std::string& id) {
  if (const int at = shelf().indexOf(id); at >= 0)
    list_->setCurrentRow(at);
}

void LibraryDialog::showShelf(Shelf shelf) {
  shelf_ = shelf;
  headSide_->setVisible(shelf == Shelf::Processes);
  fillList(shelf == Shelf::Processes ? base::dataName(jobProcess_) : materialOf(jobProcess_));
}

void LibraryDialog::fillList(const std::string& chosen) {
  {
    const QSignalBlocker quiet(list_);
    list_->clear();
    for (const ShelfEntry& entry : shelf().entries())
      showRow(*new QListWidgetItem(list_), entry);
    list_->setCurrentRow(std::max(0, shelf().indexOf(chosen)));
  }
  showEntry();
}

void LibraryDialog::showRow(QListWidgetItem& row, const ShelfEntry& entry) const {
  const QString id = named(entry.saved.id());
  QString first = entry.origin == ItemOrigin::Job ? tr("%1 (in this job)").arg(id) : id;
  if (entry.isChanged())
    first.prepend(QStringLiteral("• "));
  const QString indent(kIndent * entry.depth, QLatin1Char(' '));
  row.setText(indent + first + QLatin1Char('\n') + indent + named(entry.draft.label()));
  row.setData(Qt::UserRole, id);
  const bool locked = entry.origin != ItemOrigin::Own;
  row.setIcon(!entry.unreadable.isEmpty() ? forms::icon(forms::Icon::Blocked)
              : locked                    ? icon("lock", palette())
                                          : icon("edit", palette()));
  row.setToolTip(!entry.unreadable.isEmpty()           ? entry.unreadable
                 : entry.origin == ItemOrigin::Program ? tr("Comes with the program")
                 : entry.origin == ItemOrigin::Job     ? tr("Stored in this job")
                                                       : tr("Your own"));
  const std::string used =
      shelf_ == Shelf::Processes ? base::dataName(jobProcess_) : materialOf(jobProcess_);
  QFont font = list_->font();
  font.setBold(used == entry.saved.id());
  row.setFont(font);
}

void LibraryDialog::showEntry() {
  if (current() < 0)
    return;
  const ShelfEntry& entry = shelf().at(current());
  const bool locked = entry.origin != ItemOrigin::Own || !entry.unreadable.isEmpty();
  const LibraryItem reference = shelf().referenceOf(current());
  form_->setItem(entry.draft, reference, locked);
  if (const process::Process* process = entry.draft.process()) {
    head_->setReadOnly(locked);
    head_->setReference(reference.process()->head);
    head_->setHead(process->head);
    drawing_->setProcess(*process);
    numbers_->setEnabled(!locked);
    mesh_->setEnabled(!locked);
    sizes_->setEnabled(!locked);
  }
  title_->setText(named(entry.saved.id()));
  about_->setText(
      entry.origin == ItemOrigin::Program ? tr("Comes with the program. Duplicate it to change it.")
      : entry.origin == ItemOrigin::Job
          ? tr("Stored in this job, not in your library. Duplicate it to keep it.")
      : entry.saved.basedOn.empty() ? tr("Your own.")
      : entry.saved.inherits ? tr("Your own. It follows %1 in all fields that are not marked.")
                                   .arg(named(entry.saved.basedOn))
                             : tr("Your own, based on %1; fields that differ are marked.")
                                   .arg(named(entry.saved.basedOn)));
  showState();
}

// Whether the job uses an own process with this id and other values.
bool LibraryDialog::jobHasAnother(const ShelfEntry& entry) const {
  return entry.origin == ItemOrigin::Own && entry.saved.process() &&
         base::isDataText(jobProcess_) && base::dataName(jobProcess_) == entry.saved.id() &&
         process::jobChoice(entry.saved) != jobProcess_;
}

// Also keeps the row of the list and the buttons up to date.
void LibraryDialog::showState() {
  const ShelfEntry& entry = shelf().at(current());
  const bool own = entry.origin == ItemOrigin::Own, readable = entry.unreadable.isEmpty();
  const std::optional<process::FieldProblem> problem =
      own && readable ? process::problemOf(entry.draft) : std::nullopt;
  form_->setProblem(problem);
  head_->setProblem(problem && problem->key == "head" ? language::words(problem->reason)
                                                      : QString());
  const process::Process* process = readable ? entry.draft.process() : nullptr;
  const std::optional<base::Message> isUpsideDown =
      process && !problem ? process::upsideDown(process->head) : std::nullopt;
  stateIcon_->clear();
  if (!readable || problem)
    stateIcon_->setPixmap(forms::iconBeside(*this, forms::Icon::Blocked));
  else if (isUpsideDown)
    stateIcon_->setPixmap(forms::iconBeside(*this, forms::Icon::Warning));
  QString text;
  if (!readable)
    text = entry.unreadable;
  else if (problem)
    text = problem->key.empty()
               ? language::words(problem->reason)
               : tr("Cannot be saved: %1 %2")
                     .arg(problem->key == "head" ? tr("Head") : form_->labelOf(problem->key),
                          language::words(problem->reason));
  else if (isUpsideDown)
    text = sentence(*isUpsideDown);
  else if (entry.isChanged())
    text = tr("Not saved yet.");
  else if (jobHasAnother(entry))
    text = tr("The job uses another version of this process.");
  state_->setText(text);
  save_->setEnabled(own && readable && entry.isChanged() && !problem);
  revert_->setEnabled(own && entry.isChanged());
  use_->setEnabled(readable && !problem);
  use_->setText(own && entry.isChanged() ? tr("Save and use in this job") : tr("Use in this job"));
  duplicate_->setEnabled(readable && !problem);
  export_->setEnabled(readable && !problem);
  rename_->setEnabled(own && readable);
  remove_->setEnabled(own);
  showRow(*list_->item(current()), entry);
}

void LibraryDialog::edit(const LibraryItem& draft) {
  LibraryItem with = draft;
  // The form does not show the head.
  if (auto* process = std::get_if<process::Process>(&with.data))
    process->head = shelf().at(current()).draft.process()->head;
  shelf().setDraft(current(), with);
  if (with.process())
    drawing_->setProcess(*with.process());
  showState();
}

void LibraryDialog::setHead(const process::HeadShape& head) {
  LibraryItem with = shelf().at(current()).draft;
  std::get<process::Process>(with.data).head = head;
  shelf().setDraft(current(), with);
  head_->setHead(head);
  drawing_->setProcess(*with.process());
  showState();
}

bool LibraryDialog::tried(const std::function<void()>& work) {
  try {
    work();
    return true;
  } catch (const base::Error& error) {
    QMessageBox::warning(this, windowTitle(), language::words(error.whole()));
    return false;
  }
}

void LibraryDialog::duplicate() {
  std::string id;
  if (!tried([&] { id = shelf().duplicate(current()); }))
    return;
  libraryChanged_ = true;
  shelf().reload();
  fillList(id);
}

void LibraryDialog::rename() {
  bool accepted = false;
  const std::string old = shelf().at(current()).saved.id();
  const QString typed =
      QInputDialog::getText(this, tr("Rename"), tr("Small letters, digits, '-', '_' and '.':"),
                            QLineEdit::Normal, named(old), &accepted);
  const std::string id = typed.trimmed().toStdString();
  if (!accepted || id == old)
    return;
  if (shelf().indexOf(id) >= 0 && !process::comesWithProgram(shelf_, id)) {
    QMessageBox::warning(this, windowTitle(), tr("There is another '%1'.").arg(named(id)));
    return;
  }
  if (!tried([&] { shelf().rename(current(), id); }))
    return;
  libraryChanged_ = true;
  shelf().reload();
  fillList(id);
}

void LibraryDialog::removeEntry() {
  const QString id = named(shelf().at(current()).saved.id());
  if (QMessageBox::question(this, windowTitle(), tr("Delete %1 and its file?").arg(id)) !=
      QMessageBox::Yes)
    return;
  if (!tried([&] { shelf().remove(current()); }))
    return;
  libraryChanged_ = true;
  const std::string next = shelf().at(current()).saved.basedOn;
  shelf().reload();
  fillList(next);
}

void LibraryDialog::save() {
  const std::string id = shelf().at(current()).saved.id();
  if (!tried([&] { shelf().save(current()); }))
    return;
  libraryChanged_ = true;
  shelf().reload(); // those that inherit from it have changed, too
  fillList(id);
}

void LibraryDialog::revert() {
  shelf().revert(current());
  showEntry();
}

void LibraryDialog::importFile() {
  const QString file = chosenFile(
      this, shelf_ == Shelf::Processes ? tr("Import a process") : tr("Import a material"),
      tr("JSON files (*.json);;All files (*)"));
  if (file.isEmpty())
    return;
  std::string id;
  const auto read = [&] {
    id = process::readItem(shelf_, base::readFile(file.toStdString()), file.toStdString()).id();
    process::checkOwnId(shelf_, id, file.toStdString());
  };
  if (!tried(read))
    return;
  if (const int at = shelf().indexOf(id);
      at >= 0 && shelf().at(at).origin == ItemOrigin::Own &&
      QMessageBox::question(this, windowTitle(), tr("Replace your own %1?").arg(named(id))) !=
          QMessageBox::Yes)
    return;
  if (!tried([&] { process::importItem(shelf_, file.toStdString()); }))
    return;
  libraryChanged_ = true;
  if (const int at = shelf().indexOf(id); at >= 0)
    shelf().revert(at);
  shelf().reload();
  fillList(id);
}

void LibraryDialog::exportFile() {
  const LibraryItem& item = shelf().at(current()).draft;
  const QString file = forms::saveFile(this, tr("Export %1").arg(named(item.id())),
                                       QSettings().value("open/folder").toString() +
                                           QLatin1Char('/') + named(item.id()) + ".json",
                                       tr("JSON files (*.json)"));
  if (file.isEmpty())
    return;
  tried([&] { base::writeFile(file.toStdString(), process::itemText(item)); });
}

void LibraryDialog::compare() {
  std::vector<LibraryItem> items;
  int first = 0;
  for (std::size_t i = 0; i < shelf().entries().size(); ++i) {
    const ShelfEntry& entry = shelf().entries()[i];
    if (static_cast<int>(i) == current())
      first = static_cast<int>(items.size());
    if (entry.unreadable.isEmpty())
      items.push_back(entry.draft);
  }
  if (items.empty())
    return;
  const std::string reference = shelf().referenceOf(current()).id();
  const auto base =
      std::ranges::find_if(items, [&](const LibraryItem& item) { return item.id() == reference; });
  int second = base == items.end() ? 0 : static_cast<int>(base - items.begin());
  if (second == first && items.size() > 1)
    second = (first + 1) % static_cast<int>(items.size());
  CompareItemsDialog(items, std::min(first, static_cast<int>(items.size()) - 1), second, this)
      .exec();
}

void LibraryDialog::use() {
  const auto isUnsaved = [&] {
    const ShelfEntry& entry = shelf().at(current()); // saving reads all again
    return entry.origin == ItemOrigin::Own && entry.isChanged();
  };
  if (isUnsaved()) {
    save();
    if (isUnsaved())
      return;
  }
  const LibraryItem item = shelf().at(current()).saved;
  if (item.process())
    jobProcess_ = process::jobChoice(item);
  emit useRequested(shelf_, named(item.process() ? jobProcess_ : item.id()));
}

void LibraryDialog::setJobProcess(const std::string& choice) {
  jobProcess_ = choice;
  for (int row = 0; row < list_->count(); ++row)
    showRow(*list_->item(row), shelf().at(row));
  showState();
}

void LibraryDialog::headFromNumbers() {
  HeadNumbersDialog dialog(*shelf().at(current()).draft.process(), this);
  if (dialog.exec() == QDialog::Accepted && dialog.head())
    setHead(*dialog.head());
}

void LibraryDialog::sizesFromPlate() {
  SizesDialog dialog(*shelf().at(current()).draft.process(), this);
  if (dialog.exec() != QDialog::Accepted || !dialog.corrected())
    return;
  LibraryItem with = shelf().at(current()).draft;
  with.data = *dialog.corrected();
  shelf().setDraft(current(), with);
  showEntry();
}

void LibraryDialog::headFromMesh() {
  const QString file = chosenFile(
      this, tr("Head from a mesh"),
      tr("Meshes (%1);;All files (*)").arg(forms::filePatterns(project::NamedFiles::Meshes)));
  if (file.isEmpty())
    return;
  tried([&] {
    const geometry::TriangleMesh mesh = geometry::readMesh(file.toStdString()).mesh;
    const process::HeadShape head = process::headFromMesh(mesh);
    const auto isUpsideDown = process::upsideDown(head);
    if (const auto nozzle = isUpsideDown ? askNozzle(*isUpsideDown) : process::NozzlePoints::Down)
      setHead(*nozzle == process::NozzlePoints::Down
                  ? head
                  : process::headFromMesh(mesh, process::kHeadToleranceMm, *nozzle));
  });
}

std::optional<process::NozzlePoints> LibraryDialog::askNozzle(const base::Message& reason) {
  QMessageBox box(QMessageBox::Warning, windowTitle(), sentence(reason), QMessageBox::NoButton,
                  this);
  box.setObjectName(QStringLiteral("headUpsideDownBox"));
  box.setInformativeText(tr("Does the nozzle point up in the drawing?"));
  const QPushButton* overButton = box.addButton(tr("Turn it over"), QMessageBox::AcceptRole);
  const QPushButton* use = box.addButton(tr("Use it as drawn"), QMessageBox::DestructiveRole);
  box.addButton(QMessageBox::Cancel);
  box.exec();
  if (box.clickedButton() == overButton)
    return process::NozzlePoints::Up;
  return box.clickedButton() == use ? std::optional(process::NozzlePoints::Down) : std::nullopt;
}

bool LibraryDialog::saveChanged() {
  for (LibraryShelf& shelf : shelves_)
    for (int i = 0; i < static_cast<int>(shelf.entries().size()); ++i)
      if (shelf.at(i).isChanged() && !tried([&] { shelf.save(i); }))
        return false;
  libraryChanged_ = true;
  return true;
}

void LibraryDialog::reject() {
  if (shelves_[0].anyChanged() || shelves_[1].anyChanged()) {
    const auto answer = QMessageBox::question(
        this, windowTitle(), tr("Save the changes?"),
        QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
    if (answer == QMessageBox::Cancel || (answer == QMessageBox::Save && !saveChanged()))
      return;
  }
  QDialog::reject();
}

} // namespace voluta::window
