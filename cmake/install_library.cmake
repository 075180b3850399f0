# Installs the library, its headers and its targets, which find_package(ribbon_mapper) gives: see
# ribbon_mapper-extras.cmake.
include(CMakePackageConfigHelpers)

# The include root is ours alone, so that #include "modeler/modeler.hpp" works and nothing collides.
install(DIRECTORY ${RIBBON_MAPPER_ROOT}/modeler DESTINATION include/ribbon_mapper
  FILES_MATCHING PATTERN "*.hpp" PATTERN "ros" EXCLUDE PATTERN "program" EXCLUDE
  PATTERN "page" EXCLUDE PATTERN "build*" EXCLUDE)

# ribbon_mapper_install(core targets...): the targets as ribbon_mapper::NAME of one component.
function(ribbon_mapper_install name)
  install(TARGETS ${ARGN} EXPORT ribbon_mapper_${name}
    ARCHIVE DESTINATION ${RIBBON_MAPPER_LIB_DIR} LIBRARY DESTINATION ${RIBBON_MAPPER_LIB_DIR}
    INCLUDES DESTINATION include/ribbon_mapper)
  install(EXPORT ribbon_mapper_${name} NAMESPACE ribbon_mapper::
    FILE ribbon_mapper_${name}Targets.cmake DESTINATION ${RIBBON_MAPPER_CMAKE_DIR})
endfunction()

# The same for packages that use the devel space. Static libraries name our options there.
function(ribbon_mapper_export name)
  export(TARGETS ${ARGN} NAMESPACE ribbon_mapper::
    FILE ${RIBBON_MAPPER_DEVEL}/share/ribbon_mapper/cmake/ribbon_mapper_${name}Targets.cmake)
endfunction()

set(core ribbon_mapper_geometry ribbon_mapper_core)
ribbon_mapper_install(core ${core})
if(RIBBON_MAPPER_HAS_IO)
  ribbon_mapper_install(io ribbon_mapper_io)
endif()
if(RIBBON_MAPPER_HAS_ROS)
  ribbon_mapper_export(core ${core} ribbon_mapper_options ribbon_mapper_core_options)
  ribbon_mapper_export(io ribbon_mapper_io)
  file(COPY ${RIBBON_MAPPER_ROOT}/cmake/modules/FindGEOS.cmake
    DESTINATION ${RIBBON_MAPPER_DEVEL}/share/ribbon_mapper/cmake)
endif()

# With ROS, catkin_package() installs the configuration of this name.
if(NOT RIBBON_MAPPER_HAS_ROS)
  set(version ${CMAKE_CURRENT_BINARY_DIR}/ribbon_mapperConfigVersion.cmake)
  write_basic_package_version_file(${version}
    VERSION ${RIBBON_MAPPER_VERSION} COMPATIBILITY SameMinorVersion)
  install(FILES ${RIBBON_MAPPER_ROOT}/cmake/ribbon_mapper-extras.cmake
    RENAME ribbon_mapperConfig.cmake DESTINATION ${RIBBON_MAPPER_CMAKE_DIR})
  install(FILES ${version} DESTINATION ${RIBBON_MAPPER_CMAKE_DIR})
endif()
install(FILES ${RIBBON_MAPPER_ROOT}/cmake/modules/FindGEOS.cmake
  DESTINATION ${RIBBON_MAPPER_CMAKE_DIR})
