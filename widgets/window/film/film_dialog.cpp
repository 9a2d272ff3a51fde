#include "window/film/film_dialog.h"

#include "forms/save_file.h"
#include "forms/value_boxes.h"
#include "language/words.h"
#include "pictures/job_film.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

namespace voluta::window {

FilmDialog::FilmDialog(std::shared_ptr<const pipeline::PlanResult> plan, const QString& name,
                       bool dark, QWidget* parent)
    : QDialog(parent), plan_(std::move(plan)), name_(name), dark_(dark),
      length_(forms::makeIntegerBox(this)), size_(forms::makeCombo(this)),
      view_(forms::makeCombo(this)), progress_(new QProgressBar(this)), message_(new QLabel(this)) {
  setObjectName("filmDialog");
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Film"));
  length_->setObjectName("filmLength");
  length_->setRange(static_cast<int>(pictures::kFilmLengthMinS),
                    static_cast<int>(pictures::kFilmLengthMaxS));
  length_->setValue(20);
  length_->setSuffix(tr(" s"));
  length_->setToolTip(tr("Length of the film. The whole print is shown in it, with equal steps"));
  size_->setObjectName("filmSize");
  for (const QSize& size : {QSize(1280, 720), QSize(1920, 1080), QSize(640, 360)})
    size_->addItem(QString("%1 × %2 px").arg(size.width()).arg(size.height()), size);
  view_->setObjectName("filmView");
  view_->addItem(tr("Isometric"), "isometric");
  view_->addItem(tr("Front"), "front");
  view_->addItem(tr("Right"), "right");
  view_->addItem(tr("Top"), "top");
  auto* form = new QFormLayout;
  form->addRow(tr("&Length"), length_);
  form->addRow(tr("Si&ze"), size_);
  form->addRow(tr("&View"), view_);
  progress_->setObjectName("filmProgress");
  progress_->setRange(0, 1000);
  progress_->hide();
  message_->setObjectName("filmMessage");
  message_->setWordWrap(true);
  message_->hide();
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  save_ = buttons->addButton(tr("&Save…"), QDialogButtonBox::ActionRole);
  save_->setObjectName("filmSave");
  save_->setDefault(true);
  auto* column = new QVBoxLayout(this);
  column->addLayout(form);
  column->addWidget(message_);
  column->addWidget(progress_);
  column->addWidget(buttons);
  connect(save_, &QPushButton::clicked, this, &FilmDialog::choose);
  connect(buttons, &QDialogButtonBox::rejected, this, [this] {
    runner_.cancel();
    reject();
  });
  connect(&runner_, &jobs::JobRunner::progressed, this, [this](const jobs::Progress& progress) {
    progress_->setValue(static_cast<int>(1000.0 * progress.fraction));
  });
}

void FilmDialog::choose() {
  length_->interpretText(); // Typed, and not left yet
  const QString file =
      forms::saveFile(this, tr("Save the film"), name_ + ".webm", tr("Films (*.webm)"));
  if (!file.isEmpty())
    save(file);
}

void FilmDialog::save(const QString& file) {
  pictures::FilmOptions options;
  const QSize size = size_->currentData().toSize();
  options.look.width = size.width();
  options.look.height = size.height();
  options.look.view = view_->currentData().toString().toStdString();
  options.look.dark = dark_;
  options.lengthS = length_->value();
  for (QWidget* field : std::initializer_list<QWidget*>{length_, size_, view_, save_})
    field->setEnabled(false);
  message_->hide();
  progress_->show();
  runner_.run(
      [plan = plan_, options, to = file.toStdString()](const base::RunContext& ctx) {
        pictures::writeFilm(plan->job, options, to, ctx);
        return true;
      },
      [this, file](const base::Outcome<bool>& outcome) {
        if (std::holds_alternative<bool>(outcome)) {
          emit saved(file);
          accept();
        } else if (const auto* error = std::get_if<base::Error>(&outcome)) {
          showError(language::words(error->whole()));
        }
      },
      1);
}

void FilmDialog::showError(const QString& message) {
  for (QWidget* field : std::initializer_list<QWidget*>{length_, size_, view_, save_})
    field->setEnabled(true);
  progress_->hide();
  message_->setText(message);
  message_->show();
}

} // namespace voluta::window
