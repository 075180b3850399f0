# How tests are added.
include_guard(GLOBAL)

include(GoogleTest)

# ribbon_mapper_test(name [LONG|EACH] SOURCES a.cpp ... LIBRARIES lib ...): one gtest binary, one
# ctest entry. LONG ones start first, so that no core waits for the last one. With EACH, every test
# of the binary is an entry, for binaries of few and long tests.
function(ribbon_mapper_test name)
  cmake_parse_arguments(TEST "LONG;EACH" "" "SOURCES;LIBRARIES" ${ARGN})
  add_executable(${name} ${TEST_SOURCES})
  target_link_libraries(${name} PRIVATE ${TEST_LIBRARIES} ribbon_mapper_options
    GTest::gtest GTest::gmock GTest::gtest_main)
  target_compile_definitions(${name} PRIVATE PROJECT_DIR="${RIBBON_MAPPER_ROOT}")
  if(TEST_EACH)
    gtest_discover_tests(${name} TEST_PREFIX ${name}. DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 120)
    return()
  endif()
  add_test(NAME ${name} COMMAND ${name})
  if(TEST_LONG)
    set_tests_properties(${name} PROPERTIES COST 100)
  endif()
endfunction()
