#include "window/window_theme.h"

#include "forms/colours.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QPainter>
#include <QPalette>
#include <QProxyStyle>
#include <QStyleFactory>
#include <QStyleOption>
#include <QToolTip>

namespace voluta::window {

namespace {
constexpr int kFocusPixels = 2;
constexpr int kTipMarginPixels = 4, kSeparatorPixels = 4;

// Fusion draws outlines darker than the background, which makes them invisible in the dark looks:
// those of check boxes are drawn here, and with high contrast those of everything that can be
// used, in the colour of texts, with a thick frame in the colour of the selection for the focus.
// There is no style sheet of the application: with one, each widget has a style of its own, and a
// window takes twice as long to build.
class OutlinedStyle : public QProxyStyle {
public:
  OutlinedStyle() : QProxyStyle(QStyleFactory::create("Fusion")) {}

  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override {
    const bool strong = forms::isHighContrast(option->palette);
    if (strong && element == PE_FrameFocusRect)
      return outline(*option, *painter, option->palette.color(QPalette::Highlight), kFocusPixels);
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    const bool isBox = element == PE_IndicatorCheckBox;
    if (isBox && !strong)
      outline(*option, *painter, option->palette.color(QPalette::Disabled, QPalette::Text));
    if (element == PE_PanelLineEdit && widget &&
        qobject_cast<const QAbstractSpinBox*>(widget->parent()))
      return; // the outline is that of the whole box
    const bool isUsed =
        isBox || element == PE_PanelButtonCommand || element == PE_PanelButtonTool ||
        element == PE_PanelLineEdit || element == PE_Frame || element == PE_FrameGroupBox ||
        element == PE_FrameTabWidget || element == PE_FrameMenu || element == PE_PanelTipLabel;
    if (strong && isUsed)
      outline(*option, *painter);
    else if (element == PE_PanelTipLabel)
      outline(*option, *painter, option->palette.color(QPalette::Mid));
    if (strong && element == PE_IndicatorRadioButton) {
      painter->save();
      painter->setRenderHint(QPainter::Antialiasing);
      painter->setBrush(Qt::NoBrush);
      painter->setPen(option->palette.color(QPalette::WindowText));
      painter->drawEllipse(QRectF(option->rect).adjusted(1, 1, -1, -1));
      painter->restore();
    }
  }

  void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                   const QWidget* widget) const override {
    if (element == CE_DockWidgetTitle)
      return drawDockTitle(*option, painter, widget);
    QProxyStyle::drawControl(element, option, painter, widget);
    if (!forms::isHighContrast(option->palette))
      return;
    if (element == CE_TabBarTabShape && (option->state & State_Selected))
      outline(*option, *painter, option->palette.color(QPalette::Highlight), kFocusPixels);
    else if (element == CE_TabBarTabShape || element == CE_HeaderSection ||
             element == CE_ProgressBarGroove)
      outline(*option, *painter);
  }

  void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                          QPainter* painter, const QWidget* widget) const override {
    QProxyStyle::drawComplexControl(control, option, painter, widget);
    if (!forms::isHighContrast(option->palette))
      return;
    if (control == CC_ComboBox || control == CC_SpinBox)
      outline(*option, *painter);
    if (control == CC_Slider || control == CC_ScrollBar) {
      const SubControl handle = control == CC_Slider ? SC_SliderHandle : SC_ScrollBarSlider;
      QStyleOption part(*option);
      part.rect = subControlRect(control, option, handle, widget);
      outline(part, *painter);
    }
  }

  int pixelMetric(PixelMetric metric, const QStyleOption* option,
                  const QWidget* widget) const override {
    return metric == PM_ToolTipLabelFrameWidth ? kTipMarginPixels
           : metric == PM_DockWidgetSeparatorExtent
               ? kSeparatorPixels
               : QProxyStyle::pixelMetric(metric, option, widget);
  }

private:
  void drawDockTitle(const QStyleOption& option, QPainter* painter, const QWidget* widget) const {
    const auto* dock = qstyleoption_cast<const QStyleOptionDockWidget*>(&option);
    QStyleOptionDockWidget title = dock ? *dock : QStyleOptionDockWidget();
    painter->save();
    QFont font = painter->font();
    font.setWeight(QFont::DemiBold);
    painter->setFont(font);
    title.fontMetrics = QFontMetrics(font);
    QProxyStyle::drawControl(CE_DockWidgetTitle, &title, painter, widget);
    painter->restore();
    if (forms::isHighContrast(option.palette))
      outline(option, *painter);
  }

