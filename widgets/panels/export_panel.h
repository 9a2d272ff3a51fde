// Export of programs: formats, verdict of the replay, files, text, one button.
#pragma once

#include "panels/format_list.h"

#include <QWidget>
#include <map>
#include <optional>
#include <string>
#include <vector>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QScrollArea;

namespace voluta::panels {

class OptionsForm;
class ProgramFacts;
class ResumeBar;
class TextPreview;
class VerdictTable;
class WrittenBar;

class ExportPanel : public QWidget {
  Q_OBJECT

public:
  explicit ExportPanel(QWidget* parent = nullptr);

  // None of these emits.
  void setFormats(std::vector<ExportFormat> formats);
  void setChecked(const QStringList& ids);
  // Options of the formats that were changed, as texts by key.
  void setOptions(const std::map<std::string, std::string>& changed);
  void setFolder(const QString& folder);
  // Reason why nothing can be exported, as one line beside the button; empty if export is possible.
  void setBlockedReason(const QString& reason);
  // Highlights a line of the shown text, synchronised with the time-line: file as an index, line
  // 1-based (0: none).
  void showLine(std::size_t file, std::size_t line);
  // Place where the print can be resumed at the highlighted line; empty: nowhere.
  void setResumePlace(const QString& place);
  // One line on the files that the last export wrote; empty: none.
  void setWritten(const QString& text, bool hasProof);
  // Returns the highlighted line, 1-based; 0: none.
  std::size_t currentLine() const;
  int currentFile() const;
  // Returns the format whose text and verdict are shown; empty: none.
  QString previewFormat() const;

  QString folder() const;
  QStringList checkedFormats() const;

signals:
  void formatsChanged(const QStringList& ids);
  // includeRefused is true only if the user agreed to write refused programs. Formats without a
  // program may be included; they have to be planned first.
  void exportRequested(const QString& folder, const QStringList& formats, bool includeRefused);
  void previewFormatChanged(const QString& id);
  // `text` is parsed by base::parseParameter.
  void optionChanged(const QString& key, const QString& text);
  void optionResetRequested(const QString& key);
  void folderChanged(const QString& folder);
  void resumeAsked();
  void openProofRequested();
  void showFolderRequested();
  // `file` an index, `line` 1-based.
  void lineClicked(int file, qulonglong line);

protected:
  void changeEvent(QEvent* event) override;

private:
  void build();
  void showFormat(const QString& id);
  void showFile(int index);
  void showFileNames(const QStringList& names);
  void showButton();
  void browse();
  void exportNow();
  std::vector<const ExportFormat*> checkedIn(VerdictState state) const;
  // Ask only if there are such programs.
  bool mayExportBlocked();
  // Returns whether to write the refused programs too; nullopt: nothing at all.
  std::optional<bool> mayExportRefused();
  const ExportFormat* find(const QString& id) const;
  void retranslate();

  std::vector<ExportFormat> formats_;
  std::map<std::string, std::string> options_;
  QString blockedReason_;
  QLabel* formatsTitle_ = nullptr;
  FormatList* list_ = nullptr;
  QLabel* whyNot_ = nullptr;
  QScrollArea* upper_ = nullptr;
  QLabel* optionsTitle_ = nullptr;
  OptionsForm* optionsForm_ = nullptr;
  QLabel* verdictTitle_ = nullptr;
  VerdictTable* verdict_ = nullptr;
  ProgramFacts* facts_ = nullptr;
  QLabel* fileLabel_ = nullptr;
  QComboBox* file_ = nullptr;
  int fileCount_ = 0; // rows of file_ that show a file
  TextPreview* preview_ = nullptr;
  ResumeBar* resume_ = nullptr;
  QLabel* folderLabel_ = nullptr;
  QLineEdit* folder_ = nullptr;
  QPushButton* browse_ = nullptr;
  QLabel* reason_ = nullptr;
  QPushButton* export_ = nullptr;
  WrittenBar* written_ = nullptr;
};

} // namespace voluta::panels
