// Imports a robot arm from a URDF: shows the file's contents and lets the user choose the flange
// link, the name and the kind of cell to create.
#pragma once

#include "base/error.h"
#include "cells/arm_import.h"
#include "jobs/job_runner.h"

#include <QDialog>
#include <QString>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class QComboBox;
class QDialogButtonBox;
class QLineEdit;
class QPlainTextEdit;
class QProgressBar;
class QPushButton;

namespace voluta::window {

class ArmImportDialog : public QDialog {
  Q_OBJECT

public:
  // Reads the file at once, before the dialog is shown. Files are written to `folder` (robots/ and
  // cells/).
  ArmImportDialog(const QString& urdf, const QString& folder, QWidget* parent = nullptr);

  // The id of the cell that was written; empty until the dialog is accepted.
  const QString& cell() const { return cell_; }

private:
  // One reading of the file: the options to choose from, and the result of the current choice
  struct Look;
  void look();
  void show(const Look& look);
  void import();
  using Import = std::shared_ptr<const cells::ArmImport>;
  using Files = std::vector<std::filesystem::path>;
  bool mayReplace(const Files& files);
  void proposeName();
  void write(const Import& import);
  void setBusy(bool busy);
  robot::UrdfOptions options() const;

  QString urdf_, folder_, cell_;
  QComboBox *tip_, *kind_, *format_;
  QLineEdit* name_;
  QPlainTextEdit* found_;
  QProgressBar* progress_;
  QPushButton* import_;
  jobs::JobRunner* runner_;
  bool usable_ = false;
};

} // namespace voluta::window
