# cmake --install build/release --prefix DIR: the command with its man page and completions, the
# scenes, and every folder as a library for find_package(gw). cpack --config
# build/release/CPackConfig.cmake: the same as Debian packages gw, libgw-dev and python3-gw
# (docs/library.md).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# The libraries of the command and of the tests are not installed.
foreach(folder machine peer scene image multipass raytrace itembuffer hiddensurface render
    radiosity inspect report testing)
    if(TARGET gw_${folder})
        install(TARGETS gw_${folder} EXPORT gw COMPONENT development
            ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
            FILE_SET HEADERS DESTINATION
                ${CMAKE_INSTALL_INCLUDEDIR}/gw-${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
    endif()
endforeach()

set(package_directory ${CMAKE_INSTALL_LIBDIR}/cmake/gw)
install(EXPORT gw FILE gwTargets.cmake NAMESPACE gw:: DESTINATION ${package_directory} COMPONENT
    development)
configure_package_config_file(cmake/gwConfig.cmake.in ${PROJECT_BINARY_DIR}/gwConfig.cmake
    INSTALL_DESTINATION ${package_directory})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/gwConfigVersion.cmake COMPATIBILITY
    SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/gwConfig.cmake ${PROJECT_BINARY_DIR}/gwConfigVersion.cmake
    DESTINATION ${package_directory}
    COMPONENT development)

# The module and the decoder of image/ are for the command and for programs that link gw::image.
if(TARGET gw_formats)
    set(modules ${CMAKE_INSTALL_LIBDIR}/gw)
    set_target_properties(gw_formats PROPERTIES EXPORT_NAME formats)
    install(TARGETS gw_formats EXPORT gw LIBRARY DESTINATION ${modules} COMPONENT command)
    install(TARGETS gw_decode RUNTIME DESTINATION ${modules} COMPONENT command)
endif()
if(TARGET gw_window)
    install(TARGETS gw_window LIBRARY DESTINATION ${modules} COMPONENT command)
endif()

if(TARGET gw)
    foreach(library gw_glx gw_osmesa)  # which `gw gl` gives to programs
        if(TARGET ${library})
            install(TARGETS ${library} LIBRARY DESTINATION ${GW_INSTALLED_OPENGL}
                COMPONENT command)
        endif()
    endforeach()
    if(TARGET gw_glx)
        # Links to libGL.so.1. Python asks for the names without a number first.
        foreach(name libEGL.so.1 libGLX.so.0 libOpenGL.so.0 libEGL.so libGLX.so libOpenGL.so)
            install(FILES ${PROJECT_BINARY_DIR}/lib/opengl/${name} DESTINATION
                ${GW_INSTALLED_OPENGL} COMPONENT command)
        endforeach()
    endif()
    if(TARGET gw_irisgl_library)
        install(TARGETS gw_irisgl_library LIBRARY DESTINATION ${GW_INSTALLED_IRISGL}
            COMPONENT command)
        install(DIRECTORY ${PROJECT_BINARY_DIR}/include/irisgl DESTINATION include
            COMPONENT command)
    endif()
    file(RELATIVE_PATH to_modules ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_PREFIX}/${modules})
    set_target_properties(gw PROPERTIES INSTALL_RPATH "\$ORIGIN/${to_modules}")
    install(TARGETS gw RUNTIME COMPONENT command)
    install(FILES ${PROJECT_BINARY_DIR}/share/gw.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1
        COMPONENT command)
    install(FILES ${PROJECT_BINARY_DIR}/share/gw.bash DESTINATION
        ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME gw COMPONENT command)
    install(FILES ${PROJECT_BINARY_DIR}/share/_gw DESTINATION
        ${CMAKE_INSTALL_DATADIR}/zsh/site-functions COMPONENT command)
    install(DIRECTORY scenes DESTINATION ${CMAKE_INSTALL_DATADIR}/gw COMPONENT command
        FILES_MATCHING PATTERN *.toml PATTERN *.obj PATTERN *.mtl PATTERN *.png PATTERN make_*
            EXCLUDE)
endif()
# Debian's name and place for the licences of all that a package contains.
find_program(GW_DPKG dpkg)
if(TARGET gw AND GW_DPKG)
    set(packages "")
    if(TARGET gw_python)
        set(packages pybind11-dev)
    endif()
    execute_process(COMMAND ${PROJECT_SOURCE_DIR}/scripts/licences ${packages}
        OUTPUT_FILE ${PROJECT_BINARY_DIR}/copyright COMMAND_ERROR_IS_FATAL ANY)
    foreach(pair command:gw development:libgw-dev python:python3-gw)
        string(REPLACE ":" ";" pair ${pair})
        list(GET pair 0 component)
        list(GET pair 1 package)
        install(FILES ${PROJECT_BINARY_DIR}/copyright DESTINATION
            ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${component})
    endforeach()
endif()
# Documents name each other, the examples and the schemas by their places in the repository.
install(FILES LICENSE README.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT command)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT command PATTERN Doxyfile
    EXCLUDE)
install(DIRECTORY examples/autograder DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples COMPONENT command
    USE_SOURCE_PERMISSIONS)
install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT development
    PATTERN autograder EXCLUDE)
foreach(schema inspect/recording/recording.fbs inspect/manifest/values.fbs)
    get_filename_component(folder ${schema} DIRECTORY)
    install(FILES ${schema} DESTINATION ${CMAKE_INSTALL_DOCDIR}/${folder} COMPONENT development)
    install(FILES ${schema} DESTINATION ${CMAKE_INSTALL_DATADIR}/gw/schemas COMPONENT development)
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME gw)
set(CPACK_PACKAGE_CONTACT "the GW project")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "graphics workstation of 1991 in software, exact to the bit")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL command development)
if(TARGET gw_python)
    list(APPEND CPACK_COMPONENTS_ALL python)
endif()
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMMAND_PACKAGE_NAME gw)
set(CPACK_DEBIAN_COMMAND_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_COMMAND_PACKAGE_SHLIBDEPS ON)
# Loaded to play lists on Mesa; keeps students' programs apart; the language of the example's.
set(CPACK_DEBIAN_COMMAND_PACKAGE_RECOMMENDS "libosmesa6, bubblewrap, python3")
set(CPACK_DEBIAN_COMMAND_PACKAGE_SUGGESTS "ffmpeg")  # for gw render --video
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libgw-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    "gw (= ${PROJECT_VERSION}), libglm-dev, libfmt-dev, libtbb-dev, nlohmann-json3-dev, libpng-dev, libgtest-dev, libgmock-dev, libosmesa6-dev")
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-gw)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
if(Python_VERSION_MAJOR)  # the module is of one version of Python
    math(EXPR next "${Python_VERSION_MINOR} + 1")
    set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
        "python3 (>= ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}), python3 (<< ${Python_VERSION_MAJOR}.${next}), python3-numpy")
endif()
include(CPack)
