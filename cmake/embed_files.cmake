# cmake -DKIND=mazes -DPACKAGE=mazes -DTYPE=BuiltinMaze -DENDING=txt -DFOLDER=dir -DOUTPUT=file -P embed_files.cmake
file(GLOB files ${FOLDER}/*.${ENDING})
# By their names: with the ending, "uk-2018" would come before "uk".
list(TRANSFORM files REPLACE "[.]${ENDING}$" "")
list(SORT files)
set(text "#include \"labmouse/lab/${PACKAGE}/builtin_${KIND}.hpp\"\n\n#include <array>\n#include <string_view>\n\nnamespace labmouse {\nnamespace {\n\n")
# Their lengths are those of the literals: compilers do not count so far at compile time.
string(APPEND text "using namespace std::string_view_literals;\n\n")
list(LENGTH files count)
string(APPEND text "constexpr std::array<${TYPE}, ${count}> files = {{\n")
foreach(file IN LISTS files)
  get_filename_component(name ${file} NAME_WE)
  file(READ ${file}.${ENDING} content)
  string(APPEND text "{\"${name}\", R\"content(${content})content\"sv},\n")
endforeach()
string(APPEND text "}};\n\n}  // namespace\n\nstd::span<const ${TYPE}> builtin_${KIND}() { return files; }\n\n}  // namespace labmouse\n")
file(WRITE ${OUTPUT} "${text}")
