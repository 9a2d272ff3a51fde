// Mills a part out of a block: values, passes and the milled block in a picture, figures, and the
// G-code once its replay has passed.
#pragma once

#include "jobs/job_runner.h"
#include "window/milling/mill_picture.h"

#include <QDialog>
#include <QString>
#include <array>
#include <memory>
#include <optional>

class QCheckBox;
class QDialogButtonBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QWidget;

namespace voluta::forms {
enum class Icon;
}
namespace voluta::viewer {
class Viewport;
}

namespace voluta::window {

class MillForm;

class MillDialog : public QDialog {
  Q_OBJECT

public:
  // `name`: of the part, without folder and ending. Precondition: the part is closed.
  MillDialog(std::shared_ptr<const geometry::TriangleMesh> part, const QString& name,
             QWidget* parent);

  // Returns whether nothing is being computed.
  bool settled() const { return !runner_.running(); }

private:
  struct Made;

  void build();
  QWidget* buildSide();
  QWidget* buildLegend();
  void compute();
  void take(base::Outcome<std::shared_ptr<const Made>> outcome);
  void valuesChanged();
  void showPicture();
  void showFigures();
  void say(const QString& text, std::optional<forms::Icon> icon = {});
  void save();

  std::shared_ptr<const geometry::TriangleMesh> part_;
  QString name_;
  std::shared_ptr<const Made> made_; // null: not computed yet
  bool isOutOfDate_ = false;
  jobs::JobRunner runner_;
  viewer::Viewport* viewport_;
  scene::LineGroups lines_; // in the viewport
  MillForm* form_;
  QCheckBox *showPart_, *showMilled_;
  std::array<QCheckBox*, kMillLines> showLines_{};
  QLabel *sign_, *figures_;
  QProgressBar* progress_;
  QPushButton *compute_, *save_;
};

} // namespace voluta::window
