# How every target of this project is compiled, and the one way to declare a folder of src/ or tests/.

# Same bits everywhere: no contraction into fused multiply-adds, no reassociation. `-fno-math-errno` and
# `-fno-trapping-math` change no result; without them sqrt and selected divisions are not vectorised.
add_library(steplab_arithmetic INTERFACE)
target_compile_options(steplab_arithmetic INTERFACE -ffp-contract=off -fno-math-errno -fno-trapping-math)
# Eigen would fuse multiplications and additions by itself where the processor can.
target_compile_definitions(steplab_arithmetic INTERFACE EIGEN_DONT_VECTORIZE)

# `-Wno-psabi`: how vector registers are handed over depends on the instruction set; none are between code of several.
add_library(steplab_warnings INTERFACE)
target_compile_options(steplab_warnings INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wno-psabi
                                                  $<$<NOT:$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>>:-Wshadow>
                                                  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>>:-Wno-subobject-linkage>
                                                  $<$<BOOL:${STEPLAB_WERROR}>:-Werror>
                                                  # clang says where a loop over dual numbers cannot be vectorised
                                                  $<$<CXX_COMPILER_ID:Clang>:-Wno-pass-failed>)

add_library(steplab_instruments INTERFACE)
if(STEPLAB_SANITIZE)
  target_compile_options(steplab_instruments INTERFACE -fsanitize=${STEPLAB_SANITIZE} -fno-sanitize-recover=all
                                                       -fno-omit-frame-pointer)
  target_link_options(steplab_instruments INTERFACE -fsanitize=${STEPLAB_SANITIZE})
endif()
if(STEPLAB_COVERAGE)
  target_compile_options(steplab_instruments INTERFACE --coverage -fprofile-update=atomic)
  target_link_options(steplab_instruments INTERFACE --coverage)
endif()

