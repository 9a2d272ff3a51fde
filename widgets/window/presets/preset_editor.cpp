#include "window/presets/preset_editor.h"

#include "base/error.h"
#include "base/files.h"
#include "document/document.h"
#include "document/mode_switch.h"
#include "forms/save_file.h"
#include "language/parameter_texts.h"
#include "language/words.h"
#include "pipeline/stage_options.h"
#include "window/presets/compare_presets_dialog.h"
#include "window/presets/preset_name_dialog.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <algorithm>

namespace voluta::window {

using pipeline::PrintPreset;
using pipeline::SettingDifference;
using pipeline::Settings;

namespace {
constexpr std::size_t kShownChanges = 8;

QString named(const std::string& text) {
  return QString::fromStdString(text);
}

QString presetFilter() {
  return PresetEditor::tr("JSON files (*.json);;All files (*)");
}

Settings textsOf(const std::vector<SettingDifference>& changes) {
  Settings texts;
  for (const SettingDifference& change : changes)
    texts[change.spec.key] = base::formatParameter(change.second);
  return texts;
}
} // namespace

PresetEditor::PresetEditor(document::Document& document, QObject* parent)
    : QObject(parent), document_(document), bar_(new PresetBar) {
  bar_->setObjectName("presetBar");
  // The list may change by the choice, after its own signal.
  connect(bar_, &PresetBar::chosen, this, &PresetEditor::choose, Qt::QueuedConnection);
  connect(bar_, &PresetBar::asked, this, &PresetEditor::perform);
  reload();
}

PresetEditor::Listed PresetEditor::listed(const std::string& id) {
  try {
    const PrintPreset preset = pipeline::loadPreset(id);
    return {preset, pipeline::presetChoice(preset), {}};
  } catch (const base::Error& error) {
    return {{id, id, {}, {}}, {}, language::words(error.whole())};
  }
}

void PresetEditor::reload() {
  listed_.clear();
  for (const std::string& id : pipeline::presetIds())
    listed_.push_back(listed(id));
  settingsOf_.clear();
}

const PresetEditor::Listed* PresetEditor::chosen() const {
  const auto at = std::ranges::find(listed_, document_.jobChoices().preset, &Listed::choice);
  return at == listed_.end() ? nullptr : &*at;
}

PrintPreset PresetEditor::present() const {
  const Listed* entry = chosen();
  return entry ? entry->preset : pipeline::loadPreset(document_.jobChoices().preset);
}

bool PresetEditor::isOwn() const {
  const Listed* entry = chosen();
  return entry && !pipeline::presetComesWithProgram(entry->preset.id);
}

// Adds the presets of one kind below their parents of this kind.
void PresetEditor::addChildren(const std::vector<Listed>& kind, const std::string& parent,
                               int depth, std::vector<PresetEntry>& entries) {
  for (const Listed& one : kind) {
    const bool isRoot = std::ranges::none_of(
        kind, [&](const Listed& other) { return other.preset.id == one.preset.parent; });
    if (parent.empty() ? !isRoot : isRoot || one.preset.parent != parent)
      continue;
    entries.push_back({named(one.choice), named(one.preset.label), one.problem, depth});
    if (one.problem.isEmpty())
      addChildren(kind, one.preset.id, depth + 1, entries);
  }
}

void PresetEditor::addKind(std::vector<Listed> kind, const QString& heading,
                           std::vector<PresetEntry>& entries) {
  if (kind.empty())
    return;
  std::ranges::sort(kind, [](const Listed& a, const Listed& b) {
    const int order = QString::localeAwareCompare(named(a.preset.label), named(b.preset.label));
    return order != 0 ? order < 0 : a.preset.id < b.preset.id;
  });
  entries.push_back({{}, heading, {}, 0});
  addChildren(kind, {}, 1, entries);
}

std::vector<PresetEntry> PresetEditor::entries() const {
  std::vector<Listed> factory, own;
  for (const Listed& one : listed_)
    (pipeline::presetComesWithProgram(one.preset.id) ? factory : own).push_back(one);
  std::vector<PresetEntry> all;
  const std::string& choice = document_.jobChoices().preset;
  if (!chosen()) {
    QString label = named(choice), about;
    try {
      label = named(pipeline::loadPreset(choice).label);
    } catch (const base::Error& error) {
      about = language::words(error.whole());
    }
    all.push_back({{}, tr("In this project"), {}, 0});
    all.push_back({named(choice), label, about, 1});
  }
  addKind(std::move(factory), tr("With the program"), all);
  addKind(std::move(own), tr("Your own"), all);
  return all;
}

std::vector<std::vector<SettingDifference>> PresetEditor::changes() const {
  const project::Choices& job = document_.jobChoices();
  std::vector<std::vector<SettingDifference>> all;
  for (std::size_t i = 0; i < job.items.size(); ++i) {
    const project::ItemChoices& item = job.item(i);
    // Copies have the same.
    std::size_t like = 0;
    while (like < i &&
           !(job.item(like).parameters == item.parameters && job.item(like).mode == item.mode &&
             job.item(like).automatic == item.automatic &&
             job.item(like).automaticStrategy == item.automaticStrategy))
      ++like;
    const project::Choices one = project::onlyItem(job, i);
    all.push_back(like < i ? all[like]
                           : pipeline::settingDifferences(settings_, pipeline::givenParameters(one),
                                                          document::parametersFor(one)));
  }
  return all;
}

void PresetEditor::show() {
  const project::Choices& job = document_.jobChoices();
  if (settingsOf_ != job.preset) {
    settingsOf_ = job.preset;
    settings_ = pipeline::settingsOfPreset(job);
  }
  const auto changed = changes();
  isChanged_ = std::ranges::any_of(changed, [](const auto& ofPart) { return !ofPart.empty(); });
  bar_->showPresets(entries(), named(job.preset), isChanged_);
  for (const PresetDeed deed :
       {PresetDeed::Save, PresetDeed::SaveAs, PresetDeed::Rename, PresetDeed::Delete,
        PresetDeed::Discard, PresetDeed::Compare, PresetDeed::Export, PresetDeed::Import})
    bar_->setPossible(deed, canDo(deed));
}

bool PresetEditor::canDo(PresetDeed deed) const {
  switch (deed) {
  case PresetDeed::Save:
    return isOwn() && isChanged_;
  case PresetDeed::Discard:
    return isChanged_;
  case PresetDeed::Rename:
  case PresetDeed::Delete:
    return isOwn();
  default:
    return true;
  }
}

void PresetEditor::perform(PresetDeed deed) {
  reload();
  show();
  if (!canDo(deed))
    return; // files have changed since the menu was shown
  switch (deed) {
  case PresetDeed::Save:
    save();
    break;
  case PresetDeed::SaveAs:
    saveAs();
    break;
  case PresetDeed::Rename:
    rename();
    break;
  case PresetDeed::Delete:
    remove();
    break;
  case PresetDeed::Discard:
    discard();
    break;
  case PresetDeed::Compare:
    compare();
    break;
  case PresetDeed::Export:
    exportFile();
    break;
  case PresetDeed::Import:
    importFile();
    break;
  }
  reload();
  show();
}

bool PresetEditor::tried(const std::function<void()>& work) {
  try {
    work();
    return true;
  } catch (const base::Error& error) {
    QMessageBox box(QMessageBox::Warning, tr("Presets"), language::words(error.whole()),
                    QMessageBox::Ok, bar_->window());
    box.setObjectName("presetProblem");
    box.exec();
    return false;
  }
}

bool PresetEditor::askAboutChanges(const QString& label, std::vector<Settings>& kept) {
  const std::vector<std::vector<SettingDifference>> changed = changes();
  QStringList lines;
  for (const auto& ofPart : changed)
    for (const SettingDifference& one : ofPart) {
      const QString line =
          tr("%1: %2 instead of %3")
              .arg(language::heading(one.spec.label), language::valueText(one.spec, one.second),
                   language::valueText(one.spec, one.first));
      if (!lines.contains(line))
        lines << line;
    }
  if (lines.isEmpty())
    return true;
  if (const auto more = lines.size() - static_cast<qsizetype>(kShownChanges); more > 0) {
    lines.resize(kShownChanges);
    lines << tr("and %n more", nullptr, static_cast<int>(more));
  }
  QMessageBox box(QMessageBox::Question, tr("Change preset"),
                  tr("Settings of the preset were changed. Take the changes to %1?").arg(label),
                  QMessageBox::NoButton, bar_->window());
  box.setObjectName("presetChanges");
  box.setInformativeText(lines.join(u'\n'));
  const QPushButton* transfer = box.addButton(tr("&Transfer"), QMessageBox::AcceptRole);
  const QPushButton* discarded = box.addButton(tr("&Discard"), QMessageBox::DestructiveRole);
  QPushButton* keep = box.addButton(tr("&Keep this preset"), QMessageBox::RejectRole);
  box.setEscapeButton(keep);
  box.exec();
  if (box.clickedButton() == transfer)
    for (const auto& ofPart : changed)
      kept.push_back(textsOf(ofPart));
  return box.clickedButton() == transfer || box.clickedButton() == discarded;
}

void PresetEditor::choose(const QString& choice) {
  tried([&] {
    const QString label = named(pipeline::loadPreset(choice.toStdString()).label);
    std::vector<Settings> kept;
    if (askAboutChanges(label, kept))
      document_.setJobChoices(
          pipeline::withPreset(document_.jobChoices(), choice.toStdString(), kept),
          tr("Preset %1").arg(label));
  });
  show();
}

void PresetEditor::store(const PrintPreset& preset, const QString& editName) {
  pipeline::saveOwnPreset(preset);
  reload();
  project::Choices choices = document_.jobChoices();
  choices.preset = pipeline::presetChoice(preset);
  document_.setJobChoices(choices, editName);
}

void PresetEditor::save() {
  tried([&] {
    const project::Choices& choices = document_.choices();
    const PrintPreset own = present();
    store(pipeline::presetWith(pipeline::givenParameters(choices), document::parametersFor(choices),
                               own, own.id, own.label),
          tr("Save preset %1").arg(named(own.label)));
  });
}

// Returns a name that no preset has.
QString PresetEditor::proposedName(const std::string& label) const {
  const QString stem = tr("%1, own").arg(named(label));
  QString name = stem;
  for (int count = 2;
       std::ranges::any_of(listed_,
                           [&](const Listed& one) {
                             return named(one.preset.label).compare(name, Qt::CaseInsensitive) == 0;
                           });
       ++count)
    name = stem + u' ' + QString::number(count);
  return name;
}

void PresetEditor::saveAs() {
  tried([&] {
    PrintPreset base = present();
    PresetNameDialog dialog(tr("Save preset as"), proposedName(base.label), {}, bar_->window());
    if (dialog.exec() != QDialog::Accepted)
      return;
    const std::string label = dialog.name().toStdString();
    const std::string id = pipeline::freePresetId(label);
    if (!chosen()) {
      base.id = id; // there is no file that could be its parent
      base.label = label;
    }
    const project::Choices& choices = document_.choices();
    store(pipeline::presetWith(pipeline::givenParameters(choices), document::parametersFor(choices),
                               base, id, label),
          tr("Save preset %1").arg(named(label)));
  });
}

void PresetEditor::rename() {
  tried([&] {
    PrintPreset preset = present();
    PresetNameDialog dialog(tr("Rename preset"), named(preset.label), preset.id, bar_->window());
    if (dialog.exec() != QDialog::Accepted)
      return;
    preset.label = dialog.name().toStdString();
    store(preset, tr("Rename preset %1").arg(named(preset.label)));
  });
}

void PresetEditor::remove() {
  tried([&] {
    const PrintPreset preset = present();
    const QString label = named(preset.label);
    if (QMessageBox::question(
            bar_->window(), tr("Delete preset"),
            tr("Delete the preset %1? The settings of this project stay.").arg(label)) !=
        QMessageBox::Yes)
      return;
    project::Choices choices = document_.jobChoices();
    choices.preset = preset.parent.empty()
                         ? project::Choices().preset
                         : pipeline::presetChoice(pipeline::loadPreset(preset.parent));
    pipeline::removeOwnPreset(preset.id);
    reload();
    document_.setJobChoices(choices, tr("Delete preset %1").arg(label));
  });
}

void PresetEditor::discard() {
  tried([&] {
    const project::Choices& choices = document_.jobChoices();
    document_.setJobChoices(pipeline::withPreset(choices, choices.preset),
                            tr("Discard changes of the preset"));
  });
}

void PresetEditor::compare() {
  const project::Choices& choices = document_.choices();
  std::vector<ComparedSettings> compared{
      {tr("Present settings"), pipeline::givenParameters(choices)}};
  int second = 0;
  const auto add = [&](const PrintPreset& preset, bool isPresent) {
    try {
      compared.push_back({named(preset.label), pipeline::presetSettings(preset)});
      if (isPresent)
        second = static_cast<int>(compared.size()) - 1;
    } catch (const base::Error&) {
      // The list states why it cannot be read.
    }
  };
  for (const Listed& one : listed_)
    if (one.problem.isEmpty())
      add(one.preset, one.choice == choices.preset);
  if (!chosen())
    tried([&] { add(present(), true); });
  ComparePresetsDialog(std::move(compared), document::parametersFor(choices), 0, second,
                       bar_->window())
      .exec();
}

void PresetEditor::exportFile() {
  tried([&] {
    const PrintPreset preset = present();
    const QString folder = QSettings().value("open/folder").toString();
    const QString file =
        forms::saveFile(bar_->window(), tr("Export %1").arg(named(preset.label)),
                        folder + u'/' + named(preset.id) + QStringLiteral(".json"), presetFilter());
    if (file.isEmpty())
      return;
    // An own preset is exported with the settings of its own parents.
    const std::string choice = pipeline::presetChoice(preset);
    base::writeFile(file.toStdString(),
                    choice == preset.id ? pipeline::presetText(preset) : choice);
  });
}

void PresetEditor::importFile() {
  const QString folder = QSettings().value("open/folder").toString();
  const QString file =
      QFileDialog::getOpenFileName(bar_->window(), tr("Import a preset"), folder, presetFilter());
  if (file.isEmpty())
    return;
  QSettings().setValue("open/folder", QFileInfo(file).absolutePath());
  PrintPreset preset;
  if (!tried([&] { preset = pipeline::importablePreset(file.toStdString()); }))
    return;
  if (std::ranges::any_of(listed_, [&](const Listed& l) { return l.preset.id == preset.id; }) &&
      QMessageBox::question(bar_->window(), tr("Import a preset"),
                            tr("Replace your own preset %1?").arg(named(preset.label))) !=
          QMessageBox::Yes)
    return;
  std::string choice;
  if (!tried([&] {
        pipeline::saveOwnPreset(preset);
        choice = pipeline::presetChoice(preset);
      }))
    return;
  reload();
  if (choice != document_.jobChoices().preset)
    choose(named(choice));
}

} // namespace voluta::window
