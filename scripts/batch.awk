# Prints C++ files one after the other, as one that compiles; messages name the file itself.
# Usage: awk [-v apart=1] -f scripts/batch.awk FILE...
#   apart  each in a namespace of its own below labmouse, so that equal names of two files do not meet
FNR == 1 { printf "#line 1 \"%s\"\n", FILENAME; ++file }
apart { sub(/^namespace labmouse(::[a-z_]+)*/, "&::file_" file) }
{ print }
