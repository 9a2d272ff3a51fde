#include "window/pages/export_page.h"

#include "base/error.h"
#include "document/document.h"
#include "document/planning.h"
#include "language/window_language.h"
#include "language/words.h"
#include "motion/resumed_motion.h"
#include "panels/export_panel.h"
#include "pictures/job_picture.h"
#include "pipeline/checked_program.h"
#include "pipeline/outputs.h"
#include "pipeline/plan_verdict.h"
#include "pipeline/proof.h"
#include "pipeline/slow_spans.h"
#include "pipeline/stage_options.h"
#include "plan/finding_kinds.h"
#include "program/assumptions.h"
#include "program/dialect.h"
#include "window/pages/cell_view.h"
#include "window/pages/resumable.h"
#include "window/presenters/presenter.h"
#include "window/program_preview.h"
#include "window/verify_dialog.h"

#include <QDesktopServices>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QUrl>
#include <algorithm>
#include <utility>

namespace voluta::window {

using project::Stage;

namespace {
constexpr const char* kFolder = "export/folder";
using Directions = std::vector<Eigen::Vector3d>;
using Checked = std::shared_ptr<const pipeline::CheckedProgram>;

QString formatOf(const Checked& checked) {
  return QString::fromStdString(checked->program.format);
}

// null: no program of that format.
Checked findProgram(const pipeline::PlanResult& result, const QString& format) {
  const auto at = std::find_if(result.checked.begin(), result.checked.end(),
                               [&](const Checked& one) { return formatOf(one) == format; });
  return at == result.checked.end() ? nullptr : *at;
}

// A result's files are not copied; the panels keep the result alive through them.
std::vector<panels::ExportFile> exportFiles(const Checked& checked) {
  std::vector<panels::ExportFile> files;
  for (const plan::ProgramFile& file : checked->program.files)
    files.push_back({QString::fromStdString(pipeline::writtenName(*checked, file)),
                     std::shared_ptr<const std::string>(checked, &file.text)});
  return files;
}

panels::VerdictState stateOf(const pipeline::CheckedProgram& program,
                             const project::Report& report) {
  switch (pipeline::verdictOf(program, report)) {
  case pipeline::PlanVerdict::Passed:
    return panels::VerdictState::Passed;
  case pipeline::PlanVerdict::NotAsAsked:
    return panels::VerdictState::NotAsAsked;
  case pipeline::PlanVerdict::Unchecked:
    return panels::VerdictState::Unchecked;
  case pipeline::PlanVerdict::Blocked:
    return panels::VerdictState::Blocked;
  case pipeline::PlanVerdict::Refused:
    break;
  }
  return panels::VerdictState::Refused;
}

QString whyNotPassed(const pipeline::CheckedProgram& program, const project::Report& report) {
  if (!program.safeToRun)
    return language::words(base::Value(program.failed));
  const plan::Findings blockers = pipeline::blockersOf(report, program.program.format);
  const auto own =
      std::ranges::find(blockers, plan::FindingKind::OwnStatement, &plan::Finding::kind);
  const base::Value* const statement = own == blockers.end() ? nullptr : own->value("statement");
  if (statement && pipeline::verdictOf(program, report) == pipeline::PlanVerdict::Unchecked)
    return language::words(*statement);
  if (!blockers.empty())
    return language::words(plan::reasonOf(blockers.front()));
  return program.verdict.passed ? QString() : language::words(base::Value(program.failed));
}

// Returns the report of the program shown, else of the first written one.
QString proofToOpen(const pipeline::Programs& programs, const QString& shownFormat) {
  const auto shown = std::ranges::find(programs, shownFormat, formatOf);
  const Checked& program = shown == programs.end() ? programs.front() : *shown;
  return QString::fromStdString(pipeline::proofName(*program)) + ".pdf";
}
} // namespace

ExportPage::ExportPage(const Workspace& workspace)
    : Page({"export", QT_TRANSLATE_NOOP("Commands", "&Export")}, workspace),
      panel_(new panels::ExportPanel), side_(scrolled(panel_)), preview_(new ProgramPreview(this)) {
  panel_->setObjectName("export");
  panel_->setFolder(QSettings().value(kFolder).toString());
  listenToPanel();
  listenToRuns();
  exporting_.finish(panel_->folder());
}

void ExportPage::open(const QString& path) {
  if (!QDesktopServices::openUrl(QUrl::fromLocalFile(path)))
    work().shell.showMessage(tr("Cannot open %1").arg(QDir::toNativeSeparators(path)),
                             tr("No program on this computer is set up to open it."));
}

void ExportPage::listenToPanel() {
  using panels::ExportPanel;
  connect(panel_, &ExportPanel::exportRequested, this,
          [this](const QString& folder, const QStringList& formats, bool includeRefused) {
            place({folder, formats, includeRefused});
          });
  connect(
      panel_, &ExportPanel::optionChanged, this,
      [this](const QString& key, const QString& text) { work().document.setParameter(key, text); });
  connect(panel_, &ExportPanel::optionResetRequested, &work().document,
          &document::Document::resetParameter);
  connect(panel_, &ExportPanel::formatsChanged, this, &ExportPage::setFormats);
  connect(panel_, &ExportPanel::folderChanged, this,
          [](const QString& folder) { QSettings().setValue(kFolder, folder); });
  connect(panel_, &ExportPanel::previewFormatChanged, this, &ExportPage::showPreview);
  connect(panel_, &ExportPanel::lineClicked, this, &ExportPage::goToLine);
  connect(panel_, &ExportPanel::resumeAsked, this, [this] {
    if (const auto point = resumePoint())
      work().shell.resume(*point);
  });
  connect(panel_, &ExportPanel::openProofRequested, this,
          [this] { open(QDir(writtenTo_).filePath(proof_)); });
  connect(panel_, &ExportPanel::showFolderRequested, this, [this] { open(writtenTo_); });
  connect(preview_, &ProgramPreview::linesReady, this, &ExportPage::showLine);
  connect(&work().timeline, &timeline::TimelineBar::timeChanged, this, &ExportPage::showLine);
}

void ExportPage::listenToRuns() {
  connect(&work().document, &document::Document::resultChanged, this, &ExportPage::show);
  connect(&work().document, &document::Document::edited, this, &ExportPage::show);
  connect(&work().document, &document::Document::sourceChanged, this,
          [this] { takenOff_.clear(); });
  connect(&exporting_, &document::Exporting::written, this,
          [this](const QString& folder, int files) {
            QString text = tr("Files written to %1: %2").arg(folder).arg(files);
            if (!leftOut_.isEmpty())
              text += tr("; refused and not written: %1").arg(leftOut_.join(", "));
            if (*noPictures_)
              text += tr("; the reports have no pictures: %1").arg(language::words(**noPictures_));
            work().shell.say(text);
            written_ = text;
            writtenTo_ = folder;
            writing_ = false;
            show();
          });
  connect(&exporting_, &document::Exporting::failed, this, [this](const QString& message) {
    writing_ = false;
    show();
    work().shell.showMessage(tr("Nothing was exported"), message);
  });
  document::Planning* planning = &work().planning;
  connect(planning, &document::Planning::finished, this, [this] {
    show();
    if (const auto order = std::exchange(pending_, std::nullopt))
      write(*order);
  });
  connect(planning, &document::Planning::cancelled, this, [this] { pending_.reset(); });
  connect(planning, &document::Planning::failed, this, [this] { pending_.reset(); });
}

std::vector<Command> ExportPage::commands() {
  return {{"exportPrograms",
           "exportMenu",
           0,
           QT_TRANSLATE_NOOP("Commands", "Robot &programs…"),
           QT_TRANSLATE_NOOP("Commands", "Write the chosen programs into a folder"),
           {QKeySequence("Ctrl+E")},
           [this] { work().shell.show(*this); },
           {},
           {},
           "export"},
          {"verifyProgram",
           "exportMenu",
           0,
           QT_TRANSLATE_NOOP("Commands", "&Verify a program…"),
           QT_TRANSLATE_NOOP("Commands", "Replay a program from disk against the plan shown"),
           {},
           [this] { verify(); },
           [this] { return verifiable() != nullptr; }}};
}

std::shared_ptr<const pipeline::PlanResult> ExportPage::verifiable() const {
  const auto motion = work().document.result(Stage::Motion);
  return motion && motion->job.trajectory && work().document.upToDate(Stage::Motion) ? motion
                                                                                     : nullptr;
}

void ExportPage::verify() {
  const QString file = QFileDialog::getOpenFileName(side_->window(), tr("Verify a program"),
                                                    panel_->folder(), tr("All files (*)"));
  if (const auto plan = verifiable(); plan && !file.isEmpty())
    (new VerifyDialog(file, plan, side_->window()))->open();
}

void ExportPage::draw(scene::ViewState& view) {
  drawCellAtWork(view, work());
}

void ExportPage::show() {
  if (!isShown())
    return;
  panel_->setFormats(formats());
  panel_->setChecked(chosenFormats());
  panel_->setOptions(pipeline::givenParameters(work().document.choices()));
  // Beside the part, until the user chooses a folder.
  if (panel_->folder().isEmpty() && work().document.source()) {
    const QFileInfo part(work().document.sourcePath());
    panel_->setFolder(part.isFile() ? part.absolutePath() : QDir::homePath());
  }
  panel_->setBlockedReason(whyNot());
  showWritten();
  showPreview();
}

// The files belong to one plan and must not be shown beside another one.
void ExportPage::showWritten() {
  const auto exported = exported_.lock();
  const bool shown = exported && exported == work().document.result(Stage::Replay);
  panel_->setWritten(shown ? written_ : QString(), !proof_.isEmpty());
}

std::vector<panels::ExportFormat> ExportPage::formats() const {
  const auto result = work().document.result(Stage::Replay);
  const auto motion = work().document.result(Stage::Motion);
  const auto cell = motion ? motion->cell : nullptr;
  const bool current = work().document.upToDate(Stage::Replay);
  std::vector<panels::ExportFormat> formats;
  // The cell's own first, then those available in every cell, then other makers'.
  std::vector<const program::Dialect*> dialects;
  for (const program::Dialect& dialect : program::dialects())
    dialects.push_back(&dialect);
  const auto rank = [&](const program::Dialect* dialect) {
    const bool own = cell && !dialect->controller.empty() && !program::isForeign(*dialect, *cell);
    return own ? 0 : dialect->forAnyCell ? 1 : 2;
  };
  std::ranges::stable_sort(dialects, {}, rank);
  for (const program::Dialect* row : dialects) {
    const program::Dialect& dialect = *row;
    panels::ExportFormat format;
    format.id = QString::fromUtf8(dialect.id.data(), static_cast<qsizetype>(dialect.id.size()));
    format.label = language::words(dialect.label);
    format.options = program::optionsOf(dialect);
    format.assumptions = language::words(program::assumptionsOf(dialect));
    format.plannedS = result ? result->job.report.motion.durationS : 0.0;
    format.foreign = cell && program::isForeign(dialect, *cell);
    if (cell && work().document.upToDate(Stage::Motion))
      if (const auto refusal = program::refusal(
              dialect, *cell, motion->job.toolPlan ? motion->job.toolPlan->direction : Directions(),
              motion->job.trajectory.get()))
        format.whyNot = language::words(refusal->whole());
    if (const Checked program = result ? findProgram(*result, format.id) : nullptr) {
      format.state =
          current ? stateOf(*program, result->job.report) : panels::VerdictState::OutOfDate;
      format.whyRefused = whyNotPassed(*program, result->job.report);
      format.verdict = program->verdict;
      format.facts = {pipeline::bridgedMm(*program, result->tooling()), program->deviations};
      format.files = exportFiles(program);
    }
    formats.push_back(std::move(format));
  }
  return formats;
}

// Returns the formats in the choices, else those of the cell's programs. A reopened project has no
// programs yet, but it has its cell.
QStringList ExportPage::chosenFormats() const {
  const project::Choices& choices = work().document.choices();
  const auto planned = work().document.lastResult();
  const std::vector<std::string> ids =
      planned && planned->cell ? pipeline::chosenFormats(choices, *planned->cell) : choices.formats;
  QStringList chosen;
  for (const std::string& id : ids)
    chosen << QString::fromStdString(id);
  return chosen == takenOff_ ? QStringList() : chosen;
}

QString ExportPage::whyNot() const {
  const document::Document& document = work().document;
  const auto result = document.result(Stage::Replay);
  if (!document.source())
    return tr("Open a part first.");
  if (work().planning.running())
    return tr("Planning is in progress.");
  if (writing_)
    return tr("The files are being written.");
  if (!result)
    return tr("Nothing has been planned yet. Press Plan.");
  if (result->checked.empty())
    return tr("Programs are not saved in a project. Press Plan to generate them.");
  const auto motion = document.result(Stage::Motion);
  if (motion && motion->job.resumedAt > 0 && !document.isRest())
    return tr("This is the rest of a print made with other settings. Undo the change: Plan would "
              "plan the whole part again.");
  if (!document.upToDate(Stage::Replay))
    return tr("The programs are out of date. Press Plan.");
  return {};
}

void ExportPage::showPreview() {
  const auto result = work().document.result(Stage::Replay);
  preview_->setProgram(result ? findProgram(*result, panel_->previewFormat()) : nullptr,
                       result ? result->job.trajectory : nullptr);
  showSlow();
  showResume();
}

// Marks where the controller takes longer than planned for the program shown.
void ExportPage::showSlow() {
  std::vector<timeline::Span> spans;
  const auto result = work().document.result(Stage::Replay);
  if (const Checked program =
          isShown() && result ? findProgram(*result, panel_->previewFormat()) : nullptr)
    for (const pipeline::SlowSpan& span : program->slow)
      spans.push_back(
          {span.fromS, span.toS,
           tr("Slower on the controller by %1 s").arg(QLocale().toString(span.moreS, 'f', 1))});
  work().timeline.setSpans(std::move(spans));
}

void ExportPage::showLine() {
  const auto& clock = work().presenter.clock();
  if (!isShown() || !clock)
    return;
  if (const auto line = preview_->lineAt(*clock, work().timeline.timeS()))
    panel_->showLine(line->file, line->line);
  showResume();
}

std::optional<std::size_t> ExportPage::resumePoint() const {
  const std::size_t line = panel_->currentLine();
  const auto point = preview_->pointOf(static_cast<std::uint32_t>(panel_->currentFile()),
                                       static_cast<std::uint32_t>(line));
  if (line == 0 || !point || !work().document.upToDate(Stage::Replay))
    return std::nullopt;
  // A line is a motion to its point, so printing resumes at the point before it.
  return resumableAt(work(), [&](const plan::Trajectory& t) {
    return motion::resumePoint(t, *point > 0 ? *point - 1 : 0);
  });
}

void ExportPage::showResume() {
  const auto point = resumePoint();
  panel_->setResumePlace(
      point ? tr("Line %1, %2").arg(panel_->currentLine()).arg(placeOfPoint(work(), *point))
            : QString());
}

void ExportPage::goToLine(int file, qulonglong line) {
  const auto& clock = work().presenter.clock();
  if (!clock)
    return;
  if (const auto time = preview_->timeOf(*clock, static_cast<std::uint32_t>(file),
                                         static_cast<std::uint32_t>(line)))
    work().timeline.setTimeS(*time);
  showResume();
}

// An empty list would mean the cell's usual formats, so a selection without formats is not stored.
// The panel prompts for one.
void ExportPage::setFormats(const QStringList& ids) {
  takenOff_ = ids.isEmpty() ? chosenFormats() : QStringList();
  if (ids.isEmpty())
    return; // The choices would name the cell's own formats
  project::Choices c = work().document.choices();
  c.formats.clear();
  for (const QString& id : ids)
    c.formats.push_back(id.toStdString());
  work().document.setChoices(c, tr("program formats"));
}

void ExportPage::place(const Order& order) {
  const auto result = work().document.result(Stage::Replay);
  const bool there =
      result && work().document.upToDate(Stage::Replay) &&
      std::all_of(order.formats.begin(), order.formats.end(),
                  [&](const QString& id) { return findProgram(*result, id) != nullptr; });
  if (there) {
    write(order);
    return;
  }
  pending_ = order;
  work().planning.plan(Stage::Replay);
}

void ExportPage::write(const Order& order) {
  const auto result = work().document.result(Stage::Replay);
  if (!result)
    return;
  std::vector<std::string> wanted;
  for (const QString& id : order.formats)
    wanted.push_back(id.toStdString());
  const pipeline::Programs programs =
      pipeline::chosenPrograms(*result, wanted, order.includeRefused);
  leftOut_.clear();
  for (const Checked& program : pipeline::chosenPrograms(*result, wanted, true))
    if (!program->safeToRun && !order.includeRefused)
      leftOut_ << formatOf(program);
  if (programs.empty()) {
    work().shell.showMessage(tr("Nothing was exported"),
                             tr("The replay refused all programs: %1.").arg(leftOut_.join(", ")));
    return;
  }
  const QStringList there = document::Exporting::conflictingFiles(order.folder, *result, programs);
  if (!there.isEmpty() && !mayReplace(order.folder, there))
    return;
  exported_ = result;
  written_.clear();
  proof_ = result->proofs ? proofToOpen(programs, panel_->previewFormat()) : QString();
  const auto noPictures = std::make_shared<std::optional<base::Message>>();
  noPictures_ = noPictures;
  const auto draw = [noPictures](const project::Job& job) -> std::vector<std::string> {
    try {
      return pictures::drawProofPictures(job);
    } catch (const base::Error& error) { // A report is useful without pictures
      *noPictures = error.whole();
      return {};
    }
  };
  writing_ = true;
  exporting_.write(order.folder, result, programs,
                   {language::windowLanguage(), language::windowLanguageCode(), draw});
  show();
}

bool ExportPage::mayReplace(const QString& folder, const QStringList& names) {
  constexpr int kNamed = 6;
  QMessageBox box(QMessageBox::Warning, tr("Replace files?"),
                  tr("These files already exist in %1:").arg(QDir::toNativeSeparators(folder)),
                  QMessageBox::NoButton, side_->window());
  box.setObjectName("replaceBox");
  box.setInformativeText(names.mid(0, kNamed).join('\n') + (names.size() > kNamed ? "\n…" : ""));
  const QPushButton* replace = box.addButton(tr("Replace"), QMessageBox::DestructiveRole);
  box.setDefaultButton(box.addButton(QMessageBox::Cancel));
  box.exec();
  return box.clickedButton() == replace;
}

} // namespace voluta::window
