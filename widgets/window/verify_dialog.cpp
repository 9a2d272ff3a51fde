#include "window/verify_dialog.h"

#include "language/words.h"
#include "panels/listed_findings.h"
#include "panels/verdict_table.h"
#include "pipeline/plan_verdict.h"
#include "plan/finding_kinds.h"
#include "program/dialect.h"

#include <QDialogButtonBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

namespace voluta::window {

namespace {
constexpr int kWidth = 560, kFoundRows = 6, kMaxListed = 200;
}

VerifyDialog::VerifyDialog(const QString& program, std::shared_ptr<const pipeline::PlanResult> plan,
                           QWidget* parent)
    : QDialog(parent), sign_(new QLabel(this)), verdict_(new QLabel(this)),
      progress_(new QProgressBar(this)), table_(new panels::VerdictTable(this)),
      foundTitle_(new QLabel(tr("Replay findings"), this)), found_(new QListWidget(this)),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Cancel, this)) {
  setObjectName("verifyDialog");
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Verify %1").arg(QFileInfo(program).fileName()));
  setMinimumWidth(kWidth);
  verdict_->setObjectName("verifyVerdict");
  verdict_->setWordWrap(true);
  verdict_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  verdict_->setText(tr("Replaying the program against the current plan…"));
  sign_->setAlignment(Qt::AlignTop);
  progress_->setRange(0, 100);
  progress_->setTextVisible(false);
  found_->setObjectName("verifyFindings");
  found_->setWordWrap(true);
  found_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  found_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  found_->setMinimumHeight(kFoundRows * (fontMetrics().height() + 6));
  foundTitle_->setBuddy(found_);
  foundTitle_->hide();
  found_->hide();

  auto* head = new QHBoxLayout;
  head->addWidget(sign_);
  head->addWidget(verdict_, 1);
  auto* column = new QVBoxLayout(this);
  column->addLayout(head);
  column->addWidget(progress_);
  column->addWidget(table_);
  column->addWidget(foundTitle_);
  column->addWidget(found_, 1);
  column->addWidget(buttons_);

  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(&verifying_, &document::Verifying::progressed, this,
          [this](double fraction) { progress_->setValue(static_cast<int>(100.0 * fraction)); });
  connect(&verifying_, &document::Verifying::verified, this, &VerifyDialog::show);
  connect(&verifying_, &document::Verifying::failed, this,
          [this](const QString& message) { conclude(message, forms::Icon::Blocked); });
  verifying_.verify(program, std::move(plan));
}

void VerifyDialog::conclude(const QString& verdict, forms::Icon sign) {
  progress_->hide();
  verdict_->setText(verdict);
  const int size = fontMetrics().height() + 4;
  sign_->setPixmap(forms::icon(sign).pixmap(size, size));
  buttons_->setStandardButtons(QDialogButtonBox::Close);
}

void VerifyDialog::show(const pipeline::VerifyResult& result) {
  const QString format = language::words(program::findDialect(result.format).label);
  switch (pipeline::verdictOf(result)) {
  case pipeline::PlanVerdict::Passed:
    conclude(tr("%1: passed. The program matches the plan.").arg(format), forms::Icon::Good);
    break;
  case pipeline::PlanVerdict::NotAsAsked:
    conclude(tr("%1: safe to run, but it does not print the part as asked.").arg(format),
             forms::Icon::Warning);
    break;
  case pipeline::PlanVerdict::Unchecked:
    conclude(tr("%1: safe to run but for your own statements, which nothing checks.").arg(format),
             forms::Icon::Warning);
    break;
  default:
    conclude(tr("%1: refused. Do not run it on the robot.").arg(format), forms::Icon::Blocked);
  }
  table_->setReport(result.replay);
  const std::vector<panels::ListedFinding> listed = panels::listed(result.findings);
  for (const panels::ListedFinding& one : listed) {
    if (found_->count() == kMaxListed)
      break;
    auto* item = new QListWidgetItem(language::words(plan::reasonOf(one.finding)), found_);
    item->setIcon(forms::icon(plan::blocksRunning(one.finding) ? forms::Icon::Blocked
                              : one.finding.blocking           ? forms::Icon::Warning
                                                               : forms::Icon::Note));
    item->setToolTip(language::words(plan::remedyOf(one.finding)));
  }
  if (listed.size() > kMaxListed)
    foundTitle_->setText(tr("Replay findings, the first %1 of %2")
                             .arg(kMaxListed)
                             .arg(QLocale().toString(static_cast<qulonglong>(listed.size()))));
  foundTitle_->setVisible(!listed.empty());
  found_->setVisible(!listed.empty());
  adjustSize();
}

} // namespace voluta::window
