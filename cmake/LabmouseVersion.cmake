# The version that results name: `git describe` of the checkout, or the project's own version where there is none.
# Asked at every build, written only when it changed.
set(LABMOUSE_VERSION_SOURCE ${PROJECT_BINARY_DIR}/generated/version.cpp)
add_custom_target(labmouse_version
  COMMAND ${CMAKE_COMMAND} -DSOURCE=${PROJECT_SOURCE_DIR} -DFALLBACK=${PROJECT_VERSION}
          -DOUTPUT=${LABMOUSE_VERSION_SOURCE} -P ${CMAKE_CURRENT_LIST_DIR}/write_version.cmake
  BYPRODUCTS ${LABMOUSE_VERSION_SOURCE}
  COMMENT "Asking for the version")
