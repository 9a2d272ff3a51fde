// Facts about a written program: size, duration on its controller, assumptions about the
// controller.
#pragma once

#include <QString>
#include <QStringList>
#include <QWidget>
#include <cstddef>
#include <optional>

class QLabel;

namespace voluta::forms {
class Fold;
}

namespace voluta::panels {

struct ProgramFigures {
  std::size_t bytes = 0, files = 0;
  double controllerS = 0.0, plannedS = 0.0;
};

class ProgramFacts : public QWidget {
  Q_OBJECT

public:
  explicit ProgramFacts(QWidget* parent = nullptr);

  // nullopt: there is no program yet.
  void setFigures(const std::optional<ProgramFigures>& figures);
  // Sentences on the controller; folded initially.
  void setAssumptions(const QStringList& sentences);

protected:
  void changeEvent(QEvent* event) override;

private:
  void retranslate();

  std::optional<ProgramFigures> figures_;
  QLabel* size_;
  QLabel* time_;
  QLabel* assumed_;
  forms::Fold* fold_;
};

} // namespace voluta::panels
