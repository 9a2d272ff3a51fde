// The preset of the document: chooses, saves, renames, deletes, compares, exports and imports
// presets. A choice, a save, a new name and a deletion are edits of the document, which undo takes
// back; files stay.
#pragma once

#include "pipeline/presets/chosen_preset.h"
#include "window/presets/preset_bar.h"

#include <QObject>
#include <QString>
#include <functional>
#include <string>
#include <vector>

namespace voluta::base {
class ParameterTable;
}
namespace voluta::document {
class Document;
}

namespace voluta::window {

class PresetEditor : public QObject {
  Q_OBJECT

public:
  // The document must outlive this.
  PresetEditor(document::Document& document, QObject* parent);

  // Created here, to be placed by the caller.
  PresetBar* bar() { return bar_; }
  void show();
  // The settings of the job's preset, with those of its parents; none if it cannot be read.
  const pipeline::Settings& settings() const { return settings_; }

private:
  // A preset with a file; one that cannot be read has no choice.
  struct Listed {
    pipeline::PrintPreset preset;
    std::string choice; // As the job stores it
    QString problem;
  };
  static Listed listed(const std::string& id);
  static void addChildren(const std::vector<Listed>& kind, const std::string& parent, int depth,
                          std::vector<PresetEntry>& entries);
  static void addKind(std::vector<Listed> kind, const QString& heading,
                      std::vector<PresetEntry>& entries);

  void reload(); // reads all files
  bool canDo(PresetDeed deed) const;
  void perform(PresetDeed deed);
  void choose(const QString& choice);
  void save();
  void saveAs();
  void rename();
  void remove();
  void discard();
  void compare();
  void exportFile();
  void importFile();

  // The job's preset as its file has it; without a file as the job stores it.
  pipeline::PrintPreset present() const;
  // The entry that is the job's preset; null: the list has none, or another with its id.
  const Listed* chosen() const;
  bool isOwn() const;
  std::vector<PresetEntry> entries() const;
  // Settings of each part that differ from the job's preset.
  std::vector<std::vector<pipeline::SettingDifference>> changes() const;
  // Asks about changes before another preset is chosen. Returns false to keep the preset, else the
  // settings that stay in `kept`.
  bool askAboutChanges(const QString& label, std::vector<pipeline::Settings>& kept);
  QString proposedName(const std::string& label) const;
  void store(const pipeline::PrintPreset& preset, const QString& editName);
  // Runs work that reads or writes files; shows an error in a box. Returns whether it succeeded.
  bool tried(const std::function<void()>& work);

  document::Document& document_;
  PresetBar* bar_;
  std::vector<Listed> listed_;
  std::string settingsOf_; // The preset of settings_
  pipeline::Settings settings_;
  bool isChanged_ = false;
};

} // namespace voluta::window
