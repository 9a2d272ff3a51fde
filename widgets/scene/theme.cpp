#include "scene/theme.h"

namespace voluta::scene {

Theme lightTheme() {
  Theme t;
  t.backgroundTop = {0.93, 0.945, 0.96};
  t.backgroundBottom = {0.985, 0.985, 0.98};
  t.text = {0.16, 0.18, 0.21};
  t.axisX = {0.86, 0.52, 0.0};
  t.axisY = {0.0, 0.55, 0.42};
  t.axisZ = {0.0, 0.40, 0.70};
  t.part = {0.25, 0.58, 0.80};
  t.partEdges = {0.08, 0.27, 0.42};
  t.partInside = {0.86, 0.78, 0.66};
  t.otherPart = {0.87, 0.88, 0.89};
  t.otherPartEdges = {0.60, 0.62, 0.65};
  t.partBeyond = {0.95, 0.71, 0.29};
  t.platform = {0.84, 0.85, 0.86};
  t.platformEdges = {0.36, 0.39, 0.43};
  t.grid = {0.74, 0.76, 0.78};
  t.robotLight = {0.80, 0.82, 0.84};
  t.robotDark = {0.50, 0.60, 0.70};
  t.head = {0.72, 0.60, 0.42};
  t.obstacle = {0.80, 0.81, 0.82};
  t.material = {0.90, 0.87, 0.80};
  t.travel = {0.55, 0.57, 0.60};
  t.marker = {0.80, 0.47, 0.65};
  t.blocked = {0.85, 0.10, 0.12};
  t.unreached = {0.96, 0.96, 0.97};
  t.cascade = {0.90, 0.62, 0.00};
  t.risky = {0.86, 0.00, 0.58};
  t.current = {0.98, 0.42, 0.78};
  t.ghost = {0.60, 0.63, 0.66};
  t.front = {0.30, 0.52, 0.74};
  t.insert = {0.42, 0.46, 0.52};
  t.regionSettings = {0.24, 0.20, 0.78};
  t.regionLayers = {0.00, 0.56, 0.36};
  t.regionCut = {0.84, 0.33, 0.05};
  t.regionLoad = {0.78, 0.62, 0.00};
  return t;
}

Theme darkTheme() {
  Theme t = lightTheme();
  t.backgroundTop = {0.13, 0.14, 0.16};
  t.backgroundBottom = {0.20, 0.21, 0.23};
  t.text = {0.90, 0.91, 0.93};
  t.axisX = {0.95, 0.62, 0.20};
  t.axisY = {0.20, 0.75, 0.58};
  t.axisZ = {0.40, 0.70, 0.95};
  t.part = {0.28, 0.60, 0.82};
  t.partEdges = {0.06, 0.20, 0.32};
  t.partInside = {0.60, 0.53, 0.43};
  t.otherPart = {0.43, 0.45, 0.47};
  t.otherPartEdges = {0.27, 0.29, 0.31};
  t.partBeyond = {0.86, 0.61, 0.20};
  t.platform = {0.40, 0.42, 0.44};
  t.platformEdges = {0.66, 0.69, 0.72};
  t.grid = {0.28, 0.295, 0.315};
  t.robotLight = {0.68, 0.70, 0.72};
  t.robotDark = {0.38, 0.48, 0.58};
  t.obstacle = {0.30, 0.31, 0.33};
  t.material = {0.84, 0.80, 0.72};
  t.travel = {0.50, 0.52, 0.55};
  t.blocked = {0.95, 0.22, 0.22};
  t.risky = {0.96, 0.18, 0.72};
  t.front = {0.55, 0.76, 0.95};
  t.insert = {0.66, 0.70, 0.76};
  t.regionSettings = {0.56, 0.52, 1.00};
  t.regionLayers = {0.20, 0.80, 0.55};
  t.regionCut = {0.98, 0.50, 0.20};
  t.regionLoad = {0.96, 0.82, 0.22};
  return t;
}

Theme highContrastTheme() {
  Theme t = darkTheme();
  t.backgroundTop = t.backgroundBottom = {0.0, 0.0, 0.0};
  t.text = {1.0, 1.0, 1.0};
  t.axisX = {1.0, 0.72, 0.30};
  t.axisY = {0.30, 0.95, 0.75};
  t.axisZ = {0.55, 0.80, 1.0};
  t.part = {0.45, 0.75, 0.98};
  t.partEdges = {0.0, 0.0, 0.0};
  t.otherPart = {0.60, 0.62, 0.64};
  t.otherPartEdges = {1.0, 1.0, 1.0};
  t.partBeyond = {1.0, 0.72, 0.20};
  t.platform = {0.33, 0.34, 0.35};
  t.platformEdges = {1.0, 1.0, 1.0};
  t.grid = {0.62, 0.62, 0.62};
  t.robotLight = {0.92, 0.92, 0.92};
  t.robotDark = {0.55, 0.66, 0.78};
  t.head = {1.0, 0.84, 0.40};
  t.obstacle = {0.52, 0.52, 0.54};
  t.material = {0.98, 0.95, 0.85};
  t.travel = {0.80, 0.80, 0.80};
  t.marker = {1.0, 1.0, 0.0};
  t.blocked = {1.0, 0.42, 0.38};
  t.ghost = {0.80, 0.80, 0.80};
  t.front = {0.60, 0.85, 1.0};
  t.insert = {0.86, 0.88, 0.92};
  t.regionSettings = {0.72, 0.66, 1.0};
  t.regionLayers = {0.30, 1.0, 0.65};
  t.regionCut = {1.0, 0.60, 0.25};
  t.regionLoad = {1.0, 0.88, 0.25};
  return t;
}

} // namespace voluta::scene
