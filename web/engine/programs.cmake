# For programs of OpenGL and IRIS GL in C: lib/libOSMesa.a and lib/libgl.a, which
# scripts/browser-program links. Target: programs.
set(made ${PROJECT_BINARY_DIR}/generated)
set(gl_made ${made}/gl)
set(irisgl_made ${made}/irisgl)
gw_made_doors(${root} gl ${made} "entry_points.cpp;linked.cpp" functions.txt linked.txt)
gw_made_doors(${root} irisgl ${made} entry_points.cpp functions.txt)
gw_made_prices(${root} ${made})

# One library, no processes, no windows of X11.
file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${root}/gl/*.cpp)
list(FILTER sources EXCLUDE REGEX "/gl/(egl|glx|x11|osmesa|record|entry)/|/other_library.cpp$")
file(GLOB entry CONFIGURE_DEPENDS ${root}/gl/entry/*.cpp)
file(GLOB record CONFIGURE_DEPENDS ${root}/gl/record/*.cpp)
engine_objects(gw::gl gl ${sources} ${record})
engine_objects(gw::gl_entry gl_entry ${entry} ${gl_made}/entry_points.cpp ${gl_made}/linked.cpp)
engine_objects(gw::osmesa osmesa ${root}/gl/osmesa/osmesa.cpp)
set_target_properties(engine_gl_entry PROPERTIES UNITY_BUILD OFF)

file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${root}/irisgl/*.cpp)
list(FILTER sources EXCLUDE REGEX "/irisgl/(door/|window/host_window.cpp)")
set(alone ${root}/irisgl/calls/menus.cpp ${irisgl_made}/entry_points.cpp)
set_source_files_properties(${alone} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
# Its functions catch what their calls throw, by irisgl/calls/run.h.
set_source_files_properties(${irisgl_made}/entry_points.cpp PROPERTIES
    COMPILE_OPTIONS -fexceptions)
engine_objects(gw::irisgl irisgl ${sources} ${irisgl_made}/entry_points.cpp)

add_subdirectory(programs)
set(doors gl gl_entry osmesa irisgl program_page)
foreach(door IN LISTS doors)
    target_include_directories(engine_${door} PRIVATE ${PROJECT_BINARY_DIR})
    target_include_directories(engine_${door} SYSTEM PRIVATE ${GW_HEADERS}/opengl ${made})
    target_compile_definitions(engine_${door} PRIVATE GL_GLEXT_PROTOTYPES)
    set_target_properties(engine_${door} PROPERTIES EXCLUDE_FROM_ALL ON)
    add_dependencies(engine_${door} made_gl made_irisgl made_prices)
endforeach()
# Recorded calls have no place in the program: WebAssembly has no addresses of code.
foreach(door gl_entry irisgl)
    target_compile_options(engine_${door} PRIVATE "-D__builtin_return_address(level)=nullptr")
endforeach()
target_include_directories(engine_irisgl PRIVATE ${irisgl_made} ${irisgl_made}/include
    ${root}/irisgl/include)

set(common gw gl gl_entry inspect program_page)
list(TRANSFORM common REPLACE "(.+)" "$<TARGET_OBJECTS:engine_\\1>")
add_library(OSMesa STATIC EXCLUDE_FROM_ALL ${common} $<TARGET_OBJECTS:engine_osmesa>)
add_library(irisgl_library STATIC EXCLUDE_FROM_ALL ${common} $<TARGET_OBJECTS:engine_irisgl>)
set_target_properties(irisgl_library PROPERTIES OUTPUT_NAME gl)
set_target_properties(OSMesa irisgl_library PROPERTIES
    ARCHIVE_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib)
add_custom_target(programs DEPENDS OSMesa irisgl_library)
