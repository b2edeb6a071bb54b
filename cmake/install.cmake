# `find_package(circumball)` gives the target circumball::circumball.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
install(TARGETS circumball EXPORT circumball-targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY lib/include/circumball DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT circumball-targets NAMESPACE circumball::
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/circumball)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/circumball-config-version.cmake
                                 COMPATIBILITY SameMinorVersion)
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/circumball-config.cmake
     "include(\${CMAKE_CURRENT_LIST_DIR}/circumball-targets.cmake)\n")
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/circumball-config.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/circumball-config-version.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/circumball)
if(TARGET circumball_cli)
  install(TARGETS circumball_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
