# CLI11::CLI11: the system's, or the copy in third_party/ where there is none (Debian 11).
find_package(CLI11 CONFIG QUIET)
if(NOT TARGET CLI11::CLI11)
  add_library(CLI11::CLI11 INTERFACE IMPORTED)
  target_include_directories(CLI11::CLI11 SYSTEM INTERFACE
    ${CMAKE_CURRENT_LIST_DIR}/../../third_party/CLI11)
endif()
set(CLI11_FOUND TRUE)
