#include "window/cell/arm_import_dialog.h"

#include "language/words.h"
#include "process/process.h"
#include "program/dialect.h"
#include "project/choices.h"
#include "robot/kinematics/chain_kinematics.h"
#include "robot/urdf/urdf_chain.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QRegularExpressionValidator>
#include <QVBoxLayout>
#include <utility>

namespace voluta::window {

struct ArmImportDialog::Look {
  std::vector<std::string> tips;
  std::string tip, id; // Choices in use
  std::vector<std::string> assumed;
  robot::ArmKind kind = robot::ArmKind::Other;
  std::optional<base::Error> error;
};

namespace {

constexpr int kSteps = 1000; // Of the progress bar

QString kindOf(robot::ArmKind kind) {
  switch (kind) {
  case robot::ArmKind::SphericalWrist:
    return ArmImportDialog::tr("Six axes with a spherical wrist, solved in closed form");
  case robot::ArmKind::ParallelAxes:
    return ArmImportDialog::tr("Six axes, 2 to 4 parallel, solved in closed form");
  case robot::ArmKind::BentWrist:
    return ArmImportDialog::tr("Six axes with an offset wrist, solved by a search");
  case robot::ArmKind::Other:
    break;
  }
  return ArmImportDialog::tr("Six axes, solved numerically: plans take longer");
}

} // namespace

ArmImportDialog::ArmImportDialog(const QString& urdf, const QString& folder, QWidget* parent)
    : QDialog(parent), urdf_(urdf), folder_(folder), tip_(new QComboBox(this)),
      kind_(new QComboBox(this)), format_(new QComboBox(this)), name_(new QLineEdit(this)),
      found_(new QPlainTextEdit(this)), progress_(new QProgressBar(this)), import_(nullptr),
      runner_(new jobs::JobRunner(this)) {
  setObjectName("armImportDialog");
  setWindowTitle(tr("Import a robot arm"));
  tip_->setObjectName("armTip");
  kind_->setObjectName("armCell");
  kind_->addItem(tr("Nozzle on the arm, plate on a table"), int(robot::Mount::Flange));
  kind_->addItem(tr("Plate on the arm, nozzle fixed"), int(robot::Mount::World));
  format_->setObjectName("armFormat");
  for (const program::Dialect& dialect : program::dialects())
    format_->addItem(language::heading(dialect.label),
                     QString::fromStdString(std::string(dialect.id)));
  format_->setCurrentIndex(format_->findData(QStringLiteral("csv")));
  name_->setObjectName("armName");
  // The id becomes a file name and is typed on the command line.
  name_->setValidator(new QRegularExpressionValidator(
      QRegularExpression(QStringLiteral("[a-z0-9][a-z0-9._-]*")), name_));
  found_->setObjectName("armFound");
  found_->setAccessibleName(tr("Found in the file"));
  found_->setReadOnly(true);
  found_->setMinimumSize(60 * fontMetrics().averageCharWidth(), 12 * fontMetrics().height());
  progress_->setRange(0, kSteps);

  auto* form = new QFormLayout;
  form->addRow(tr("File"), new QLabel(QFileInfo(urdf).fileName(), this));
  form->addRow(tr("Flange"), tip_);
  form->addRow(tr("Name"), name_);
  form->addRow(tr("Cell"), kind_);
  form->addRow(tr("Programs"), format_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  import_ = buttons->addButton(tr("Import"), QDialogButtonBox::ActionRole);
  import_->setObjectName("armImport");
  import_->setDefault(true);
  auto* column = new QVBoxLayout(this);
  column->addLayout(form);
  column->addWidget(found_, 1);
  column->addWidget(progress_);
  column->addWidget(buttons);
  connect(import_, &QPushButton::clicked, this, &ArmImportDialog::import);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(tip_, &QComboBox::activated, this, &ArmImportDialog::look);
  connect(name_, &QLineEdit::textChanged, this, [this] { setBusy(runner_->running()); });
  connect(runner_, &jobs::JobRunner::progressed, this, [this](const jobs::Progress& progress) {
    progress_->setValue(static_cast<int>(kSteps * progress.fraction));
  });
  look();
}

robot::UrdfOptions ArmImportDialog::options() const {
  return {.tip = tip_->currentText().toStdString(),
          .base = {},
          .id = name_->text().toStdString(),
          .controller = format_->currentData().toString().toStdString()};
}

void ArmImportDialog::setBusy(bool busy) {
  progress_->setVisible(busy);
  for (QWidget* one : {static_cast<QWidget*>(tip_), static_cast<QWidget*>(kind_),
                       static_cast<QWidget*>(format_), static_cast<QWidget*>(name_)})
    one->setEnabled(!busy);
  import_->setEnabled(!busy && usable_ && name_->hasAcceptableInput());
}

void ArmImportDialog::look() {
  const std::filesystem::path file = urdf_.toStdString();
  const robot::UrdfOptions asked = options();
  usable_ = false;
  found_->setPlainText(tr("Reading…"));
  runner_->run(
      [file, asked](const base::RunContext&) {
        Look look;
        try {
          look.tips = robot::urdfTips(robot::readUrdfTree(file), file.filename().string());
          const robot::UrdfRobot robot = robot::readUrdf(file, asked);
          look.tip = robot.tip;
          look.id = robot.model.id;
          look.assumed = robot.model.assumed;
          look.kind = robot::ChainKinematics(robot.chain).kind();
        } catch (const base::Error& error) {
          look.error = error;
        }
        return look;
      },
      [this](const base::Outcome<Look>& outcome) {
        if (const auto* look = std::get_if<Look>(&outcome))
          show(*look);
      });
  setBusy(true);
}

void ArmImportDialog::show(const Look& look) {
  if (tip_->count() == 0) {
    for (const std::string& tip : look.tips)
      tip_->addItem(QString::fromStdString(tip));
    tip_->setCurrentIndex(tip_->findText(QString::fromStdString(look.tip)));
  }
  if (name_->text().isEmpty() && !look.id.empty())
    name_->setText(QString::fromStdString(look.id));
  QStringList lines;
  if (look.error) {
    lines << language::words(look.error->whole());
  } else {
    lines << kindOf(look.kind) << QString() << tr("Assumed:");
    for (const std::string& assumed : look.assumed)
      lines << QStringLiteral("• ") + QString::fromStdString(assumed);
  }
  found_->setPlainText(lines.join('\n'));
  usable_ = !look.error;
  setBusy(false);
}

void ArmImportDialog::import() {
  const std::filesystem::path file = urdf_.toStdString(), folder = folder_.toStdString();
  const robot::UrdfOptions asked = options();
  const auto mount = static_cast<robot::Mount>(kind_->currentData().toInt());
  runner_->run(
      [file, folder, asked, mount](const base::RunContext& ctx) {
        const process::Process process = process::loadProcess(project::Choices().tool().process);
        const auto import = std::make_shared<const cells::ArmImport>(
            cells::importArm(file, asked, mount, process, ctx));
        return std::pair(import, cells::conflictingFiles(*import, folder));
      },
      [this](const base::Outcome<std::pair<Import, Files>>& outcome) {
        setBusy(false);
        if (const auto* made = std::get_if<std::pair<Import, Files>>(&outcome)) {
          if (made->second.empty() || mayReplace(made->second))
            write(made->first);
          else
            proposeName();
        } else if (const auto* error = std::get_if<base::Error>(&outcome)) {
          found_->setPlainText(language::words(error->whole()));
        }
      });
  setBusy(true);
}

bool ArmImportDialog::mayReplace(const Files& files) {
  QStringList names;
  for (const std::filesystem::path& file : files)
    names << QString::fromStdString(file.string());
  QMessageBox box(QMessageBox::Warning, windowTitle(),
                  tr("An arm named %1 exists.").arg(name_->text()), QMessageBox::NoButton, this);
  box.setObjectName(QStringLiteral("replaceArmBox"));
  box.setInformativeText(
      tr("Replacing it loses the frames, obstacles and other changes in these files:") +
      QChar('\n') + names.join(QChar('\n')));
  const QPushButton* replace = box.addButton(tr("Replace"), QMessageBox::DestructiveRole);
  QPushButton* other = box.addButton(tr("Use another name"), QMessageBox::RejectRole);
  box.setDefaultButton(other);
  box.setEscapeButton(other);
  box.exec();
  return box.clickedButton() == replace;
}

void ArmImportDialog::proposeName() {
  const auto isTaken = [this](const QString& name) {
    const QDir folder(folder_);
    return folder.exists(QStringLiteral("robots/%1.json").arg(name)) ||
           folder.exists(QStringLiteral("cells/%1-moving.json").arg(name)) ||
           folder.exists(QStringLiteral("cells/%1-fixed.json").arg(name));
  };
  int number = 2;
  const QString name = name_->text();
  while (isTaken(QStringLiteral("%1-%2").arg(name).arg(number)))
    ++number;
  name_->setText(QStringLiteral("%1-%2").arg(name).arg(number));
  name_->setFocus();
  name_->selectAll();
}

void ArmImportDialog::write(const Import& import) {
  runner_->run(
      [import, folder = std::filesystem::path(folder_.toStdString())](const base::RunContext&) {
        cells::writeImport(*import, folder, cells::Existing::Replace);
        return import->layout.cell.id;
      },
      [this](const base::Outcome<std::string>& outcome) {
        setBusy(false);
        if (const auto* id = std::get_if<std::string>(&outcome)) {
          cell_ = QString::fromStdString(*id);
          accept();
        } else if (const auto* error = std::get_if<base::Error>(&outcome)) {
          found_->setPlainText(language::words(error->whole()));
        }
      });
  setBusy(true);
}

} // namespace voluta::window
