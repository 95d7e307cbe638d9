# What `cmake --install` puts where, and the target `programs`: everything a user runs, without the tests.
# Programs and run-time modules are those that the folders under src/ declare; they are not listed a second time.

# steplab_targets_below(directory result): all targets declared in a source folder and the folders it adds.
function(steplab_targets_below directory result)
  get_property(targets DIRECTORY ${directory} PROPERTY BUILDSYSTEM_TARGETS)
  get_property(folders DIRECTORY ${directory} PROPERTY SUBDIRECTORIES)
  foreach(folder IN LISTS folders)
    steplab_targets_below(${folder} below)
    list(APPEND targets ${below})
  endforeach()
  set(${result} ${targets} PARENT_SCOPE)
endfunction()

# What is not named otherwise is of the package of the programs; the library and the Python module have packages of their
# own (SteplabPackage.cmake).
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME steplab)

add_custom_target(programs)
steplab_targets_below(${PROJECT_SOURCE_DIR}/src all_targets)
foreach(target IN LISTS all_targets)
  get_target_property(type ${target} TYPE)
  if(type STREQUAL "EXECUTABLE")
    install(TARGETS ${target} RUNTIME DESTINATION bin)
    add_dependencies(programs ${target})
  elseif(type STREQUAL "MODULE_LIBRARY")
    # Beside the program at ../lib/steplab, in the build tree as when installed: the programs look nowhere else.
    install(TARGETS ${target} LIBRARY DESTINATION lib/steplab)
    add_dependencies(programs ${target})
  endif()
endforeach()

install(DIRECTORY assets/scenes/ DESTINATION share/steplab/scenes)
install(DIRECTORY assets/lessons/ DESTINATION share/steplab/lessons)
if(STEPLAB_GRAPHICS)
  install(DIRECTORY assets/pictures/ DESTINATION share/steplab/pictures)
  install(DIRECTORY shaders/ DESTINATION share/steplab/shaders)
  install(FILES assets/steplab.desktop DESTINATION share/applications)
  file(GLOB entries CONFIGURE_DEPENDS assets/package/*.desktop)
  install(FILES ${entries} DESTINATION share/applications)
  install(FILES assets/package/steplab.xml DESTINATION share/mime/packages)
  install(FILES assets/steplab.svg DESTINATION share/icons/hicolor/scalable/apps)
endif()
# README.md links to the pages and pictures: they are installed beside it, in the same folders.
file(GLOB pages CONFIGURE_DEPENDS docs/*.md)
install(FILES README.md CHANGELOG.md LICENSE DESTINATION share/doc/steplab)
install(FILES ${pages} DESTINATION share/doc/steplab/docs)
install(DIRECTORY docs/images DESTINATION share/doc/steplab/docs)
install(DIRECTORY python/notebooks DESTINATION share/doc/steplab/python)

# The library: find_package(steplab) gives programs the target steplab::steplab.
include(CMakePackageConfigHelpers)
set(steplab_library_component libsteplab${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
install(TARGETS steplab_shared EXPORT steplab
        LIBRARY DESTINATION lib COMPONENT ${steplab_library_component} NAMELINK_COMPONENT libsteplab-dev)
install(EXPORT steplab NAMESPACE steplab:: FILE steplabConfig.cmake DESTINATION lib/cmake/steplab
        COMPONENT libsteplab-dev)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/steplabConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/steplabConfigVersion.cmake DESTINATION lib/cmake/steplab COMPONENT libsteplab-dev)
install(DIRECTORY include/steplab ${PROJECT_BINARY_DIR}/include/steplab DESTINATION include COMPONENT libsteplab-dev
        FILES_MATCHING PATTERN *.hpp)
install(FILES examples/own_method.cpp examples/own_force.cpp examples/CMakeLists.txt
        DESTINATION share/doc/libsteplab-dev/examples COMPONENT libsteplab-dev)
