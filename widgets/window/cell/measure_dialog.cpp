#include "window/cell/measure_dialog.h"

#include "base/error.h"
#include "base/number_list.h"
#include "forms/icons.h"
#include "language/words.h"
#include "robot/measured/measured_json.h"
#include "robot/measured/measured_words.h"

#include <QDialogButtonBox>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace voluta::window {

namespace {

constexpr int kWidth = 520, kRows = 9, kResultRows = 5;
constexpr std::size_t kOfAPose = 7; // x, y, z, qw, qx, qy, qz

} // namespace

MeasureDialog* MeasureDialog::ofFrame(const QString& body, const QString& in, QWidget* parent) {
  return new MeasureDialog(
      body,
      tr("One point per row, in mm, %1. Three rows x, y, z: origin, a point on X, a point in the "
         "XY plane. Or at least three rows of six: nominal point, touched point.")
          .arg(in),
      QStringLiteral("400, 100, 20\n550, 100, 20\n400, 250, 20"), std::nullopt, parent);
}

MeasureDialog* MeasureDialog::ofTip(const QString& body, const robot::RobotModel& robot,
                                    QWidget* parent) {
  return new MeasureDialog(
      body,
      tr("At least four poses in which the tip touches the same point, tilted to different sides, "
         "one per row: the robot's joints, or x, y, z, qw, qx, qy, qz of the flange."),
      QStringLiteral("0, -90, 90, -90, -90, 0"), robot, parent);
}

MeasureDialog::MeasureDialog(const QString& body, const QString& what, const QString& example,
                             std::optional<robot::RobotModel> robot, QWidget* parent)
    : QDialog(parent), robot_(std::move(robot)), rows_(new QPlainTextEdit(this)),
      sign_(new QLabel(this)), result_(new QLabel(this)) {
  setObjectName("measureDialog");
  setWindowTitle(tr("Measure %1").arg(body));
  setMinimumWidth(kWidth);
  auto* asked = new QLabel(what, this);
  asked->setWordWrap(true);
  asked->setBuddy(rows_);
  rows_->setObjectName("measureRows");
  rows_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  rows_->setPlaceholderText(example);
  rows_->setTabChangesFocus(true);
  rows_->setMinimumHeight(kRows * fontMetrics().height());
  result_->setObjectName("measureTold");
  result_->setWordWrap(true);
  result_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  result_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  result_->setMinimumHeight(kResultRows * fontMetrics().height());
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  use_ = buttons->addButton(tr("Use this frame"), QDialogButtonBox::AcceptRole);
  use_->setObjectName("measureUse");
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(rows_, &QPlainTextEdit::textChanged, this, &MeasureDialog::evaluate);

  auto* line = new QHBoxLayout;
  line->addWidget(sign_, 0, Qt::AlignTop);
  line->addWidget(result_, 1);
  auto* column = new QVBoxLayout(this);
  column->addWidget(asked);
  column->addWidget(rows_, 1);
  column->addLayout(line);
  column->addWidget(buttons);
  evaluate();
}

void MeasureDialog::evaluate() {
  frame_.reset();
  sign_->clear();
  result_->clear();
  const std::string text = rows_->toPlainText().toStdString();
  try {
    const robot::NumberRows rows = base::readRows(text, tr("Rows").toStdString());
    if (!rows.empty()) {
      robot::Residual residual;
      Eigen::Isometry3d found = Eigen::Isometry3d::Identity();
      if (robot_) {
        const bool poses = rows.front().size() == kOfAPose;
        const robot::MeasuredTip tip = robot::tipOfRows(rows, poses ? nullptr : &*robot_);
        found.translation() = tip.tipInFlange;
        residual = tip.residual;
      } else {
        const robot::MeasuredFrame measured = robot::frameOfRows(rows);
        found = measured.base_T_frame;
        residual = measured.residual;
      }
      frame_ = found;
      result_->setText(language::words(robot::placeOf(found)) + QLatin1Char('\n') +
                       language::words(robot::agreementOf(residual, rows.size())));
      sign_->setPixmap(forms::iconBeside(*this, forms::Icon::Good));
    }
  } catch (const base::Error& error) {
    result_->setText(language::words(error.whole()));
    sign_->setPixmap(forms::iconBeside(*this, forms::Icon::Blocked));
  }
  use_->setEnabled(frame_.has_value());
}

} // namespace voluta::window
