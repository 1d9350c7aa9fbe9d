# How every target of the project is built: language, warnings, sanitizers, ccache, one shared precompiled header.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin")

# A whole build takes half the time where sources of a target are compiled together, since what they include and instantiate is
# most of the work; the preset dev compiles each by itself, which is faster after a change and shows what a file fails to include.
# A file whose names are a neighbour's too stands alone: glenoid_alone in its folder's list.
option(GLENOID_UNITY "Compile several sources of a target at once" ON)
set(CMAKE_UNITY_BUILD ${GLENOID_UNITY})
set(CMAKE_UNITY_BUILD_BATCH_SIZE 8)

# glenoid_alone(SOURCES...): those are compiled by themselves.
macro(glenoid_alone)
  set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endmacro()

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env
      CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime ${CCACHE_PROGRAM})
endif()

if(GLENOID_ASSERTS)
  foreach(config RELEASE RELWITHDEBINFO MINSIZEREL)
    string(REPLACE "-DNDEBUG" "" CMAKE_CXX_FLAGS_${config} "${CMAKE_CXX_FLAGS_${config}}")
  endforeach()
endif()
string(REPLACE "-O2" "-O3" CMAKE_CXX_FLAGS_RELWITHDEBINFO "${CMAKE_CXX_FLAGS_RELWITHDEBINFO}")

# Contraction is off so that a result depends on the source, not on what the optimizer fused; kernels write FMA where it is meant.
add_library(glenoid_flags INTERFACE)
target_compile_options(glenoid_flags INTERFACE -Wall -Wextra -Wshadow -Wno-maybe-uninitialized -ffp-contract=off)
if(CCACHE_PROGRAM)
  target_compile_options(glenoid_flags INTERFACE -fpch-preprocess)
endif()
target_include_directories(glenoid_flags INTERFACE "${CMAKE_SOURCE_DIR}")

# Sanitizers for our own numerics and document code; Qt's widgets and GL drivers are left out.
add_library(glenoid_sanitize INTERFACE)
if(GLENOID_SANITIZE STREQUAL "address")
  target_compile_options(glenoid_sanitize INTERFACE -fsanitize=address,undefined -fno-sanitize=null,alignment,vptr,object-size -fno-omit-frame-pointer)
  target_link_options(glenoid_sanitize INTERFACE -fsanitize=address,undefined)
elseif(GLENOID_SANITIZE STREQUAL "thread")
  target_compile_options(glenoid_sanitize INTERFACE -fsanitize=thread)
  target_link_options(glenoid_sanitize INTERFACE -fsanitize=thread)
endif()

