# labmouse_room(NAME [ROOM...]): one static library (or an interface, where a room has only headers) from all sources
# of labmouse/NAME, that may use the rooms named behind it.
function(labmouse_room name)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/labmouse/${name}/*.cpp)
  set(target labmouse_${name})
  if(sources)
    set(scope PUBLIC)
    add_library(${target} STATIC ${sources})
    target_compile_options(${target} PRIVATE ${LABMOUSE_WARNINGS})
    labmouse_batch(${target} ${sources})
  else()
    set(scope INTERFACE)
    add_library(${target} INTERFACE)
  endif()
  add_library(labmouse::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(${target} ${scope} $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
                             $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_compile_features(${target} ${scope} cxx_std_20)
  # The same bits everywhere: no contraction of floating-point expressions, in no room.
  target_compile_options(${target} ${scope} $<BUILD_INTERFACE:-ffp-contract=off>)
  if(LABMOUSE_SANITIZE)
    target_compile_options(${target} ${scope} $<BUILD_INTERFACE:-fsanitize=address,undefined>
                           $<BUILD_INTERFACE:-fno-sanitize-recover=all> $<BUILD_INTERFACE:-fno-omit-frame-pointer>)
    target_link_options(${target} ${scope} $<BUILD_INTERFACE:-fsanitize=address,undefined>)
  endif()
  foreach(room IN LISTS ARGN)
    target_link_libraries(${target} ${scope} labmouse_${room})
  endforeach()
  set_property(GLOBAL APPEND PROPERTY LABMOUSE_ROOMS ${target})
endfunction()

# labmouse_precompile(TARGET HEADER...): compiles these headers once for the whole target, where the build asks for it.
function(labmouse_precompile target)
  if(LABMOUSE_PRECOMPILE)
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()
