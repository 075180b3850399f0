# Embree::Embree, of version 4, as in Debian 13, or 3.
foreach(major 4 3)
  find_package(embree ${major} CONFIG QUIET)
  if(embree_FOUND)
    set(Embree_VERSION ${embree_VERSION})
    if(NOT TARGET Embree::Embree)
      add_library(Embree::Embree INTERFACE IMPORTED)
      target_link_libraries(Embree::Embree INTERFACE embree)
      target_compile_definitions(Embree::Embree INTERFACE RIBBON_MAPPER_EMBREE=${major})
    endif()
    break()
  endif()
endforeach()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Embree
  REQUIRED_VARS Embree_VERSION VERSION_VAR Embree_VERSION
  REASON_FAILURE_MESSAGE "install libembree-dev (./install_dependencies test installs it)")
