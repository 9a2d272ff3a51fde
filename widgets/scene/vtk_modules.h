// Forces the linker to keep the file that registers VTK's object factories.
#pragma once

namespace voluta::scene {

void registerVtkModules();

} // namespace voluta::scene
