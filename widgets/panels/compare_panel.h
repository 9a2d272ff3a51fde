// Settings of a comparison: ways of building, growth schemes, platforms, weights.
#pragma once

#include "forms/choices_form.h"
#include "pipeline/compare_figures.h"
#include "project/job_stage.h"

#include <QWidget>
#include <functional>
#include <string>
#include <vector>

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QListWidget;
class QPushButton;

namespace voluta::forms {
class Fold;
class NumberBox;
class PlatformEditor;
} // namespace voluta::forms

namespace voluta::panels {

class ComparePanel : public QWidget {
  Q_OBJECT

public:
  explicit ComparePanel(QWidget* parent = nullptr);

  // Keeps the selection as far as the new lists contain it; at first all modes and the first scheme
  // are selected. Emits nothing.
  void setLists(const std::vector<forms::ChoiceItem>& modes,
                const std::vector<forms::ChoiceItem>& growths);
  // Labels of the weighted figures, in the language of the window, in the order of
  // pipeline::figures().
  void setFigures(const std::vector<QString>& labels);
  // The platform of the document: always in the list, and selected while no other is.
  void setPlatform(const QString& platform);
  // Returns the text shown for a platform such as "fit:20".
  void setPlatformTexts(std::function<QString(const QString&)> text);

  // Cells to choose from; keeps the selection as far as the new list contains it. Emits nothing.
  void setCells(const std::vector<forms::ChoiceItem>& cells);

  std::vector<std::string> modes() const;
  // The selected cells; empty: only the document's own.
  std::vector<std::string> cells() const;
  std::vector<curved::GrowthScheme> growths() const;
  std::vector<project::Platform> platforms() const;
  project::Stage until() const;
  // Number of rows of the comparison; 0: nothing can be run.
  void setCount(int count);
  // `part`: there is a part to compare with; `running`: a comparison is in progress.
  void setState(bool part, bool running);

  void setWeights(const pipeline::Weights& weights);
  pipeline::Weights weights() const;

signals:
  void changed(); // the settings of the comparison
  void weightsChanged();
  void runAsked();
  void cancelAsked();

protected:
  void changeEvent(QEvent* event) override;

private:
  struct Tick {
    std::string id;
    QCheckBox* box;
  };
  void fill(std::vector<Tick>& ticks, QGridLayout* grid,
            const std::vector<forms::ChoiceItem>& items, const char* prefix, bool all);
  void addPlatform(const QString& platform, bool ticked);
  void showCount();
  void showPlatforms();
  void retranslate();

  QLabel *modesTitle_ = nullptr, *growthsTitle_ = nullptr, *platformsTitle_ = nullptr,
         *untilTitle_ = nullptr, *count_ = nullptr, *rule_ = nullptr;
  QGridLayout *modesGrid_ = nullptr, *growthsGrid_ = nullptr;
  std::vector<Tick> modes_, growths_;
  QListWidget *platforms_ = nullptr, *cells_ = nullptr;
  forms::Fold* cellsFold_ = nullptr;
  forms::PlatformEditor* platform_ = nullptr;
  QPushButton *add_ = nullptr, *run_ = nullptr, *cancel_ = nullptr;
  QComboBox* until_ = nullptr;
  forms::Fold* counts_ = nullptr;
  std::vector<QLabel*> weightNames_;
  std::vector<forms::NumberBox*> weights_;
  QPushButton* reset_ = nullptr;
  std::function<QString(const QString&)> platformText_;
  int rows_ = 0;
  bool part_ = false, running_ = false;
};

} // namespace voluta::panels
