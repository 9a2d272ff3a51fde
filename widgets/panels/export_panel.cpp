#include "panels/export_panel.h"

#include "panels/options_form.h"
#include "panels/program_facts.h"
#include "panels/resume_bar.h"
#include "panels/text_preview.h"
#include "panels/verdict_table.h"
#include "panels/written_bar.h"

#include "forms/icons.h"
#include "forms/tab_order.h"
#include "forms/value_boxes.h"

#include <QComboBox>
#include <QDir>
#include <QEvent>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>

namespace voluta::panels {

namespace {
std::optional<ProgramFigures> figuresOf(const ExportFormat& format) {
  if (format.files.empty() || !format.verdict)
    return std::nullopt;
  ProgramFigures figures{0, format.files.size(), format.verdict->controllerDurationS,
                         format.plannedS};
  for (const ExportFile& file : format.files)
    figures.bytes += file.text ? file.text->size() : 0;
  return figures;
}
} // namespace

ExportPanel::ExportPanel(QWidget* parent) : QWidget(parent) {
  build();
  retranslate();
}

void ExportPanel::build() {
  const auto title = [this] {
    auto* label = new QLabel(this);
    QFont bold = label->font();
    bold.setBold(true);
    label->setFont(bold);
    return label;
  };
  formatsTitle_ = title();
  list_ = new FormatList(this);
  list_->setObjectName(QStringLiteral("formats"));
  connect(list_, &FormatList::checkedChanged, this, [this](const QStringList& ids) {
    showButton();
    emit formatsChanged(ids);
  });
  connect(list_, &FormatList::currentChangedTo, this, [this](const QString& id) {
    showFormat(id);
    emit previewFormatChanged(id);
  });
  optionsTitle_ = title();
  optionsTitle_->setWordWrap(true);
  optionsForm_ = new OptionsForm(this);
  optionsForm_->setObjectName(QStringLiteral("options"));
  connect(optionsForm_, &OptionsForm::changed, this, &ExportPanel::optionChanged);
  connect(optionsForm_, &OptionsForm::resetRequested, this, &ExportPanel::optionResetRequested);
  whyNot_ = new QLabel(this);
  whyNot_->setObjectName(QStringLiteral("whyNot"));
  whyNot_->setWordWrap(true);
  verdictTitle_ = title();
  verdictTitle_->setWordWrap(true);
  verdict_ = new VerdictTable(this);
  facts_ = new ProgramFacts(this);

  fileLabel_ = new QLabel(this);
  file_ = forms::makeCombo(this);
  file_->setObjectName(QStringLiteral("file"));
  connect(file_, &QComboBox::currentIndexChanged, this, &ExportPanel::showFile);
  preview_ = new TextPreview(this);
  preview_->setObjectName(QStringLiteral("preview"));
  preview_->setMinimumHeight(fontMetrics().height() * 6);
  connect(preview_, &TextPreview::lineClicked, this,
          [this](qulonglong line) { emit lineClicked(file_->currentIndex(), line); });

  resume_ = new ResumeBar(this);
  connect(resume_, &ResumeBar::asked, this, &ExportPanel::resumeAsked);

  folderLabel_ = new QLabel(this);
  folder_ = new QLineEdit(this);
  folder_->setObjectName(QStringLiteral("folder"));
  connect(folder_, &QLineEdit::textChanged, this, &ExportPanel::showButton);
  connect(folder_, &QLineEdit::editingFinished, this, [this] {
    if (folder_->isModified())
      emit folderChanged(folder());
    folder_->setModified(false);
  });
  browse_ = new QPushButton(this);
  connect(browse_, &QPushButton::clicked, this, &ExportPanel::browse);

  reason_ = new QLabel(this);
  reason_->setObjectName(QStringLiteral("reason"));
  reason_->setWordWrap(true);
  export_ = new QPushButton(this);
  export_->setObjectName(QStringLiteral("export"));
  export_->setDefault(true);
  connect(export_, &QPushButton::clicked, this, &ExportPanel::exportNow);

  written_ = new WrittenBar(this);
  connect(written_, &WrittenBar::openProofRequested, this, &ExportPanel::openProofRequested);
  connect(written_, &WrittenBar::showFolderRequested, this, &ExportPanel::showFolderRequested);

  auto* fileRow = new QHBoxLayout;
  fileRow->addWidget(fileLabel_);
  fileRow->addWidget(file_, 1);
  auto* folderRow = new QHBoxLayout;
  folderRow->addWidget(folder_, 1);
  folderRow->addWidget(browse_);
  auto* exportRow = new QHBoxLayout;
  exportRow->addWidget(reason_, 1);
  exportRow->addWidget(export_, 0, Qt::AlignRight);
  auto* upper = new QWidget;
  auto* column = new QVBoxLayout(upper);
  column->setContentsMargins(6, 6, 6, 6);
  column->setSpacing(4);
  column->addWidget(formatsTitle_);
  column->addWidget(list_);
  column->addWidget(whyNot_);
  column->addWidget(optionsTitle_);
  column->addWidget(optionsForm_);
  column->addSpacing(4);
  column->addWidget(verdictTitle_);
  column->addWidget(verdict_);
  column->addWidget(facts_);
  column->addSpacing(4);
  column->addLayout(fileRow);
  column->addWidget(preview_, 1);
  column->addWidget(resume_);
  // The controls that write the programs stay visible; the rest above them scrolls.
  upper_ = new QScrollArea(this);
  upper_->setObjectName(QStringLiteral("upper"));
  upper_->setFrameShape(QFrame::NoFrame);
  upper_->setWidgetResizable(true);
  upper_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  upper_->setWidget(upper);
  auto* lower = new QVBoxLayout;
  lower->setContentsMargins(6, 4, 6, 6);
  lower->setSpacing(4);
  lower->addWidget(folderLabel_);
  lower->addLayout(folderRow);
  lower->addLayout(exportRow);
  lower->addWidget(written_);
  auto* whole = new QVBoxLayout(this);
  whole->setContentsMargins(0, 0, 0, 0);
  whole->setSpacing(0);
  whole->addWidget(upper_, 1);
  whole->addLayout(lower);
}

const ExportFormat* ExportPanel::find(const QString& id) const {
  const auto found = std::find_if(formats_.begin(), formats_.end(),
                                  [&](const ExportFormat& format) { return format.id == id; });
  return found == formats_.end() ? nullptr : &*found;
}

void ExportPanel::setFormats(std::vector<ExportFormat> formats) {
  formats_ = std::move(formats);
  list_->setFormats(formats_);
  showFormat(list_->currentId());
  showButton();
}

void ExportPanel::setChecked(const QStringList& ids) {
  list_->setChecked(ids);
  showButton();
}

void ExportPanel::setOptions(const std::map<std::string, std::string>& changed) {
  options_ = changed;
  optionsForm_->setValues(options_);
}

void ExportPanel::setFolder(const QString& folder) {
  folder_->setText(QDir::toNativeSeparators(folder));
  folder_->setModified(false);
}

void ExportPanel::setBlockedReason(const QString& reason) {
  blockedReason_ = reason;
  showButton();
}

void ExportPanel::showLine(std::size_t file, std::size_t line) {
  if (static_cast<int>(file) >= fileCount_)
    return;
  file_->setCurrentIndex(static_cast<int>(file));
  preview_->showLine(line);
}

void ExportPanel::setResumePlace(const QString& place) {
  resume_->setPlace(place);
}

void ExportPanel::setWritten(const QString& text, bool hasProof) {
  written_->setWritten(text, hasProof);
}

std::size_t ExportPanel::currentLine() const {
  return preview_->currentLine();
}

int ExportPanel::currentFile() const {
  return file_->currentIndex();
}

QString ExportPanel::previewFormat() const {
  return list_->currentId();
}

QString ExportPanel::folder() const {
  return QDir::fromNativeSeparators(folder_->text().trimmed());
}

QStringList ExportPanel::checkedFormats() const {
  return list_->checkedIds();
}

void ExportPanel::showFormat(const QString& id) {
  const ExportFormat* format = find(id);
  verdictTitle_->setText(format ? tr("Replay of %1").arg(format->label) : tr("Replay"));
  const QString whyNot = format ? format->whyNot : QString();
  whyNot_->setText(whyNot);
  whyNot_->setVisible(!whyNot.isEmpty());
  verdict_->setReport(format ? format->verdict : std::nullopt,
                      format && format->state == VerdictState::OutOfDate,
                      format ? format->facts : VerdictFacts());
  optionsTitle_->setText(format ? tr("%1 options").arg(format->label) : QString());
  optionsForm_->setOptions(format ? format->options : std::vector<base::ParameterSpec>());
  optionsForm_->setValues(options_);
  optionsTitle_->setVisible(!optionsForm_->isEmpty());
  optionsForm_->setVisible(!optionsForm_->isEmpty());
  upper_->setMinimumWidth(upper_->widget()->minimumSizeHint().width() +
                          upper_->verticalScrollBar()->sizeHint().width());
  forms::tabInReadingOrder({this}); // rows of options are added and removed
  facts_->setFigures(format ? figuresOf(*format) : std::nullopt);
  facts_->setAssumptions(format ? format->assumptions : QStringList());
  QStringList names;
  if (format)
    for (const ExportFile& file : format->files)
      names << QStringLiteral("%1 (%2)").arg(
          file.name,
          QLocale().formattedDataSize(file.text ? static_cast<qint64>(file.text->size()) : 0, 1));
  showFileNames(names);
  showFile(file_->currentIndex());
}

// An event of the list itself may lead here, by a key that starts a plan. Rows are therefore only
// removed after it.
void ExportPanel::showFileNames(const QStringList& names) {
  const QSignalBlocker quiet(file_);
  const int count = static_cast<int>(names.size()), before = file_->currentIndex();
  for (int row = 0; row < count; ++row)
    if (row < file_->count())
      file_->setItemText(row, names[row]);
    else
      file_->addItem(names[row]);
  file_->setEnabled(count > 0);
  file_->setCurrentIndex(std::min(std::max(before, 0), count - 1));
  fileCount_ = count;
  if (file_->count() > count)
    QTimer::singleShot(0, this, [this] {
      const QSignalBlocker stillQuiet(file_);
      while (file_->count() > fileCount_)
        file_->removeItem(file_->count() - 1);
    });
}

void ExportPanel::showFile(int index) {
  const ExportFormat* format = find(list_->currentId());
  const bool there = format && index >= 0 && index < static_cast<int>(format->files.size());
  const auto text = there ? format->files[static_cast<std::size_t>(index)].text : nullptr;
  if (text != preview_->lines().text())
    preview_->setText(text);
}

void ExportPanel::showButton() {
  QString why = blockedReason_;
  if (why.isEmpty() && list_->checkedIds().isEmpty())
    why = tr("Choose at least one format.");
  if (why.isEmpty() && folder_->text().trimmed().isEmpty())
    why = tr("Choose a folder.");
  export_->setEnabled(why.isEmpty());
  reason_->setText(why);
}

void ExportPanel::browse() {
  const QString chosen =
      QFileDialog::getExistingDirectory(this, tr("Folder for the programs"), folder());
  if (chosen.isEmpty())
    return;
  setFolder(chosen);
  emit folderChanged(folder());
}

void ExportPanel::exportNow() {
  if (!mayExportBlocked())
    return;
  const std::optional<bool> includeRefused = mayExportRefused();
  if (includeRefused)
    emit exportRequested(folder(), list_->checkedIds(), *includeRefused);
}

std::vector<const ExportFormat*> ExportPanel::checkedIn(VerdictState state) const {
  std::vector<const ExportFormat*> formats;
  for (const QString& id : list_->checkedIds())
    if (const ExportFormat* format = find(id); format && format->state == state)
      formats.push_back(format);
  return formats;
}

bool ExportPanel::mayExportBlocked() {
  const std::vector<const ExportFormat*> blocked = checkedIn(VerdictState::Blocked),
                                         differing = checkedIn(VerdictState::NotAsAsked),
                                         unchecked = checkedIn(VerdictState::Unchecked);
  if (blocked.empty() && differing.empty() && unchecked.empty())
    return true;
  QMessageBox box(QMessageBox::Warning, tr("Blocked plan"), QString(), QMessageBox::NoButton, this);
  box.setObjectName(QStringLiteral("blockedBox"));
  if (blocked.empty() && !unchecked.empty()) {
    box.setWindowTitle(tr("Not checked"));
    box.setText(
        tr("Safe to run but for your own statements: %1").arg(unchecked.front()->whyRefused));
    box.setInformativeText(
        tr("Nothing checks what they do. Try them on the controller with the arm clear first."));
  } else if (blocked.empty()) {
    box.setWindowTitle(tr("Not as asked"));
    box.setText(tr("Safe to run, not as asked: %1").arg(differing.front()->whyRefused));
    box.setInformativeText(
        tr("The part will differ from the requested one there. To export without this question, "
           "accept it in the list of findings."));
  } else {
    box.setText(tr("The plan has blocking findings: %1").arg(blocked.front()->whyRefused));
    box.setInformativeText(tr("Do not run the programs before these are solved."));
  }
  QPushButton* anyway = box.addButton(tr("Export anyway"), QMessageBox::DestructiveRole);
  anyway->setObjectName(QStringLiteral("exportBlocked"));
  box.setDefaultButton(box.addButton(QMessageBox::Cancel));
  box.exec();
  return box.clickedButton() == anyway;
}

std::optional<bool> ExportPanel::mayExportRefused() {
  QStringList names;
  const std::vector<const ExportFormat*> refused = checkedIn(VerdictState::Refused);
  for (const ExportFormat* format : refused)
    for (const ExportFile& file : format->files)
      names << (file.name.startsWith(QLatin1String("refused-"))
                    ? file.name
                    : QStringLiteral("refused-") + file.name);
  if (names.isEmpty())
    return false;
  QMessageBox box(QMessageBox::Warning, tr("Refused programs"),
                  tr("The replay refused some of the programs. Never run them on a robot."),
                  QMessageBox::NoButton, this);
  constexpr int kNamed = 5;
  const QString more = names.size() > kNamed ? QStringLiteral("\n…") : QString();
  box.setInformativeText(tr("For inspection only, they can be saved as:") + QChar('\n') +
                         names.mid(0, kNamed).join(QChar('\n')) + more);
  QPushButton* all = box.addButton(tr("Save them too"), QMessageBox::DestructiveRole);
  all->setObjectName(QStringLiteral("writeRefused"));
  QPushButton* passed = nullptr;
  if (refused.size() < static_cast<std::size_t>(list_->checkedIds().size()))
    passed = box.addButton(tr("Leave out"), QMessageBox::AcceptRole);
  QPushButton* cancel = box.addButton(QMessageBox::Cancel);
  box.setDefaultButton(passed ? passed : cancel);
  box.setEscapeButton(cancel);
  box.exec();
  if (box.clickedButton() == cancel || !box.clickedButton())
    return std::nullopt;
  return box.clickedButton() == all;
}

void ExportPanel::retranslate() {
  formatsTitle_->setText(tr("Formats"));
  list_->setAccessibleName(tr("Formats"));
  fileLabel_->setText(tr("File"));
  preview_->setAccessibleName(tr("Program text"));
  folderLabel_->setText(tr("Folder"));
  folder_->setAccessibleName(tr("Folder"));
  browse_->setText(tr("Browse…"));
  export_->setText(tr("Export"));
  showFormat(list_->currentId());
  showButton();
}

void ExportPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange)
    retranslate();
  QWidget::changeEvent(event);
}

} // namespace voluta::panels
