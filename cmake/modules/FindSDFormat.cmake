# SDFormat::SDFormat, the newest version that is there: 9 is Debian 11's, 12 Debian 12's.
foreach(major RANGE 15 9 -1)
  find_package(sdformat${major} CONFIG QUIET)
  if(sdformat${major}_FOUND)
    set(SDFormat_VERSION ${sdformat${major}_VERSION})
    if(NOT TARGET SDFormat::SDFormat)
      add_library(SDFormat::SDFormat INTERFACE IMPORTED)
      target_link_libraries(SDFormat::SDFormat INTERFACE sdformat${major}::sdformat${major})
    endif()
    break()
  endif()
endforeach()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(SDFormat
  REQUIRED_VARS SDFormat_VERSION VERSION_VAR SDFormat_VERSION
  REASON_FAILURE_MESSAGE "install libsdformat-dev (./install_dependencies does, unless this release of the system lacks it)")
