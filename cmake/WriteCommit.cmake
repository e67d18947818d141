# Writes TO, a C++ source that knows the commit of the checkout SOURCE; not anew if it is the same.
# Run by the build: cmake -DTO=FILE -DSOURCE=DIR -P WriteCommit.cmake
execute_process(COMMAND git -C ${SOURCE} describe --always --dirty --abbrev=12 --exclude=*
    OUTPUT_VARIABLE commit ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE failed)
if(failed OR NOT commit MATCHES "^[0-9a-f]+(-dirty)?$")
    set(commit unknown)
endif()
set(text "#include \"apps/command/command.h\"\nstd::string gw::apps::commit() { return \"${commit}\"; }\n")
set(before "")
if(EXISTS ${TO})
    file(READ ${TO} before)
endif()
if(NOT text STREQUAL before)
    file(WRITE ${TO} "${text}")
endif()
