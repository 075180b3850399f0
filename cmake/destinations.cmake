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

# The targets lie beside the configuration that find_package() reads: catkin's, which Debian's
# catkin places among the libraries if the prefix is /usr, or ours.
if(NOT RIBBON_MAPPER_HAS_ROS OR CMAKE_INSTALL_PREFIX STREQUAL "/usr")
  set(RIBBON_MAPPER_CMAKE_DIR ${RIBBON_MAPPER_LIB_DIR}/cmake/ribbon_mapper)
else()
  set(RIBBON_MAPPER_CMAKE_DIR ${RIBBON_MAPPER_SHARE_DIR}/cmake)
endif()
