# Installs BUILD into an empty prefix, then configures, builds and runs SOURCE against it. Its program
# must be the one that README shows.
function(run folder)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${folder} RESULT_VARIABLE status OUTPUT_VARIABLE said)
  message("${said}")
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "failed: ${ARGN}")
  endif()
  set(said "${said}" PARENT_SCOPE)
endfunction()

foreach(file main.cpp CMakeLists.txt)
  file(READ ${SOURCE}/${file} program)
  file(READ ${README} readme)
  string(FIND "${readme}" "\n${program}```" place)
  if(place EQUAL -1)
    message(FATAL_ERROR "README.md does not show ${SOURCE}/${file} as it is")
  endif()
endforeach()

file(REMOVE_RECURSE ${WORK}/prefix ${WORK}/build)
file(MAKE_DIRECTORY ${WORK}/build)
run(${WORK} ${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
# The program may have headers of the names of ours, which nothing of ours may take.
file(REMOVE_RECURSE ${WORK}/namesakes)
file(GLOB_RECURSE headers RELATIVE ${WORK}/prefix/include/lpquad ${WORK}/prefix/include/lpquad/*.h)
if(NOT EXISTS ${WORK}/prefix/include/lpquad/base/result.h)
  message(FATAL_ERROR "not the headers expected: ${headers}")
endif()
foreach(header IN LISTS headers)
  file(WRITE ${WORK}/namesakes/${header} "#error the program's own ${header}\n")
  file(STRINGS ${WORK}/prefix/include/lpquad/${header} by_name REGEX "#include \"")
  if(by_name)
    message(FATAL_ERROR "${header} leaves to the search path: ${by_name}")
  endif()
endforeach()
run(${WORK} ${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/build -G ${GENERATOR} -DCMAKE_BUILD_TYPE=Release
    -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_PREFIX_PATH=${WORK}/prefix
    -DCMAKE_CXX_FLAGS=-I${WORK}/namesakes)
run(${WORK} ${CMAKE_COMMAND} --build ${WORK}/build)

# Faces of four corners: readers of surfaces divide them.
file(WRITE ${WORK}/build/cube.obj "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
  "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n")
run(${WORK}/build ./app cube.obj)
# The plate's area is 1.92: about 192 quads of size 0.1. The cube has 4 x 4 of size 0.25 on each face.
if(NOT said MATCHES "plate: (1[6-9]|2[0-3])[0-9] quads, 0 triangles" OR
   NOT said MATCHES "surface: 96 quads, 0 triangles")
  message(FATAL_ERROR "not the meshes expected")
endif()
foreach(mesh plate.msh surface.msh)
  file(STRINGS ${WORK}/build/${mesh} first LIMIT_COUNT 1)
  if(NOT first STREQUAL "$MeshFormat")
    message(FATAL_ERROR "${mesh} is not there")
  endif()
endforeach()
