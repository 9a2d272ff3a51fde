#include "window/presets/preset_name_dialog.h"

#include "base/error.h"
#include "language/translated.h"
#include "language/words.h"
#include "pipeline/presets/print_preset.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace voluta::window {

namespace {
constexpr int kLongestName = 60;
constexpr int kLetters = 36; // Shown at once
} // namespace

PresetNameDialog::PresetNameDialog(const QString& title, const QString& name, const std::string& id,
                                   QWidget* parent)
    : QDialog(parent), id_(id), name_(new QLineEdit(name, this)), problem_(new QLabel(this)) {
  setObjectName("presetName");
  setWindowTitle(title);
  name_->setObjectName("presetNameField");
  name_->setMaxLength(kLongestName);
  name_->setMinimumWidth(kLetters * fontMetrics().averageCharWidth());
  name_->selectAll();
  auto* label = new QLabel(tr("Name"), this);
  label->setBuddy(name_);
  problem_->setObjectName("presetNameProblem");
  problem_->setWordWrap(true);
  problem_->setMinimumHeight(2 * fontMetrics().height());
  problem_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  accept_ =
      buttons->addButton(id.empty() ? tr("Save") : tr("Rename"), QDialogButtonBox::AcceptRole);
  accept_->setObjectName("presetNameAccept");
  accept_->setDefault(true);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(name_, &QLineEdit::textChanged, this, &PresetNameDialog::check);
  auto* column = new QVBoxLayout(this);
  column->addWidget(label);
  column->addWidget(name_);
  column->addWidget(problem_);
  column->addWidget(buttons);
  check();
}

QString PresetNameDialog::name() const {
  return name_->text().simplified();
}

void PresetNameDialog::check() {
  try {
    pipeline::checkPresetLabel(name().toStdString(), id_);
    problem_->clear();
    accept_->setEnabled(true);
  } catch (const base::Error& error) {
    problem_->setText(language::capitalized(language::words(error.message())) + u'.');
    accept_->setEnabled(false);
  }
}

} // namespace voluta::window
