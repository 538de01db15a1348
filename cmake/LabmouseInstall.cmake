# `cmake --install`: the headers of include/, the modules, and a CMake package for find_package(labmouse).
include(CMakePackageConfigHelpers)

install(TARGETS ${LABMOUSE_MODULES} labmouse_all EXPORT labmouse)
set(left_out)
if(NOT LABMOUSE_LAB)
  set(left_out REGEX "/labmouse/(external|lab)$" EXCLUDE)
endif()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/labmouse DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} ${left_out})
install(EXPORT labmouse NAMESPACE labmouse:: FILE labmouse-targets.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/labmouse)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/labmouse-config.cmake.in
  ${PROJECT_BINARY_DIR}/labmouse-config.cmake INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/labmouse)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/labmouse-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/labmouse-config.cmake ${PROJECT_BINARY_DIR}/labmouse-config-version.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/labmouse)

# For builds without CMake: `pkg-config --cflags --libs labmouse`. Each module stands before those that it uses.
set(LABMOUSE_LIBRARIES "")
foreach(module IN LISTS LABMOUSE_MODULES)
  get_target_property(type ${module} TYPE)
  if(NOT type STREQUAL INTERFACE_LIBRARY)
    string(PREPEND LABMOUSE_LIBRARIES " -l${module}")
  endif()
endforeach()
file(RELATIVE_PATH LABMOUSE_PREFIX /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
set(LABMOUSE_REQUIRES "")
if(LABMOUSE_LAB)
  set(LABMOUSE_REQUIRES "tbb fmt nlohmann_json zlib sqlite3")
endif()
configure_file(${CMAKE_CURRENT_LIST_DIR}/labmouse.pc.in ${PROJECT_BINARY_DIR}/labmouse.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/labmouse.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

if(TARGET labmouse)
  # Finds the libraries beside it, where they are shared.
  set_target_properties(labmouse PROPERTIES INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")
  install(TARGETS labmouse)
  if(TARGET labmouse-avr)
    install(TARGETS labmouse-avr RUNTIME DESTINATION libexec)
  endif()
endif()
