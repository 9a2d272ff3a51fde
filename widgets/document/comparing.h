// Ways of building the document's part, planned one after the other in the background.
#pragma once

#include "jobs/job_runner.h"
#include "pipeline/compare_figures.h"

#include <QImage>
#include <QObject>
#include <QString>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace voluta::document {

class Document;

// What is compared; a list that is empty means what the document has.
struct ComparedWays {
  std::vector<std::string> modes;
  std::vector<curved::GrowthScheme> growths;
  std::vector<project::Platform> platforms;
  project::Stage until = project::Stage::Replay;
};

// A picture of a planned job; called on the thread of the run. Null: none.
using PictureMaker = std::function<QImage(const project::Job&)>;

class Comparing : public QObject {
  Q_OBJECT

public:
  // `document` outlives this.
  explicit Comparing(Document& document, QObject* parent = nullptr);
  ~Comparing() override;

  void setPictures(PictureMaker pictures) { pictures_ = std::move(pictures); }

  // Precondition: the document has a part that is ready. Rows of the last comparison are dropped.
  void run(const ComparedWays& ways);
  // Rows that are done stay.
  void cancel();
  bool running() const { return runner_.running(); }
  const jobs::Progress& progress() const { return runner_.progress(); }

  struct Row {
    pipeline::Combination combination;
    std::optional<pipeline::CompareRow> compared; // none: not planned yet, or never
    QImage picture;
    // Its plan, to be gone on with: kept of the best few only.
    std::shared_ptr<const pipeline::PlanResult> result;
  };
  const std::vector<Row>& rows() const { return rows_; }
  std::optional<std::size_t> current() const { return current_; } // row that is being planned
  project::Stage until() const { return until_; }
  // The part and all other choices are what the rows were planned with.
  bool upToDate() const;

  const pipeline::Weights& weights() const { return weights_; }
  void setWeights(const pipeline::Weights& weights);
  // Of the rows that are done; `scores` and the numbers are those of rows(), which is in order of
  // planning.
  const pipeline::Ranking& ranking() const { return ranking_; }

signals:
  void started();
  void progressed(const voluta::jobs::Progress& progress);
  void rowsChanged();                  // other rows
  void rowChanged(int row);            // it begins, or is done
  void rankingChanged();               // scores, the best
  void ended();                        // also after a cancel
  void failed(const QString& message); // the part or a choice will not do; before ended()

private:
  std::string keyOf(const pipeline::PlanRequest& request) const;
  bool sameAsPlanned() const;
  void take(std::size_t row, const pipeline::CompareRow& compared, const QImage& picture,
            std::shared_ptr<const pipeline::PlanResult> result);
  void rankAgain();

  Document& document_;
  jobs::JobRunner runner_;
  PictureMaker pictures_;
  std::vector<Row> rows_;
  std::optional<std::size_t> current_;
  pipeline::Weights weights_ = pipeline::defaultWeights();
  pipeline::Ranking ranking_;
  project::Stage until_ = project::Stage::Replay;
  std::string key_;
  mutable std::optional<bool>
      upToDate_; // until the next edit: asked far more often than it changes
};

} // namespace voluta::document
