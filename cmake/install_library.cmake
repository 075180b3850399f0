# Installs the library as a plain CMake package, which find_package(ribbon_mapper) finds.
# In the build with ROS, catkin installs a ribbon_mapperConfig.cmake of its own: there, this is
# installed only when asked for, by `cmake --install build --component library --prefix DIR`.
include(CMakePackageConfigHelpers)

set(package_dir lib/cmake/ribbon_mapper)
set(component COMPONENT library)
if(RIBBON_MAPPER_HAS_ROS)
  list(APPEND component EXCLUDE_FROM_ALL)
endif()

# The include root is ours alone, so that #include "modeler/modeler.hpp" works and nothing collides.
install(DIRECTORY ${RIBBON_MAPPER_ROOT}/modeler DESTINATION include/ribbon_mapper ${component}
  FILES_MATCHING PATTERN "*.hpp" PATTERN "ros" EXCLUDE PATTERN "program" EXCLUDE
  PATTERN "build*" EXCLUDE)

# ribbon_mapper_install(core targets...): the targets as ribbon_mapper::NAME of one component.
function(ribbon_mapper_install name)
  install(TARGETS ${ARGN} EXPORT ribbon_mapper_${name}
    ARCHIVE DESTINATION lib ${component} LIBRARY DESTINATION lib ${component}
    INCLUDES DESTINATION include/ribbon_mapper)
  install(EXPORT ribbon_mapper_${name} NAMESPACE ribbon_mapper::
    FILE ribbon_mapper_${name}Targets.cmake DESTINATION ${package_dir} ${component})
endfunction()

ribbon_mapper_install(core ribbon_mapper_geometry ribbon_mapper_core)
if(RIBBON_MAPPER_HAS_IO)
  ribbon_mapper_install(io ribbon_mapper_io)
endif()

set(generated ${CMAKE_CURRENT_BINARY_DIR}/package)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/ribbon_mapperConfig.cmake.in
  ${generated}/ribbon_mapperConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${generated}/ribbon_mapperConfigVersion.cmake
  VERSION ${RIBBON_MAPPER_VERSION} COMPATIBILITY SameMinorVersion)
install(FILES ${generated}/ribbon_mapperConfig.cmake ${generated}/ribbon_mapperConfigVersion.cmake
  ${CMAKE_CURRENT_LIST_DIR}/modules/FindGEOS.cmake DESTINATION ${package_dir} ${component})
