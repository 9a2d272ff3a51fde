#include "window/layer_event_dialog.h"

#include "base/error.h"
#include "forms/value_boxes.h"
#include "language/words.h"
#include "motion/layer_event_text.h"
#include "program/dialect.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

namespace voluta::window {

LayerEventDialog::LayerEventDialog(int layer, std::size_t tools, QWidget* parent)
    : QDialog(parent), form_(new QFormLayout), kind_(forms::makeCombo(this)),
      format_(forms::makeCombo(this)), text_(new QLineEdit(this)), statement_(new QLineEdit(this)),
      seconds_(new forms::NumberBox(this)), output_(forms::makeIntegerBox(this)),
      tool_(forms::makeIntegerBox(this)), on_(new QCheckBox(this)), problem_(new QLabel(this)) {
  setObjectName("layerEventDialog");
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Event before layer %1").arg(layer));
  build(tools);
}

void LayerEventDialog::build(std::size_t tools) {
  kind_->setObjectName("eventKind");
  kind_->addItem(tr("Pause"), "pause");
  kind_->addItem(tr("Wait"), "wait");
  kind_->addItem(tr("Output"), "output");
  if (tools > 1)
    kind_->addItem(tr("Tool"), "tool");
  kind_->addItem(tr("Own statement"), "statement");
  text_->setObjectName("eventText");
  text_->setMaxLength(static_cast<int>(motion::kOwnTextLength));
  text_->setToolTip(tr("Shown to the operator; the arm waits until the operator continues"));
  statement_->setObjectName("eventStatement");
  statement_->setToolTip(tr("This line is written into programs of the format. Nothing checks it"));
  for (const program::Dialect& row : program::dialects())
    format_->addItem(QString::fromStdString(std::string(row.id)));
  format_->setObjectName("eventFormat");
  seconds_->setObjectName("eventSeconds");
  seconds_->setRange(0.1, 36000.0);
  seconds_->setDecimals(1);
  seconds_->setValue(60.0);
  seconds_->setUnit("s");
  output_->setObjectName("eventOutput");
  output_->setRange(0, 4095);
  tool_->setObjectName("eventTool");
  tool_->setRange(1, static_cast<int>(tools));
  on_->setObjectName("eventOn");
  on_->setText(tr("On"));
  on_->setChecked(true);
  form_->addRow(tr("&Event"), kind_);
  form_->addRow(tr("Te&xt"), text_);
  form_->addRow(tr("&Duration"), seconds_);
  form_->addRow(tr("&Number"), output_);
  form_->addRow(QString(), on_);
  form_->addRow(tr("&Tool"), tool_);
  form_->addRow(tr("&Format"), format_);
  form_->addRow(tr("&Line"), statement_);
  problem_->setObjectName("eventProblem");
  problem_->setTextFormat(Qt::PlainText);
  problem_->setWordWrap(true);
  problem_->hide();
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  buttons->button(QDialogButtonBox::Ok)->setObjectName("eventOk");
  auto* column = new QVBoxLayout(this);
  column->addLayout(form_);
  column->addWidget(problem_);
  column->addWidget(buttons);
  connect(kind_, &QComboBox::currentIndexChanged, this, &LayerEventDialog::showFields);
  connect(buttons, &QDialogButtonBox::accepted, this, [this] { emit chosen(event()); });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  showFields();
}

void LayerEventDialog::showFields() {
  const QString kind = kind_->currentData().toString();
  problem_->hide();
  form_->setRowVisible(text_, kind == "pause");
  form_->setRowVisible(seconds_, kind == "wait");
  form_->setRowVisible(output_, kind == "output");
  form_->setRowVisible(on_, kind == "output");
  form_->setRowVisible(tool_, kind == "tool");
  form_->setRowVisible(format_, kind == "statement");
  form_->setRowVisible(statement_, kind == "statement");
  adjustSize();
}

QString LayerEventDialog::event() {
  const QString kind = kind_->currentData().toString();
  for (QAbstractSpinBox* box :
       {static_cast<QAbstractSpinBox*>(seconds_), static_cast<QAbstractSpinBox*>(output_),
        static_cast<QAbstractSpinBox*>(tool_)})
    box->interpretText(); // typed, and not left yet
  const QString value =
      kind == "pause"    ? text_->text().trimmed()
      : kind == "wait"   ? QString::number(seconds_->value())
      : kind == "output" ? QStringLiteral("%1 %2")
                               .arg(output_->value())
                               .arg(on_->isChecked() ? QStringLiteral("on") : QStringLiteral("off"))
      : kind == "tool" ? QString::number(tool_->value())
                       : format_->currentText() + ' ' + statement_->text().trimmed();
  return (kind + ' ' + value).trimmed();
}

void LayerEventDialog::showProblem(const base::Error& error) {
  problem_->setText(language::capitalized(language::words(error.message())));
  problem_->show();
  adjustSize();
}

} // namespace voluta::window
