# gw_library, gw_command, gw_test: a folder's sources as one target. Each folder's CMakeLists.txt
# finds its packages.
include_guard(GLOBAL)

# With precompiled headers, g++ -O0 takes <immintrin.h> for that of optimized code, and refuses
# Highway's AVX-512.
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_BUILD_TYPE MATCHES "^(Debug)?$"
        AND NOT "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_DEBUG}" MATCHES "-O[123s]")
    set(CMAKE_DISABLE_PRECOMPILE_HEADERS ON)
endif()

# Warnings are chosen so that correct code needs no casts beyond those that change a number's kind.
# In a batch, a local name would shadow a function of another source.
set(gw_misfires -Wno-restrict)  # false alarms of g++ 12 in std::string
if(NOT CMAKE_DISABLE_PRECOMPILE_HEADERS)
    # the same, if its header is precompiled
    list(APPEND gw_misfires -Wno-stringop-overflow -Wno-stringop-overread -Wno-array-bounds)
endif()
add_library(gw_warnings INTERFACE)
target_compile_options(gw_warnings INTERFACE
    -Wall -Wextra $<$<NOT:$<BOOL:${GW_BATCHES}>>:-Wshadow> -Wvla -Wnon-virtual-dtor
        -Woverloaded-virtual -Wfloat-conversion
    -Wno-missing-field-initializers  # pass tuples name only what differs from GL's initial value
    "$<$<CXX_COMPILER_ID:GNU>:${gw_misfires}>")

# -O1 saves more time in compiling tests that compute than it costs in running them, -O0 in
# compiling the others. At -O1, g++ reports the value of an empty std::optional as used.
set(gw_test_options $<$<CONFIG:Release>:-O1>
    $<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU>>:-Wno-maybe-uninitialized>)
set(gw_plain_test_options $<$<CONFIG:Release>:-O0>)

# In a batch, g++ takes a source for a header, in which types must not have members from anonymous
# namespaces. What it finds by following inlined calls depends on the batch, so it warns without
# ending the build.
if(GW_BATCHES)
    set(gw_batch_options -Wno-subobject-linkage -Wno-error=maybe-uninitialized
        -Wno-error=dangling-pointer -Wno-error=use-after-free -Wno-error=free-nonheap-object
        -Wno-error=nonnull)
    set(gw_batch_options "$<$<CXX_COMPILER_ID:GNU>:${gw_batch_options}>")
endif()

function(gw_compile target)
    target_compile_features(${target} PUBLIC cxx_std_20)
    set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
    target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:gw_warnings>)
endfunction()

# gw_position_independent(TARGET): shared libraries and Python modules can link it. The compiler may
# still inline and clone its functions: no symbol of it is replaced at run time.
function(gw_position_independent target)
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    target_compile_options(${target} PRIVATE -fno-semantic-interposition)
endfunction()

