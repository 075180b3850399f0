# assimp::assimp by pkg-config: in Debian 11, the package's own CMake files name a folder that is not
# there.
find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
  pkg_check_modules(ASSIMP QUIET IMPORTED_TARGET assimp)
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(assimp
  REQUIRED_VARS ASSIMP_LINK_LIBRARIES VERSION_VAR ASSIMP_VERSION
  REASON_FAILURE_MESSAGE "install libassimp-dev (./install_dependencies does, unless this release of the system lacks it)")
if(assimp_FOUND AND NOT TARGET assimp::assimp)
  add_library(assimp::assimp INTERFACE IMPORTED)
  target_link_libraries(assimp::assimp INTERFACE PkgConfig::ASSIMP)
endif()
