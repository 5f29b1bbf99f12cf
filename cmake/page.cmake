# build/web/normalscope.html: the program as one page that needs nothing else.

add_executable(engine app/web/exports.cpp)
target_link_libraries(engine PRIVATE normalscope_web)
target_link_options(engine PRIVATE
  --no-entry --js-library ${PROJECT_SOURCE_DIR}/app/web/library.js
  -sMODULARIZE=1 -sEXPORT_NAME=makeEngine -sENVIRONMENT=web -sDYNAMIC_EXECUTION=0 -sTEXTDECODER=2
  -sMIN_WEBGL_VERSION=2 -sMAX_WEBGL_VERSION=2
  -sALLOW_MEMORY_GROWTH=1 -sINITIAL_MEMORY=64MB -sSTACK_SIZE=8MB
  -sEXPORTED_RUNTIME_METHODS=ccall,FS
  -sEXPORTED_FUNCTIONS=_malloc,_free)
set_target_properties(engine PROPERTIES LINK_DEPENDS "${PROJECT_SOURCE_DIR}/app/web/library.js")

set(page "${PROJECT_SOURCE_DIR}/app/web")
set(page_parts
  ${page}/page.html ${page}/page.css
  ${page}/start.js ${page}/screen.js ${page}/keys.js ${page}/hands.js ${page}/fingers.js
  ${page}/exchange.js ${page}/fonts.js ${page}/address.js
  ${page}/frame.js)
add_custom_command(OUTPUT "${PROJECT_BINARY_DIR}/normalscope.html"
  COMMAND python3 "${PROJECT_SOURCE_DIR}/cmake/make_page.py" "${PROJECT_BINARY_DIR}/normalscope.html"
    "$<TARGET_FILE:engine>" ${page_parts}
  DEPENDS engine "${PROJECT_SOURCE_DIR}/cmake/make_page.py" ${page_parts}
  COMMENT "normalscope.html" VERBATIM)
add_custom_target(page ALL DEPENDS "${PROJECT_BINARY_DIR}/normalscope.html")
