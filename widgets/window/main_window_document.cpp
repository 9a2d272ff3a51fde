// What the panels show of the document.
#include "window/main_window.h"

#include "forms/choices_form.h"
#include "forms/parameter_form.h"
#include "modes/mode_table.h"
#include "panels/export_panel.h"
#include "panels/findings_panel.h"
#include "panels/layer_info.h"
#include "panels/mesh_panel.h"
#include "panels/placement_panel.h"
#include "pipeline/outputs.h"
#include "pipeline/remedies.h"
#include "program/dialect.h"
#include "timeline/timeline_bar.h"
#include "window/core_texts.h"
#include "window/mesh_summary.h"
#include "window/program_preview.h"
#include "window/status_line.h"
#include "window/welcome.h"

#include <QActionGroup>
#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <algorithm>

namespace voluta::window {

using project::Stage;

namespace {
using document::StageState;

// A page is worth what its stages are worth; the worst counts.
PageState pageState(const document::Document& document, std::initializer_list<Stage> stages) {
  PageState worst = PageState::Nothing;
  const auto rank = [](PageState s) {
    switch (s) {
    case PageState::Nothing:
      return 0;
    case PageState::Done:
      return 1;
    case PageState::OutOfDate:
      return 2;
    case PageState::Blocked:
      return 3;
    default:
      return 4;
    }
  };
  for (const Stage stage : stages) {
    PageState one = PageState::Nothing;
    switch (document.state(stage)) {
    case StageState::Nothing:
      one = PageState::Nothing;
      break;
    case StageState::Running:
      one = PageState::Running;
      break;
    case StageState::Done:
      one = PageState::Done;
      break;
    case StageState::OutOfDate:
      one = PageState::OutOfDate;
      break;
    case StageState::Blocked:
    case StageState::Failed:
      one = PageState::Blocked;
      break;
    }
    if (rank(one) > rank(worst))
      worst = one;
  }
  return worst;
}

// As typed; what cannot be read is for the run to say.
forms::RodProfile rodProfileOf(const project::Choices& choices) {
  const auto text = [&](const char* key) {
    const auto at = choices.parameters.find(key);
    return at == choices.parameters.end() ? QString() : QString::fromStdString(at->second);
  };
  return {text("rodSides").toInt(), text("rodProfile")};
}

QString vectorText(const Eigen::Vector3d& v) {
  const QLocale locale;
  return QString::fromUtf8("%1 × %2 × %3 mm")
      .arg(locale.toString(v.x(), 'f', 1), locale.toString(v.y(), 'f', 1),
           locale.toString(v.z(), 'f', 1));
}

// A result's files stay where they are; the panels hold on to the result through them.
std::vector<panels::ExportFile>
exportFiles(const std::shared_ptr<const pipeline::CheckedProgram>& checked) {
  std::vector<panels::ExportFile> files;
  for (const plan::ProgramFile& file : checked->program.files)
    files.push_back({QString::fromStdString(pipeline::writtenName(*checked, file)),
                     std::shared_ptr<const std::string>(checked, &file.text)});
  return files;
}
} // namespace

void MainWindow::showStates() {
  if (!flow_)
    return;
  flow_->setState(Page::Prepare,
                  opening_.running() ? PageState::Running : pageState(document_, {Stage::Load}));
  flow_->setState(Page::Layers,
                  pageState(document_, {Stage::Decompose, Stage::Layers, Stage::Toolpath}));
  flow_->setState(Page::Simulate, pageState(document_, {Stage::Motion}));
  flow_->setState(Page::Export, pageState(document_, {Stage::Replay}));
  showCompareState();
  const bool busy =
      planning_.running() || opening_.running() || live_.running() || comparing_.running();
  cancel_->setEnabled(busy);
  plan_->setEnabled(static_cast<bool>(document_.source()));
  if (QAction* layers = findChild<QAction*>("planLayers"))
    layers->setEnabled(plan_->isEnabled());
  tools_->setEnabled(page() == Page::Prepare && document_.source());
  for (const char* id : {"dropToPlate", "centrePart"})
    findChild<QAction*>(id)->setEnabled(static_cast<bool>(document_.source()));
  // Around a rod the rod says where the part lies.
  findChild<QAction*>("touchedPoints")
      ->setEnabled(document_.source() && !modes::findMode(document_.choices().mode).aroundRod);
  QString text = summaryText();
  const auto result = document_.presentResult();
  if (!document_.preview() && result && result->job.reached &&
      !document_.upToDate(*result->job.reached))
    text = tr("Out of date: %1").arg(text);
  summary_->setText(text);
}

void MainWindow::showChoices() {
  const project::Choices& c = document_.choices();
  choices_->setTexts({QString::fromStdString(c.mode), QString::fromStdString(c.growth.id()),
                      QString::fromStdString(c.platform.text()), QString::fromStdString(c.cell),
                      QString::fromStdString(c.process), c.seed, rodProfileOf(c)});
  parameters_->setDefaults(document::parametersFor(c));
  parameters_->setValues(c.parameters);
  placement_->setOnPlate(!modes::findMode(c.mode).aroundRod);
  placement_->setPlacement(placed());
  mesh_->setRepair(c.repair);
  tree_->setText(panels::SceneItem::Platform, {}, platformText(c.platform));
  tree_->setText(panels::SceneItem::Cell, {}, QString::fromStdString(c.cell));
  tree_->setText(panels::SceneItem::Plate,
                 modes::findMode(c.mode).aroundRod ? tr("Rod") : QString(), {});
  status_->setCell(QString::fromStdString(c.cell));
  showNotice();
  showCuts();
  showPart();
}

void MainWindow::showPart() {
  const auto source = document_.source();
  welcome_->setVisible(!source || welcome_->hasMessage());
  const auto placed = document_.result(Stage::Load);
  const bool current = placed && document_.upToDate(Stage::Load);
  placement_->setEnabled(static_cast<bool>(source));
  placement_->setScale(QString::fromStdString(document_.choices().scale),
                       current ? placed->job.scale : 0.0);
  if (!source) {
    mesh_->setSummary(std::nullopt);
    tree_->setText(panels::SceneItem::Part, {}, {});
    status_->setPart({});
    return;
  }
  Eigen::Vector3d size = Eigen::Vector3d::Zero();
  if (!presenter_->partBox().isEmpty())
    size = presenter_->partBox().sizes();
  placement_->setSizeMm(size);
  tree_->setText(panels::SceneItem::Part, QString::fromStdString(source->name), vectorText(size));
  status_->setPart(vectorText(size));
  mesh_->setSummary(meshSummary(*source));
}

void MainWindow::showFindings() {
  const auto result = document_.lastResult();
  findings_->setPlanned(document_.preview() ||
                        (result && result->job.reached && *result->job.reached > Stage::Load));
  findings_->setFindings(presentFindings());
  std::vector<timeline::Mark> marks;
  if (result)
    for (const plan::Finding& finding : result->job.report.findings)
      if (finding.whenS)
        marks.push_back({*finding.whenS, finding.blocking, QString::fromStdString(finding.reason)});
  timeline_->setMarks(std::move(marks));
}

plan::Findings MainWindow::presentFindings() const {
  plan::Findings findings;
  if (const document::Failure* failure = document_.failure()) {
    plan::Finding stopped;
    stopped.stage = project::stageName(failure->stage);
    stopped.kind = pipeline::kStopped;
    stopped.reason = failure->error.what();
    findings.push_back(stopped);
  }
  plan::Findings more;
  if (const auto& preview = document_.preview())
    more = preview->decomposition->findings;
  else if (const auto result = document_.presentResult())
    more = result->job.report.findings;
  findings.insert(findings.end(), more.begin(), more.end());
  return findings;
}

std::vector<panels::RemedyButton> MainWindow::remediesOf(const plan::Finding& finding) const {
  std::vector<panels::RemedyButton> buttons;
  for (const pipeline::Offer& offer : pipeline::remediesFor(finding, document_.choices())) {
    const RemedyTexts texts = remedyTexts(offer);
    buttons.push_back({QString::fromUtf8(offer.id.data(), static_cast<qsizetype>(offer.id.size())),
                       texts.label, texts.help});
  }
  return buttons;
}

void MainWindow::applyRemedy(const plan::Finding& finding, const QString& id) {
  for (const pipeline::Offer& offer : pipeline::remediesFor(finding, document_.choices()))
    if (id.toStdString() == offer.id) {
      document_.setChoices(offer.cure.choices, remedyTexts(offer).label);
      const auto before = document_.lastResult();
      if (live_.enabled() && document_.result(Stage::Decompose))
        live_.refresh();
      else
        planning_.plan(std::max(Stage::Layers, before ? before->job.reached.value_or(Stage::Layers)
                                                      : Stage::Layers));
      return;
    }
}

void MainWindow::showExport() {
  if (page() != Page::Export)
    return;
  const auto result = document_.result(Stage::Replay);
  const auto motion = document_.result(Stage::Motion);
  const auto cell = motion ? motion->cell : nullptr;
  std::vector<panels::ExportFormat> formats;
  QStringList checked;
  for (const std::string& id : document_.choices().formats)
    checked << QString::fromStdString(id);
  for (const program::Dialect& dialect : program::dialects()) {
    panels::ExportFormat format;
    format.id = QString::fromUtf8(dialect.id.data(), static_cast<qsizetype>(dialect.id.size()));
    format.label = coreLabel(dialect.label);
    format.foreign = cell && program::isForeign(dialect, *cell);
    if (result)
      for (const auto& program : result->checked)
        if (program->program.format == dialect.id) {
          format.state =
              program->passed ? panels::VerdictState::Passed : panels::VerdictState::Refused;
          if (!program->passed)
            format.whyRefused = QString::fromStdString(program->failed);
          format.verdict = program->verdict;
          format.files = exportFiles(program);
          if (document_.choices().formats.empty())
            checked << format.id;
        }
    formats.push_back(std::move(format));
  }
  export_->setFormats(std::move(formats));
  export_->setChecked(checked);
  // Beside the part, until the user says where.
  if (export_->folder().isEmpty() && document_.source()) {
    const QFileInfo part(document_.sourcePath());
    export_->setFolder(part.isFile() ? part.absolutePath() : QDir::homePath());
  }
  QString reason;
  if (!document_.source())
    reason = tr("Open a part first.");
  else if (planning_.running())
    reason = tr("Planning is under way.");
  else if (!result)
    reason = tr("Nothing is planned yet. Press Plan.");
  else if (result->checked.empty())
    reason = tr("A project keeps the plan, not the programs. Press Plan to write them.");
  else if (!document_.upToDate(Stage::Replay))
    reason = tr("The programs are out of date. Press Plan.");
  export_->setBlockedReason(reason);
  showPreview();
}

void MainWindow::showPreview() {
  const auto result = document_.result(Stage::Replay);
  std::shared_ptr<const pipeline::CheckedProgram> shown;
  if (result)
    for (const auto& program : result->checked)
      if (QString::fromStdString(program->program.format) == export_->previewFormat())
        shown = program;
  preview_->setProgram(shown, result ? result->job.trajectory : nullptr);
}

void MainWindow::showLayerMeasures(int layer) {
  // Layers of other voxels than those on show have nothing to say.
  const auto facts =
      document_.voxelsAhead() && presenter_->hasVoxels() ? nullptr : presenter_->facts();
  if (facts && layer >= 0 && layer < static_cast<int>(facts->measures.size()))
    layerInfo_->setMeasures(facts->measures[static_cast<std::size_t>(layer)]);
  else
    layerInfo_->setMeasures(std::nullopt);
}

} // namespace voluta::window
