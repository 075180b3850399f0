# GEOS::geos_c, also on systems whose package has no CMake files (before GEOS 3.10, as in Debian 11).
find_package(GEOS CONFIG QUIET)
if(NOT TARGET GEOS::geos_c)
  find_path(GEOS_INCLUDE_DIR geos_c.h)
  find_library(GEOS_C_LIBRARY geos_c)
  if(GEOS_INCLUDE_DIR AND GEOS_C_LIBRARY)
    add_library(GEOS::geos_c UNKNOWN IMPORTED)
    set_target_properties(GEOS::geos_c PROPERTIES
      IMPORTED_LOCATION ${GEOS_C_LIBRARY} INTERFACE_INCLUDE_DIRECTORIES ${GEOS_INCLUDE_DIR})
  endif()
  mark_as_advanced(GEOS_INCLUDE_DIR GEOS_C_LIBRARY)
endif()
include(FindPackageHandleStandardArgs)
if(TARGET GEOS::geos_c)
  set(geos_target GEOS::geos_c)
endif()
find_package_handle_standard_args(GEOS
  REQUIRED_VARS geos_target
  REASON_FAILURE_MESSAGE "install libgeos-dev (./install_dependencies does, unless this release of the system lacks it)")
