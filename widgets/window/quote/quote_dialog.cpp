#include "window/quote/quote_dialog.h"

#include "base/data_files.h"
#include "base/error.h"
#include "base/files.h"
#include "forms/duration_text.h"
#include "forms/save_file.h"
#include "forms/value_boxes.h"
#include "language/words.h"
#include "pictures/job_picture.h"

#include <QDialogButtonBox>
#include <QDir>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace voluta::window {

namespace {
constexpr double kHighestPrice = 1e6, kHighestMargin = 1000.0; // [%]
constexpr double kTitleShare = 1.6; // Size of the price, of the usual text
} // namespace

QuoteDialog::QuoteDialog(std::shared_ptr<const pipeline::PlanResult> plan, QString name,
                         QString size, QWidget* parent)
    : QDialog(parent), plan_(std::move(plan)), name_(std::move(name)), size_(std::move(size)),
      machine_(new forms::NumberBox(this)), fixed_(new forms::NumberBox(this)),
      margin_(new forms::NumberBox(this)), total_(new QLabel(this)), state_(new QLabel(this)),
      rows_(new QTreeWidget(this)) {
  setObjectName("quoteDialog");
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Quote"));
  if (plan_) {
    cell_ = base::dataName(plan_->job.choices.cell);
    if (auto quote = quoteOf(*plan_, quotePrices(cell_)))
      quote_ = std::move(*quote);
  }
  build();
  show();
}

void QuoteDialog::build() {
  total_->setObjectName("quoteTotal");
  QFont large = total_->font();
  large.setPointSizeF(kTitleShare * large.pointSizeF());
  large.setBold(true);
  total_->setFont(large);
  state_->setObjectName("quoteState");
  state_->setWordWrap(true);
  machine_->setObjectName("quoteMachine");
  machine_->setToolTip(
      tr("Price of an hour of the machine, with power and operator; each cell has its own"));
  fixed_->setObjectName("quoteFixed");
  fixed_->setToolTip(tr("Price of each print, whatever its size"));
  margin_->setObjectName("quoteMargin");
  margin_->setToolTip(tr("Added to the cost"));
  for (forms::NumberBox* box : {machine_, fixed_})
    box->setRange(0.0, kHighestPrice);
  margin_->setRange(0.0, kHighestMargin);
  margin_->setUnit(QStringLiteral("%"));
  machine_->setValue(quote_.prices.machinePerHour);
  fixed_->setValue(quote_.prices.fixed);
  margin_->setValue(100.0 * quote_.prices.margin);
  for (forms::NumberBox* box : {machine_, fixed_, margin_})
    connect(box, &QDoubleSpinBox::valueChanged, this, [this] {
      quote_.prices = {machine_->value(), fixed_->value(), 0.01 * margin_->value()};
      keepQuotePrices(quote_.prices, cell_);
      show();
    });
  rows_->setObjectName("quoteRows");
  rows_->setAccessibleName(tr("Cost"));
  rows_->setRootIsDecorated(false);
  rows_->setColumnCount(3);
  rows_->setHeaderLabels({tr("Item"), tr("Amount"), tr("Cost")});
  rows_->headerItem()->setTextAlignment(2, Qt::AlignRight);
  rows_->header()->setStretchLastSection(false);
  rows_->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  rows_->header()->setSectionResizeMode(1, QHeaderView::Stretch);
  rows_->header()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
  auto* form = new QFormLayout;
  form->addRow(tr("Machine, per hour"), machine_);
  form->addRow(tr("Set-up, per print"), fixed_);
  form->addRow(tr("Margin"), margin_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  save_ = buttons->addButton(tr("Save page…"), QDialogButtonBox::ActionRole);
  save_->setObjectName("quoteSave");
  save_->setToolTip(tr("A page for the customer, as PDF or HTML"));
  connect(save_, &QPushButton::clicked, this, &QuoteDialog::save);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  for (QAbstractButton* button : buttons->buttons())
    static_cast<QPushButton*>(button)->setAutoDefault(false); // Enter commits a number
  auto* column = new QVBoxLayout(this);
  column->addWidget(total_);
  column->addWidget(rows_, 1);
  column->addLayout(form);
  column->addWidget(state_);
  column->addWidget(buttons);
  resize(520, 460);
}

void QuoteDialog::show() {
  const QLocale locale;
  rows_->clear();
  const auto add = [&](const QString& name, const QString& amount, double cost) {
    auto* row = new QTreeWidgetItem(rows_, {name, amount, moneyText(cost)});
    row->setTextAlignment(2, Qt::AlignRight | Qt::AlignVCenter);
  };
  for (const PrintQuote::Material& material : quote_.materials)
    add(material.name,
        material.pricePerKg > 0.0
            ? tr("%1 g at %2 per kg")
                  .arg(locale.toString(material.massG, 'f', 1), moneyText(material.pricePerKg))
            : tr("%1 g; its price is not known").arg(locale.toString(material.massG, 'f', 1)),
        material.cost());
  add(tr("Machine"), forms::durationText(quote_.timeS), quote_.machineCost());
  if (quote_.prices.fixed > 0.0)
    add(tr("Set-up"), {}, quote_.prices.fixed);
  if (quote_.prices.margin > 0.0)
    add(tr("Margin"), tr("%1 %").arg(locale.toString(100.0 * quote_.prices.margin, 'f', 0)),
        quote_.total() - quote_.cost());
  total_->setText(moneyText(quote_.total()));
  save_->setEnabled(plan_ != nullptr && !quote_.materials.empty());
  if (!save_->isEnabled())
    state_->setText(tr("Plan the part first."));
  else
    state_->setText(quote_.isPriced()
                        ? QString()
                        : tr("Enter the price of the material under Processes and materials."));
}

void QuoteDialog::save() {
  const QString file =
      forms::saveFile(this, tr("Save page"), tr("%1 quote").arg(name_) + QStringLiteral(".pdf"),
                      tr("PDF (*.pdf);;HTML (*.html)"));
  if (file.isEmpty())
    return;
  const bool isHtml = file.endsWith(QStringLiteral(".html"), Qt::CaseInsensitive);
  save_->setEnabled(false);
  state_->setText(tr("Drawing the part…"));
  using Written = bool;
  runner_.run(
      [plan = plan_, quote = quote_, name = name_, size = size_, file,
       isHtml](const base::RunContext&) -> Written {
        const page::Sheet sheet = quoteSheet(quote, name, size, pictures::proofPictures(plan->job));
        base::writeFile(file.toStdString(), isHtml ? page::html(sheet) : page::pdf(sheet));
        return true;
      },
      [this, file](base::Outcome<Written> outcome) {
        save_->setEnabled(true);
        const auto* error = std::get_if<base::Error>(&outcome);
        state_->setText(error ? language::words(error->whole())
                              : tr("Saved as %1.").arg(QDir::toNativeSeparators(file)));
      },
      1);
}

} // namespace voluta::window
