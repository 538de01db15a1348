# cmake -DFOLDER=folder -DOUTPUT=file -P embed_bridge.cmake
set(script "")
foreach(part dialogue other_python capstone)
  file(READ ${FOLDER}/${part}.py text)
  string(APPEND script "${text}")
endforeach()
file(WRITE ${OUTPUT} "#include \"labmouse/external/capstone.hpp\"\n\nnamespace labmouse {\n\n"
  "std::string_view capstone_bridge() { return R\"bridge(${script})bridge\"; }\n\n}  // namespace labmouse\n")
