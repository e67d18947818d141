# cmake -DFILES=a,b -DOUTPUT=c.cpp -P embed.cmake: the files' bytes as C++ (inspect/report/embedded.h).
string(REPLACE "," ";" files "${FILES}")
set(arrays "")
set(rows "")
foreach(file IN LISTS files)
    file(READ ${file} hex HEX)
    string(REGEX REPLACE "(..)" "0x\\1," bytes "${hex}")
    get_filename_component(name ${file} NAME)
    string(MAKE_C_IDENTIFIER ${name} identifier)
    string(APPEND arrays "constexpr unsigned char bytes_${identifier}[] = {${bytes}};\n")
    string(APPEND rows "    if (name == \"${name}\") return {reinterpret_cast<const char*>(bytes_${identifier}), sizeof bytes_${identifier}};\n")
endforeach()
file(WRITE ${OUTPUT} "#include \"inspect/report/embedded.h\"
#include \"gw/error.h\"
namespace {
${arrays}}
std::string_view gw::report::embedded(std::string_view name) {
${rows}    throw Error(std::string(name) + \": is not built in\");
}
")
