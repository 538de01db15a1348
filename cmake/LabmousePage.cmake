# The page (built by `make page`) as the program embeds it. At every build it is copied to LABMOUSE_PAGE_COPY, only where it
# changed, and an empty file takes its place where there is none: so that a page built later gets in without reconfiguring.
set(LABMOUSE_PAGE_FILE ${PROJECT_SOURCE_DIR}/build/page/labmouse.html CACHE FILEPATH "The page that the program embeds")
set(LABMOUSE_PAGE_COPY ${PROJECT_BINARY_DIR}/generated/labmouse.html)
add_custom_target(labmouse_page
  COMMAND ${CMAKE_COMMAND} -DINPUT=${LABMOUSE_PAGE_FILE} -DOUTPUT=${LABMOUSE_PAGE_COPY}
          -P ${CMAKE_CURRENT_LIST_DIR}/copy_page.cmake
  BYPRODUCTS ${LABMOUSE_PAGE_COPY}
  COMMENT "Looking for the page")
