// Registers VTK's object factories here once; VTK's autoinit would do so in every file.
#include <vtkAutoInit.h>

#include "scene/vtk_modules.h"

VTK_MODULE_INIT(vtkRenderingOpenGL2)
VTK_MODULE_INIT(vtkRenderingFreeType)
VTK_MODULE_INIT(vtkInteractionStyle)

namespace voluta::scene {

void registerVtkModules() {}

} // namespace voluta::scene
