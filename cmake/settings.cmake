# What every target of the project is built with.
include_guard(GLOBAL)

get_filename_component(RIBBON_MAPPER_ROOT ${CMAKE_CURRENT_LIST_DIR}/.. ABSOLUTE)

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")  # -O3 gains nothing here and builds slower
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)  # for clang-tidy and editors
set_property(GLOBAL PROPERTY TARGET_MESSAGES OFF)  # no line for each target that is built

find_program(CCACHE ccache)
if(CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()

option(RIBBON_MAPPER_WERROR "Treat warnings as errors, as make lint does" OFF)
set(RIBBON_MAPPER_SANITIZE "" CACHE STRING "Sanitizers to build with, as in -fsanitize=")
if(RIBBON_MAPPER_SANITIZE)
  add_compile_options(-fsanitize=${RIBBON_MAPPER_SANITIZE} -fno-sanitize-recover=all
    -fno-omit-frame-pointer -O1 -g1)
  add_link_options(-fsanitize=${RIBBON_MAPPER_SANITIZE})
endif()

# Warnings are for our own targets only: never exported.
add_library(ribbon_mapper_options INTERFACE)
target_compile_options(ribbon_mapper_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow $<$<BOOL:${RIBBON_MAPPER_WERROR}>:-Werror>)
target_include_directories(ribbon_mapper_options INTERFACE ${RIBBON_MAPPER_ROOT})

# The core also refuses conversions that may lose digits. Signs are exempt: Eigen's indices are
# signed, those of the standard library are not.
add_library(ribbon_mapper_core_options INTERFACE)
target_compile_options(ribbon_mapper_core_options INTERFACE -Wconversion -Wno-sign-conversion)
target_link_libraries(ribbon_mapper_core_options INTERFACE ribbon_mapper_options)
