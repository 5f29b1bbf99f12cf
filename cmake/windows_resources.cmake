# What Windows shows of the program, and how it is to treat it: icon, version, manifest.
enable_language(RC)
find_program(RSVG_CONVERT rsvg-convert REQUIRED)
find_package(Python3 REQUIRED COMPONENTS Interpreter)
set(resources "${PROJECT_BINARY_DIR}/resources")
add_custom_command(OUTPUT "${resources}/normalscope.ico"
  COMMAND ${Python3_EXECUTABLE} "${PROJECT_SOURCE_DIR}/cmake/make_icon.py" "${RSVG_CONVERT}"
    "${PROJECT_SOURCE_DIR}/assets/icons/normalscope.svg" "${resources}/normalscope.ico"
  DEPENDS assets/icons/normalscope.svg cmake/make_icon.py
  COMMENT "The icon, in the sizes that Windows shows")
configure_file(assets/windows/normalscope.rc.in "${resources}/normalscope.rc" @ONLY)
configure_file(assets/windows/normalscope.manifest.in "${resources}/normalscope.manifest" @ONLY)
set_source_files_properties("${resources}/normalscope.rc" PROPERTIES
  OBJECT_DEPENDS "${resources}/normalscope.ico;${resources}/normalscope.manifest")
target_sources(normalscope PRIVATE "${resources}/normalscope.rc")
