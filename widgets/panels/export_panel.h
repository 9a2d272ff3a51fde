// Programs to hand over: formats, verdict of the replay, files, text, one button.
#pragma once

#include "panels/format_list.h"

#include <QWidget>
#include <map>
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
  // Of the formats' options, texts by key of what was changed.
  void setOptions(const std::map<std::string, std::string>& changed);
  void setFolder(const QString& folder);
  // Why nothing can be exported, one line beside the button; empty: it can.
  void setBlockedReason(const QString& reason);
  // Sets off a line of the text in sight, in step with the time-line: file as an index, line
  // 1-based (0: none).
  void showLine(std::size_t file, std::size_t line);
  // Where the print could be taken up at the line that is set off; empty: nowhere.
  void setResumePlace(const QString& place);
  // What the last export wrote, a line; empty: nothing to show.
  void setWritten(const QString& text, bool hasProof);
  // The line that is set off, 1-based; 0: none.
  std::size_t currentLine() const;
  int currentFile() const;
  // The format whose text and verdict are shown; empty: none.
  QString previewFormat() const;

  QString folder() const;
  QStringList checkedFormats() const;

signals:
  void formatsChanged(const QStringList& ids);
  // The user's word on refused programs was asked for: includeRefused is true only after a yes.
  // Formats without a program yet are among them; they are to be planned first.
  void exportRequested(const QString& folder, const QStringList& formats, bool includeRefused);
  void previewFormatChanged(const QString& id);
  // `text` is what base::parseParameter takes.
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
  void showButton();
  void browse();
  void exportNow();
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