  static void outline(const QStyleOption& option, QPainter& painter, const QColor& colour,
                      int pixels) {
    painter.save();
    painter.setBrush(Qt::NoBrush);
    for (int i = 0; i < pixels; ++i) {
      painter.setPen(colour);
      painter.drawRect(option.rect.adjusted(i, i, -1 - i, -1 - i));
    }
    painter.restore();
  }
  static void outline(const QStyleOption& option, QPainter& painter, const QColor& colour) {
    outline(option, painter, colour, 1);
  }
  static void outline(const QStyleOption& option, QPainter& painter) {
    const bool enabled = option.state & State_Enabled;
    const bool marked = enabled && (option.state & (State_HasFocus | State_On));
    outline(option, painter,
            option.palette.color(enabled ? QPalette::Active : QPalette::Disabled,
                                 marked ? QPalette::Highlight : QPalette::WindowText),
            marked ? kFocusPixels : 1);
  }
};

QPalette highContrastPalette() {
  QPalette p;
  for (const QPalette::ColorRole role :
       {QPalette::Window, QPalette::Base, QPalette::AlternateBase, QPalette::Button,
        QPalette::ToolTipBase, QPalette::Dark, QPalette::Shadow, QPalette::HighlightedText})
    p.setColor(role, Qt::black);
  for (const QPalette::ColorRole role :
       {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::BrightText,
        QPalette::ToolTipText, QPalette::Light, QPalette::Mid})
    p.setColor(role, Qt::white);
  p.setColor(QPalette::Midlight, QColor("#c0c0c0"));
  p.setColor(QPalette::PlaceholderText, QColor("#c8c8c8"));
  p.setColor(QPalette::Highlight, QColor("#ffe000"));
  p.setColor(QPalette::Link, QColor("#80d0ff"));
  p.setColor(QPalette::LinkVisited, QColor("#e0b0ff"));
  for (const QPalette::ColorRole role :
       {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    p.setColor(QPalette::Disabled, role, QColor("#a0a0a0"));
  p.setColor(QPalette::Disabled, QPalette::Highlight, QColor("#606060"));
  p.setColor(QPalette::Disabled, QPalette::HighlightedText, Qt::white);
  return p;
}
} // namespace

QPalette paletteOf(Appearance appearance) {
  if (appearance == Appearance::HighContrast)
    return highContrastPalette();
  const bool dark = appearance == Appearance::Dark;
  QPalette p;
  const auto set = [&](QPalette::ColorRole role, const char* light, const char* darkColour) {
    p.setColor(role, QColor(dark ? darkColour : light));
  };
  set(QPalette::Window, "#f3f4f6", "#25282d");
  set(QPalette::WindowText, "#1c1f24", "#e4e7eb");
  set(QPalette::Base, "#ffffff", "#1c1f23");
  set(QPalette::AlternateBase, "#f7f8fa", "#212429");
  set(QPalette::Text, "#1c1f24", "#e4e7eb");
  set(QPalette::Button, "#e9ebee", "#343840");
  set(QPalette::ButtonText, "#1c1f24", "#e4e7eb");
  set(QPalette::BrightText, "#ffffff", "#ffffff");
  set(QPalette::ToolTipBase, "#ffffff", "#343840");
  set(QPalette::ToolTipText, "#1c1f24", "#e4e7eb");
  set(QPalette::PlaceholderText, "#646b78", "#9aa2ad");
  set(QPalette::Highlight, "#1f6fb2", "#2f75b4");
  set(QPalette::HighlightedText, "#ffffff", "#ffffff");
  set(QPalette::Link, "#1f6fb2", "#6cb2eb");
  set(QPalette::LinkVisited, "#5b4b9a", "#a99be0");
  set(QPalette::Light, "#ffffff", "#3f444d");
  set(QPalette::Midlight, "#e3e6ea", "#383d45");
  set(QPalette::Mid, "#b9bfc7", "#4a505a");
  set(QPalette::Dark, "#9aa1ab", "#15171a");
  set(QPalette::Shadow, "#6f7782", "#0d0e10");
  const QColor faint(dark ? "#7b838e" : "#8d949e");
  for (const QPalette::ColorRole role :
       {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::HighlightedText})
    p.setColor(QPalette::Disabled, role, faint);
  p.setColor(QPalette::Disabled, QPalette::Highlight, QColor(dark ? "#4a505a" : "#c3c8cf"));
  return p;
}

void applyAppearance(QApplication& app, Appearance appearance) {
  app.setStyle(new OutlinedStyle); // Owned by the application
  app.setPalette(paletteOf(appearance));
  QToolTip::setPalette(app.palette());
}

QString appearanceName(Appearance appearance) {
  return appearance == Appearance::Dark           ? "dark"
         : appearance == Appearance::HighContrast ? "highContrast"
                                                  : "light";
}

Appearance appearanceNamed(const QString& name) {
  return name == "dark"           ? Appearance::Dark
         : name == "highContrast" ? Appearance::HighContrast
                                  : Appearance::Light;
}

} // namespace voluta::window
