#include "window/copies_dialog.h"

#include "forms/value_boxes.h"
#include "pipeline/items/plate_parts.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

namespace voluta::window {

CopiesDialog::CopiesDialog(std::size_t present, QWidget* parent)
    : QDialog(parent), count_(forms::makeIntegerBox(this)) {
  setObjectName("copiesDialog");
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Number of copies"));
  count_->setObjectName("copiesCount");
  count_->setRange(1, static_cast<int>(pipeline::kMaxCopies));
  count_->setValue(static_cast<int>(present));
  count_->setToolTip(tr("Number of these parts on the plate; all parts are arranged anew"));
  count_->selectAll();
  auto* form = new QFormLayout;
  form->addRow(tr("&Copies on the plate"), count_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  QPushButton* fill = buttons->addButton(tr("&Fill the plate"), QDialogButtonBox::ActionRole);
  fill->setObjectName("copiesFill");
  fill->setToolTip(tr("As many copies as the plate has room for"));
  buttons->button(QDialogButtonBox::Ok)->setObjectName("copiesOk");
  buttons->button(QDialogButtonBox::Ok)->setDefault(true);
  auto* column = new QVBoxLayout(this);
  column->addLayout(form);
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, [this] {
    count_->interpretText(); // Typed, and not left yet
    choose(static_cast<std::size_t>(count_->value()));
  });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(fill, &QPushButton::clicked, this, [this] { choose(std::nullopt); });
}

void CopiesDialog::choose(std::optional<std::size_t> count) {
  accept();
  emit chosen(count);
}

} // namespace voluta::window
