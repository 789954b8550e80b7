# SPDX-License-Identifier: Apache-2.0
# find_package(Quadbound) for other projects, and the project that tests it.

include(CMakePackageConfigHelpers)

set(QUADBOUND_CONFIG_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/Quadbound)
configure_package_config_file(cmake/QuadboundConfig.cmake.in QuadboundConfig.cmake
                              INSTALL_DESTINATION ${QUADBOUND_CONFIG_DIR})
write_basic_package_version_file(QuadboundConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/QuadboundConfig.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/QuadboundConfigVersion.cmake
        DESTINATION ${QUADBOUND_CONFIG_DIR})
install(EXPORT QuadboundTargets NAMESPACE Quadbound:: DESTINATION ${QUADBOUND_CONFIG_DIR})

if(QUADBOUND_TESTS)
  string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type)  # sanitizer flags must reach the consumer too
  add_test(NAME consumer_project
           COMMAND ${CMAKE_COMMAND} -D BUILD_DIR=${CMAKE_BINARY_DIR} -D GENERATOR=${CMAKE_GENERATOR}
                   -D "FLAGS=${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${build_type}}"
                   -D SOURCE_DIR=${PROJECT_SOURCE_DIR}/cmake/consumer
                   -P ${PROJECT_SOURCE_DIR}/cmake/consumer/test.cmake)
endif()
