# Where programs are built and installed: as catkin wants it, or in the same places without catkin.
include_guard(GLOBAL)

if(NOT CATKIN_DEVEL_PREFIX)
  set(CATKIN_DEVEL_PREFIX ${PROJECT_BINARY_DIR}/devel)
  set(CATKIN_PACKAGE_BIN_DESTINATION lib/${PROJECT_NAME})
  set(CATKIN_PACKAGE_SHARE_DESTINATION share/${PROJECT_NAME})
endif()

# Places the executables where rosrun finds them, and installs them.
function(ribbon_mapper_programs)
  set_target_properties(${ARGN} PROPERTIES
    RUNTIME_OUTPUT_DIRECTORY ${CATKIN_DEVEL_PREFIX}/lib/${PROJECT_NAME})
  install(TARGETS ${ARGN} DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
endfunction()