# glenoid_library(NAME SOURCES ... [LINKS public targets] [PRIVATE_LINKS hidden targets])
function(glenoid_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  target_link_libraries(${name} PUBLIC glenoid_flags glenoid_sanitize Eigen3::Eigen ${ARG_LINKS} PRIVATE ${ARG_PRIVATE_LINKS})
  if(TARGET glenoid_pch)
    target_precompile_headers(${name} REUSE_FROM glenoid_pch)
  endif()
endfunction()

# glenoid_light(TARGETS...): code that reads, writes and shows but does not compute; a third of its compilation is spared.
function(glenoid_light)
  foreach(target ${ARGN})
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  endforeach()
endfunction()

# A sanitizer slows a test ten to twenty times. Those that repeat for seconds what shorter ones do once are left out there.
set(GLENOID_SANITIZED_FILTER "-Hertz.*:Energy.neverGrowsInAnImpactOfAnyTissueUpToFiveMilliseconds"
  "Energy.neverExceedsTheStartFromAScatteredShape" "Energy.ofASpinningChain*" "Energy.ofATautBand*" "LinearCost.*" "PeerStudy.*"
  "Simplify.smoothShapes*" "Simplify.surfaceThatCuts*" "Simplify.largeSurface*" "Cells.chosenCellsReachTheTargets"
  "NearCouplings.aBallLimitsIt" "NearCouplings.whatCannotHoldIsRefusedByName" "RefineJoint.aCarriedState*" "ContactState.*"
  "Stacking.tenStandForAMinute" "Sliding.bumps*" "Tunnelling.whatIsThrown*" "FrictionCost.*" "ImportWorker.memoryHasALimit"
  "FindProblems.ofHalfAMillion*" "LargeMeshes.*"
  "SelfContact.aPressed*" "SelfContact.aSheet*" "SelfContact.aSqueezed*" "SelfContact.threeLayers*" "SelfContact.aSlit*"
  "SelfContact.keepsMomentum*" "SelfContact.layersOn*" "StaticPart.aPatchOnABlock*" "MakeDents.tissueThinner*" "MakeDents.aTableSays*"
  "TrainingMetrics.growing*" "TrainingMetrics.careful*" "Wrap.*")
list(JOIN GLENOID_SANITIZED_FILTER ":" GLENOID_SANITIZED_FILTER)

# Programs that run at length, on larger scenes or by the clock, what others check once: continuous integration builds and
# runs them without a sanitizer; and what takes a minute to compile there of code that the steps' own tests go through. By hand:
# cmake --build --preset asan --target simcore_tests && ctest --preset asan -L simcore
set(GLENOID_NOT_SANITIZED tst_study tst_study_accuracy tst_haptic_trial tst_peer_scene tst_peer_study
  tst_step_sliding tst_step_friction tst_collide_cost tst_linear_allocation tst_live_bits tst_live_carry tst_export tst_large_surface
  tst_difficult_meshes tst_body tst_coupling tst_static_part)  # the last is what the thread sanitizer is for

# glenoid_test(NAME LABEL unit|numerics|render|long [THREADS] SOURCES ... LINKS ...): one GoogleTest program of one folder.
# Those below tests/simcore and tests/hard also get the label simcore, most of them the label sanitized, and with THREADS
# the label threads. The targets simcore_tests, sanitized_tests and thread_tests build them.
function(glenoid_test name)
  cmake_parse_arguments(ARG "THREADS" "LABEL;TIMEOUT" "SOURCES;LINKS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE ${ARG_LINKS} GTest::gtest GTest::gtest_main)
  # Everything that a test includes first, read once; it is only taken by what is compiled as it was, so -fPIC.
  target_link_libraries(${name} PRIVATE glenoid_flags glenoid_sanitize)
  target_compile_options(${name} PRIVATE -fPIC)
  target_precompile_headers(${name} REUSE_FROM glenoid_test_pch)
  target_compile_definitions(${name} PRIVATE GLENOID_SOURCE_DIR="${CMAKE_SOURCE_DIR}" GLENOID_BUILD_DIR="${CMAKE_BINARY_DIR}")
  add_test(NAME ${name} COMMAND ${name})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 300)
  endif()
  cmake_path(RELATIVE_PATH CMAKE_CURRENT_SOURCE_DIR BASE_DIRECTORY "${CMAKE_SOURCE_DIR}/tests" OUTPUT_VARIABLE folder)
  if(folder MATCHES "^(simcore|hard)")
    list(APPEND ARG_LABEL simcore)
    add_dependencies(simcore_tests ${name})
    if(NOT name IN_LIST GLENOID_NOT_SANITIZED AND NOT folder STREQUAL "hard")
      list(APPEND ARG_LABEL sanitized)
      add_dependencies(sanitized_tests ${name})
    endif()
  endif()
  if(ARG_THREADS)
    list(APPEND ARG_LABEL threads)
    add_dependencies(thread_tests ${name})
  endif()
  set(environment "OPENBLAS_NUM_THREADS=1;QT_QPA_PLATFORM=offscreen")
  if(GLENOID_SANITIZE)
    list(APPEND environment "GTEST_FILTER=${GLENOID_SANITIZED_FILTER}")
    math(EXPR ARG_TIMEOUT "4 * ${ARG_TIMEOUT}")
  endif()
  if("long" IN_LIST ARG_LABEL)
    set_tests_properties(${name} PROPERTIES COST 1000)  # first, so that none is left over at the end
  endif()
  set_tests_properties(${name} PROPERTIES LABELS "${ARG_LABEL}" TIMEOUT ${ARG_TIMEOUT} ENVIRONMENT "${environment}")
endfunction()
