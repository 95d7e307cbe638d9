# The target `tidy` (preset `clang`): clang-tidy over every source of src/, a room at a time. A room's sources are read as
# one: what takes long is the headers that they share. Of names that two sources of a room give to different things it
# says so: they need two names.
#
# Some rooms are read source by source: models, which have the same functions each; what draws through different headers
# of OpenGL; what is told more on its command line.

file(GLOB_RECURSE tidied ${PROJECT_SOURCE_DIR}/src/*.cpp)
list(FILTER tidied EXCLUDE REGEX "/src/app/(offscreen/(osmesa|egl|module)|steplab)\\.cpp$")
if(NOT STEPLAB_GRAPHICS)
  list(FILTER tidied EXCLUDE REGEX "/src/(render|ui|app/window|app/offscreen)/")
endif()

include(${PROJECT_SOURCE_DIR}/src/methods/list.cmake)
set(units "")
set(rooms "")
foreach(source IN LISTS tidied)
  get_filename_component(room ${source} DIRECTORY)
  file(RELATIVE_PATH room ${PROJECT_SOURCE_DIR}/src ${room})
  if(room MATCHES "^(models|app|app/window|app/offscreen)$")
    list(APPEND units ${source})
  else()
    list(APPEND rooms ${room})
    string(APPEND sources_of_${room} "#include \"${source}\"\n")
  endif()
endforeach()
list(REMOVE_DUPLICATES rooms)
foreach(id IN LISTS STEPLAB_METHODS)
  string(APPEND sources_of_steppers "#include \"${PROJECT_BINARY_DIR}/src/sim/generated/stepper_${id}.cpp\"\n")
endforeach()

foreach(room IN LISTS rooms ITEMS steppers)
  string(REPLACE "/" "_" name ${room})
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/tidy/${name}.cpp CONTENT "${sources_of_${room}}" @ONLY)
  list(APPEND units ${PROJECT_BINARY_DIR}/tidy/${name}.cpp)
endforeach()

add_library(tidy OBJECT EXCLUDE_FROM_ALL ${units})
steplab_compile(tidy)
set_target_properties(tidy PROPERTIES CXX_CLANG_TIDY "clang-tidy;--quiet;--checks=-bugprone-suspicious-include")
target_link_libraries(tidy PRIVATE steplab_commands PNG::PNG)
target_include_directories(tidy PRIVATE ${PROJECT_SOURCE_DIR}/include ${PROJECT_BINARY_DIR}/include)
if(STEPLAB_GRAPHICS)
  target_link_libraries(tidy PRIVATE steplab_ui glfw GLEW::GLEW OpenGL::GL X11::X11)
endif()
set_source_files_properties(${units} PROPERTIES COMPILE_DEFINITIONS
                            "STEPLAB_SHADERS_IN_SOURCE=\"\";STEPLAB_ASSETS_IN_SOURCE=\"\"")
# After the other warnings: names of one source hide those of another.
set_source_files_properties(${units} PROPERTIES COMPILE_OPTIONS "-fsyntax-only;-Wno-shadow")
