// The platform as its text: "fit:MARGIN", "disc:DIAMETER", "rect:WIDTHxDEPTH",
// "rod:DIAMETERxLENGTH" or "mesh:FILE", in mm; and of a rod, what is across it.
#pragma once

#include <QStringList>
#include <QWidget>

class QComboBox;
class QLabel;
class QLineEdit;
class QToolButton;

namespace voluta::forms {

class NumberBox;

// Across a rod: round where sides is 0, else a prism; `points` (x,radius pairs) instead of
// straight.
struct RodProfile {
  int sides = 0;
  QString points;
  bool operator==(const RodProfile&) const = default;
};

class PlatformEditor : public QWidget {
  Q_OBJECT

public:
  explicit PlatformEditor(QWidget* parent = nullptr);

  // The kinds to choose from, of "fit", "disc", "rect", "rod", "mesh". `aroundRod`: "fit" is then
  // the cell's own rod. Emits nothing.
  void setKinds(const QStringList& kinds, bool aroundRod);
  // Emits nothing; a text that is none of the forms leaves all as it is. A kind that is not to be
  // chosen from is added.
  void setText(const QString& text);
  QString text() const;
  // Emits nothing.
  void setProfile(const RodProfile& profile);

  // Asks for the file of a body; without an answer all stays as it was.
  void chooseFile();

signals:
  void changed(const QString& text);
  void profileChanged(const voluta::forms::RodProfile& profile);

protected:
  void changeEvent(QEvent* event) override;

private:
  QString kind() const;
  void addKind(const QString& kind);
  void chooseKind();
  void showKind();
  void showProfile();
  void commit();
  void commitProfile();
  void retranslate();

  QComboBox* kind_ = nullptr;
  NumberBox* first_ = nullptr;
  NumberBox* second_ = nullptr;
  QLabel* times_ = nullptr;
  QToolButton* fileButton_ = nullptr;
  QComboBox* shape_ = nullptr;
  QLineEdit* points_ = nullptr;
  QString shownText_, file_;
  RodProfile profile_;
  bool aroundRod_ = false;
};

} // namespace voluta::forms
