# cmake -DFILES=a.cpp,b.cpp -DOUTPUT=c.cpp -P batch_tests.cmake: the test files as one source. Each
# file's `namespace gw... {` gets a namespace inside that is the file's own, so that two files may
# use one name. Messages of the compiler name the files.
string(REPLACE "," ";" files "${FILES}")
set(batch "")
foreach(file IN LISTS files)
    file(READ ${file} text)
    get_filename_component(name ${file} NAME_WE)
    string(FIND "${text}" "\nnamespace gw" start)
    string(SUBSTRING "${text}" 0 ${start} includes)
    string(SUBSTRING "${text}" ${start} -1 rest)
    string(FIND "${rest}" "{\n" brace)
    math(EXPR brace "${brace} + 1")
    string(SUBSTRING "${rest}" 0 ${brace} open)
    string(SUBSTRING "${rest}" ${brace} -1 body)
    string(APPEND batch
        "#line 1 \"${file}\"\n${includes}${open} namespace file_${name} {${body}}\n")
endforeach()
file(WRITE ${OUTPUT} "${batch}")
