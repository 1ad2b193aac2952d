# The libraries of the game, from the source packages of the distribution, as one target: web_libraries.

# only_source(VARIABLE NAME): the folder of a source package, whatever its version.
function(only_source variable name)
  file(GLOB found LIST_DIRECTORIES true ${WEB_SOURCES}/${name}-[0-9]*)
  list(FILTER found EXCLUDE REGEX "\\.(gz|xz|asc|dsc)$")
  list(LENGTH found count)
  if(NOT count EQUAL 1)
    message(FATAL_ERROR "WEB_SOURCES is ${WEB_SOURCES}, which has ${count} folders ${name}-…; accepted is the folder "
                        "in which game/web/build unpacks one of each")
  endif()
  set(${variable} ${found} PARENT_SCOPE)
endfunction()
only_source(box2d box2d)
only_source(sdl libsdl2)
only_source(sdl_image libsdl2-image)
only_source(sdl_ttf libsdl2-ttf)
only_source(freetype freetype)
only_source(png libpng1.6)
only_source(zlib zlib)
only_source(imgui imgui)

# The parts of SDL that a browser has, with its own configuration for emscripten. (Its CMakeLists.txt asks the compiler
# hundreds of questions, which takes longer than to compile it.)
set(sdl_sources)
foreach(part . atomic audio audio/disk audio/dummy audio/emscripten cpuinfo dynapi events file filesystem/emscripten haptic
        haptic/dummy hidapi joystick joystick/emscripten joystick/virtual libm loadso/dlopen locale locale/emscripten misc
        misc/emscripten power power/emscripten render render/opengles2 render/software sensor sensor/dummy stdlib thread
        thread/generic timer timer/unix video video/dummy video/emscripten video/yuv2rgb)
  file(GLOB part_sources ${sdl}/src/${part}/*.c)
  list(APPEND sdl_sources ${part_sources})
endforeach()
add_library(web_sdl STATIC ${sdl_sources})
target_compile_options(web_sdl PRIVATE -w)
target_include_directories(web_sdl SYSTEM PUBLIC ${sdl}/include)

# FreeType reads no other font than TrueType's here.
set(freetype_modules ${CMAKE_BINARY_DIR}/freetype/freetype/config)
file(WRITE ${freetype_modules}/ftmodule.h
     "FT_USE_MODULE(FT_Module_Class, autofit_module_class)\n"
     "FT_USE_MODULE(FT_Driver_ClassRec, tt_driver_class)\n"
     "FT_USE_MODULE(FT_Module_Class, psnames_module_class)\n"
     "FT_USE_MODULE(FT_Module_Class, sfnt_module_class)\n"
     "FT_USE_MODULE(FT_Renderer_Class, ft_smooth_renderer_class)\n")
add_library(web_freetype STATIC)
foreach(source autofit/autofit base/ftbase base/ftbbox base/ftbitmap base/ftdebug base/ftglyph base/ftinit base/ftmm
        base/ftstroke base/ftsynth base/ftsystem gzip/ftgzip psnames/psnames sfnt/sfnt smooth/smooth truetype/truetype)
  target_sources(web_freetype PRIVATE ${freetype}/src/${source}.c)
endforeach()
target_compile_options(web_freetype PRIVATE -w)
target_compile_definitions(web_freetype PRIVATE FT2_BUILD_LIBRARY FT_CONFIG_OPTION_SYSTEM_ZLIB)
target_include_directories(web_freetype SYSTEM PUBLIC ${CMAKE_BINARY_DIR}/freetype ${freetype}/include PRIVATE ${zlib})

file(GLOB_RECURSE box2d_sources ${box2d}/src/*.cpp)
file(GLOB zlib_sources ${zlib}/*.c)
file(GLOB png_sources ${png}/png*.c)
list(FILTER png_sources EXCLUDE REGEX "/pngtest\\.c$")
file(GLOB imgui_sources ${imgui}/imgui*.cpp)
configure_file(${png}/scripts/pnglibconf.h.prebuilt ${CMAKE_BINARY_DIR}/png/pnglibconf.h COPYONLY)

# Of SDL_image the game uses the writer of PNG alone.
add_library(web_libraries STATIC ${box2d_sources} ${zlib_sources} ${png_sources} ${imgui_sources}
            ${sdl_image}/IMG_png.c ${sdl_ttf}/SDL_ttf.c)
target_compile_options(web_libraries PRIVATE -w)
target_compile_definitions(web_libraries PRIVATE WANT_LIBPNG LOAD_PNG TTF_USE_HARFBUZZ=0 HAVE_UNISTD_H)
target_include_directories(web_libraries SYSTEM PUBLIC ${box2d}/include ${imgui} ${sdl_image} ${sdl_ttf}
                           PRIVATE ${box2d}/src ${zlib} ${png} ${CMAKE_BINARY_DIR}/png)
target_link_libraries(web_libraries PUBLIC web_sdl PRIVATE web_freetype)

# Libraries of headers alone: those of this machine do for any. Each by its one folder, since /usr/include of this machine
# is not that of a browser.
foreach(header nlohmann CLI)
  find_path(${header}_include ${header} PATHS /usr/include NO_CMAKE_FIND_ROOT_PATH REQUIRED)
  file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/headers)
  file(CREATE_LINK ${${header}_include}/${header} ${CMAKE_BINARY_DIR}/headers/${header} SYMBOLIC)
endforeach()
target_include_directories(web_libraries SYSTEM PUBLIC ${CMAKE_BINARY_DIR}/headers)
