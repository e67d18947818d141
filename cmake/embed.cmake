# The work of gw_embed: cmake -DFILES=a,b -DHEADER=h.h -DFUNCTION=gw::report::embedded
# -DOUTPUT=c.cpp -P embed.cmake
string(REPLACE "," ";" files "${FILES}")
set(arrays "")
set(rows "")
foreach(file IN LISTS files)
    file(READ ${file} hex HEX)
    string(REGEX REPLACE "(..)" "0x\\1," bytes "${hex}")
    get_filename_component(name ${file} NAME)
    string(MAKE_C_IDENTIFIER ${name} identifier)
    string(APPEND arrays "constexpr unsigned char bytes_${identifier}[] = {${bytes}};\n")
    string(APPEND rows
        "    if (name == \"${name}\") return {reinterpret_cast<const char*>(bytes_${identifier}), sizeof bytes_${identifier}};\n")
endforeach()
file(WRITE ${OUTPUT} "#include \"${HEADER}\"
namespace {
${arrays}}
std::string_view ${FUNCTION}([[maybe_unused]] std::string_view name) {
${rows}    return {};
}
")
