include(CMakePackageConfigHelpers)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/texbake-config.cmake.in ${PROJECT_BINARY_DIR}/texbake-config.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/texbake)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/texbake-config-version.cmake COMPATIBILITY SameMajorVersion)
install(EXPORT texbake-targets NAMESPACE texbake:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/texbake)
install(FILES ${PROJECT_BINARY_DIR}/texbake-config.cmake ${PROJECT_BINARY_DIR}/texbake-config-version.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/texbake)
