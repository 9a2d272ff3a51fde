#include "forms/platform_editor.h"

#include "forms/value_boxes.h"

#include <QComboBox>
#include <QEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSettings>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

namespace voluta::forms {

namespace {
constexpr double kLargestMm = 5000.0;
constexpr double kUsualPlateMm = 200.0, kUsualRodMm = 5.0;
constexpr int kHexagon = 6;

QString numberText(double value) {
  return QString::number(value, 'g', 10);
}
} // namespace

PlatformEditor::PlatformEditor(QWidget* parent) : QWidget(parent) {
  kind_ = makeCombo(this);
  kind_->setObjectName(QStringLiteral("kind"));
  const auto box = [this](const char* name) {
    auto* made = new NumberBox(this);
    made->setObjectName(QLatin1String(name));
    made->setUnit(QStringLiteral("mm"));
    made->setRange(0.0, kLargestMm);
    made->setMinimumWidth(fontMetrics().averageCharWidth() * 9);
    connect(made, &QDoubleSpinBox::valueChanged, this, &PlatformEditor::commit);
    return made;
  };
  first_ = box("first");
  second_ = box("second");
  times_ = new QLabel(QStringLiteral("×"), this);
  fileButton_ = new QToolButton(this);
  fileButton_->setObjectName(QStringLiteral("file"));
  fileButton_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  shape_ = makeCombo(this);
  shape_->setObjectName(QStringLiteral("rodShape"));
  for (const int sides : {0, kHexagon, -1})
    shape_->addItem(QString(), sides);
  points_ = new QLineEdit(this);
  points_->setObjectName(QStringLiteral("rodPoints"));

  auto* sizes = new QHBoxLayout;
  sizes->setSpacing(4);
  sizes->addWidget(first_, 1);
  sizes->addWidget(times_);
  sizes->addWidget(second_, 1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  column->addWidget(kind_);
  column->addLayout(sizes);
  column->addWidget(fileButton_);
  column->addWidget(shape_);
  column->addWidget(points_);

  connect(kind_, &QComboBox::currentIndexChanged, this, &PlatformEditor::chooseKind);
  connect(fileButton_, &QToolButton::clicked, this, &PlatformEditor::chooseFile);
  connect(shape_, &QComboBox::currentIndexChanged, this, [this] {
    const int sides = shape_->currentData().toInt();
    profile_.sides = std::max(0, sides);
    showProfile();
    if (sides >= 0)
      profile_.points.clear();
    if (sides >= 0 || !profile_.points.isEmpty())
      commitProfile();
    else
      points_->setFocus();
  });
  connect(points_, &QLineEdit::editingFinished, this, [this] {
    if (points_->text().trimmed() == profile_.points)
      return;
    profile_.points = points_->text().trimmed();
    commitProfile();
  });
  setKinds({QStringLiteral("fit"), QStringLiteral("disc"), QStringLiteral("rect")}, false);
  shownText_ = text();
}

QString PlatformEditor::kind() const {
  return kind_->currentData().toString();
}

void PlatformEditor::addKind(const QString& kind) {
  kind_->addItem(QString(), kind);
}

void PlatformEditor::setKinds(const QStringList& kinds, bool aroundRod) {
  QStringList now;
  for (int i = 0; i < kind_->count(); ++i)
    now << kind_->itemData(i).toString();
  if (now == kinds && aroundRod == aroundRod_)
    return;
  aroundRod_ = aroundRod;
  const QSignalBlocker quiet(kind_);
  const QString chosen = kind();
  kind_->clear();
  for (const QString& one : kinds)
    addKind(one);
  kind_->setCurrentIndex(std::max(0, kind_->findData(chosen)));
  retranslate();
}

void PlatformEditor::chooseKind() {
  const QString chosen = kind();
  if (chosen == QLatin1String("mesh")) {
    showKind();
    chooseFile();
    return;
  }
  const bool rod = chosen == QLatin1String("rod");
  const QSignalBlocker quietFirst(first_), quietSecond(second_);
  showKind();
  first_->setValue(chosen == QLatin1String("fit") ? 0.0 : rod ? kUsualRodMm : kUsualPlateMm);
  second_->setValue(kUsualPlateMm);
  commit();
}

// Without a file it stays what it was.
void PlatformEditor::chooseFile() {
  const QString folder = QSettings().value(QStringLiteral("open/folder")).toString();
  const QString file =
      QFileDialog::getOpenFileName(this, tr("Body to print on"), file_.isEmpty() ? folder : file_,
                                   tr("Meshes (*.stl *.obj *.ply *.off *.3mf);;All files (*)"));
  if (file.isEmpty()) {
    setText(shownText_);
    return;
  }
  QSettings().setValue(QStringLiteral("open/folder"), QFileInfo(file).absolutePath());
  setText(QStringLiteral("mesh:") + file);
  commit();
}

void PlatformEditor::setText(const QString& text) {
  const QString kind = text.section(QChar(':'), 0, 0);
  const QString size = text.section(QChar(':'), 1);
  bool firstOk = false, secondOk = true;
  double first = 0.0, second = 0.0;
  if (kind == QLatin1String("mesh")) {
    firstOk = !size.isEmpty();
  } else if (kind == QLatin1String("rect") || kind == QLatin1String("rod")) {
    first = size.section(QChar('x'), 0, 0).toDouble(&firstOk);
    second = size.section(QChar('x'), 1).toDouble(&secondOk);
  } else {
    first = size.toDouble(&firstOk);
    firstOk = firstOk || (kind == QLatin1String("fit") && size.isEmpty());
  }
  const bool known = kind == QLatin1String("fit") || kind == QLatin1String("disc") ||
                     kind == QLatin1String("rect") || kind == QLatin1String("rod") ||
                     kind == QLatin1String("mesh");
  if (!known || !firstOk || !secondOk)
    return;
  const QSignalBlocker quietKind(kind_), quietFirst(first_), quietSecond(second_);
  shownText_ = text;
  if (kind == QLatin1String("mesh"))
    file_ = size;
  if (kind_->findData(kind) < 0) {
    addKind(kind);
    retranslate();
  }
  kind_->setCurrentIndex(kind_->findData(kind));
  showKind();
  first_->setValue(first);
  second_->setValue(second);
}

QString PlatformEditor::text() const {
  const QString chosen = kind();
  if (chosen == QLatin1String("mesh"))
    return chosen + QChar(':') + file_;
  QString text = chosen + QChar(':') + numberText(first_->value());
  if (chosen == QLatin1String("rect") || chosen == QLatin1String("rod"))
    text += QChar('x') + numberText(second_->value());
  return text;
}

void PlatformEditor::setProfile(const RodProfile& profile) {
  profile_ = profile;
  const QSignalBlocker quiet(shape_), quietPoints(points_);
  const int wanted = profile.points.isEmpty() ? profile.sides : -1;
  if (shape_->findData(wanted) < 0) {
    shape_->addItem(QString(), wanted);
    retranslate();
  }
  shape_->setCurrentIndex(shape_->findData(wanted));
  points_->setText(profile.points);
  showProfile();
}

void PlatformEditor::showKind() {
  const QString chosen = kind();
  const bool mesh = chosen == QLatin1String("mesh"), rod = chosen == QLatin1String("rod");
  const bool ownRod = chosen == QLatin1String("fit") && aroundRod_;
  const bool two = chosen == QLatin1String("rect") || rod;
  const QSignalBlocker quiet(first_), quietSecond(second_);
  first_->setMinimum(rod ? 0.1 : chosen == QLatin1String("fit") ? 0.0 : 1.0);
  second_->setMinimum(1.0);
  first_->setVisible(!mesh && !ownRod);
  times_->setVisible(two);
  second_->setVisible(two);
  fileButton_->setVisible(mesh);
  fileButton_->setText(file_.isEmpty() ? tr("Choose a file…") : QFileInfo(file_).fileName());
  fileButton_->setToolTip(file_.isEmpty() ? tr("A closed mesh, in the same place as in the part's "
                                               "file")
                                          : tr("%1\nClick to choose another one").arg(file_));
  const QString name = chosen == QLatin1String("fit") ? tr("Margin around what stands on the plate")
                       : two && !rod                  ? tr("Width (X)")
                                                      : tr("Diameter");
  first_->setToolTip(name);
  first_->setAccessibleName(name);
  const QString other = rod ? tr("Length") : tr("Depth (Y)");
  second_->setToolTip(other);
  second_->setAccessibleName(other);
  showProfile();
}

void PlatformEditor::showProfile() {
  const bool rod = kind() == QLatin1String("rod") || (kind() == QLatin1String("fit") && aroundRod_);
  shape_->setVisible(rod);
  points_->setVisible(rod && shape_->currentData().toInt() < 0);
}

void PlatformEditor::commit() {
  shownText_ = text();
  emit changed(shownText_);
}

void PlatformEditor::commitProfile() {
  emit profileChanged(profile_);
}

void PlatformEditor::retranslate() {
  for (int i = 0; i < kind_->count(); ++i) {
    const QString kind = kind_->itemData(i).toString();
    kind_->setItemText(i, kind == QLatin1String("fit")
                              ? (aroundRod_ ? tr("Rod of the cell") : tr("Contact area, margin"))
                          : kind == QLatin1String("disc") ? tr("Disc, diameter")
                          : kind == QLatin1String("rect") ? tr("Rectangle")
                          : kind == QLatin1String("rod")  ? tr("Rod, diameter × length")
                                                          : tr("Body from a file"));
  }
  for (int i = 0; i < shape_->count(); ++i) {
    const int sides = shape_->itemData(i).toInt();
    shape_->setItemText(i, sides < 0           ? tr("Stepped: points x,radius")
                           : sides == 0        ? tr("Round")
                           : sides == kHexagon ? tr("Hexagonal, over corners")
                                               : tr("%1 sides, over corners").arg(sides));
  }
  shape_->setAccessibleName(tr("Shape of the rod"));
  points_->setAccessibleName(tr("Profile of the rod"));
  points_->setPlaceholderText(QStringLiteral("-20,2.5 0,2.5 0,3.5 20,3.5"));
  points_->setToolTip(tr("Pairs of x and radius in mm; a step has two pairs at one x"));
  showKind();
}

void PlatformEditor::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange)
    retranslate();
  QWidget::changeEvent(event);
}

} // namespace voluta::forms
