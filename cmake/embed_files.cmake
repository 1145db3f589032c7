# Writes the header and source that rayscope_embed() describes. Bytes are written as numbers, so any content is safe.
string(REPLACE "|" ";" FILES "${FILES}")
file(WRITE ${HEADER} "#pragma once
#include <span>
#include <string_view>
namespace rayscope::${NAMESPACE} {
struct EmbeddedFile { std::string_view name; std::string_view content; };
std::span<const EmbeddedFile> files();
}
")
set(arrays "")
set(rows "")
set(index 0)
foreach(path IN LISTS FILES)
  get_filename_component(name ${path} NAME)
  file(READ ${path} hex HEX)
  string(REGEX REPLACE "(..)" "'\\\\x\\1'," bytes "${hex}")
  string(REGEX REPLACE "('.x..',)('.x..',)('.x..',)('.x..',)('.x..',)('.x..',)('.x..',)('.x..',)" "\\0\n" bytes "${bytes}")
  string(APPEND arrays "constexpr char file${index}[] = {${bytes}'\\0'};\n")
  string(APPEND rows "    {\"${name}\", {file${index}, sizeof(file${index}) - 1}},\n")
  math(EXPR index "${index} + 1")
endforeach()
file(WRITE ${SOURCE} "#include \"${INCLUDE}\"
namespace rayscope::${NAMESPACE} {
namespace {
${arrays}constexpr EmbeddedFile kFiles[] = {
${rows}};
}
std::span<const EmbeddedFile> files() { return kFiles; }
}
")
