# What builds of a part by another compiler share: the lab's engine, the matrix of processors,
# Windows. Their sources that come from tables are made by programs of the machine that compiles.
include_guard(GLOBAL)

# Libraries that are headers only are reached by links, as the rest of /usr is of another processor
# or system. Those of OpenGL are in GW_HEADERS/opengl. What is there already stays.
set(GW_HEADERS ${PROJECT_BINARY_DIR}/headers CACHE PATH "folder of the header-only libraries")
file(MAKE_DIRECTORY ${GW_HEADERS}/opengl)
foreach(header glm fmt hwy CLI flatbuffers nlohmann toml++ xxhash.h opengl/GL opengl/KHR)
    string(REGEX REPLACE "^opengl/" "" origin ${header})
    if(NOT EXISTS ${GW_HEADERS}/${header})
        file(CREATE_LINK /usr/include/${origin} ${GW_HEADERS}/${header} SYMBOLIC)
    endif()
endforeach()

# gw_made_schemas(ROOT FOLDER): the headers of recordings. The same text does not compile anew.
find_program(GW_FLATC flatc REQUIRED)
function(gw_made_schemas root folder)
    execute_process(COMMAND ${GW_FLATC} --cpp --scoped-enums --cpp-std c++17
        --cpp-static-reflection --no-warnings -o ${PROJECT_BINARY_DIR}/flatc
        ${root}/inspect/recording/recording.fbs ${root}/inspect/manifest/values.fbs
        COMMAND_ERROR_IS_FATAL ANY)
    file(MAKE_DIRECTORY ${folder})
    foreach(schema recording values)
        file(COPY_FILE ${PROJECT_BINARY_DIR}/flatc/${schema}_generated.h
            ${folder}/${schema}_generated.h ONLY_IF_DIFFERENT)
    endforeach()
endfunction()

# gw_made_doors(ROOT API FOLDER OUTPUT TABLE...): the sources and headers that an API's generator
# makes of its tables of functions, in FOLDER/API. The target is made_API.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
function(gw_made_doors root api folder output)
    set(entry ${root}/${api}/entry)
    list(TRANSFORM output PREPEND ${folder}/${api}/)
    list(TRANSFORM ARGN PREPEND ${entry}/)
    file(MAKE_DIRECTORY ${folder}/${api}/include/gl)
    add_custom_command(OUTPUT ${output}
        COMMAND ${Python3_EXECUTABLE} ${entry}/generate.py ${ARGN} ${folder}/${api}
        DEPENDS ${entry}/generate.py ${ARGN} VERBATIM)
    add_custom_target(made_${api} DEPENDS ${output})
endfunction()

# gw_made_prices(ROOT FOLDER): FOLDER/gl/vgx_prices.h; the target is made_prices.
function(gw_made_prices root folder)
    set(prices ${root}/inspect/report/prices/vgx.toml)
    set(generate ${root}/gl/record/generate_prices.py)
    add_custom_command(OUTPUT ${folder}/gl/vgx_prices.h
        COMMAND ${Python3_EXECUTABLE} ${generate} ${prices} ${folder}/gl/vgx_prices.h
        DEPENDS ${generate} ${prices} VERBATIM)
    add_custom_target(made_prices DEPENDS ${folder}/gl/vgx_prices.h)
endfunction()
