#include "window/pages/parts_view.h"

#include "base/error.h"
#include "document/document.h"
#include "document/shown_names.h"
#include "geometry/measures.h"
#include "language/words.h"
#include "modes/mode_stages.h"
#include "modes/mode_table.h"
#include "panels/object_tree.h"
#include "pipeline/items/plate_parts.h"
#include "pipeline/stage_options.h"
#include "window/copies_dialog.h"
#include "window/presenters/presenter.h"

#include <QDockWidget>
#include <QFileInfo>
#include <QLocale>
#include <variant>

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
  connect(list_, &PartList::removeRequested, this,
          [this] { work_.document.removeParts(selected()); });
  connect(list_, &PartList::arrangeRequested, this, &PartsView::arrange);
  connect(&work_.tree, &panels::ObjectTree::renamed, this, [this](const QString& name) {
    if (work_.document.source() && work_.document.sourceReady())
      work_.document.renamePart(name);
  });
  connect(list_, &PartList::printOrderChosen, document, &Document::setPrintOrder);
}

std::vector<Command> PartsView::commands() {
  Document& document = work_.document;
  const auto anyPart = [this] { return page_.isShown() && work_.document.partCount() > 0; };
  return {
      {"duplicatePart",
       "editMenu",
       3,
       QT_TRANSLATE_NOOP("Commands", "D&uplicate part"),
       QT_TRANSLATE_NOOP("Commands", "Adds a copy of the selected part beside the others"),
       {QKeySequence("Ctrl+D")},
       [&document] { document.duplicatePart(); },
       [&document] { return document.partCount() > 0; },
       {},
       "duplicate",
       BarGroup::Parts},
      {"removePart",
       "editMenu",
       3,
       QT_TRANSLATE_NOOP("Commands", "&Remove part"),
       QT_TRANSLATE_NOOP("Commands", "Removes the selected parts from the plate"),
       {QKeySequence::Delete},
       [this] { work_.document.removeParts(selected()); },
       anyPart,
       {},
       "remove-part",
       BarGroup::Parts},
      {"renamePart",
       "editMenu",
       3,
       QT_TRANSLATE_NOOP("Commands", "Re&name part"),
       QT_TRANSLATE_NOOP("Commands", "Edits the name of the part in the tree"),
       {QKeySequence("F2")},
       [this] { editName(); },
       [&document] { return document.source() && document.sourceReady(); }},
      {"copiesOfPart",
       "editMenu",
       3,
       QT_TRANSLATE_NOOP("Commands", "&Number of copies…"),
       QT_TRANSLATE_NOOP("Commands", "Prints the selected part several times, or as often as the "
                                     "plate has room"),
       {QKeySequence("Ctrl+Shift+D")},
       [this] { chooseCopies(); },
       [this, anyPart] { return anyPart() && work_.document.sourceReady(); },
       {},
       "copies",
       BarGroup::Parts},
      {"arrangeParts",
       "editMenu",
       3,
       QT_TRANSLATE_NOOP("Commands", "&Arrange parts"),
       QT_TRANSLATE_NOOP("Commands",
                         "Moves all parts beside each other, with room for the print head"),
       {QKeySequence("Ctrl+Shift+A")},
       [this] { arrange(); },
       [&document] { return document.partCount() > 1; },
       {},
       "arrange",
       BarGroup::Parts},
      {"copyPart",
       "editMenu",
       0,
       QT_TRANSLATE_NOOP("Commands", "&Copy"),
       QT_TRANSLATE_NOOP("Commands", "Copies the selected parts with their settings"),
       {QKeySequence::Copy},
       [this] {
         work_.document.copyParts(selected());
         work_.shell.showStates();
       },
       anyPart},
      {"pastePart",
       "editMenu",
       0,
       QT_TRANSLATE_NOOP("Commands", "&Paste"),
       QT_TRANSLATE_NOOP("Commands", "Adds the copied parts beside the others"),
       {QKeySequence::Paste},
       [&document] { document.pasteParts(); },
       [this] { return page_.isShown() && work_.document.hasCopiedParts(); }},
      {"selectAllParts",
       "editMenu",
       0,
       QT_TRANSLATE_NOOP("Commands", "Select &all"),
       QT_TRANSLATE_NOOP("Commands", "Selects all parts, to copy or to remove them"),
       {QKeySequence::SelectAll},
       [this] { list_->selectAll(); },
       [this] { return page_.isShown() && work_.document.partCount() > 1; }}};
}

// In the tree, which may be in a closed dock.
void PartsView::editName() {
  for (QWidget* around = &work_.tree; around; around = around->parentWidget())
    if (auto* dock = qobject_cast<QDockWidget*>(around)) {
      dock->show();
      dock->raise();
      break;
    }
  work_.tree.editPartName(
      QFileInfo(QString::fromStdString(work_.document.source()->name)).completeBaseName());
}

std::vector<std::size_t> PartsView::selected() const {
  return work_.document.partCount() > 1 ? list_->selection()
                                        : std::vector<std::size_t>{work_.document.active()};
}

void PartsView::chooseCopies() {
  auto* dialog = new CopiesDialog(work_.document.copiesOfActive(), work_.viewport.window());
  connect(dialog, &CopiesDialog::chosen, this, &PartsView::makeCopies);
  dialog->open();
}

// The window's thread does not search for places.
void PartsView::makeCopies(std::optional<std::size_t> count) {
  const std::uint64_t revision = work_.document.revision();
  work_.shell.say(tr("Arranging the copies…"));
  using Made = pipeline::PlanRequest;
  runner_.run(
      [request = work_.document.request(project::Stage::Load), item = work_.document.active(),
       count](const base::RunContext& ctx) {
        return pipeline::withCopies(request, item, count, ctx);
      },
      [this, revision](base::Outcome<Made> made) {
        work_.shell.say({});
        if (const auto* error = std::get_if<base::Error>(&made))
          work_.shell.showMessage(tr("Number of copies"), language::words(error->whole()));
        else if (const auto* copies = std::get_if<Made>(&made);
                 copies && work_.document.revision() == revision) // Not edited meanwhile
          takeCopies(*copies);
      },
      1); // Planning uses the other threads
}

void PartsView::takeCopies(const pipeline::PlanRequest& made) {
  work_.document.setCopies(made);
  work_.shell.say(
      tr("%n copies on the plate", nullptr, static_cast<int>(work_.document.copiesOfActive())));
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
