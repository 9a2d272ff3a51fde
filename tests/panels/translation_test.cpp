#include "forms/choices_form.h"
#include "forms/parameter_form.h"
#include "gallery_data.h"
#include "long_translator.h"
#include "panels/export_panel.h"
#include "panels/findings_panel.h"
#include "panels/layer_info.h"
#include "panels/mesh_panel.h"
#include "panels/object_tree.h"
#include "panels/placement_panel.h"
#include "panels/verdict_table.h"
#include "pipeline/road.h"
#include "pipeline/stage_options.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QTextDocumentFragment>
#include <gtest/gtest.h>

using namespace voluta;

namespace {
// The texts on a widget and its children, tool tips included.
QStringList textsOf(const QWidget& top) {
  QStringList texts;
  for (const QWidget* widget : top.findChildren<QWidget*>()) {
    texts << widget->toolTip();
    if (const auto* label = qobject_cast<const QLabel*>(widget))
      texts << label->text();
    if (const auto* button = qobject_cast<const QAbstractButton*>(widget))
      texts << button->text();
    if (const auto* line = qobject_cast<const QLineEdit*>(widget))
      texts << line->placeholderText();
    if (const auto* combo = qobject_cast<const QComboBox*>(widget))
      for (int i = 0; i < combo->count(); ++i)
        texts << combo->itemText(i);
    if (const auto* view = qobject_cast<const QAbstractItemView*>(widget)) {
      const QAbstractItemModel* model = view->model();
      for (int column = 0; column < model->columnCount(); ++column)
        texts << model->headerData(column, Qt::Horizontal).toString();
      for (int row = 0; row < model->rowCount(); ++row)
        for (int column = 0; column < model->columnCount(); ++column)
          texts << model->index(row, column).data(Qt::ToolTipRole).toString();
    }
  }
  for (QString& text : texts)
    text = QTextDocumentFragment::fromHtml(text).toPlainText();
  texts.removeDuplicates();
  return texts;
}

// Shows `panel` in English, then in the longer language, and names texts that stayed English though
// they have words that are not data.
void expectFollows(QWidget& panel, const QStringList& data) {
  panel.show();
  const QStringList english = textsOf(panel);
  gallery::LongTranslator translator;
  QApplication::installTranslator(&translator);
  QApplication::processEvents();
  const QStringList after = textsOf(panel);
  EXPECT_LE(panel.minimumSizeHint().width(), 300);
  QApplication::removeTranslator(&translator);
  QApplication::processEvents();
  EXPECT_EQ(textsOf(panel), english);
  for (const QString& text : after) {
    const bool isData = std::any_of(data.begin(), data.end(),
                                    [&](const QString& known) { return text.contains(known); });
    const bool hasWord = text.contains(QRegularExpression(QStringLiteral("[A-Za-z]{3}")));
    EXPECT_TRUE(isData || !hasWord || text.contains(QChar(0x00ab))) << qPrintable(text);
  }
}
} // namespace

TEST(Translation, FormsFollowAChangeOfLanguage) {
  forms::ParameterForm form(pipeline::allParameters());
  form.setValues({{"layerHeightMm", "0.6"}});
  form.setShowAll(true);
  expectFollows(form, {});
  forms::ChoicesForm choices;
  choices.setTexts({"curved", "auto", "fit:0", "ur5-fixed", "fdm-1.0", 1});
  expectFollows(choices, {"curved", "auto", "ur5-fixed", "fdm-1.0"});
}

TEST(Translation, PanelsFollowAChangeOfLanguage) {
  panels::FindingsPanel findings;
  findings.setFindings(gallery::sampleFindings());
  expectFollows(findings, {"ear", "hole", "wrist"});
  panels::PlacementPanel placement;
  placement.setSizeMm({1.0, 2.0, 3.0});
  expectFollows(placement, {});
  panels::MeshPanel mesh;
  mesh.setSummary(gallery::sampleMesh());
  expectFollows(mesh, {});
  panels::LayerInfo layer;
  layer.setMeasures(gallery::sampleLayer());
  expectFollows(layer, {});
  panels::ExportPanel exported;
  exported.setFormats(gallery::sampleFormats());
  exported.setFolder("/tmp");
  expectFollows(exported, {"kitten.script", "Not tested on a machine"});
}

TEST(Translation, TheTreeFollowsAChangeOfLanguage) {
  panels::ObjectTree tree;
  gallery::LongTranslator translator;
  QApplication::installTranslator(&translator);
  QApplication::processEvents();
  for (int i = 0; i < tree.topLevelItemCount(); ++i)
    EXPECT_TRUE(tree.topLevelItem(i)->text(0).contains(QChar(0x00ab)));
  QApplication::removeTranslator(&translator);
}
