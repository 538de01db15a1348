# The behaviour signature of this build, as a constant: to compute it takes seconds, so a small program does it once, when
# the modules that it depends on were compiled.
set(LABMOUSE_SIGNATURE_SOURCE ${PROJECT_BINARY_DIR}/generated/build_signature.cpp)
if(LABMOUSE_SANITIZE)
  # It only marks contests in stores, and takes a minute to compute with the sanitizers.
  file(GENERATE OUTPUT ${LABMOUSE_SIGNATURE_SOURCE} CONTENT "#include \"labmouse/lab/store/build_signature.hpp\"

namespace labmouse {
std::string_view build_signature() { return \"sanitized\"; }
}  // namespace labmouse
")
  return()
endif()
add_executable(labmouse_signature apps/signature/signature.cpp labmouse/lab/bench/signature.cpp)
target_compile_options(labmouse_signature PRIVATE ${LABMOUSE_WARNINGS})
target_link_libraries(labmouse_signature PRIVATE labmouse::contest labmouse::strategies)
add_custom_command(OUTPUT ${LABMOUSE_SIGNATURE_SOURCE}
  COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:labmouse_signature> -DOUTPUT=${LABMOUSE_SIGNATURE_SOURCE}
          -P ${CMAKE_CURRENT_LIST_DIR}/write_signature.cmake
  DEPENDS labmouse_signature ${CMAKE_CURRENT_LIST_DIR}/write_signature.cmake VERBATIM
  COMMENT "Computing the behaviour signature")
