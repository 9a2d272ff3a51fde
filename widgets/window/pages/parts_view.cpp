#include "window/pages/parts_view.h"

#include "base/error.h"
#include "document/document.h"
#include "document/shown_names.h"
#include "geometry/measures.h"
#include "language/words.h"
#include "modes/mode_stages.h"
#include "modes/mode_table.h"
#include "pipeline/stage_options.h"
#include "window/presenters/presenter.h"

#include <QLocale>

namespace voluta::window {

using document::Document;

namespace {

QString strategyText(const project::ItemChoices& item) {
  if (item.automatic)
    return PartsView::tr("Automatic");
  const modes::Mode* mode = modes::modeNamed(item.mode);
  return mode ? language::words(mode->label) : QString::fromStdString(item.mode);
}

QString sizeText(const Eigen::Vector3d& size) {
  const QLocale locale;
  return QStringLiteral("%1 × %2 × %3")
      .arg(locale.toString(size.x(), 'f', 0), locale.toString(size.y(), 'f', 0),
           locale.toString(size.z(), 'f', 0));
}

// Empty: not placed yet.
QString sizeText(const std::shared_ptr<const pipeline::PlanResult>& placed, std::size_t item) {
  const auto& part = placed ? placed->job.item(item).part : nullptr;
  return part && !part->empty() ? sizeText(geometry::bounds(*part).sizes()) : QString();
}

} // namespace

PartsView::PartsView(const Workspace& workspace, Page& page)
    : QObject(&page), work_(workspace), page_(page), list_(new panels::PartList) {
  list_->setObjectName("partList");
  list_->hide();
  Document* document = &work_.document;
  for (const auto changed : {&Document::partsChanged, &Document::choicesChanged})
    connect(document, changed, this, &PartsView::show);
  connect(document, &Document::resultChanged, this, [this](project::Stage stage) {
    if (stage == project::Stage::Load)
      show();
  });
  using panels::PartList;
  connect(list_, &PartList::selected, document, &Document::setActive);
  connect(list_, &PartList::addRequested, this, [this] { work_.shell.addPart(); });
  connect(list_, &PartList::duplicateRequested, document, &Document::duplicatePart);
  connect(list_, &PartList::removeRequested, document, &Document::removePart);
  connect(list_, &PartList::arrangeRequested, this, &PartsView::arrange);
  connect(list_, &PartList::printOrderChosen, document, &Document::setPrintOrder);
}

std::vector<Command> PartsView::commands() {
  Document& document = work_.document;
  return {{"duplicatePart",
           "editMenu",
           3,
           QT_TRANSLATE_NOOP("Commands", "D&uplicate part"),
           QT_TRANSLATE_NOOP("Commands", "Adds a copy of the selected part beside the others"),
           {QKeySequence("Ctrl+D")},
           [&document] { document.duplicatePart(); },
           [&document] { return document.partCount() > 0; }},
          {"removePart",
           "editMenu",
           3,
           QT_TRANSLATE_NOOP("Commands", "&Remove part"),
           QT_TRANSLATE_NOOP("Commands", "Removes the selected part from the plate"),
           {QKeySequence::Delete},
           [&document] { document.removePart(); },
           [this] { return page_.isShown() && work_.document.partCount() > 1; }},
          {"arrangeParts",
           "editMenu",
           3,
           QT_TRANSLATE_NOOP("Commands", "&Arrange parts"),
           QT_TRANSLATE_NOOP("Commands",
                             "Moves all parts beside each other, with room for the print head"),
           {QKeySequence("Ctrl+Shift+A")},
           [this] { arrange(); },
           [&document] { return document.partCount() > 1; }}};
}

void PartsView::arrange() {
  try {
    work_.document.arrangeParts();
  } catch (const base::Error& error) {
    work_.shell.showMessage(tr("Arrange parts"), language::words(error.whole()));
  }
}

void PartsView::show() {
  const Document& document = work_.document;
  const auto sources = document.sources();
  list_->setVisible(sources.size() > 1);
  if (sources.size() < 2)
    return;
  const QStringList names = document::shownNames(sources);
  const project::Choices& choices = document.jobChoices();
  const auto placed = document.result(project::Stage::Load);
  std::vector<panels::ListedPart> parts;
  for (std::size_t i = 0; i < sources.size(); ++i)
    parts.push_back(
        {names[static_cast<qsizetype>(i)], strategyText(choices.item(i)), sizeText(placed, i)});
  list_->setParts(parts, document.active());
  list_->setPrintOrder(choices.printOrder);
}

} // namespace voluta::window
