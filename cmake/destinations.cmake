# The folders below the prefix that things are installed into: catkin's, or the same without catkin.
include_guard(GLOBAL)

if(RIBBON_MAPPER_HAS_ROS)
  set(RIBBON_MAPPER_DEVEL ${CATKIN_DEVEL_PREFIX})
  set(RIBBON_MAPPER_BIN_DIR ${CATKIN_PACKAGE_BIN_DESTINATION})
  set(RIBBON_MAPPER_LIB_DIR ${CATKIN_PACKAGE_LIB_DESTINATION})
  set(RIBBON_MAPPER_SHARE_DIR ${CATKIN_PACKAGE_SHARE_DESTINATION})
else()
  set(RIBBON_MAPPER_DEVEL ${PROJECT_BINARY_DIR}/devel)
  set(RIBBON_MAPPER_BIN_DIR lib/ribbon_mapper)
  set(RIBBON_MAPPER_LIB_DIR lib)
  set(RIBBON_MAPPER_SHARE_DIR share/ribbon_mapper)
endif()

# The targets lie beside the configuration that find_package() reads: ours, or catkin's, which is
# among the libraries where those have a folder per architecture (Debian's catkin, prefix /usr).
if(NOT RIBBON_MAPPER_HAS_ROS OR NOT RIBBON_MAPPER_LIB_DIR STREQUAL "lib")
  set(RIBBON_MAPPER_CMAKE_DIR ${RIBBON_MAPPER_LIB_DIR}/cmake/ribbon_mapper)
else()
  set(RIBBON_MAPPER_CMAKE_DIR ${RIBBON_MAPPER_SHARE_DIR}/cmake)
endif()
