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
#include <utility>

namespace voluta::window {

LayerEventDialog::LayerEventDialog(int layer, std::size_t tools, QWidget* parent)
    : QDialog(parent), form_(new QFormLayout), kind_(forms::makeCombo(this)),
      format_(forms::makeCombo(this)), text_(new QLineEdit(this)), statement_(new QLineEdit(this)),
      seconds_(new forms::NumberBox(this)), pulse_(new forms::NumberBox(this)),
      output_(forms::makeIntegerBox(this)), tool_(forms::makeIntegerBox(this)),
      on_(new QCheckBox(this)), problem_(new QLabel(this)) {
  setObjectName("layerEventDialog");
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Event before layer %1").arg(layer));
  build(tools);
}

void LayerEventDialog::build(std::size_t tools) {
  kind_->setObjectName("eventKind");
  kind_->addItem(tr("Pause"), "pause");
  kind_->addItem(tr("Change of filament"), "filament");
  kind_->addItem(tr("Wait"), "wait");
  kind_->addItem(tr("Output"), "output");
  kind_->addItem(tr("Photo"), "photo");
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
  pulse_->setObjectName("eventPulse");
  pulse_->setRange(0.2, 60.0);
  pulse_->setDecimals(1);
  pulse_->setValue(0.5);
  pulse_->setUnit("s");
  pulse_->setToolTip(tr("The camera's output is on for this long; the arm waits beside the part"));
  output_->setObjectName("eventOutput");
  output_->setRange(0, 4095);
  tool_->setObjectName("eventTool");
  tool_->setRange(1, static_cast<int>(tools));
  on_->setObjectName("eventOn");
  on_->setText(tr("On"));
  on_->setChecked(true);
  form_->addRow(tr("&Event"), kind_);
  addField(tr("Te&xt"), {text_, {"pause", "filament"}, [this] { return text_->text().trimmed(); }});
  addField(tr("&Number"),
           {output_, {"output", "photo"}, [this] { return QString::number(output_->value()); }});
  addField({}, {on_, {"output"}, [this] {
                  return on_->isChecked() ? QStringLiteral("on") : QStringLiteral("off");
                }});
  addField(tr("&Duration"),
           {seconds_, {"wait"}, [this] { return QString::number(seconds_->value()); }});
  addField(tr("&Duration"),
           {pulse_, {"photo"}, [this] { return QString::number(pulse_->value()); }});
  addField(tr("&Tool"), {tool_, {"tool"}, [this] { return QString::number(tool_->value()); }});
  addField(tr("&Format"), {format_, {"statement"}, [this] { return format_->currentText(); }});
  addField(tr("&Line"),
           {statement_, {"statement"}, [this] { return statement_->text().trimmed(); }});
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
  for (QSpinBox* box : {output_, tool_}) {
    box->setKeyboardTracking(true);
    connect(box, &QSpinBox::valueChanged, this, &LayerEventDialog::check);
  }
  for (QLineEdit* line : {text_, statement_})
    connect(line, &QLineEdit::textChanged, this, &LayerEventDialog::check);
  connect(format_, &QComboBox::currentIndexChanged, this, &LayerEventDialog::check);
  connect(buttons, &QDialogButtonBox::accepted, this, [this] {
    for (const Field& field : fields_)
      if (auto* box = qobject_cast<QAbstractSpinBox*>(field.box))
        box->interpretText(); // typed, and not left yet
    emit chosen(event());
  });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  showFields();
}

void LayerEventDialog::addField(const QString& label, const Field& field) {
  form_->addRow(label, field.box);
  fields_.push_back(field);
}

void LayerEventDialog::setCheck(Check check) {
  check_ = std::move(check);
  this->check();
}

void LayerEventDialog::showFields() {
  for (const Field& field : fields_)
    form_->setRowVisible(field.box, field.kinds.contains(kind_->currentData().toString()));
  check();
}

// A statement that is not begun is no problem yet.
bool LayerEventDialog::isEmpty() const {
  return kind_->currentData() == "statement" && statement_->text().trimmed().isEmpty();
}

void LayerEventDialog::check() {
  problem_->hide();
  if (const auto problem = check_ && !isEmpty() ? check_(event()) : std::nullopt)
    showProblem(*problem);
  else
    adjustSize();
}

QString LayerEventDialog::event() const {
  QStringList words{kind_->currentData().toString()};
  for (const Field& field : fields_)
    if (field.kinds.contains(words.front()))
      words << field.text();
  return words.join(' ').trimmed();
}

void LayerEventDialog::showProblem(const base::Error& error) {
  problem_->setText(language::capitalized(language::words(error.message())));
  problem_->show();
  adjustSize();
}

} // namespace voluta::window
