# Debian packages by cpack (scripts/package.sh), one for each component that is installed: the programs, the library,
# what programs on it are built with, and the Python module.
set(library libsteplab${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(packages steplab ${library} libsteplab-dev)
if(pybind11_FOUND)
  list(APPEND packages python3-steplab)
endif()

# What Debian wants of every package.
set(made ${PROJECT_BINARY_DIR}/package)
configure_file(${PROJECT_SOURCE_DIR}/assets/package/changelog.in ${made}/changelog @ONLY)
execute_process(COMMAND gzip -9nf ${made}/changelog COMMAND_ERROR_IS_FATAL ANY)
file(WRITE ${made}/shlibs "libsteplab ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR} ${library} (= ${PROJECT_VERSION})\n")
install(FILES ${PROJECT_SOURCE_DIR}/assets/package/lintian-overrides DESTINATION share/lintian/overrides RENAME steplab
        COMPONENT steplab)
foreach(package IN LISTS packages)
  install(FILES ${PROJECT_SOURCE_DIR}/assets/package/copyright ${made}/changelog.gz DESTINATION share/doc/${package}
          COMPONENT ${package})
endforeach()

# steplab_package(name DEPENDS text DESCRIPTION text [other variables of cpack's DEB generator and their values])
function(steplab_package name)
  string(TOUPPER ${name} component)
  set(CPACK_DEBIAN_${component}_PACKAGE_NAME ${name} PARENT_SCOPE)
  set(CPACK_DEBIAN_${component}_FILE_NAME DEB-DEFAULT PARENT_SCOPE)
  while(ARGN)
    list(POP_FRONT ARGN variable value)
    if(variable STREQUAL DESCRIPTION)
      set(CPACK_DEBIAN_${component}_DESCRIPTION "laboratory for numerical integrators${value}" PARENT_SCOPE)
    else()
      set(CPACK_DEBIAN_${component}_PACKAGE_${variable} ${value} PARENT_SCOPE)
    endif()
  endwhile()
endfunction()

set(about "\nsteplab runs scenes of point masses by many integration methods, in a window\nor on the command line, and shows how wrong each method is and what it costs.")
steplab_package(steplab SECTION science
  DEPENDS "fonts-dejavu-core" RECOMMENDS "ffmpeg, fonts-inter, libgl1-mesa-dri"
  DESCRIPTION " of point masses${about}")
steplab_package(${library} SECTION libs
  DESCRIPTION ": library${about}\nThis package holds the library that programs and the Python module use.")
steplab_package(libsteplab-dev SECTION libdevel DEPENDS "${library} (= ${PROJECT_VERSION})"
  DESCRIPTION ": headers${about}\nThis package holds what programs on its library are built with.")
math(EXPR next_minor "${Python3_VERSION_MINOR} + 1")
steplab_package(python3-steplab SECTION python
  DEPENDS "${library} (= ${PROJECT_VERSION}), python3 (>= ${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}), python3 (<< ${Python3_VERSION_MAJOR}.${next_minor}), python3-numpy"
  RECOMMENDS "steplab (= ${PROJECT_VERSION})"
  DESCRIPTION ": Python module${about}\nThis package holds the module steplab for Python.")

string(TOUPPER ${library} component)
set(CPACK_DEBIAN_${component}_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/assets/package/triggers ${made}/shlibs)
set(CPACK_DEBIAN_PYTHON3-STEPLAB_PACKAGE_CONTROL_EXTRA  # compiled files come and go with the package
    ${PROJECT_SOURCE_DIR}/assets/package/postinst ${PROJECT_SOURCE_DIR}/assets/package/prerm)

set(CPACK_GENERATOR DEB)
set(CPACK_COMPONENTS_ALL ${packages})
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
                                                WORLD_READ WORLD_EXECUTE)
set(CPACK_PACKAGE_CONTACT "steplab contributors <steplab@users.noreply.github.com>")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/lib)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
include(CPack)
