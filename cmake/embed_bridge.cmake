# cmake -DSCRIPT=file -DOUTPUT=file -P embed_bridge.cmake
file(READ ${SCRIPT} script)
file(WRITE ${OUTPUT} "#include \"labmouse/guests/capstone.hpp\"\n\nnamespace labmouse {\n\n"
  "std::string_view capstone_bridge() { return R\"bridge(${script})bridge\"; }\n\n}  // namespace labmouse\n")
