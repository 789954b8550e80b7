# SPDX-License-Identifier: Apache-2.0
# How every library, program and test of the project is built.

include(GNUInstallDirs)

# The language, the rules that make results the same everywhere, and our own warnings.
function(quadbound_compile_rules target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  # Doubles only filter in front of exact tests; a fused multiply-add would still make the filters'
  # counters differ from one machine to the next.
  target_compile_options(${target} PRIVATE -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow
                                           -Wconversion -Wsign-conversion)
  if(QUADBOUND_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()

# quadbound_library(NAME SOURCES ... LINKS ...): the library Quadbound::NAME.
function(quadbound_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  add_library(quadbound_${name} ${ARG_SOURCES})
  add_library(Quadbound::${name} ALIAS quadbound_${name})
  set_target_properties(quadbound_${name} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(
    quadbound_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
                             $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
                             $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/quadbound>)
  target_link_libraries(quadbound_${name} PUBLIC ${ARG_LINKS} PRIVATE ${ARG_PRIVATE_LINKS})
  quadbound_compile_rules(quadbound_${name})
  install(TARGETS quadbound_${name} EXPORT QuadboundTargets)
  install(DIRECTORY ./ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/quadbound/${name}
          FILES_MATCHING PATTERN "*.hpp" PATTERN "*_for_tests.hpp" EXCLUDE
          PATTERN "test_*.hpp" EXCLUDE PATTERN "naive_judge.hpp" EXCLUDE
          PATTERN "mutations.hpp" EXCLUDE)
endfunction()

# quadbound_test(NAME SOURCES ... LINKS ...): one GoogleTest program, a CTest entry per test.
function(quadbound_test name)
  if(NOT QUADBOUND_TESTS)
    return()
  endif()
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE ${ARG_LINKS} GTest::gtest_main)
  quadbound_compile_rules(${name})
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60)
endfunction()
