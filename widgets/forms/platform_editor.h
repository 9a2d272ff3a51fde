// The platform as its text: "fit:MARGIN", "disc:DIAMETER" or "rect:WIDTHxDEPTH", in mm.
#pragma once

#include <QWidget>

class QComboBox;
class QLabel;

namespace voluta::forms {

class NumberBox;

class PlatformEditor : public QWidget {
  Q_OBJECT

public:
  explicit PlatformEditor(QWidget* parent = nullptr);

  // Emits nothing; a text that is none of the three forms leaves all as it is.
  void setText(const QString& text);
  QString text() const;

signals:
  void changed(const QString& text);

protected:
  void changeEvent(QEvent* event) override;

private:
  void showKind();
  void commit();
  void retranslate();

  QComboBox* kind_ = nullptr;
  NumberBox* first_ = nullptr;
  NumberBox* second_ = nullptr;
  QLabel* times_ = nullptr;
};

} // namespace voluta::forms
