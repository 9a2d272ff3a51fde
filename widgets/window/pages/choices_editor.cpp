#include "window/pages/choices_editor.h"

#include "base/data_files.h"
#include "curved/decompose.h"
#include "document/document.h"
#include "document/mode_switch.h"
#include "language/words.h"
#include "modes/mode_table.h"
#include "pipeline/search_texts.h"
#include "pipeline/stage_options.h"
#include "process/own_materials.h"
#include "process/process.h"
#include "robot/cell.h"
#include "window/data_labels.h"
#include "window/library/library_dialog.h"
#include "window/quote/quote.h"

#include <QLocale>
#include <algorithm>

namespace voluta::window {

namespace {
constexpr const char* kAutomatic = "auto"; // Entry in the list of modes

QString named(const std::string& text) {
  return QString::fromStdString(text);
}

forms::ChoiceItem item(std::string_view id, base::Text label = {}, base::Text help = {}) {
  const QString name = QString::fromUtf8(id.data(), static_cast<qsizetype>(id.size()));
  return {name, label.empty() ? name : language::words(label), language::words(help)};
}

// Returns whether an error is about parts that do not go together; one of a parameter names it.
bool concernsTheJob(const base::Error* error) {
  const auto* parameter = error ? std::get_if<std::string>(&error->context().data()) : nullptr;
  return error && (!parameter || parameter->empty());
}

// Returns the name of a choice for undo.
QString editNameOf(const QString& field) {
  if (field == "growth")
    return ChoicesEditor::tr("growth");
  if (field == "platform")
    return ChoicesEditor::tr("platform");
  if (field == "cell")
    return ChoicesEditor::tr("cell");
  if (field == "process")
    return ChoicesEditor::tr("process");
  if (field == "material")
    return ChoicesEditor::tr("material");
  return ChoicesEditor::tr("seed");
}

// Describes the differences of `to` from `from`.
QString changesOf(const project::Choices& from, const project::Choices& to) {
  QStringList parts;
  if (to.cell != from.cell)
    parts << ChoicesEditor::tr("cell %1").arg(cellLabel(to.cell));
  if (to.item().platform != from.item().platform)
    parts << ChoicesEditor::tr("platform %1").arg(language::words(to.item().platform.shown()));
  if (to.tool().process != from.tool().process)
    parts << ChoicesEditor::tr("process %1").arg(processLabel(to.tool().process));
  if (to.item().scale != from.item().scale)
    parts << ChoicesEditor::tr("scale %1").arg(named(to.item().scale));
  if (to.item().parameters != from.item().parameters)
    parts << ChoicesEditor::tr("the part's orientation unchanged");
  return parts.join(QStringLiteral(", "));
}

// Returns e.g. "1.27 g/cm³, nozzle 240 °C, plate 80 °C, fan 50 %, $24.00/kg".
QString materialFacts(const process::Material& m) {
  const QLocale locale;
  QStringList facts{ChoicesEditor::tr("%1 g/cm³").arg(locale.toString(m.densityGPerCm3))};
  if (m.nozzleC)
    facts << ChoicesEditor::tr("nozzle %1 °C").arg(*m.nozzleC);
  if (m.bedC)
    facts << ChoicesEditor::tr("plate %1 °C").arg(*m.bedC);
  facts << ChoicesEditor::tr("fan %1 %").arg(qRound(100.0 * m.fan));
  if (m.maxFlowMm3PerS)
    facts << ChoicesEditor::tr("up to %1 mm³/s").arg(locale.toString(*m.maxFlowMm3PerS));
  if (m.pricePerKg > 0.0)
    facts << ChoicesEditor::tr("%1/kg").arg(moneyText(m.pricePerKg));
  if (!m.notes.empty())
    facts << named(m.notes);
  return facts.join(QStringLiteral(", "));
}

bool wantsBody(const project::Choices& choices) {
  return modes::findMode(choices.item().mode).platforms.front() == project::PlatformUse::Body &&
         !choices.item().platform.isBody();
}

// Adds the material of a process, if that can be read: the run reports what is wrong with it.
void showMaterial(const std::string& process, forms::ChoiceTexts& texts) {
  try {
    const process::Material m = process::loadProcess(process).material;
    texts.material = named(m.id);
    texts.materialColour = named(m.colour);
    texts.materialFacts = materialFacts(m);
  } catch (const base::Error&) {
    texts.materialFacts.clear();
  }
}

forms::ToolTexts toolTexts(const std::string& process) {
  forms::ToolTexts texts{named(process), {}};
  try {
    const process::Material m = process::loadProcess(process).material;
    texts.material = named(m.id);
    texts.colour = named(m.colour);
  } catch (const base::Error&) {
    return texts; // The run reports what is wrong with it
  }
  return texts;
}

// Returns the process unchanged if it or the material cannot be read.
std::string withMaterial(const std::string& process, const std::string& material) {
  try {
    return process::processTextWith(process, material);
  } catch (const base::Error&) {
    return process;
  }
}

// Returns the choice that the job stores for a process of the list: the text of an own one, so that
// the project needs no file of the user's; unchanged if it cannot be read.
std::string storedProcess(const std::string& id) {
  try {
    return base::isDataText(id)
               ? id
               : process::jobChoice(process::loadItem(process::Shelf::Processes, id));
  } catch (const base::Error&) {
    return id;
  }
}

// Returns the entry of the list that a job's process is: the id of an own one that is still the
// same, else unchanged.
std::string listedProcess(const std::string& choice) {
  if (!base::isDataText(choice))
    return choice;
  const std::string id = base::dataName(choice);
  const std::vector<std::string> ids = process::processIds();
  return std::ranges::find(ids, id) != ids.end() && storedProcess(id) == choice ? id : choice;
}

// As typed; the run reports values that cannot be parsed.
forms::RodProfile rodProfileOf(const project::Choices& choices) {
  const auto text = [&](const char* key) {
    const auto at = choices.item().parameters.find(key);
    return at == choices.item().parameters.end() ? QString() : QString::fromStdString(at->second);
  };
  return {text("rodSides").toInt(), text("rodProfile")};
}
} // namespace

forms::ChoiceLists choiceLists() {
  forms::ChoiceLists lists;
  for (const modes::Mode& mode : modes::modeTable()) {
    lists.modes.push_back(item(mode.id, mode.label));
    lists.platforms[lists.modes.back().id] = mode.platforms;
  }
  for (const curved::GrowthScheme& growth : curved::growthSchemes())
    lists.growths.push_back(item(growth.id(), growth.row().label, growth.row().help));
  lists.cells = labelledItems(robot::cellIds(), cellLabel);
  lists.processes = labelledItems(process::processIds(), processLabel);
  lists.materials = labelledItems(process::materialIds(), materialLabel);
  return lists;
}

ChoicesEditor::ChoicesEditor(document::Document& document, QObject* parent)
    : QObject(parent), document_(document), form_(new forms::ChoicesForm) {
  form_->setObjectName("choices");
  connect(form_, &forms::ChoicesForm::changed, this, &ChoicesEditor::change);
  connectTools();
  connect(&document_, &document::Document::stateChanged, this, [this] {
    if (document_.choices().item().automatic && !document_.unusable())
      form_->setNotice(chosenStrategy(), {}, false); // Called often, so no file is read here
  });
  connect(form_, &forms::ChoicesForm::noticePressed, this, &ChoicesEditor::pressNotice);
  connect(form_, &forms::ChoicesForm::rodProfileChanged, this, &ChoicesEditor::changeRod);
  connect(form_, &forms::ChoicesForm::libraryRequested, this, [this](const QString& field) {
    openLibrary(field == "process" ? process::Shelf::Processes : process::Shelf::Materials);
  });
}

void ChoicesEditor::retranslate() {
  forms::ChoiceLists lists = choiceLists();
  const QString automatic = QString::fromLatin1(kAutomatic);
  lists.modes.insert(lists.modes.begin(),
                     {automatic, tr("Automatic"),
                      tr("The first way of building and platform without blocking findings.")});
  lists.platforms[automatic] = {project::PlatformUse::Plate, project::PlatformUse::Rod,
                                project::PlatformUse::Body};
  form_->setLists(lists);
  show();
}

void ChoicesEditor::show() {
  const project::Choices& c = document_.choices();
  forms::ChoiceTexts texts{c.item().automatic ? QString::fromLatin1(kAutomatic)
                                              : named(c.item().mode),
                           named(c.item().growth.id()),
                           named(c.item().platform.text()),
                           named(c.cell),
                           named(listedProcess(c.tool().process)),
                           c.seed,
                           rodProfileOf(c)};
  if (base::isDataText(c.cell))
    texts.cellLabel = cellLabel(c.cell);
  if (base::isDataText(texts.process.toStdString()))
    texts.processLabel =
        tr("%1 (%2)").arg(processLabel(c.tool().process), named(base::dataName(c.tool().process)));
  showMaterial(c.tool().process, texts);
  for (std::size_t i = 1; i < c.tools.size(); ++i)
    texts.moreTools.push_back(toolTexts(c.tool(i).process));
  form_->setTexts(texts);
  form_->setGrows(modes::findMode(c.item().mode).grows);
  showNotice();
}

void ChoicesEditor::change(const QString& field, const QString& text) {
  project::Choices c = document_.choices();
  const std::string value = text.toStdString();
  if (field == "mode") {
    if (value == kAutomatic)
      document_.setChoices(modeSwitch_.automatic(c), tr("way of building"));
    else
      switchMode(value);
    return;
  }
  if (field == "growth") {
    c.item().growth = curved::GrowthScheme(value);
  } else if (field == "platform") {
    c.item().platform = project::Platform(value);
    c.item().platformStays = c.item().automatic;
  } else if (field == "cell") {
    c.cell = value;
  } else if (field == "process") {
    c.tool().process = storedProcess(value);
  } else if (field == "material") {
    c.tool().process = withMaterial(c.tool().process, value);
  } else if (field == "seed") {
    c.seed = text.toInt();
  }
  document_.setChoices(c, editNameOf(field));
}

void ChoicesEditor::openLibrary(process::Shelf shelf) {
  LibraryDialog dialog(document_.choices().tool().process, shelf, form_->window());
  connect(&dialog, &LibraryDialog::useRequested, this,
          [this, &dialog](process::Shelf of, const QString& choice) {
            change(of == process::Shelf::Processes ? "process" : "material", choice);
            dialog.setJobProcess(document_.choices().tool().process);
          });
  dialog.exec();
  if (dialog.libraryChanged())
    retranslate(); // there are other entries to choose
}

void ChoicesEditor::connectTools() {
  const forms::ToolRows* rows = form_->tools();
  const auto edit = [this](const QString& name, auto&& change) {
    project::Choices c = document_.jobChoices();
    change(c);
    document_.setJobChoices(c, name);
  };
  connect(rows, &forms::ToolRows::addRequested, this, [edit] {
    edit(tr("tool added"), [](project::Choices& c) { c.tools.push_back(c.tools.back()); });
  });
  connect(rows, &forms::ToolRows::removeRequested, this, [edit](int tool) {
    edit(tr("tool removed"),
         [tool](project::Choices& c) { pipeline::removeTool(c, static_cast<std::size_t>(tool)); });
  });
  connect(rows, &forms::ToolRows::processChosen, this, [edit](int tool, const QString& id) {
    edit(tr("process"), [&](project::Choices& c) {
      c.tool(static_cast<std::size_t>(tool)).process = id.toStdString();
    });
  });
  connect(rows, &forms::ToolRows::materialChosen, this, [edit](int tool, const QString& id) {
    edit(tr("material"), [&](project::Choices& c) {
      std::string& process = c.tool(static_cast<std::size_t>(tool)).process;
      process = withMaterial(process, id.toStdString());
    });
  });
}

void ChoicesEditor::changeRod(const forms::RodProfile& profile) {
  project::Choices c = document_.choices();
  c.item().parameters.erase("rodSides");
  c.item().parameters.erase("rodProfile");
  if (profile.sides > 0)
    c.item().parameters["rodSides"] = std::to_string(profile.sides);
  if (!profile.points.isEmpty())
    c.item().parameters["rodProfile"] = profile.points.toStdString();
  document_.setChoices(c, tr("rod shape"));
}

void ChoicesEditor::switchMode(const std::string& mode) {
  const project::Choices before = document_.choices();
  const project::Choices now = modeSwitch_.switched(before, mode);
  wentAlong_ = {mode, changesOf(before, now)};
  document_.setChoices(now, tr("way of building"));
  showNotice();
}

void ChoicesEditor::showNotice() {
  const project::Choices& choices = document_.choices();
  if (const QString obstacle = document::obstacle(choices); !obstacle.isEmpty()) {
    const project::Choices mended = document::fitting(choices);
    const QString changes = changesOf(choices, mended);
    form_->setNotice(obstacle,
                     document::bodyIsMissing(choices) ? tr("Choose the file…")
                     : changes.isEmpty()              ? QString()
                                                      : tr("Use %1").arg(changes),
                     true);
  } else if (document_.partCount() > 1 && concernsTheJob(document_.unusable())) {
    form_->setNotice(language::words(document_.unusable()->whole()), {}, true);
  } else if (choices.item().automatic) {
    form_->setNotice(chosenStrategy(), {}, false);
  } else if (wantsBody(choices)) {
    form_->setNotice(tr("Which body is printed on? If none is chosen, the plate."),
                     tr("Choose the body…"), false);
  } else if (wentAlong_.first == choices.item().mode && !wentAlong_.second.isEmpty()) {
    form_->setNotice(tr("Changed with it: %1.").arg(wentAlong_.second), {}, false);
  } else {
    form_->setNotice({}, {}, false);
  }
}

QString ChoicesEditor::chosenStrategy() const {
  const auto result = document_.lastResult();
  if (!result)
    return {};
  const project::ItemReport& item = result->job.report.item(document_.active());
  if (item.tried.empty())
    return {};
  QStringList lines{language::words(pipeline::chosenText(item)) + u'.'};
  for (const base::Message& rejected : pipeline::rejectedTexts(item))
    lines << tr("Rejected: %1.").arg(language::words(rejected));
  return lines.join(u'\n');
}

void ChoicesEditor::pressNotice() {
  const project::Choices& choices = document_.choices();
  if (document::bodyIsMissing(choices) || wantsBody(choices))
    form_->choosePlatformFile();
  else
    document_.setChoices(document::fitting(choices), tr("choices that fit the way of building"));
}

} // namespace voluta::window