function(steplab_compile target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  target_include_directories(${target} PUBLIC ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(${target} PRIVATE steplab_arithmetic steplab_warnings steplab_instruments)
endfunction()

# With these ccache keeps what uses precompiled headers: g++ names them in preprocessed sources, clang++ leaves their
# time out.
add_library(steplab_pch_for_ccache INTERFACE)
target_compile_options(steplab_pch_for_ccache INTERFACE
                       $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>
                       "$<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>")

# Standard headers that most sources include, compiled once: those of steplab_core serve all libraries. Every source
# includes what it needs nonetheless (preset `clang` builds without them). Headers of CLI11 and JSON would double the time
# of the sources of app: what is precompiled is read whole.
set(steplab_precompiled <algorithm> <array> <cmath> <cstddef> <cstdint> <functional> <limits> <memory> <optional> <span>
                        <string> <string_view> <type_traits> <utility> <variant> <vector> <fmt/format.h>)
# steplab_precompile(target [header...]): with the standard headers alone, or with a room's own headers too, where reading
# these takes most of the time of its sources.
function(steplab_precompile target)
  if(NOT STEPLAB_PRECOMPILED_HEADERS)
    return()
  endif()
  target_link_libraries(${target} PRIVATE steplab_pch_for_ccache)
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)  # as what is shared was compiled
  if(target STREQUAL steplab_core OR ARGN)
    target_precompile_headers(${target} PRIVATE ${steplab_precompiled} ${ARGN})
  else()
    target_precompile_headers(${target} REUSE_FROM steplab_core)
  endif()
endfunction()

# steplab_join(target): most of the time of small sources goes into headers, which several read at once. Hence names in
# unnamed namespaces differ within a room, as tidy asks for too. What the compiler says of names of one source
# alone is said where sources are not joined (presets `clang` and `debug`).
function(steplab_join target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${STEPLAB_JOINED_SOURCES} UNITY_BUILD_BATCH_SIZE 8)
endfunction()

# steplab_library(folder [LINK target...] [SOURCES file...] [EXCLUDE regex] [PRECOMPILE header...] [APART]): the static
# library steplab_<folder> of all sources in the current folder and the rooms below it; APART: never several at a time.
# It is compiled as position-independent code, because the off-screen modules link it too.
function(steplab_library folder)
  cmake_parse_arguments(ARG "APART" "EXCLUDE" "LINK;SOURCES;PRECOMPILE" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  if(ARG_EXCLUDE)
    list(FILTER sources EXCLUDE REGEX ${ARG_EXCLUDE})
  endif()
  set(target steplab_${folder})
  if(sources OR ARG_SOURCES)
    add_library(${target} STATIC ${sources} ${ARG_SOURCES})
    steplab_compile(${target})
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    target_link_libraries(${target} PUBLIC ${ARG_LINK})
    steplab_precompile(${target} ${ARG_PRECOMPILE})
    if(NOT ARG_APART)
      steplab_join(${target})
    endif()
  else()
    add_library(${target} INTERFACE)
    target_include_directories(${target} INTERFACE ${PROJECT_SOURCE_DIR}/src)
    target_link_libraries(${target} INTERFACE ${ARG_LINK})
  endif()
endfunction()

# steplab_program(name SOURCES file... [LINK target...]): a program in build/<preset>/bin.
function(steplab_program name)
  cmake_parse_arguments(ARG "" "" "LINK;SOURCES" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  steplab_compile(${name})
  target_link_libraries(${name} PRIVATE ${ARG_LINK})
endfunction()

# How test programs are compiled. Results do not depend on optimisation; little of it makes a release build faster.
add_library(steplab_testing INTERFACE)
target_link_libraries(steplab_testing INTERFACE GTest::gmock GTest::gtest steplab_pch_for_ccache)
# With -O1 g++ 12 sees bounds overstepped in sums of short strings, which no other level does.
target_compile_options(steplab_testing INTERFACE $<$<CONFIG:Release>:-O1>
                                                 $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-restrict;-Wno-stringop-overflow;-Wno-stringop-overread>)

# steplab_test_headers(): the target test_headers, which compiles the headers that most tests include once for all test
# programs. Every test includes what it needs nonetheless (preset `clang` builds without them).
set(steplab_test_precompiled
    <algorithm> <array> <cmath> <cstddef> <cstdint> <filesystem> <fstream> <functional> <limits> <map> <memory>
    <optional> <random> <set> <span> <sstream> <stdexcept> <string> <string_view> <utility> <variant> <vector>
    <gmock/gmock.h> <gtest/gtest.h>)
function(steplab_test_headers)
  file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/empty.cpp CONTENT "" @ONLY)
  add_library(test_headers OBJECT ${CMAKE_CURRENT_BINARY_DIR}/empty.cpp)
  steplab_compile(test_headers)
  target_link_libraries(test_headers PRIVATE steplab_testing)
  target_precompile_headers(test_headers PRIVATE ${steplab_test_precompiled})
endfunction()

# steplab_tests(folder [LINK target...] [PRECOMPILE header...] [APART]): test_<folder> of all sources in the current folder
# and the rooms below it, each test known to ctest; PRECOMPILE and APART as in steplab_library().
function(steplab_tests folder)
  cmake_parse_arguments(ARG "APART" "" "LINK;PRECOMPILE" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  if(NOT sources)
    return()
  endif()
  steplab_program(test_${folder} SOURCES ${sources} LINK ${ARG_LINK} steplab_testing GTest::gtest_main)
  if(TARGET test_headers AND ARG_PRECOMPILE)
    target_precompile_headers(test_${folder} PRIVATE ${steplab_test_precompiled} ${ARG_PRECOMPILE})
  elseif(TARGET test_headers)
    target_precompile_headers(test_${folder} REUSE_FROM test_headers)
  endif()
  if(NOT ARG_APART)
    steplab_join(test_${folder})
  endif()
  target_include_directories(test_${folder} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  set_target_properties(test_${folder} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests)
  target_compile_definitions(test_${folder} PRIVATE STEPLAB_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
                                                    STEPLAB_BINARY_DIR="${PROJECT_BINARY_DIR}")
  include(GoogleTest)
  gtest_discover_tests(test_${folder} TEST_PREFIX ${folder}. DISCOVERY_TIMEOUT 60
                       PROPERTIES TIMEOUT 1500 LABELS ${folder})
endfunction()

# steplab_count_allocations(folder): its tests have an operator new that counts, and fails when asked to.
function(steplab_count_allocations folder)
  set(counting ${PROJECT_SOURCE_DIR}/tests/support/allocations.cpp)
  target_sources(test_${folder} PRIVATE ${counting})
  set_source_files_properties(${counting} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  if(STEPLAB_SANITIZE STREQUAL thread)
    # the sanitizer comes with an operator new of its own: that of allocations.cpp, which is linked first, counts
    target_link_options(test_${folder} PRIVATE -Wl,--allow-multiple-definition)
  endif()
endfunction()

# The class of a method: rk4 -> Rk4, verlet-2008 -> Verlet2008.
function(steplab_method_class id class)
  string(REPLACE "-" ";" words ${id})
  set(name "")
  foreach(word IN LISTS words)
    string(SUBSTRING ${word} 0 1 first)
    string(SUBSTRING ${word} 1 -1 rest)
    string(TOUPPER ${first} first)
    string(APPEND name ${first}${rest})
  endforeach()
  set(${class} ${name} PARENT_SCOPE)
endfunction()

# Compiler flags of an instruction set. By itself g++ 12 moves the registers of AVX2 in halves, and each is waited for
# where it is read as a whole.
set(steplab_flags_of_avx2 -mavx2 -mbmi -mbmi2
                          "$<$<CXX_COMPILER_ID:GNU>:-mmove-max=256;-mstore-max=256>")
set(steplab_flags_of_avx512 -mavx512f -mavx512vl -mavx512dq -mavx512bw -mbmi -mbmi2 -mprefer-vector-width=512)

# steplab_instruction_sets: those that methods are compiled for. `native` stands for the best that this processor has,
# alone: a third of the time to build.
set(steplab_instruction_sets baseline)
if(STEPLAB_INSTRUCTION_SETS STREQUAL none)
  set(steplab_instruction_sets "")
elseif(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64" AND STEPLAB_INSTRUCTION_SETS STREQUAL native)
  if(NOT STEPLAB_NATIVE_SET)
    try_run(ran compiled ${PROJECT_BINARY_DIR}/native ${PROJECT_SOURCE_DIR}/cmake/native_set.cpp
            CMAKE_FLAGS -DINCLUDE_DIRECTORIES=${PROJECT_SOURCE_DIR}/src CXX_STANDARD 20
            RUN_OUTPUT_VARIABLE native)
    set(STEPLAB_NATIVE_SET ${native} CACHE INTERNAL "The best instruction set of this processor")
  endif()
  set(steplab_instruction_sets ${STEPLAB_NATIVE_SET})
elseif(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  list(APPEND steplab_instruction_sets ${STEPLAB_INSTRUCTION_SETS})
endif()
set(steplab_flags_of_baseline "")
foreach(set IN LISTS steplab_instruction_sets)
  if(NOT DEFINED steplab_flags_of_${set})
    message(FATAL_ERROR "STEPLAB_INSTRUCTION_SETS names '${set}'; known are avx2 and avx512, or native or none by itself")
  endif()
endforeach()

# What is compiled in each instruction set beside the steppers of the methods: sources of src/sim/steppers.
set(steplab_shared_steppers energy_sums erased_forces kick_drift_steps own_steps runge_kutta_steps)

# Methods that are compiled on layouts of forces of their own, in twice the time of all others: each precision is a source,
# so that two processors share it.
set(steplab_large_methods euler-forward midpoint rk4)

# steplab_catalogue(sources METHODS id... MODELS id... [INSTRUCTIONS set...]): the sources of a catalogue of these, written
# from their ids, the steppers of its methods in each of the instruction sets among them.
function(steplab_catalogue sources)
  cmake_parse_arguments(ARG "" "" "METHODS;MODELS;INSTRUCTIONS" ${ARGN})
  set(folder ${PROJECT_SOURCE_DIR}/src/sim)
  set(templates ${folder}/steppers)
  set(generated ${CMAKE_CURRENT_BINARY_DIR}/generated)
  set(written ${generated}/catalogue_entries.cpp)
  set(steppers "")
  set(STEPLAB_METHOD_MAKERS "")
  set(STEPLAB_METHOD_ENTRIES "")
  foreach(id IN LISTS ARG_METHODS)
    steplab_method_class(${id} STEPLAB_CLASS)
    set(STEPLAB_METHOD ${id})
    steplab_stepper_makers(${STEPLAB_CLASS} "${ARG_INSTRUCTIONS}")
    configure_file(${templates}/method.cpp.in ${generated}/method_${id}.cpp @ONLY)
    set(STEPLAB_FLOAT_APART "")
    if(id IN_LIST steplab_large_methods)
      configure_file(${templates}/stepper_float.cpp.in ${generated}/stepper_${id}_float.cpp @ONLY)
      list(APPEND steppers ${generated}/stepper_${id}_float.cpp)
      set(STEPLAB_FLOAT_APART
          "extern template std::unique_ptr<Stepper> make_stepper_in<${STEPLAB_CLASS}, float>(const StepperSetup&);")
    endif()
    configure_file(${templates}/stepper.cpp.in ${generated}/stepper_${id}.cpp @ONLY)
    list(APPEND written ${generated}/method_${id}.cpp)
    list(APPEND steppers ${generated}/stepper_${id}.cpp)
    string(APPEND STEPLAB_METHOD_MAKERS "Method method_${STEPLAB_CLASS}();\n")
    string(APPEND STEPLAB_METHOD_ENTRIES "        method_${STEPLAB_CLASS}(),\n")
  endforeach()
  set(STEPLAB_MODEL_MAKERS "")
  set(STEPLAB_MODEL_ENTRIES "")
  foreach(id IN LISTS ARG_MODELS)
    string(REPLACE "-" "_" function ${id})
    string(APPEND STEPLAB_MODEL_MAKERS "const Model& ${function}_model();\n")
    string(APPEND STEPLAB_MODEL_ENTRIES "        ${function}_model(),\n")
  endforeach()
  steplab_in_each_set(ENERGY "EnergySums energy_sums()" "energy_sums()" "EnergySums{}" "${ARG_INSTRUCTIONS}")
  steplab_in_each_set(OWN "std::unique_ptr<Stepper> make_own_stepper(const StepperSetup&, std::shared_ptr<const OwnSteps>)"
                      make_own_stepper nullptr "${ARG_INSTRUCTIONS}")
  configure_file(${folder}/catalogue_entries.cpp.in ${generated}/catalogue_entries.cpp @ONLY)
  if(STEPLAB_JOINED_SOURCES)  # with each other alone: other catalogues take the place of this one
    set(joined ${generated}/catalogue.cpp)
    list(TRANSFORM written REPLACE "(.+)" "#include \"\\1\"\n" OUTPUT_VARIABLE includes)
    string(JOIN "" includes ${includes})
    file(CONFIGURE OUTPUT ${joined} CONTENT "${includes}")
    set_source_files_properties(${joined} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    set(written ${joined})
  endif()
  foreach(shared IN LISTS steplab_shared_steppers)
    list(APPEND steppers ${templates}/${shared}.cpp)
  endforeach()
  foreach(set IN LISTS ARG_INSTRUCTIONS)
    if(set STREQUAL baseline)
      set_source_files_properties(${steppers} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)  # one method is built at a time
      list(APPEND written ${steppers})
    else()
      steplab_steppers(${set} object ${steppers})
      list(APPEND written ${object})
    endif()
  endforeach()
  set(${sources} ${written} PARENT_SCOPE)
endfunction()

# What the entry of a method names: its maker in each instruction set, null where it was not compiled for it.
function(steplab_stepper_makers class sets)
  foreach(set IN ITEMS baseline avx2 avx512)
    if(set IN_LIST sets)
      string(APPEND declarations "namespace ${set} {\nstd::unique_ptr<Stepper> make_${class}(const StepperSetup&);\n"
                                 "std::unique_ptr<EnsembleStepper> make_ensemble_${class}(std::span<const StepperSetup> runs);\n}\n")
      list(APPEND makers "${set}::make_${class}")
      list(APPEND groups "goes_in_lanes<${class}> ? ${set}::make_ensemble_${class} : nullptr")
    else()
      list(APPEND makers nullptr)
      list(APPEND groups nullptr)
    endif()
  endforeach()
  list(JOIN makers ", " makers)
  list(JOIN groups ", " groups)
  set(STEPLAB_STEPPER_DECLARATIONS ${declarations} PARENT_SCOPE)
  set(STEPLAB_STEPPER_MAKERS ${makers} PARENT_SCOPE)
  set(STEPLAB_ENSEMBLE_MAKERS ${groups} PARENT_SCOPE)
endfunction()

# steplab_in_each_set(name declaration value none sets): what is compiled once for each instruction set, as the variables
# STEPLAB_<name>_DECLARATIONS and STEPLAB_<name>_ENTRIES: its value in each set, `none` where it was not compiled for it.
function(steplab_in_each_set name declaration value none sets)
  foreach(set IN ITEMS baseline avx2 avx512)
    if(set IN_LIST sets)
      string(APPEND declarations "namespace ${set} {\n${declaration};\n}\n")
      list(APPEND entries "${set}::${value}")
    else()
      list(APPEND entries "${none}")
    endif()
  endforeach()
  list(JOIN entries ", " entries)
  set(STEPLAB_${name}_DECLARATIONS ${declarations} PARENT_SCOPE)
  set(STEPLAB_${name}_ENTRIES ${entries} PARENT_SCOPE)
endfunction()

# ld of the GNU binutils, which alone knows --force-group-allocation; CMake may have found ld.lld.
find_program(STEPLAB_GNU_LINKER NAMES ld.bfd ld REQUIRED DOC "GNU ld, for the steppers of one instruction set")
mark_as_advanced(STEPLAB_GNU_LINKER)

# One object file of these sources, compiled for an instruction set beyond the baseline. All it holds but the makers is
# local to it: inline functions and templates that other files have too would else be taken from here for all of them,
# and be run where the processor does not know such instructions.
function(steplab_steppers set object)
  set(target steplab_steppers_${set})
  add_library(${target} OBJECT ${ARGN})
  steplab_compile(${target})
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  # unique symbols cannot be made local
  target_compile_options(${target} PRIVATE ${steplab_flags_of_${set}} $<$<CXX_COMPILER_ID:GNU>:-fno-gnu-unique>)
  if(STEPLAB_SANITIZE AND NOT STEPLAB_SANITIZE_STEPPERS)
    target_compile_options(${target} PRIVATE -fno-sanitize=all)
  endif()
  target_compile_definitions(${target} PRIVATE STEPLAB_INSTRUCTION_SET=${set})
  target_link_libraries(${target} PRIVATE steplab_core steplab_methods steplab_models)
  set(linked ${CMAKE_CURRENT_BINARY_DIR}/${target}.o)
  string(LENGTH ${set} length)
  add_custom_command(OUTPUT ${linked}
                     COMMAND ${STEPLAB_GNU_LINKER} -r --force-group-allocation -o ${linked} $<TARGET_OBJECTS:${target}>
                     COMMAND ${CMAKE_OBJCOPY} --wildcard --keep-global-symbol=_ZN7steplab${length}${set}* ${linked}
                     DEPENDS ${target} $<TARGET_OBJECTS:${target}>
                     COMMENT "Linking the steppers for ${set}" COMMAND_EXPAND_LISTS VERBATIM)
  set_source_files_properties(${linked} PROPERTIES EXTERNAL_OBJECT ON GENERATED ON)
  set(${object} ${linked} PARENT_SCOPE)
endfunction()
