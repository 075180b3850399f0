# Where programs are built and installed: as catkin wants it (REP 122), or in the same places
# without catkin.
include_guard(GLOBAL)

# A program finds our libraries from where it is itself, so that the prefix can be moved.
file(RELATIVE_PATH RIBBON_MAPPER_TO_LIBRARIES /${RIBBON_MAPPER_BIN_DIR} /${RIBBON_MAPPER_LIB_DIR})

# Places the executables where rosrun finds them, and installs them.
function(ribbon_mapper_programs)
  set_target_properties(${ARGN} PROPERTIES
    RUNTIME_OUTPUT_DIRECTORY ${RIBBON_MAPPER_DEVEL}/lib/${PROJECT_NAME}
    INSTALL_RPATH "$ORIGIN/${RIBBON_MAPPER_TO_LIBRARIES}")
  install(TARGETS ${ARGN} RUNTIME DESTINATION ${RIBBON_MAPPER_BIN_DIR})
  set_property(GLOBAL APPEND PROPERTY RIBBON_MAPPER_PROGRAMS ${ARGN})  # for their tests
endfunction()
