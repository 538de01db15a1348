# `cmake --install`: the headers, the rooms, and a CMake package for find_package(labmouse), which says which headers are
# public. The others are details that these include.
include(CMakePackageConfigHelpers)
include(LabmousePublicHeaders)
if(NOT LABMOUSE_LAB)
  list(FILTER LABMOUSE_PUBLIC_HEADERS EXCLUDE REGEX "^labmouse/lab/")
endif()
set(no_headers "")
foreach(header IN LISTS LABMOUSE_HEADERS_OF_ONE_FILE)
  cmake_path(GET header FILENAME name)
  list(APPEND no_headers PATTERN ${name} EXCLUDE)
endforeach()
get_property(rooms GLOBAL PROPERTY LABMOUSE_ROOMS)

# labmouse::labmouse is everything at once.
add_library(labmouse_all INTERFACE)
add_library(labmouse::labmouse ALIAS labmouse_all)
set_target_properties(labmouse_all PROPERTIES EXPORT_NAME labmouse)
target_link_libraries(labmouse_all INTERFACE ${rooms})

install(TARGETS ${rooms} labmouse_all EXPORT labmouse ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/labmouse DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        FILES_MATCHING PATTERN "*.hpp" ${no_headers})
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
