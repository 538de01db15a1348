# Compiling several files at once, with the largest headers compiled before, takes a third of the time: most of it goes
# into reading headers and into instantiating what stands in them. docs/contributing/building.md has the figures.
#
# A batch holds whole folders, small ones together, or an even part of one that is larger. Two files of a batch may not
# declare the same name for themselves, unless as overloads: the compiler says where they do. A world's folder is a batch of
# its own, for it has the same names as those of its neighbours.
set(LABMOUSE_BATCH_SIZE 40 CACHE STRING "Files that compile as one: more save little and make a developer wait")

# labmouse_batch(TARGET FILE...): compiles these files of the target in batches, where the build asks for it. Files with
# compiler options of their own stay alone.
function(labmouse_batch target)
  if(NOT LABMOUSE_BATCHES)
    return()
  endif()
  set(folders)
  foreach(file IN LISTS ARGN)
    cmake_path(GET file PARENT_PATH folder)
    cmake_path(RELATIVE_PATH folder BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
    get_source_file_property(options ${file} COMPILE_OPTIONS)
    if(NOT options)
      list(APPEND folders ${folder})
      list(APPEND files_${folder} ${file})
    endif()
  endforeach()
  list(REMOVE_DUPLICATES folders)
  set(batch 0)
  set(held 0)  # files in the batch
  set(world_before FALSE)
  foreach(folder IN LISTS folders)
    list(LENGTH files_${folder} count)
    math(EXPR parts "(${count} + ${LABMOUSE_BATCH_SIZE} - 1) / ${LABMOUSE_BATCH_SIZE}")
    math(EXPR together "${held} + ${count}")
    set(world FALSE)
    if("${files_${folder}}" MATCHES "_world[.]cpp")
      set(world TRUE)
    endif()
    if(together GREATER LABMOUSE_BATCH_SIZE OR world OR world_before)
      math(EXPR batch "${batch} + 1")
      set(together ${count})
    endif()
    set(index 0)
    foreach(file IN LISTS files_${folder})
      math(EXPR group "${batch} + ${index} * ${parts} / ${count}")
      set_source_files_properties(${file} PROPERTIES UNITY_GROUP ${group})
      math(EXPR index "${index} + 1")
    endforeach()
    math(EXPR batch "${batch} + ${parts} - 1")
    set(held ${together})
    set(world_before ${world})
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  # Names of one file may be shadowed in another; without batches this warns as ever.
  target_compile_options(${target} PRIVATE -Wno-shadow)
endfunction()

# labmouse_precompile(TARGET HEADER...): compiles these headers once for the whole target, where the build has batches.
function(labmouse_precompile target)
  if(LABMOUSE_BATCHES)
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()
