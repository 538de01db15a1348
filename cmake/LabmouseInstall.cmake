# `cmake --install`: the headers, the rooms, and a CMake package for find_package(labmouse), which says which headers are
# public. The others are details that these include.
include(CMakePackageConfigHelpers)
include(LabmousePublicHeaders)
get_property(rooms GLOBAL PROPERTY LABMOUSE_ROOMS)

# labmouse::labmouse is everything at once.
add_library(labmouse_all INTERFACE)
add_library(labmouse::labmouse ALIAS labmouse_all)
set_target_properties(labmouse_all PROPERTIES EXPORT_NAME labmouse)
target_link_libraries(labmouse_all INTERFACE ${rooms})

install(TARGETS ${rooms} labmouse_all EXPORT labmouse ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
foreach(header IN LISTS LABMOUSE_INSTALLED_HEADERS)
  cmake_path(GET header PARENT_PATH folder)
  install(FILES ${PROJECT_SOURCE_DIR}/${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/${folder})
endforeach()
install(EXPORT labmouse NAMESPACE labmouse:: FILE labmouse-targets.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/labmouse)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/labmouse-config.cmake.in
  ${PROJECT_BINARY_DIR}/labmouse-config.cmake INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/labmouse)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/labmouse-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/labmouse-config.cmake ${PROJECT_BINARY_DIR}/labmouse-config-version.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/labmouse)
if(TARGET labmouse)
  install(TARGETS labmouse DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
