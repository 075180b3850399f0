# What find_package(ribbon_mapper [COMPONENTS core io]) gives: ribbon_mapper::core and, if its
# libraries are there, ribbon_mapper::io. Without COMPONENTS, only the core is required.
# This is the whole configuration of the plain library. Where ROS is, catkin's includes it, and has
# the messages on top.
include(CMakeFindDependencyMacro)
find_dependency(Eigen3 NO_MODULE)
list(INSERT CMAKE_MODULE_PATH 0 ${ribbon_mapper_DIR})
find_dependency(GEOS)  # by our FindGEOS.cmake
list(REMOVE_AT CMAKE_MODULE_PATH 0)
find_dependency(tsl-robin-map)
if(TARGET ribbon_mapper::core)  # both are in the same catkin workspace
  set(_ribbon_mapper_includes ${ribbon_mapper_SOURCE_DIR})
else()
  include(${ribbon_mapper_DIR}/ribbon_mapper_coreTargets.cmake)
  include(${ribbon_mapper_DIR}/ribbon_mapper_ioTargets.cmake OPTIONAL)
  get_target_property(_ribbon_mapper_includes
    ribbon_mapper::geometry INTERFACE_INCLUDE_DIRECTORIES)
endif()
set(ribbon_mapper_core_FOUND TRUE)

if(TARGET ribbon_mapper::io)
  find_package(yaml-cpp QUIET)
  find_package(octomap QUIET)
  find_package(ZLIB QUIET)
  find_package(nlohmann_json QUIET)  # named by the devel space only
  if(yaml-cpp_FOUND AND octomap_FOUND AND ZLIB_FOUND)
    set(ribbon_mapper_io_FOUND TRUE)
  endif()
endif()

# For packages that use catkin_INCLUDE_DIRS instead of targets.
list(APPEND ribbon_mapper_INCLUDE_DIRS ${_ribbon_mapper_includes} ${EIGEN3_INCLUDE_DIRS})

foreach(_component ${ribbon_mapper_FIND_COMPONENTS})
  if(ribbon_mapper_FIND_REQUIRED_${_component} AND NOT ribbon_mapper_${_component}_FOUND)
    set(ribbon_mapper_FOUND FALSE)
    set(ribbon_mapper_NOT_FOUND_MESSAGE "the component ${_component} is not there")
  endif()
endforeach()
