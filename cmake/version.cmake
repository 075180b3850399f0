# Reads the version of the project from package.xml, the one place where it is written.
file(READ ${CMAKE_CURRENT_LIST_DIR}/../package.xml package)
if(NOT package MATCHES "<version>([0-9.]+)</version>")
  message(FATAL_ERROR "package.xml has no <version>")
endif()
set(RIBBON_MAPPER_VERSION ${CMAKE_MATCH_1})
