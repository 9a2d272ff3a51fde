# The core modules as a package for other programs: find_package(Voluta), voluta::pipeline and the rest
# (examples/plan_a_part). Component `development`; the programs, their data and their entries in menus are `program`.
include(CMakePackageConfigHelpers)
set(package lib/cmake/Voluta)

install(DIRECTORY ${CMAKE_SOURCE_DIR}/core/ DESTINATION include/voluta COMPONENT development
  FILES_MATCHING PATTERN "*.h")
install(EXPORT Voluta NAMESPACE voluta:: FILE VolutaTargets.cmake DESTINATION ${package}
  COMPONENT development)
configure_package_config_file(${CMAKE_SOURCE_DIR}/cmake/VolutaConfig.cmake.in
  ${CMAKE_BINARY_DIR}/package/VolutaConfig.cmake INSTALL_DESTINATION ${package})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/package/VolutaConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/package/VolutaConfig.cmake
  ${CMAKE_BINARY_DIR}/package/VolutaConfigVersion.cmake ${CMAKE_SOURCE_DIR}/cmake/FindLibSVM.cmake
  DESTINATION ${package} COMPONENT development)