# gw_batch(TARGET): compiles its sources 32 at a time (CMake's unity build), so that they
# share the work of headers and templates. A source that defines macros is compiled alone: Highway's
# kernels, and sources that configure a library. Within a batch, names in anonymous namespaces must
# differ.
function(gw_batch target)
    if(NOT GW_BATCHES)
        return()
    endif()
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 32)
    target_compile_options(${target} PRIVATE ${gw_batch_options})
    get_target_property(sources ${target} SOURCES)
    foreach(source IN LISTS sources)
        get_filename_component(path ${source} ABSOLUTE BASE_DIR ${CMAKE_CURRENT_SOURCE_DIR})
        gw_defines_macros(${path} alone)
        if(alone)
            set_source_files_properties(${path} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
        endif()
    endforeach()
endfunction()

function(gw_defines_macros path result)
    set(macros "")
    if(EXISTS ${path})
        file(STRINGS ${path} macros REGEX "^#define" LIMIT_COUNT 1)
    endif()
    set(${result} OFF PARENT_SCOPE)
    if(macros)
        set(${result} ON PARENT_SCOPE)
    endif()
endfunction()

# gw_batch_tests(TARGET VARIABLE): replaces the files test_*.cpp in the list VARIABLE by sources
# that hold 32 of them each, made by batch_tests.cmake. Names of two files do not meet there.
function(gw_batch_tests target variable)
    if(NOT GW_BATCHES)
        return()
    endif()
    set(sources ${${variable}})
    set(batch "")
    set(count 0)
    foreach(source IN LISTS ${variable} ITEMS end)
        set(alone ON)
        if(source MATCHES "/test_[^/]*$")
            gw_defines_macros(${source} alone)
        endif()
        if(NOT alone)
            list(APPEND batch ${source})
        endif()
        list(LENGTH batch length)
        if(length EQUAL 32 OR (source STREQUAL end AND length GREATER 0))
            math(EXPR count "${count} + 1")
            set(output ${CMAKE_CURRENT_BINARY_DIR}/batches/${target}_${count}.cpp)
            list(JOIN batch "," joined)
            add_custom_command(OUTPUT ${output}
                COMMAND ${CMAKE_COMMAND} -DFILES=${joined} -DOUTPUT=${output}
                    -P ${PROJECT_SOURCE_DIR}/cmake/batch_tests.cmake
                DEPENDS ${batch} ${PROJECT_SOURCE_DIR}/cmake/batch_tests.cmake
                VERBATIM)
            list(REMOVE_ITEM sources ${batch})
            list(APPEND sources ${output})
            set(batch "")
        endif()
    endforeach()
    set(${variable} ${sources} PARENT_SCOPE)
endfunction()

# gw_library(FOLDER [TARGET name] [EXCLUDE file...] [LINK library...])
# Compiles all *.cpp below the calling folder into library gw_FOLDER, alias gw::FOLDER (or the name,
# if given), and installs the headers. A folder below it with a CMakeLists.txt is a target of its
# own. EXCLUDE: sources to leave out, headers not to install.
function(gw_library folder)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "TARGET" "EXCLUDE;LINK")
    set(name ${folder})
    if(arg_TARGET)
        set(name ${arg_TARGET})
    endif()
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} *.cpp)
    list(REMOVE_ITEM sources ${arg_EXCLUDE} "")
    file(GLOB others CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} */CMakeLists.txt)
    list(TRANSFORM others REPLACE "CMakeLists.txt$" "")
    foreach(other IN LISTS others)
        list(FILTER sources EXCLUDE REGEX "^${other}")
    endforeach()
    if(NOT sources)
        return()
    endif()
    add_library(gw_${name} ${sources})
    add_library(gw::${name} ALIAS gw_${name})
    gw_compile(gw_${name})
    gw_position_independent(gw_${name})
    gw_use_precompiled(gw_${name} library)
    gw_batch(gw_${name})
    target_link_libraries(gw_${name} PUBLIC ${arg_LINK})

    # Headers are included from the root of the repository, and so from the root of their
    # installation.
    file(GLOB_RECURSE headers CONFIGURE_DEPENDS *.h)
    set(observer ${headers})  # inspect's headers include it
    list(FILTER observer INCLUDE REGEX "/gw/reference/observer\\.h$")
    list(FILTER headers EXCLUDE REGEX "-inl\\.h$|/gw/(fast|reference)/")
    foreach(other IN LISTS others)
        list(FILTER headers EXCLUDE REGEX "^${CMAKE_CURRENT_SOURCE_DIR}/${other}")
    endforeach()
    list(TRANSFORM arg_EXCLUDE PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
    list(REMOVE_ITEM headers ${arg_EXCLUDE} "")
    list(APPEND headers ${observer})
    target_sources(gw_${name} PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES
        ${headers})
    set_target_properties(gw_${name} PROPERTIES EXPORT_NAME ${name})
endfunction()

# gw_module(NAME SOURCES file... [LINK library...]): lib/libgw_NAME.so, loaded at run time; so its
# libraries cost nothing until then.
set(GW_ERRORS ${PROJECT_SOURCE_DIR}/gw/error.cpp ${PROJECT_SOURCE_DIR}/gw/escape_controls.cpp)
function(gw_module name)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LINK")
    add_library(gw_${name} MODULE ${arg_SOURCES} ${GW_ERRORS})
    gw_compile(gw_${name})
    set_target_properties(gw_${name} PROPERTIES CXX_VISIBILITY_PRESET hidden
        LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib)
    target_include_directories(gw_${name} PRIVATE ${PROJECT_SOURCE_DIR})
    target_link_libraries(gw_${name} PRIVATE ${arg_LINK})
endfunction()

# gw_embed(TARGET FUNCTION HEADER FILE...): the bytes of the files, built in. The header declares
# the function: a file's bytes by its name; empty for any other name.
function(gw_embed target function header)
    string(MAKE_C_IDENTIFIER ${function} name)
    set(output ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
    set(files "")
    foreach(file IN LISTS ARGN)
        cmake_path(ABSOLUTE_PATH file BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
        list(APPEND files ${file})
    endforeach()
    list(JOIN files "," joined)
    add_custom_command(OUTPUT ${output}
        COMMAND ${CMAKE_COMMAND} -DFILES=${joined} -DHEADER=${header} -DFUNCTION=${function}
            -DOUTPUT=${output} -P ${PROJECT_SOURCE_DIR}/cmake/embed.cmake
        DEPENDS ${files} ${PROJECT_SOURCE_DIR}/cmake/embed.cmake
        VERBATIM)
    target_sources(${target} PRIVATE ${output})
    set_source_files_properties(${output} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# gw_command(NAME SOURCE [LINK library...]): an executable in bin/.
function(gw_command name source)
    cmake_parse_arguments(PARSE_ARGV 2 arg "" "" "LINK")
    add_executable(${name} ${source})
    gw_compile(${name})
    target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR})
    target_link_libraries(${name} PRIVATE ${arg_LINK})
endfunction()

# gw_test(FOLDER SUFFIX [COMPUTES] [LABEL label] [TIMEOUT seconds] [LINK library...])
# All *.cpp below tests/FOLDER/SUFFIX become bin/test_FOLDER_SUFFIX, every TEST of it a test of
# ctest. SUFFIX may be "": all but long/ and folders with a CMakeLists.txt of their own. COMPUTES:
# the tests themselves take long to run, not only what they call.
function(gw_test folder suffix)
    cmake_parse_arguments(PARSE_ARGV 2 arg "COMPUTES" "LABEL;TIMEOUT" "LINK")
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS
        ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/${suffix}/*.cpp)
    list(TRANSFORM sources REPLACE "//" "/")
    if(NOT suffix)
        list(FILTER sources EXCLUDE REGEX "/${folder}/long/")
        file(GLOB others CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*/CMakeLists.txt)
        list(TRANSFORM others REPLACE "CMakeLists.txt$" "")
        foreach(other IN LISTS others)
            list(FILTER sources EXCLUDE REGEX "^${other}")
        endforeach()
    endif()
    if(NOT sources)
        return()
    endif()
    string(REGEX REPLACE "_$" "" name test_${folder}_${suffix})
    gw_batch_tests(${name} sources)
    gw_command(${name} "${sources}" LINK ${arg_LINK} GTest::gtest_main)
    if(arg_COMPUTES)
        gw_use_precompiled(${name} test)
        target_compile_options(${name} PRIVATE ${gw_test_options})
    else()
        gw_use_precompiled(${name} plain_test)
        target_compile_options(${name} PRIVATE ${gw_plain_test_options})
    endif()
    target_compile_options(${name} PRIVATE ${gw_batch_options})
    configure_file(${PROJECT_SOURCE_DIR}/tests/test_paths.h.in
        ${PROJECT_BINARY_DIR}/generated/test_paths.h @ONLY)
    target_include_directories(${name} PRIVATE ${PROJECT_BINARY_DIR}/generated)
    if(arg_LABEL)  # not built by `all`, but by the target of the label's name
        if(NOT TARGET ${arg_LABEL})
            add_custom_target(${arg_LABEL})
        endif()
        set_target_properties(${name} PROPERTIES EXCLUDE_FROM_ALL ON)
        add_dependencies(${arg_LABEL} ${name})
    endif()
    gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60
        PROPERTIES TIMEOUT ${arg_TIMEOUT} LABELS "${arg_LABEL}")
endfunction()
