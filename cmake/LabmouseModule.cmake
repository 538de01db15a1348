# labmouse_module(NAME [MODULE...]): one library (or an interface, where a module has only headers) from all sources of
# labmouse/NAME, that may use the modules named behind it.
function(labmouse_module name)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/labmouse/${name}/*.cpp)
  if(LABMOUSE_LEFT_OUT)
    list(FILTER sources EXCLUDE REGEX ${LABMOUSE_LEFT_OUT})
  endif()
  set(target labmouse_${name})
  if(sources)
    set(scope PUBLIC)
    add_library(${target} ${sources})
    # Interfaces change with the second number. Shared libraries define no symbol of their own, so that the program can use
    # their precompiled headers.
    set_target_properties(${target} PROPERTIES VERSION ${PROJECT_VERSION}
                          SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR} INSTALL_RPATH $ORIGIN DEFINE_SYMBOL "")
    target_compile_options(${target} PRIVATE ${LABMOUSE_WARNINGS})
    labmouse_batch(${target} ${sources})
  else()
    set(scope INTERFACE)
    add_library(${target} INTERFACE)
  endif()
  add_library(labmouse::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(${target} ${scope} $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
                             $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_compile_features(${target} ${scope} cxx_std_20)
  # The same bits everywhere: no contraction of floating-point expressions, in no module.
  target_compile_options(${target} ${scope} $<BUILD_INTERFACE:-ffp-contract=off>)
  # Nor by g++ 12, which fuses the product and the sums of two turned directions all the same, where it makes vectors of
  # them and the processor can (-march=native). clang 14 for WebAssembly makes wrong vectors of two numbers that come of the
  # middle bits of others.
  target_compile_options(${target} ${scope} $<BUILD_INTERFACE:$<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>>
                         $<BUILD_INTERFACE:$<$<PLATFORM_ID:Emscripten>:-fno-slp-vectorize>>)
  if(LABMOUSE_SANITIZE)
    # Also the library's own checks: of front() of an empty vector, and the like.
    target_compile_definitions(${target} ${scope} $<BUILD_INTERFACE:_GLIBCXX_ASSERTIONS>)
    target_compile_options(${target} ${scope} $<BUILD_INTERFACE:-fsanitize=address,undefined>
                           $<BUILD_INTERFACE:-fno-sanitize-recover=all> $<BUILD_INTERFACE:-fno-omit-frame-pointer>)
    # lld takes a fifth of the time of the usual linker.
    target_link_options(${target} ${scope} $<BUILD_INTERFACE:-fsanitize=address,undefined>
                        $<BUILD_INTERFACE:$<$<CXX_COMPILER_ID:Clang>:-fuse-ld=lld>>)
  endif()
  foreach(module IN LISTS ARGN)
    target_link_libraries(${target} ${scope} labmouse_${module})
  endforeach()
  set_property(GLOBAL APPEND PROPERTY LABMOUSE_MODULES ${target})
endfunction()
