# assimp::assimp, also where the package's own CMake files define no target (Debian 11).
find_package(assimp CONFIG QUIET)
if(NOT TARGET assimp::assimp)
  find_package(PkgConfig QUIET)
  if(PkgConfig_FOUND)
    pkg_check_modules(ASSIMP QUIET IMPORTED_TARGET assimp)
    if(ASSIMP_FOUND)
      add_library(assimp::assimp INTERFACE IMPORTED)
      target_link_libraries(assimp::assimp INTERFACE PkgConfig::ASSIMP)
    endif()
  endif()
endif()
include(FindPackageHandleStandardArgs)
if(TARGET assimp::assimp)
  set(assimp_target assimp::assimp)
endif()
find_package_handle_standard_args(assimp
  REQUIRED_VARS assimp_target
  REASON_FAILURE_MESSAGE "install libassimp-dev (./install_dependencies installs all)")
