# Compiling several files at once takes a third of the time: most of it goes into reading headers and into instantiating
# what stands in them. Within a batch no name may stand for two things, so files that share one in their anonymous
# namespaces are kept apart. docs/building.md has the figures.
set(LABMOUSE_BATCH_SIZE 5)  # files: more save little and make a developer wait

# labmouse_names(FILE OUT): what FILE declares for itself, as a list: names in its anonymous namespace, and NAME=TYPE for
# an alias.
function(labmouse_names file out)
  set(names)
  file(READ ${file} text)
  string(REGEX REPLACE "[][;\\]" "_" text "${text}")  # what a list of CMake cannot hold
  string(REGEX MATCHALL "\nusing [^\n]*" aliases "${text}")
  foreach(alias IN LISTS aliases)
    string(REGEX REPLACE "^\nusing ([A-Za-z0-9_]+) = (.*)$" "\\1=\\2" name "${alias}")
    list(APPEND names ${name})
  endforeach()
  string(REGEX REPLACE "\nusing [^\n]*" "" text "${text}")
  set(opening "\nnamespace {\n")
  string(LENGTH "${opening}" skipped)
  string(FIND "${text}" "${opening}" begin)
  string(FIND "${text}" "\n}  // namespace\n" end)
  if(begin GREATER_EQUAL 0 AND end GREATER begin)
    math(EXPR begin "${begin} + ${skipped} - 1")
    math(EXPR length "${end} - ${begin}")
    string(SUBSTRING "${text}" ${begin} ${length} text)
    string(REGEX MATCHALL "\n([A-Za-z][^\n({=]*[ *&>])?[A-Za-z][A-Za-z0-9_]* ?[({=]" declarations "${text}")
    foreach(declaration IN LISTS declarations)
      string(REGEX REPLACE "^.*[^A-Za-z0-9_]([A-Za-z][A-Za-z0-9_]*) ?[({=]$" "\\1" name "${declaration}")
      list(APPEND names ${name})
    endforeach()
  endif()
  set(${out} ${names} PARENT_SCOPE)
endfunction()

# labmouse_clash(OUT BATCH NAME...): whether one of these names stands for something else in the list BATCH.
function(labmouse_clash out batch)
  set(${out} FALSE PARENT_SCOPE)
  foreach(name IN LISTS ARGN)
    string(REGEX REPLACE "=.*" "" word "${name}")
    if(word IN_LIST ${batch} AND (word STREQUAL name OR NOT name IN_LIST ${batch}))
      set(${out} TRUE PARENT_SCOPE)
    endif()
  endforeach()
endfunction()

# labmouse_batch(TARGET FILE...): compiles these files of the target in batches, where the build asks for it. Files with
# compiler options of their own stay alone.
function(labmouse_batch target)
  if(NOT LABMOUSE_BATCHES)
    return()
  endif()
  # A change may bring a name that another file of the batch has.
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${ARGN})
  set(open)  # batches that are not full
  set(count 0)
  foreach(file IN LISTS ARGN)
    labmouse_names(${file} names)
    set(chosen ${count})
    foreach(batch IN LISTS open)
      labmouse_clash(clash names_${batch} ${names})
      if(NOT clash)
        set(chosen ${batch})
        break()
      endif()
    endforeach()
    if(chosen EQUAL count)
      list(APPEND open ${count})
      math(EXPR count "${count} + 1")
    endif()
    list(APPEND files_${chosen} ${file})
    list(LENGTH files_${chosen} size)
    if(size EQUAL LABMOUSE_BATCH_SIZE)
      list(REMOVE_ITEM open ${chosen})
    endif()
    foreach(name IN LISTS names)
      string(REGEX REPLACE "=.*" "" word "${name}")
      list(APPEND names_${chosen} ${word} ${name})
    endforeach()
    set_source_files_properties(${file} PROPERTIES UNITY_GROUP ${chosen})
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  # Names of one file may be shadowed in another; without batches this warns as ever.
  target_compile_options(${target} PRIVATE -Wno-shadow)
endfunction()
