# Run at every build (cmake -P): writes OUTPUT, a source file with the commit that is built, and only when that has changed.
execute_process(COMMAND git describe --always --dirty --exclude=* WORKING_DIRECTORY ${SOURCE} OUTPUT_VARIABLE commit
                OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT commit)
  set(commit unknown)
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "#include \"core/base/version.h\"\n\nstd::string cullscope::buildCommit() { return \"${commit}\"; }\n")
