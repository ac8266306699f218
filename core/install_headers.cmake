# Copies the headers of SOURCE to TARGET, with includes that need no search path but that of <lpquad/...>.
file(REMOVE_RECURSE ${TARGET})
file(GLOB_RECURSE headers RELATIVE ${SOURCE} ${SOURCE}/*.h)
list(FILTER headers EXCLUDE REGEX "^cli/")
foreach(header IN LISTS headers)
  file(READ ${SOURCE}/${header} text)
  string(REGEX REPLACE "#include \"([^\"\n]+)\"" "#include <lpquad/\\1>" text "${text}")
  file(WRITE ${TARGET}/${header} "${text}")
endforeach()
