// Contents of the gallery: values as a window would have them.
#pragma once

#include "panels/format_list.h"
#include "panels/layer_info.h"
#include "panels/mesh_panel.h"
#include "plan/finding.h"

#include <vector>

namespace voluta::gallery {

plan::Findings sampleFindings();
panels::MeshSummary sampleMesh();
panels::LayerMeasures sampleLayer();
std::vector<panels::ExportFormat> sampleFormats();

} // namespace voluta::gallery
