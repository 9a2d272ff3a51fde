#include "panels/mesh_panel.h"

#include "forms/icons.h"
#include "language/words.h"

#include <QCheckBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>

namespace voluta::panels {

namespace {
QString listHtml(const QString& title, const std::vector<base::Message>& sentences) {
  if (sentences.empty())
    return {};
  QString html = QStringLiteral("<p style=\"margin-top:6px;margin-bottom:0px\"><b>%1</b></p>")
                     .arg(title.toHtmlEscaped());
  for (const base::Message& sentence : sentences)
    html += QStringLiteral("<p style=\"margin-top:2px;margin-bottom:0px;margin-left:8px\">%1</p>")
                .arg(language::words(sentence).toHtmlEscaped());
  return html;
}
} // namespace

MeshPanel::MeshPanel(QWidget* parent) : QWidget(parent) {
  stateIcon_ = new QLabel(this);
  state_ = new QLabel(this);
  state_->setWordWrap(true);
  text_ = new QLabel(this);
  text_->setObjectName(QStringLiteral("text"));
  text_->setWordWrap(true);
  text_->setTextFormat(Qt::RichText);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  text_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  repair_ = new QCheckBox(this);
  repair_->setObjectName(QStringLiteral("repair"));
  repair_->setChecked(true);
  connect(repair_, &QCheckBox::toggled, this, &MeshPanel::repairToggled);

  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(6, 6, 6, 6);
  grid->setSpacing(4);
  grid->setColumnStretch(1, 1);
  grid->addWidget(stateIcon_, 0, 0, Qt::AlignTop);
  grid->addWidget(state_, 0, 1);
  grid->addWidget(text_, 1, 0, 1, 2);
  grid->addWidget(repair_, 2, 0, 1, 2);
  retranslate();
}

void MeshPanel::setSummary(std::optional<MeshSummary> summary) {
  summary_ = std::move(summary);
  retranslate();
}

void MeshPanel::setRepair(bool repair) {
  const QSignalBlocker quiet(repair_);
  repair_->setChecked(repair);
}

void MeshPanel::retranslate() {
  repair_->setText(tr("Repair the mesh"));
  repair_->setToolTip(
      tr("Closes holes, orients triangles and removes duplicates, as far as the shape "
         "is not in doubt"));
  repair_->setEnabled(summary_.has_value());
  stateIcon_->setVisible(summary_.has_value());
  text_->setVisible(summary_.has_value());
  if (!summary_) {
    state_->setText(tr("No part is open."));
    return;
  }
  const bool sound = summary_->watertight && summary_->remains.empty();
  stateIcon_->setPixmap(forms::iconBeside(*this, sound ? forms::Icon::Good : forms::Icon::Warning));
  state_->setText(!summary_->watertight ? tr("The mesh is not watertight.")
                  : sound               ? tr("The mesh is watertight.")
                                        : tr("The mesh is watertight, but has defects."));
  const QLocale locale;
  const auto number = [&](double value) { return locale.toString(value, 'f', 1); };
  QString html = QString::fromStdString(summary_->name).toHtmlEscaped();
  html += QStringLiteral("<br>") +
          tr("Triangles: %1").arg(locale.toString(static_cast<qulonglong>(summary_->triangles)));
  if (summary_->watertight)
    html +=
        QStringLiteral("<br>") + QStringLiteral("%1 cm³").arg(number(summary_->volumeMm3 / 1000.0));
  html += listHtml(tr("Found"), summary_->found);
  html += listHtml(tr("Repaired"), summary_->repaired);
  html += listHtml(tr("Remains"), summary_->remains);
  text_->setText(html);
}

void MeshPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
    retranslate();
  QWidget::changeEvent(event);
}

} // namespace voluta::panels
