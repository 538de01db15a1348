# cmake -DPROGRAM=file -DOUTPUT=file -P write_signature.cmake
execute_process(COMMAND ${PROGRAM} OUTPUT_VARIABLE signature OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
file(WRITE ${OUTPUT} "#include \"labmouse/lab/store/build_signature.hpp\"\n\nnamespace labmouse {\nstd::string_view build_signature() { return \"${signature}\"; }\n}  // namespace labmouse\n")
