# zlib and libpng compiled from source, for systems that bring neither: zlib_and_png(FOLDER), where fetch_*.sh left them.
function(zlib_and_png folder)
  file(GLOB zlib_sources "${folder}/zlib/*.c")
  list(FILTER zlib_sources EXCLUDE REGEX "/gz[a-z]*\\.c$")  # files
  add_library(own_zlib STATIC ${zlib_sources})
  target_include_directories(own_zlib SYSTEM PUBLIC "${folder}/zlib")
  target_compile_definitions(own_zlib PRIVATE Z_HAVE_UNISTD_H)
  add_library(ZLIB::ZLIB ALIAS own_zlib)

  set(png "${folder}/libpng1.6")
  set(parts png pngerror pngget pngmem pngpread pngread pngrio pngrtran pngrutil pngset pngtrans pngwio pngwrite pngwtran
    pngwutil)
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    list(APPEND parts intel/intel_init intel/filter_sse2_intrinsics)
  endif()
  list(TRANSFORM parts REPLACE "(.+)" "${png}/\\1.c" OUTPUT_VARIABLE png_sources)
  configure_file("${png}/scripts/pnglibconf.h.prebuilt" "${PROJECT_BINARY_DIR}/libpng/pnglibconf.h" COPYONLY)
  add_library(own_png STATIC ${png_sources})
  target_include_directories(own_png SYSTEM PUBLIC "${png}" "${PROJECT_BINARY_DIR}/libpng")
  target_link_libraries(own_png PUBLIC own_zlib)
  add_library(PNG::PNG ALIAS own_png)
endfunction()
